// match_faults.h — why the words of a line make no block, in the control's words where it has some.
#pragma once

#include <string_view>

#include "nc/lexer.h"
#include "nc/match.h"

namespace kadr::nc {

/// A mistake of words as a mistake of their line: the message, the word it is at, its arguments.
///
/// words  of `line`, which do not match
/// modal  functions under which they were read
LineFault fault_of_line(const DialectTables& tables, const MatchFault& fault,
                        const LexedLine& words, std::string_view line, const ModalFunctions& modal);

}  // namespace kadr::nc
