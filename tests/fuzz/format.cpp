// Any bytes as a Kadr source for the formatter. Promises: what it lays out is the same program, and
// laying it out again changes nothing.
#include "syntax/format.h"

#include <cstdint>
#include <optional>
#include <string>

#include "syntax/print.h"
#include "tests/fuzz/world.h"

namespace {

using namespace kadr;

std::optional<std::string> formatted(fuzz::Checked& parsed) {
    const std::string_view text = parsed.sources.text(parsed.ast.file);
    return syntax::format(parsed.sources, parsed.ast.file, fuzz::world().keywords_for(text),
                          fuzz::world().dialect_for(text), parsed.messages);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view source(reinterpret_cast<const char*>(data), size);
    const auto before = fuzz::parse(source);
    if (before->messages.has_errors()) return 0;
    const std::optional<std::string> once = formatted(*before);
    if (!once) fuzz::broken("a source without errors is laid out", source);
    const auto after = fuzz::parse(*once);
    if (after->messages.has_errors() || syntax::dump(after->ast) != syntax::dump(before->ast)) {
        fuzz::broken("what is laid out is the same program", *once);
    }
    if (formatted(*after) != once) fuzz::broken("laying out again changes nothing", *once);
    return 0;
}
