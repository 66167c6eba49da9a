// letters.h — kinds of characters in the texts of controls, which are ASCII.
#pragma once

namespace kadr::nc {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
constexpr bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
/// What a name begins with.
constexpr bool is_letter(char c) { return is_upper(c) || is_lower(c) || c == '_'; }

}  // namespace kadr::nc
