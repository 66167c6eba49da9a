// utf8.h — whether bytes are a UTF-8 text at all.
#pragma once

#include <cstddef>
#include <string_view>

namespace kadr {

/// The first byte that belongs to no well-formed code point; npos: the text is UTF-8.
std::size_t find_malformed(std::string_view text);

}  // namespace kadr
