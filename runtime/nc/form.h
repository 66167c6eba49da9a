// form.h — the pattern language of forms: `G04 P{time:ms}`, `TRANS X{x} Y{y}`, `MSG("{text}")`.
//
// A line is words between blanks:
//   G04  X0.  TRANS             stand for themselves
//   P{time}  CR={radius}        an address with a parameter of the function
//   T="{tool}"                  a parameter between quotes
//   NAME({a},{b},,0,"{text}")   a call; arguments may be left out
//   NAME[X]=({a},{b})           a call by a word with an index
//   (MSG,{text})                between the control's comment signs
// A number that has a dimension is {=0.5:length}, in mm, so that it is right in inches too.
// A placeholder is {name}, {name?} (may be left out), {name:unit}, {name+6}, {name-6}, {name=0}
// (written when it is not given), {+name} (written as 0; a value that is read is added to the
// parameter), {name:named} (the word's presence is the value: written 0), {name:absolute} (read
// where the word is so by itself, `AC(…)`).
#pragma once

#include <string>
#include <vector>

#include "base/done.h"
#include "nc/tables.h"

namespace kadr::nc {

/// Reads the pattern `text` into `form`, whose function, cycle and constraints are set. A code
/// with a parameter (`G{number+53}`) becomes one form a number. Mistakes are reported at
/// form.range; the result is empty then. Names and calls are added to the addresses.
std::vector<Form> parse_form(const Form& form, std::string_view text, DialectTables& tables,
                             DiagnosticSink& sink);

/// Reads the words of one line that are no form of their own (deferred words).
Done parse_form_line(std::string_view line, std::span<const Parameter> parameters,
                     DialectTables& tables, const SourceRange& range, std::vector<FormWord>& words,
                     DiagnosticSink& sink);

}  // namespace kadr::nc
