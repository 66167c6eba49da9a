// builtin_calls.h — the functions that the language has by itself: NC's mathematics, conversions.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// Reports a call of the language with another number of arguments, or with named ones.
Done require_argument_count(Check& check, const syntax::Expr& expr, std::string_view name,
                            std::size_t least, std::size_t most);
/// A numeric argument; nothing, with a message, if it is none.
std::optional<Value> numeric_argument(Check& check, syntax::ExprId argument, std::string_view name);
/// A call of a function that the language has by itself; nothing: it has none of that name.
std::optional<Value> builtin(Check& check, std::string_view name, const syntax::Expr& expr,
                             Reg hint);

}  // namespace kadr::sema
