// lvalues.h — what can be assigned and referred to: variables, members, elements; and assignment.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// What a name, a member or an element refers to; nothing, with a message, if it cannot be
/// assigned.
std::optional<Lvalue> lvalue(Check& check, syntax::ExprId id);
/// … of a name.
std::optional<Lvalue> name_lvalue(Check& check, syntax::ExprId id);
/// An lvalue, or the temporary that an expression leaves.
std::optional<Lvalue> owner_lvalue(Check& check, syntax::ExprId id);
/// The member `expr.text` of a struct that stands somewhere.
std::optional<Lvalue> part_lvalue(Check& check, const Lvalue& whole, syntax::ExprId id);
/// The value that stands there; `checked`: it must be given.
Value load(Check& check, const Lvalue& lvalue, const SourceRange& range, bool checked, Reg hint);
/// Reports what cannot be assigned: a constant, a temporary, a part of a contour.
Done require_assignable(Check& check, const Lvalue& lvalue, const SourceRange& range);
/// From here on the variable is given.
void note_assignment(Check& check, const Lvalue& lvalue);
/// A register that refers to it, for a parameter `&`.
Reg reference_to(Check& check, const Lvalue& lvalue);
/// `a = b`, `a += b`; `is_value`: somebody uses what it comes to.
Value assign(Check& check, syntax::ExprId id, bool is_value);
/// `i++`, `--i`, likewise.
Value step(Check& check, syntax::ExprId id, bool is_value);

}  // namespace kadr::sema
