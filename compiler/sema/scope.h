// scope.h — names: where they are looked for, and how they come and go.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// What a name means.
struct Found {
    std::int32_t symbol = -1;    // local
    const Name* name = nullptr;  // of a file
};
/// What a name means where the check is.
Found find(const Check& check, std::string_view name);
/// What a Name means; it is recorded as a use.
Found look_up(Check& check, syntax::ExprId id);
/// Reports a name that two imports declare.
void check_unambiguous(Check& check, std::string_view name, const SourceRange& range);
/// Declares a local name; one that is taken is reported.
void add_symbol(Check& check, Symbol symbol);
/// Leaves a scope; local variables that nothing has read are kept for a warning.
void leave_scope(Check& check, const Scopes::Outer& outer);
/// Keeps a local variable for a warning, if nothing has read it.
void report_unused(Check& check, const Symbol& symbol);
/// Names that could be meant, sorted: of functions, or of everything else.
std::vector<std::string_view> known_names(const Check& check, bool functions);
/// A name that a mistake has taken away, which is reported already.
Done require_not_lost(Check& check, std::string_view name);

}  // namespace kadr::sema
