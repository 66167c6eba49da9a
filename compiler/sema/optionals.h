// optionals.h — not given is not zero: what is known about it, how it is asked and supplied.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// Reads an optional as if it were given: reports or emits the check.
Value require_given(Check& check, const Value& value, const SourceRange& range,
                    std::string_view name);
/// Emits checks that every part of a value is given when it is read; `name` is for the message.
void check_unset(Check& check, const Value& value, std::string_view name, const SourceRange& range);
/// `given a`.
Value given(Check& check, const syntax::Expr& expr);
/// Whether a value is given: a constant or a register; of a struct, whether one of its parts is.
Value is_given(Check& check, const Value& value);
/// `a ?? b`.
Value coalesce(Check& check, syntax::ExprId id, Type expected);
/// The value of a name, member or element without the check that it is given; sets
/// BodyState::last_unset if the variable may be without a value.
Value unchecked(Check& check, syntax::ExprId id);
/// What a condition tells about optionals: inside `if (given b)`, b is given.
void assume_given(Check& check, syntax::ExprId condition, bool sense);

}  // namespace kadr::sema
