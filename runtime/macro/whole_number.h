// whole_number.h — a whole number that a name or a number of a group is written as.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace kadr::macro {

/// Nothing: the text is something else, or more than that.
inline std::optional<std::int64_t> whole_number(std::string_view text) {
    std::int64_t number = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_whole = result.ec == std::errc() && result.ptr == text.data() + text.size();
    return is_whole ? std::optional(number) : std::nullopt;
}

}  // namespace kadr::macro
