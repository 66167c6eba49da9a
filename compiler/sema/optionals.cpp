// optionals.cpp — not given is not zero: what is known about it, how it is asked and supplied.
#include <algorithm>
#include <iterator>

#include "base/diagnostics/sema.h"
#include "sema/checker.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;

Value Checker::require_given(const Value& value, const SourceRange& range, std::string_view name) {
    if (!type_info(value.type).is_optional) return value;
    Value given = value;
    given.type = types_.given(value.type);
    if (value.is_constant()) {
        report(diag::NotGiven, range).arg(name.empty() ? sources_.text(range) : name);
        return error_value();
    }
    const std::vector<SlotKind> layout = types_.layout(given.type);
    const SourceRange before = emit_.location();
    emit_.set_location(range);
    emit_.emit_pair(OpCode::CheckGiven, value.reg, 0, static_cast<unsigned>(layout[0]),
                    text_constant(name.empty() ? sources_.text(range) : name));
    emit_.set_location(before);
    return given;
}

void Checker::check_unset(const Value& value, std::string_view name, const SourceRange& range) {
    const SourceRange before = emit_.location();
    emit_.set_location(range);
    const auto check = [&](auto&& self, Type type, Reg reg, const std::string& path) -> void {
        if (type_info(type).is_optional) return;
        if (kind(type) == TypeKind::Struct) {
            for (const Member& member : types_.struct_of(type).members) {
                self(self, member.type, static_cast<Reg>(reg + member.offset),
                     path + '.' + member.name);
            }
            return;
        }
        const std::vector<SlotKind> layout = types_.layout(type);
        if (layout.size() != 1 || layout[0] == SlotKind::Array) return;
        emit_.emit_pair(OpCode::CheckGiven, reg, 0, static_cast<unsigned>(layout[0]),
                        text_constant(path));
    };
    check(check, value.type, value.reg, std::string(name));
    emit_.set_location(before);
}

Value Checker::given(const Expr& expr) {
    const ExprId operand = expr.child[0];
    const Expr& inner = ast()[operand];
    Value value;
    if (inner.kind == ExprKind::Name && look_up(operand).symbol >= 0) {
        const std::int32_t index = find(text(inner.text)).symbol;
        Symbol& symbol = symbols_[static_cast<std::size_t>(index)];
        symbol.is_read = true;
        if (symbol.storage == Symbol::Storage::Local) {
            value = in_registers(symbol.type, symbol.reg);
            if (!type_info(symbol.type).is_optional && !symbol.may_be_unset &&
                kind(symbol.type) != TypeKind::Struct) {
                report(diag::AlwaysGiven, expr.range).arg(symbol.name);
                return constant_integer(1, types::kBool);
            }
        }
    }
    if (value.form == Value::Form::None) {
        const std::optional<Lvalue> found = lvalue(operand);
        if (!found) return error_value();
        value = load(*found, inner.range, false, kNoReg);
    }
    return is_given(value);
}

Value Checker::is_given(const Value& value) {
    if (is_error(value)) return value;
    const std::vector<SlotKind> layout = types_.layout(value.type);
    const Reg reg = emit_.take(1);
    if (kind(value.type) != TypeKind::Struct) {
        emit_.emit(OpCode::IsGiven, reg, value.reg, static_cast<unsigned>(layout[0]));
        return in_registers(types::kBool, reg);
    }
    // A point is given as soon as one of its components is. A list in a struct is there from the
    // start and tells nothing, unless there is nothing else.
    const bool has_lists_only = std::ranges::count(layout, SlotKind::Array) == std::ssize(layout);
    emit_.emit_integer(OpCode::LoadI, reg, 0, 0);
    const Reg part = emit_.take(1);
    for (std::size_t i = 0; i < layout.size(); ++i) {
        if (layout[i] == SlotKind::Array && !has_lists_only) continue;
        emit_.emit(OpCode::IsGiven, part, static_cast<unsigned>(value.reg + i),
                   static_cast<unsigned>(layout[i]));
        emit_.emit(OpCode::OrI, reg, reg, part);
    }
    return in_registers(types::kBool, reg);
}

