// values.cpp — what an expression came to: constants and registers, and values moved between them.
#include <algorithm>

#include "sema/checker.h"

namespace kadr::sema {

using syntax::ExprId;

Value Checker::constant_number(double value, Type type) const {
    Value result;
    result.form = Value::Form::Constant;
    result.type = type;
    result.constant.number = value;
    return result;
}

Value Checker::constant_integer(std::int64_t value, Type type) const {
    Value result;
    result.form = Value::Form::Constant;
    result.type = type;
    result.constant.integer = value;
    return result;
}

Value Checker::constant_text(std::string_view text) {
    return constant_integer(text_constant(text), types::kString);
}

Value Checker::in_registers(Type type, Reg reg) const {
    Value result;
    result.form = Value::Form::InRegister;
    result.type = type;
    result.reg = reg;
    return result;
}

Value Checker::error_value() const {
    Value result;
    result.form = Value::Form::Constant;
    result.type = types::kError;
    result.constant.integer = 0;
    return result;
}

std::optional<double> Checker::number_of(const Value& constant) const {
    if (!constant.is_constant()) return std::nullopt;
    switch (kind(constant.type)) {
        case TypeKind::Int: return static_cast<double>(constant.constant.integer);
        case TypeKind::Real:
        case TypeKind::Feed:
        case TypeKind::Speed: return constant.constant.number;
        default: return std::nullopt;
    }
}

Reg Checker::in_register(const Value& value, Reg hint) {
    if (value.form == Value::Form::InRegister && (hint == kNoReg || hint == value.reg)) {
        return value.reg;
    }
    const Reg reg =
        hint != kNoReg ? hint : emit_.take(std::max<unsigned>(1, type_info(value.type).slots));
    copy_value(value, reg);
    return reg;
}

void Checker::copy_value(const Value& value, Reg target) {
    if (value.form == Value::Form::InRegister) {
        const std::uint16_t slots = type_info(value.type).slots;
        if (value.reg != target) {
            if (slots == 1) emit_.emit(OpCode::Move, target, value.reg);
            else if (slots > 1) emit_.emit(OpCode::MoveN, target, value.reg, slots);
        }
        if (value.is_variable && !value.is_fresh && value.reg != target &&
            types_.holds_array(value.type)) {
            if (kind(value.type) == TypeKind::Array) emit_.emit(OpCode::CopyArray, target, target);
            else emit_.emit_pair(OpCode::CopyParts, target, 0, 0, layout_constant(value.type));
        }
        return;
    }
    switch (kind(value.type)) {
        case TypeKind::String:
            if (value.constant.integer == kNotGivenInteger) {
                emit_.emit_integer(OpCode::LoadI, target, 0, kNotGivenInteger);
            } else {
                emit_.emit_pair(OpCode::LoadText, target, 0, 0, value.constant.integer);
            }
            break;
        case TypeKind::Real:
        case TypeKind::Feed:
        case TypeKind::Speed:
            emit_.emit_number(OpCode::LoadF, target, 0, value.constant.number);
            break;
        default: emit_.emit_integer(OpCode::LoadI, target, 0, value.constant.integer); break;
    }
}

void Checker::emit_unset(Type type, Reg reg) {
    const TypeInfo& info = type_info(type);
    // An array that was not given a value is empty; a fixed one has all its elements, not given.
    if (info.kind == TypeKind::Array && !info.is_optional) {
        if (info.count < 0)
            emit_.emit_pair(OpCode::NewArray, reg, 0, 0, layout_constant(info.element));
        else
            emit_.emit_pair(OpCode::NewFixed, reg, 0, 0, layout_constant(info.element), info.count);
        return;
    }
    if (info.kind == TypeKind::Struct) {
        for (const Member& member : types_.struct_of(type).members) {
            emit_unset(member.type, static_cast<Reg>(reg + member.offset));
        }
        return;
    }
    for (const SlotKind slot : types_.layout(type)) {
        if (slot == SlotKind::Number) emit_.emit_number(OpCode::LoadF, reg, 0, kNotGivenNumber);
        else emit_.emit_integer(OpCode::LoadI, reg, 0, kNotGivenInteger);
        ++reg;
    }
}

Reg Checker::expression_in(ExprId id, Type type, Reg reg, std::string_view what) {
    const Reg target = reg != kNoReg ? reg : emit_.take(type_info(type).slots);
    const Reg mark = emit_.mark();
    const Value value = convert(expression(id, type, target), type, ast()[id].range, what);
    if (!is_error(value)) copy_value(value, target);
    emit_.release_to(mark);
    return target;
}

}  // namespace kadr::sema
