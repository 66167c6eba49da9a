// refused_words.h — words that the lexer cannot take: whether the control has them all the same,
// and what there is to report about them.
//
// Questions to the tables of a dialect alone; where a word stands in its line the lexer knows.
#pragma once

#include <string>
#include <string_view>

#include "nc/tables.h"

namespace kadr::nc {

/// `L10`: a code and the number of a program behind it.
bool is_program_call(const DialectTables& tables, std::string_view written);

/// Whether words of this name have their axis between brackets: `ACC` of `ACC[X]=50`.
bool takes_axis(const DialectTables& tables, const std::string& name);

/// `S1`, `SPI(2)`
bool is_spindle_name(std::string_view index);

/// Why what stands between the brackets is no axis: "it is another word (…)".
std::string why_no_axis(const DialectTables& tables, const std::string& index);

}  // namespace kadr::nc
