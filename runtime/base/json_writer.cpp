#include "base/json_writer.h"

#include <cmath>

#include "base/numbers.h"

namespace kadr {

namespace {

bool is_plain(unsigned char c, JsonStyle style) {
    return c >= ' ' && c < 0x80 && c != '"' && c != '\\' &&
           (c != '<' || style != JsonStyle::Script);
}

/// Bytes of the character that begins at `at`; 0: it is malformed.
std::size_t character_length(std::string_view text, std::size_t at) {
    const auto c = static_cast<unsigned char>(text[at]);
    const std::size_t length = c >= 0xF0 ? 4 : c >= 0xE0 ? 3 : c >= 0xC2 ? 2 : 0;
    if (length == 0 || c > 0xF4 || at + length > text.size()) return 0;
    for (std::size_t k = 1; k < length; ++k) {
        if ((static_cast<unsigned char>(text[at + k]) & 0xC0) != 0x80) return 0;
    }
    return length;
}

void append_escape(std::string& out, unsigned char c) {
    static constexpr char kHex[] = "0123456789abcdef";
    out += '\\';
    if (c == '"' || c == '\\') {
        out += static_cast<char>(c);
    } else if (c == '\n') {
        out += 'n';
    } else {
        out += "u00";
        out += kHex[c >> 4];
        out += kHex[c & 15];
    }
}

}  // namespace

void JsonWriter::append_text(std::string_view text) {
    out_ += '"';
    std::size_t begin = 0;  // of what is taken as it is
    for (std::size_t i = 0; i < text.size();) {
        const auto c = static_cast<unsigned char>(text[i]);
        if (is_plain(c, style_)) {
            ++i;
        } else if (const std::size_t length = c < 0x80 ? 0 : character_length(text, i)) {
            i += length;
        } else {
            out_ += text.substr(begin, i - begin);
            if (c < 0x80) append_escape(out_, c);
            else out_ += "\xEF\xBF\xBD";
            begin = ++i;
        }
    }
    out_ += text.substr(begin);
    out_ += '"';
}

JsonWriter& JsonWriter::number(double value) {
    if (!std::isfinite(value)) return null();
    separate();
    append_shortest(out_, value);
    return *this;
}

JsonWriter& JsonWriter::rounded(double value, int decimals) {
    return number(std::isfinite(value) ? round_to(value, decimals) : value);
}

JsonWriter& JsonWriter::coordinate(double value) {
    constexpr double kScale = 1e9;
    constexpr double kQuickLimit = 1e6;  // below it 15 digits hold the value and its decimals
    if (!(std::abs(value) < kQuickLimit)) return rounded(value, 9);
    std::array<char, 32> text;
    char* end = text.data();
    const long long scaled = std::llround(value * kScale);
    if (has_comma_) *end++ = ',';
    if (scaled < 0) *end++ = '-';
    const auto size = static_cast<unsigned long long>(scaled < 0 ? -scaled : scaled);
    end = std::to_chars(end, text.data() + text.size(), size / 1'000'000'000).ptr;
    if (unsigned long long rest = size % 1'000'000'000; rest != 0) {
        *end++ = '.';
        for (std::size_t i = 9; i-- > 0; rest /= 10) end[i] = static_cast<char>('0' + rest % 10);
        end += 9;
        while (end[-1] == '0') --end;
    }
    out_.append(text.data(), end);
    has_comma_ = true;
    return *this;
}

JsonWriter& JsonWriter::general(double value) {
    if (!std::isfinite(value)) return null();
    const double size = std::abs(value);
    const bool has_exponent = size != 0 && (size < 1e-4 || size >= 1e16);
    std::array<char, 32> text;
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value,
                      has_exponent ? std::chars_format::scientific : std::chars_format::fixed);
    return word({text.data(), static_cast<std::size_t>(end.ptr - text.data())});
}

}  // namespace kadr
