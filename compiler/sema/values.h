// values.h — values: constants, registers, copies.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

Value constant_number(double value, Type type);
Value constant_integer(std::int64_t value, Type type);
Value constant_text(Check& check, std::string_view text);
Value in_registers(Type type, Reg reg);
Value error_value();
std::optional<double> number_of(const Check& check, const Value& constant);
Reg in_register(Check& check, const Value& value, Reg hint = kNoReg);
void copy_value(Check& check, const Value& value, Reg target);
void emit_unset(Check& check, Type type, Reg reg);
/// An expression where a type is wanted: converted and in registers `reg` (taken if none).
Reg expression_in(Check& check, syntax::ExprId id, Type type, Reg reg, std::string_view what);

}  // namespace kadr::sema
