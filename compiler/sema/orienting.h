// orienting.h — `orient` and `tcp`: how the tool stands beside the words of a block.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// The point and the `orient(…)` behind the words of a block, in whatever order.
BehindWords behind_words(Check& check, const syntax::Stmt& stmt);
/// The direction that a call of `orient` gives, as a unit vector in the registers from `first`.
Done take_direction(Check& check, const syntax::Expr& expr, Reg first);
/// Adds the direction in the registers behind the plan's to the block.
Done add_direction(Check& check, Plan& plan, const SourceRange& range);
/// `orient(…)` as a block of its own.
Value orient_call(Check& check, const syntax::Expr& expr);
/// `tcp(…)`: tool centre point control on and off.
Value tcp_call(Check& check, const syntax::Expr& expr);

}  // namespace kadr::sema
