// quotes.h — where a text ends whose braces may hold texts of their own.
#pragma once

#include <cstdint>
#include <string_view>

namespace kadr::syntax {

/// Past the quote that closes the text which the quote at `begin` opens, or `begin` if none does in
/// its line before `end`. Inside `{ … }` a quote opens a text of its own where a value may stand.
std::uint32_t end_of_text(std::string_view text, std::uint32_t begin, std::uint32_t end);

/// The index of the `}` that closes the brace at `open` of a text, or `end`. Texts inside are
/// skipped.
std::uint32_t closing_brace(std::string_view text, std::uint32_t open, std::uint32_t end);

}  // namespace kadr::syntax
