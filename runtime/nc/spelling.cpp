#include "nc/spelling.h"

#include <array>
#include <utility>

#include "nc/writer.h"

namespace kadr::nc {

static constexpr std::size_t kOffsetNumber = parameter_of<Function::WorkOffset>("number");

std::string_view WholeText::next() { return std::exchange(text_, {}); }

Spelling spelling_of(const Dialect& dialect, std::span<const Block> blocks,
                     std::vector<Refusal>* refusals) {
    Spelling spelling;
    DiagnosticList messages;
    Writer writer(dialect, {.number_blocks = false, .refusals = refusals}, messages);
    writer.begin({"example", 1, "", false}, spelling.text);
    // Another motion before, so that the example's own is written.
    Block before;
    const bool is_rapid = !blocks.empty() && blocks[0].motion == Function::Rapid;
    before.motion = is_rapid ? Function::Line : Function::Rapid;
    writer.write(before, spelling.text);
    spelling.text.clear();
    for (const Block& block : blocks) writer.write(block, spelling.text);
    while (spelling.text.ends_with('\n') || spelling.text.ends_with('\r')) spelling.text.pop_back();
    if (!messages.all().empty()) spelling.fault = messages.all()[0].message();
    return spelling;
}

std::string spelling_of_offset(const Dialect& dialect, std::int64_t number) {
    Block block;
    block.set_argument(*block.add(Function::WorkOffset, 1), kOffsetNumber,
                       static_cast<double>(number));
    Spelling spelling = spelling_of(dialect, std::span(&block, 1));
    return spelling.fault.empty() ? std::move(spelling.text) : std::string();
}

std::vector<Block> blocks_of_head(const Dialect& dialect) {
    DiagnosticList messages;
    Writer writer(dialect, {}, messages);
    std::string text;
    writer.begin({"head", 1, "", false}, text);
    writer.write(Block{}, text);
    WholeText source(text);
    Reader reader(dialect, source, "head", messages);
    std::array<Block, 8> batch;
    std::vector<Block> blocks;
    while (const std::size_t count = reader.pull(batch))
        blocks.insert(blocks.end(), batch.begin(),
                      batch.begin() + static_cast<std::ptrdiff_t>(count));
    return blocks;
}

std::optional<int> offset_of_head(const Dialect& dialect) {
    std::optional<int> offset;
    for (const Block& block : blocks_of_head(dialect)) {
        if (const Invocation* said = block.find(Function::WorkOffset))
            offset = static_cast<int>(block.argument(*said, kOffsetNumber));
    }
    return offset;
}

}  // namespace kadr::nc
