// head_words.h — the words that stand behind the head of a program, in its line.
//
// `O0001 G20` and `%PART G71 *` set the units of all that follows; a head that is passed over whole
// would lose them.
#pragma once

#include <cstddef>
#include <string_view>

#include "nc/tables.h"

namespace kadr::nc {

/// Where the words behind the program's name begin; npos: the line is no head, or comments and the
/// end of the block are all that stands there.
std::size_t words_behind_head(const DialectTables& tables, std::string_view line);

}  // namespace kadr::nc
