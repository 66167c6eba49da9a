#include "base/printable.h"

#include <algorithm>
#include <cstddef>

#include "base/text.h"

namespace kadr {

namespace {

/// Characters of a text that was cut: its beginning shows what it is.
constexpr std::size_t kBeginning = 120;

/// Bytes of the control character that stands at `at`; 0: none. In UTF-8 those from U+0080 to
/// U+009F have two bytes.
std::size_t control_length(std::string_view text, std::size_t at) {
    const auto byte = static_cast<unsigned char>(text[at]);
    if (byte == '\n' || byte == '\t') return 0;
    if (byte < 0x20 || byte == 0x7f) return 1;
    if (byte != 0xC2 || at + 1 == text.size()) return 0;
    const auto next = static_cast<unsigned char>(text[at + 1]);
    return next >= 0x80 && next < 0xA0 ? 2 : 0;
}

}  // namespace

std::string printable(std::string_view text) {
    static constexpr char kHex[] = "0123456789abcdef";
    std::string out;
    out.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = control_length(text, i);
        if (length == 0) {
            out += text[i++];
            continue;
        }
        const auto code = static_cast<unsigned char>(text[i + length - 1]);
        out += "\\x";
        out += kHex[code >> 4];
        out += kHex[code & 15];
        i += length;
    }
    return out;
}

std::string shortened(std::string_view text, std::size_t most) {
    if (text.size() <= most) return std::string(text);
    return std::string(code_points(text, 0, std::min(kBeginning, most))) + "… (" +
           std::to_string(count_code_points(text)) + " characters)";
}

}  // namespace kadr
