// origins.h — numbers whose origin makes them a slip where an angle is wanted.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

Origin origin_of_literal(double number, std::string_view literal);

Origin origin_of_result(const Check& check, syntax::Operator op, const Value& left,
                        const Value& right);
void warn_of_origin(Check& check, const Value& value, Type target, const SourceRange& range);

}  // namespace kadr::sema
