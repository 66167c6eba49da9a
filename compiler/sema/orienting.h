// orienting.h — `orient` and `tcp`: how the tool stands beside the words of a block.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

BehindWords behind_words(Check& check, const syntax::Stmt& stmt);
Done take_direction(Check& check, const syntax::Expr& expr, Reg first);
Done add_direction(Check& check, Plan& plan, const SourceRange& range);
Value orient_call(Check& check, const syntax::Expr& expr);
Value tcp_call(Check& check, const syntax::Expr& expr);

}  // namespace kadr::sema
