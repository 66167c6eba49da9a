// unicode.h — what the tables of Unicode hold about texts; the only door to utf8proc.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace kadr {

/// A text in composed form (NFC): `é` of one code point and of two are the same then. A text that
/// is no UTF-8 stays.
std::string composed(std::string_view text);

/// Columns that a text takes on a terminal: none for a mark on the letter before, two for a wide
/// letter of East Asia, one for a control character, which is shown as a blank.
std::size_t display_width(std::string_view text);

}  // namespace kadr
