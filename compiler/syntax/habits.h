// habits.h — words of other languages, and what Kadr has in their place.
//
// They are no words of Kadr: a program may use every one of them as a name. They are looked up only
// where something was not understood, so that a programmer of C, Python or Pascal gets a hint.
#pragma once

#include <string>
#include <string_view>

#include "base/diagnostic.h"

namespace kadr::syntax {

struct Habit {
    std::string_view word;
    std::string_view instead;  // stands in the same position; empty: nothing does
    std::string_view hint;
    bool is_statement = false;  // begins statements or declarations there
};

/// Whether the language has the keyword, in small letters.
bool is_keyword(std::string_view word);

/// How a statement of this keyword is written: what to suggest where small letters alone do not
/// make a control's statement one. `jumps`: it does so there. Empty: it is no such keyword.
std::string form_of_statement(std::string_view keyword, bool jumps);

/// A word in lower case: words of other languages are known in capitals as well.
std::string lower_ascii(std::string_view text);

/// The word, in capitals or not; null if it is none of them. In capitals some have a number:
/// `END1`, `GOTO10`.
const Habit* habit_of(std::string_view word);

/// Adds the hint, with the replacement of the word at `range` if there is one.
void advise(DiagnosticBuilder& message, const Habit& habit, const SourceRange& range);

}  // namespace kadr::syntax
