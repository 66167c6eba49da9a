// expressions.h — expressions by their kind: literals, names, `? :`.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

Value expression(Check& check, syntax::ExprId id, Type expected = {}, Reg hint = kNoReg);
void note_value(Check& check, syntax::ExprId id, const Value& value);
Value symbol_value(Check& check, std::int32_t index, const SourceRange& range, bool checked);
Value name_value(Check& check, syntax::ExprId id, Reg hint);
Type type_of(Check& check, syntax::ExprId id);
bool writes(Check& check, syntax::ExprId id);

}  // namespace kadr::sema
