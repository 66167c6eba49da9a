// columns.h — numbers of a CSV row: fixed decimals, trailing zeros left out.
#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <string>

#include "base/numbers.h"

namespace kadr::driver {

inline void append_trimmed(std::string& out, double value, int decimals) {
    std::array<char, kMaxFixedLength> text;
    char* end = format_fixed(text.data(), value, decimals);
    while (end[-1] == '0') --end;
    if (end[-1] == '.') --end;
    out.append(text.data(), end);
}

inline void append_column(std::string& out, double value, int decimals) {
    out += ',';
    append_trimmed(out, value, decimals);
}

/// A whole number: a line of the text, a flag.
inline void append_column(std::string& out, std::uint32_t value) {
    std::array<char, 16> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    out += ',';
    out.append(text.data(), end.ptr);
}

}  // namespace kadr::driver
