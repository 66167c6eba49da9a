// curves.h — curves: a function of points by a parameter, and `follow`, which fits blocks to it.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// The body of one of the two functions that a curve becomes: its points, or its limits.
void curve_body(Check& check, const FunctionDecl& function, const syntax::Decl& decl);
/// The call of a curve that is the first argument of `follow`; nothing if it is none.
std::optional<syntax::ExprId> curve_argument(Check& check, const syntax::Expr& expr);
/// `follow(curve(…))`: blocks that are fitted to it.
Value follow_curve(Check& check, const syntax::Expr& expr, std::string_view name,
                   syntax::ExprId curve);

}  // namespace kadr::sema
