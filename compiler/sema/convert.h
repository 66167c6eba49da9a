// convert.h — units and dimensions: a value of one type where another one is wanted.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// The value, seen as of another type with the same registers.
Value retyped(Value value, Type type);

void check_places(Check& check, Type from, Type to, const SourceRange& range,
                  std::string_view what);
Value adapt_number(Check& check, const Value& value, Type target);
/// The value, converted to `target`; `what` names it in messages.
Value convert(Check& check, const Value& value, Type target, const SourceRange& range,
              std::string_view what);
bool is_plain_number(const Check& check, const Value& value);
bool is_diameter(const Check& check, const Value& value);
std::string quantity_name(const Check& check, Type type);
bool settle(Check& check, Value& value);
Value plain_form(Check& check, const Value& value, int form);
Value to_real(Check& check, const Value& value);

}  // namespace kadr::sema
