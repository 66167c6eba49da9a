#include "nc/program_head.h"

#include <array>
#include <string>
#include <utility>

#include "nc/program_lines.h"

namespace kadr::nc {

std::string_view WholeText::next() { return std::exchange(text_, {}); }

std::vector<Block> blocks_of_head(const Dialect& dialect) {
    const DialectTables& tables = dialect.tables();
    const ProgramLines lines = program_lines(tables, {"head", 1, "", false});
    std::string text;
    for (const std::string& line : lines.header) text += line + '\n';
    for (const std::string& line : lines.start) text += line + tables.notation.block_end + '\n';
    DiagnosticList messages;
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
    constexpr std::size_t kNumber = parameter_of<Function::WorkOffset>("number");
    std::optional<int> offset;
    for (const Block& block : blocks_of_head(dialect)) {
        if (const Invocation* invocation = block.find(Function::WorkOffset))
            offset = static_cast<int>(block.argument(*invocation, kNumber));
    }
    return offset;
}

}  // namespace kadr::nc
