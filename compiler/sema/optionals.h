// optionals.h — not given is not zero: what is known about it, how it is asked and supplied.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// Reads an optional as if it were given: reports or emits the check.
Value require_given(Check& check, const Value& value, const SourceRange& range,
                    std::string_view name);
void check_unset(Check& check, const Value& value, std::string_view name, const SourceRange& range);
Value given(Check& check, const syntax::Expr& expr);
Value is_given(Check& check, const Value& value);
Value coalesce(Check& check, syntax::ExprId id, Type expected);
/// The value of a name, member or element without the check that it is given; sets
/// last_unset_ if the variable may be without a value.
Value unchecked(Check& check, syntax::ExprId id);
/// What a condition tells about optionals: inside `if (given b)`, b is given.
void assume_given(Check& check, syntax::ExprId condition, bool sense);

}  // namespace kadr::sema
