// conditions.h — conditions and comparisons, as jumps and as values.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

struct Sides {
    Value left;
    Value right;
};
struct ComparedSides {
    syntax::Operator op = syntax::Operator::Equal;
    bool is_real = false;
    Value left;
    Value right;
};

/// Whether an expression is a number as somebody entered it and nothing has calculated: a
/// parameter, a row of a table. Such numbers may be compared by `==`.
bool is_as_given(const Check& check, syntax::ExprId id);
/// Both sides of a comparison, checked; nothing, with a message, if one has a mistake.
std::optional<Sides> compared_sides(Check& check, const syntax::Expr& expr);
/// Two values made comparable; nothing, with a message, if they cannot be.
std::optional<ComparedSides> compare(Check& check, const syntax::Expr& expr, Value left,
                                     Value right);
/// Jumps to the label if the comparison has this truth.
void jump_compare(Check& check, const ComparedSides& comparison, bool sense, Label& label,
                  int depth);
/// Jumps to the label if the condition has this truth. `depth` ≥ 0: a loop's backward jump.
void jump_if(Check& check, syntax::ExprId id, bool sense, Label& label, int depth = -1);
/// A condition as a value.
Value truth(Check& check, syntax::ExprId id, Reg hint);
/// `list contains a`.
Value contains(Check& check, const syntax::Expr& expr, Reg hint);

}  // namespace kadr::sema
