// convert.h — units and dimensions: a value of one type where another one is wanted.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// The value, seen as of another type with the same registers.
Value retyped(Value value, Type type);

/// Reports that a value of one type stands where another one is needed.
void check_places(Check& check, Type from, Type to, const SourceRange& range,
                  std::string_view what);
/// A number as `target`, where both are numeric: units, int to real.
Value adapt_number(Check& check, const Value& value, Type target);
/// The value, converted to `target`; `what` names it in messages.
Value convert(Check& check, const Value& value, Type target, const SourceRange& range,
              std::string_view what);
/// Whether a value is an int or a real without a dimension.
bool is_plain_number(const Check& check, const Value& value);
/// Whether a value measures across a part.
bool is_diameter(const Check& check, const Value& value);
/// A type as messages name it: `length`, `feed`, `mm²`.
std::string quantity_name(const Check& check, Type type);
/// A feed or speed times something that has come to be a feed or speed again is made one (`f*d/d`);
/// false: it has not.
bool settle(Check& check, Value& value);
/// A feed or speed as the plain quantity of one of its forms (0 or 1), checked when it runs.
Value plain_form(Check& check, const Value& value, int form);
/// A whole number as a real one; others stay.
Value to_real(Check& check, const Value& value);

}  // namespace kadr::sema
