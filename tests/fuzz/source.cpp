// Any bytes as a Kadr source, down the whole road: parse, check, expand, write, read back, execute.
// The size of the input chooses the control. Promise: text that was written without a complaint
// reads back without one.
#include <cstdint>
#include <string>
#include <vector>

#include "tests/fuzz/world.h"
#include "write/writer.h"

namespace {

using namespace kadr;

/// The ISO-7bit text of a checked program as far as it came.
struct Written {
    std::string text;
    bool is_whole = false;  // no error, and nothing of it is the author's own raw text
};

Written write_text(const sema::Code& code, const nc::Dialect& target, DiagnosticList& messages) {
    expand::ExpandOptions options;
    options.limits = fuzz::small_limits();
    options.trace = true;
    expand::Expander expander(code, target, options, messages);
    Written written;
    if (!expander.start("", {})) return written;
    write::Writer writer(target, {}, messages);
    writer.set_statements(code.statements);
    writer.begin({.name = "fuzz"}, written.text);
    bool has_raw = false;
    std::vector<nc::Block> blocks(16);
    while (const std::size_t count = expander.pull(blocks)) {
        for (std::size_t i = 0; i < count; ++i) {
            has_raw |= blocks[i].kind == nc::Block::Kind::Raw;
            writer.write(blocks[i], written.text);
        }
    }
    writer.end(written.text);
    written.is_whole = !has_raw && !expander.failed() && !writer.failed();
    return written;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto checked = fuzz::check({reinterpret_cast<const char*>(data), size});
    if (checked->code) {
        const auto& controls = fuzz::world().controls;
        const nc::Dialect& target = *controls[size % controls.size()];
        const Written written = write_text(*checked->code, target, checked->messages);
        const std::string complaint = fuzz::complaint_about(target, written.text);
        if (written.is_whole && !complaint.empty()) {
            fuzz::broken("what is written reads back", complaint + written.text);
        }
        fuzz::execute(target, written.text);
    }
    fuzz::show(checked->messages, checked->sources);
    return 0;
}
