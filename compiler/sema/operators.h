// operators.h — operators on numbers, points, texts; quantities that go together.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

Value unary(Check& check, syntax::ExprId id, Type expected, Reg hint);
Value binary(Check& check, syntax::ExprId id, Type expected, Reg hint);
Value binary_values(Check& check, syntax::Operator op, Value left, Value right,
                    const syntax::Expr& expr, Reg hint);
void check_same_parts(Check& check, Reg left, syntax::ExprId left_text, Reg right,
                      syntax::ExprId right_text);
/// Makes two numbers comparable and addable: the same quantity.
Done match_quantities(Check& check, Value& left, Value& right, const syntax::Expr& expr);
Value emit_reals(Check& check, syntax::Operator op, const Value& a, const Value& b, Type type,
                 Reg hint, const SourceRange& range);
Value arithmetic(Check& check, syntax::Operator op, Value left, Value right,
                 const syntax::Expr& expr, Reg hint);

}  // namespace kadr::sema
