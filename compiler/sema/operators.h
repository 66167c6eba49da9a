// operators.h — operators on numbers, points, texts; quantities that go together.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// `-a`, `!a`, `~a`.
Value unary(Check& check, syntax::ExprId id, Type expected, Reg hint);
/// A binary operator; a chain of them is walked by a loop.
Value binary(Check& check, syntax::ExprId id, Type expected, Reg hint);
/// An operator between two values; `expr` is for messages.
Value binary_values(Check& check, syntax::Operator op, Value left, Value right,
                    const syntax::Expr& expr, Reg hint);
/// Emits checks that the same coordinates of two points are given; the texts are for the message.
void check_same_parts(Check& check, Reg left, syntax::ExprId left_text, Reg right,
                      syntax::ExprId right_text);
/// Makes two numbers comparable and addable: the same quantity.
Done match_quantities(Check& check, Value& left, Value& right, const syntax::Expr& expr);
/// Emits an operator on two real numbers, or folds it.
Value emit_reals(Check& check, syntax::Operator op, const Value& a, const Value& b, Type type,
                 Reg hint, const SourceRange& range);
/// `+ - * / %` with dimensions.
Value arithmetic(Check& check, syntax::Operator op, Value left, Value right,
                 const syntax::Expr& expr, Reg hint);

}  // namespace kadr::sema
