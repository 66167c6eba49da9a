// Any bytes as ISO-7bit text; the first byte chooses the control, unless KADR_FUZZ_CONTROL says its
// number: then all inputs are for that one. Read, interpreted, planned and sampled a little; what
// was read is written again.
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nc/reader.h"
#include "tests/fuzz/world.h"
#include "write/writer.h"

namespace {

using namespace kadr;

/// The whole text as one piece.
class Whole final : public nc::TextSource {
  public:
    explicit Whole(std::string_view text) : text_(text) {}
    std::string_view next() override { return std::exchange(text_, {}); }

  private:
    std::string_view text_;
};

void rewrite(const nc::Dialect& dialect, std::string_view text) {
    DiagnosticList messages;
    Whole whole(text);
    nc::Reader reader(dialect, whole, "fuzz", messages);
    write::Writer writer(dialect, {}, messages);
    std::string out;
    std::vector<nc::Block> blocks(64);
    while (const std::size_t count = reader.pull(blocks)) {
        for (std::size_t i = 0; i < count; ++i) writer.write(blocks[i], out);
        out.clear();
    }
    fuzz::show(messages, fuzz::world().sources);
}

/// The control that all inputs are for, if the environment says one.
std::optional<std::size_t> only_control() {
    const char* const number = std::getenv("KADR_FUZZ_CONTROL");
    if (number == nullptr) return std::nullopt;
    return static_cast<std::size_t>(std::strtoul(number, nullptr, 10));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto& controls = fuzz::world().controls;
    static const std::optional<std::size_t> only = only_control();
    const nc::Dialect& dialect = *controls[only.value_or(data[0]) % controls.size()];
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    fuzz::execute(dialect, text);
    rewrite(dialect, text);
    return 0;
}
