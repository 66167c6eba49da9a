// composites.h — points, structs and arrays in braces; members.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// `{1, 2}`, `{x: 1mm}`: a point, a struct or an array, as `expected` says.
Value braces(Check& check, syntax::ExprId id, Type expected, Reg hint);
/// What a variable without a value holds: nothing but the defaults of a struct's members.
void emit_initial(Check& check, Type type, Reg reg);
/// `a.b`: a member, a property, an enum's member, `position.x`, `state.feed`.
Value member(Check& check, syntax::ExprId id);

}  // namespace kadr::sema
