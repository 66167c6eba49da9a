// values.cpp — what an expression came to: constants and registers, and values moved between them.
#include "sema/values.h"

#include <algorithm>

#include "sema/checking.h"
#include "sema/convert.h"
#include "sema/expressions.h"
#include "sema/texts.h"

namespace kadr::sema {

using syntax::ExprId;

Value constant_number(double value, Type type) {
    Value result;
    result.form = Value::Form::Constant;
    result.type = type;
    result.constant.number = value;
    return result;
}

Value constant_integer(std::int64_t value, Type type) {
    Value result;
    result.form = Value::Form::Constant;
    result.type = type;
    result.constant.integer = value;
    return result;
}

Value constant_text(Check& check, std::string_view text) {
    return constant_integer(text_constant(check, text), types::kString);
}

Value in_registers(Type type, Reg reg) {
    Value result;
    result.form = Value::Form::InRegister;
    result.type = type;
    result.reg = reg;
    return result;
}

Value error_value() {
    Value result;
    result.form = Value::Form::Constant;
    result.type = types::kError;
    result.constant.integer = 0;
    return result;
}

std::optional<double> number_of(const Check& check, const Value& constant) {
    if (!constant.is_constant()) return std::nullopt;
    switch (check.kind(constant.type)) {
        case TypeKind::Int: return static_cast<double>(constant.constant.integer);
        case TypeKind::Real:
        case TypeKind::Feed:
        case TypeKind::Speed: return constant.constant.number;
        default: return std::nullopt;
    }
}

Reg in_register(Check& check, const Value& value, Reg hint) {
    if (value.form == Value::Form::InRegister && (hint == kNoReg || hint == value.reg)) {
        return value.reg;
    }
    const Reg reg = hint != kNoReg
                        ? hint
                        : check.emit.take(std::max<unsigned>(1, check.type_info(value.type).slots));
    copy_value(check, value, reg);
    return reg;
}

void copy_value(Check& check, const Value& value, Reg target) {
    if (value.form == Value::Form::InRegister) {
        const std::uint16_t slots = check.type_info(value.type).slots;
        if (value.reg != target) {
            if (slots == 1) check.emit.emit(OpCode::Move, target, value.reg);
            else if (slots > 1) check.emit.emit(OpCode::MoveN, target, value.reg, slots);
        }
        if (value.is_variable && !value.is_fresh && value.reg != target &&
            check.types.holds_array(value.type)) {
            if (check.kind(value.type) == TypeKind::Array)
                check.emit.emit(OpCode::CopyArray, target, target);
            else
                check.emit.emit_pair(OpCode::CopyParts, target, 0, 0,
                                     layout_constant(check, value.type));
        }
        return;
    }
    switch (check.kind(value.type)) {
        case TypeKind::String:
            if (value.constant.integer == kNotGivenInteger) {
                check.emit.emit_integer(OpCode::LoadI, target, 0, kNotGivenInteger);
            } else {
                check.emit.emit_pair(OpCode::LoadText, target, 0, 0, value.constant.integer);
            }
            break;
        case TypeKind::Real:
        case TypeKind::Feed:
        case TypeKind::Speed:
            check.emit.emit_number(OpCode::LoadF, target, 0, value.constant.number);
            break;
        default: check.emit.emit_integer(OpCode::LoadI, target, 0, value.constant.integer); break;
    }
}

void emit_unset(Check& check, Type type, Reg reg) {
    const TypeInfo& info = check.type_info(type);
    // An array that was not given a value is empty; a fixed one has all its elements, not given.
    if (info.kind == TypeKind::Array && !info.is_optional) {
        if (info.count < 0)
            check.emit.emit_pair(OpCode::NewArray, reg, 0, 0, layout_constant(check, info.element));
        else
            check.emit.emit_pair(OpCode::NewFixed, reg, 0, 0, layout_constant(check, info.element),
                                 info.count);
        return;
    }
    if (info.kind == TypeKind::Struct) {
        for (const Member& member : check.types.struct_of(type).members) {
            emit_unset(check, member.type, static_cast<Reg>(reg + member.offset));
        }
        return;
    }
    for (const SlotKind slot : check.types.layout(type)) {
        if (slot == SlotKind::Number)
            check.emit.emit_number(OpCode::LoadF, reg, 0, kNotGivenNumber);
        else check.emit.emit_integer(OpCode::LoadI, reg, 0, kNotGivenInteger);
        ++reg;
    }
}

Reg expression_in(Check& check, ExprId id, Type type, Reg reg, std::string_view what) {
    const Reg target = reg != kNoReg ? reg : check.emit.take(check.type_info(type).slots);
    const Reg mark = check.emit.mark();
    const Value value =
        convert(check, expression(check, id, type, target), type, check.ast()[id].range, what);
    if (!check.is_error(value)) copy_value(check, value, target);
    check.emit.release_to(mark);
    return target;
}

}  // namespace kadr::sema
