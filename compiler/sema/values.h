// values.h — values: constants, registers, copies.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// A constant of a numeric type, in the unit of registers: mm, degrees, s.
Value constant_number(double value, Type type);
/// A constant of a type that whole numbers hold: int, bool, an enum.
Value constant_integer(std::int64_t value, Type type);
/// A text constant.
Value constant_text(Check& check, std::string_view text);
/// A value that stands in the registers from `reg`.
Value in_registers(Type type, Reg reg);
/// What an expression with a mistake comes to: it fits everywhere, so that one mistake is one
/// message.
Value error_value();
/// A numeric constant as a real number; nothing: it is none.
std::optional<double> number_of(const Check& check, const Value& constant);
/// The first register of a value: a constant is loaded into `hint`, or into registers that are
/// taken.
Reg in_register(Check& check, const Value& value, Reg hint = kNoReg);
/// Puts a value into the registers from `target`; an array that somebody else holds is copied.
void copy_value(Check& check, const Value& value, Reg target);
/// Puts what is not given into the registers of a type; arrays are empty.
void emit_unset(Check& check, Type type, Reg reg);
/// An expression where a type is wanted: converted and in registers `reg` (taken if none).
Reg expression_in(Check& check, syntax::ExprId id, Type type, Reg reg, std::string_view what);

}  // namespace kadr::sema
