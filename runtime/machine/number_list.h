// number_list.h — several plain numbers in one text: `1 0 0 1`, `-50,-50,0.012,-0.020`.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "base/numbers.h"

namespace kadr::machine {

/// Without the blanks around it.
inline std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// A decimal number and nothing else but blanks around it.
inline std::optional<double> plain_number(std::string_view text) {
    text = trimmed(text);
    const Decimal decimal = parse_decimal(text.data(), text.data() + text.size());
    if (text.empty() || decimal.end != text.data() + text.size()) return std::nullopt;
    return decimal.value;
}

/// Exactly N numbers with `separator` between them; nothing if there are others or fewer.
template <std::size_t N>
std::optional<std::array<double, N>> number_list(std::string_view text, char separator) {
    std::array<double, N> values{};
    text = trimmed(text);
    for (std::size_t i = 0; i < N; ++i) {
        const std::size_t end = text.find(separator);
        if ((end == std::string_view::npos) != (i + 1 == N)) return std::nullopt;
        const auto value = plain_number(text.substr(0, end));
        if (!value) return std::nullopt;
        values[i] = *value;
        if (end != std::string_view::npos) text = trimmed(text.substr(end + 1));
    }
    return values;
}

}  // namespace kadr::machine
