// printable.h — texts from outside as a terminal may see them.
#pragma once

#include <string>
#include <string_view>

namespace kadr {

/// A text with its control characters written out: `\x1b` for the one that begins a command to the
/// terminal. Line ends and tabs stay; bytes that are no UTF-8 stay.
std::string printable(std::string_view text);

/// A long text cut, with its length: "G1 X1 … (5000000 characters)". Texts up to `most` bytes stay.
std::string shortened(std::string_view text, std::size_t most);

}  // namespace kadr
