#include "write/spelling.h"

#include <utility>

#include "write/writer.h"

namespace kadr::write {

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
    block.set_argument(*block.add(Function::WorkOffset, 1),
                       parameter_of<Function::WorkOffset>("number"), static_cast<double>(number));
    Spelling spelling = spelling_of(dialect, std::span(&block, 1));
    return spelling.fault.empty() ? std::move(spelling.text) : std::string();
}

}  // namespace kadr::write
