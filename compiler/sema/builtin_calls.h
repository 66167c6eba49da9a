// builtin_calls.h — the functions that the language has by itself: NC's mathematics, conversions.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

Done require_argument_count(Check& check, const syntax::Expr& expr, std::string_view name,
                            std::size_t least, std::size_t most);
std::optional<Value> numeric_argument(Check& check, syntax::ExprId argument, std::string_view name);
std::optional<Value> builtin(Check& check, std::string_view name, const syntax::Expr& expr,
                             Reg hint);

}  // namespace kadr::sema
