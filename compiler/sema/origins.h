// origins.h — numbers whose origin makes them a slip where an angle is wanted.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// Where a number in the source seems to come from: `0.7854` is an angle in radians.
Origin origin_of_literal(double number, std::string_view literal);

/// … what an operator makes of two values.
Origin origin_of_result(const Check& check, syntax::Operator op, const Value& left,
                        const Value& right);
/// Warns of radians where degrees are wanted, and of their like.
void warn_of_origin(Check& check, const Value& value, Type target, const SourceRange& range);

}  // namespace kadr::sema
