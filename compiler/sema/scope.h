// scope.h — names: where they are looked for, and what is said of one that is not there.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// What a name means.
struct Found {
    std::int32_t symbol = -1;    // local
    const Name* name = nullptr;  // of a file
};

void check_unambiguous(Check& check, std::string_view name, const SourceRange& range);
Found find(const Check& check, std::string_view name);
/// What a Name means; it is recorded as a use.
Found look_up(Check& check, syntax::ExprId id);
void add_symbol(Check& check, Symbol symbol);
void leave_scope(Check& check, const Scopes::Outer& outer);
void report_unused(Check& check, const Symbol& symbol);
std::vector<std::string_view> known_names(const Check& check, bool functions);
/// A name that a mistake has taken away, which is reported already.
Done require_not_lost(Check& check, std::string_view name);
/// `=` between an address and its value, which has this many letters.
void fix_glued(std::size_t letters, const SourceRange& range, DiagnosticBuilder& builder);
bool is_numbered_word(const Check& check, std::string_view word);
Done require_no_foreign_keyword(Check& check, std::string_view name, const SourceRange& range);
bool fix_statement(Check& check, std::string_view name, const SourceRange& range,
                   DiagnosticBuilder& builder);
std::size_t glued_letters(Check& check, std::string_view name, const SourceRange& range);
bool take_proposal(Check& check);
void report_unknown(Check& check, std::string_view name, const SourceRange& range);

}  // namespace kadr::sema