Value Checker::coalesce(ExprId id, Type expected) {
    const Expr& expr = ast()[id];
    const Expr& left = ast()[expr.child[0]];
    Value value;
    const bool is_path = left.kind == ExprKind::Name || left.kind == ExprKind::Index ||
                         left.kind == ExprKind::Member;
    value = is_path ? unchecked(expr.child[0]) : expression(expr.child[0], expected);
    if (is_error(value)) {
        expression(expr.child[1], expected);
        return error_value();
    }
    const bool may_be_missing =
        type_info(value.type).is_optional || last_unset_ || kind(value.type) == TypeKind::Struct;
    if (!may_be_missing) report(diag::AlwaysGiven, left.range).arg(sources_.text(left.range));
    const Type other_type = type_of(expr.child[1]);
    // `a ?? b` with an optional b stays optional.
    const bool stays_optional = type_info(other_type).is_optional;
    const Type plain = types_.given(value.type);
    const Type type = stays_optional ? types_.optional(plain) : plain;
    const std::uint16_t slots = type_info(plain).slots;
    const Reg result = emit_.take(slots);
    copy_value(value, result);
    Label done;
    if (kind(plain) == TypeKind::Struct) {
        const Value answer = is_given(in_registers(plain, result));
        emit_.jump(OpCode::JumpIf, done, answer.reg);
    } else {
        emit_.jump(OpCode::JumpGiven, done, result, 0,
                   static_cast<unsigned>(types_.layout(plain)[0]));
    }
    const Reg above = emit_.mark();
    const Value second =
        convert(expression(expr.child[1], plain), type, ast()[expr.child[1]].range, {});
    if (is_error(second)) return error_value();
    copy_value(second, result);
    emit_.release_to(above);
    emit_.bind(done);
    return in_registers(type, result);
}

Value Checker::unchecked(ExprId id) {
    const Value value = unchecked_kind(id);
    note_value(id, value);
    return value;
}

Value Checker::unchecked_kind(ExprId id) {
    last_unset_ = false;
    const Expr& expr = ast()[id];
    if (expr.kind == ExprKind::Name) {
        const Found found = look_up(id);
        if (found.symbol >= 0 &&
            symbols_[static_cast<std::size_t>(found.symbol)].storage == Symbol::Storage::Local) {
            last_unset_ = symbols_[static_cast<std::size_t>(found.symbol)].may_be_unset;
            return symbol_value(found.symbol, expr.range, false);
        }
        return name_value(id, kNoReg);
    }
    if (expr.kind == ExprKind::Member) {
        const Expr& owner = ast()[expr.child[0]];
        if (owner.kind == ExprKind::Name &&
            (text(owner.text) == "position" || text(owner.text) == "state") &&
            find(text(owner.text)).symbol < 0) {
            return member(id);
        }
    }
    const std::optional<Lvalue> found = lvalue(id);
    if (!found) return error_value();
    last_unset_ = found->may_be_unset;
    return load(*found, expr.range, false, kNoReg);
}

void Checker::assume_given(ExprId condition, bool sense) {
    const Expr& expr = ast()[condition];
    if (expr.kind == ExprKind::Unary && expr.op == Operator::Not) {
        assume_given(expr.child[0], !sense);
        return;
    }
    const bool splits = expr.kind == ExprKind::Binary && ((expr.op == Operator::And && sense) ||
                                                          (expr.op == Operator::Or && !sense));
    if (splits) {
        assume_given(expr.child[0], sense);
        assume_given(expr.child[1], sense);
        return;
    }
    if (expr.kind != ExprKind::Given || ast()[expr.child[0]].kind != ExprKind::Name) return;
    const Found found = find(text(ast()[expr.child[0]].text));
    if (found.symbol < 0) return;
    Symbol& symbol = symbols_[static_cast<std::size_t>(found.symbol)];
    if (symbol.storage != Symbol::Storage::Local || kind(symbol.type) == TypeKind::Struct) return;
    symbol.givenness = sense ? Givenness::Given : Givenness::NotGiven;
}

}  // namespace kadr::sema
