// composites.h — points, structs and arrays in braces; members.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

Value braces(Check& check, syntax::ExprId id, Type expected, Reg hint);
void emit_initial(Check& check, Type type, Reg reg);
Value member(Check& check, syntax::ExprId id);

}  // namespace kadr::sema
