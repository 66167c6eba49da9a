// foreign_words.h — words of other controls, which people write out of habit, and what this control
// has instead.
//
// Asked when a line cannot be read, and never before.
#pragma once

#include <string_view>

#include "nc/lexer.h"
#include "nc/tables.h"

namespace kadr::nc {

/// What to write instead of a foreign word: of the one at the fault, else of the first one in the
/// line that this control does not have, else of a word directly in front of the fault. Empty where
/// the dialect knows of none; stays valid as long as the tables.
std::string_view instead_of_foreign(const DialectTables& tables, std::string_view line,
                                    const Span& fault);

}  // namespace kadr::nc
