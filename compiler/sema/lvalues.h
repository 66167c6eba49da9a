// lvalues.h — what can be assigned and referred to: variables, members, elements; and assignment.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

std::optional<Lvalue> lvalue(Check& check, syntax::ExprId id);
std::optional<Lvalue> name_lvalue(Check& check, syntax::ExprId id);
/// An lvalue, or the temporary that an expression leaves.
std::optional<Lvalue> owner_lvalue(Check& check, syntax::ExprId id);
/// The member `expr.text` of a struct that stands somewhere.
std::optional<Lvalue> part_lvalue(Check& check, const Lvalue& whole, syntax::ExprId id);
Value load(Check& check, const Lvalue& lvalue, const SourceRange& range, bool checked, Reg hint);
Done require_assignable(Check& check, const Lvalue& lvalue, const SourceRange& range);
void note_assignment(Check& check, const Lvalue& lvalue);
Reg reference_to(Check& check, const Lvalue& lvalue);
Value assign(Check& check, syntax::ExprId id, bool is_value);
Value step(Check& check, syntax::ExprId id, bool is_value);

}  // namespace kadr::sema
