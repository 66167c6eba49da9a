// foreign_words.h — words of other controls, which people write out of habit, and what this control
// has instead.
//
// Asked when a line cannot be read, or executed, and never before. What comes up while a line is
// executed has nothing to do with how the rest of it is written.
#pragma once

#include <string_view>

#include "nc/lexer.h"
#include "nc/tables.h"

namespace kadr::nc {

/// How a fault has come up.
struct ForeignLocation {
    bool in_cycle = false;     // a cycle acts, or the line calls one: its words come first
    bool is_executed = false;  // the line could be read: only the word at the fault counts
};

/// What to write instead of a foreign word: of the one at the fault, else of the first one in the
/// line that this control does not have, else of a word directly in front of the fault. Empty where
/// the dialect knows of none; stays valid as long as the tables.
std::string_view instead_of_foreign(const DialectTables& tables, std::string_view line,
                                    const Span& fault, const ForeignLocation& location);

}  // namespace kadr::nc
