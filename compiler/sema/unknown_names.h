// unknown_names.h — what is said of a name that is not there, and what it may have meant.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// Reports a name that nobody declares, with what it may have meant.
void report_unknown(Check& check, std::string_view name, const SourceRange& range);
/// A keyword of English in a file of another keyword language.
Done require_no_foreign_keyword(Check& check, std::string_view name, const SourceRange& range);
/// Whether this is a word with a number: `X10`.
bool is_numbered_word(const Check& check, std::string_view word);
/// Letters of the address of a word that has its value without `=`; 0: it is none.
std::size_t glued_letters(Check& check, std::string_view name, const SourceRange& range);
/// `=` between an address and its value, which has this many letters.
void fix_glued(std::size_t letters, const SourceRange& range, DiagnosticBuilder& builder);
/// A name that is a statement by itself, as only words of a language are: `BREAK;`, `E5;`.
bool fix_statement(Check& check, std::string_view name, const SourceRange& range,
                   DiagnosticBuilder& builder);
/// Whether one more proposal may be looked for; they take time.
bool take_proposal(Check& check);

}  // namespace kadr::sema
