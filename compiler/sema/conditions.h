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

bool is_as_given(const Check& check, syntax::ExprId id);
std::optional<Sides> compared_sides(Check& check, const syntax::Expr& expr);
std::optional<ComparedSides> compare(Check& check, const syntax::Expr& expr, Value left,
                                     Value right);
void jump_compare(Check& check, const ComparedSides& comparison, bool sense, Label& label,
                  int depth);
/// Jumps to the label if the condition has this truth. `depth` ≥ 0: a loop's backward jump.
void jump_if(Check& check, syntax::ExprId id, bool sense, Label& label, int depth = -1);
Value truth(Check& check, syntax::ExprId id, Reg hint);
Value contains(Check& check, const syntax::Expr& expr, Reg hint);

}  // namespace kadr::sema
