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
void check_unambiguous(Check& check, std::string_view name, const SourceRange& range);
void add_symbol(Check& check, Symbol symbol);
void leave_scope(Check& check, const Scopes::Outer& outer);
void report_unused(Check& check, const Symbol& symbol);
/// Names that could be meant, sorted: of functions, or of everything else.
std::vector<std::string_view> known_names(const Check& check, bool functions);
/// A name that a mistake has taken away, which is reported already.
Done require_not_lost(Check& check, std::string_view name);

}  // namespace kadr::sema
