// optionals.cpp — not given is not zero: what is known about it, how it is asked and supplied.
#include "sema/optionals.h"

#include <algorithm>
#include <iterator>

#include "base/diagnostics/sema.h"
#include "sema/checking.h"
#include "sema/composites.h"
#include "sema/convert.h"
#include "sema/expressions.h"
#include "sema/library_tools.h"
#include "sema/lvalues.h"
#include "sema/scope.h"
#include "sema/texts.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;

namespace {

Value unchecked_kind(Check& check, syntax::ExprId id);

}  // namespace

Value require_given(Check& check, const Value& value, const SourceRange& range,
                    std::string_view name) {
    if (!check.type_info(value.type).is_optional) return value;
    Value given = value;
    given.type = check.types.given(value.type);
    if (value.is_constant()) {
        check.report(diag::NotGiven, range).arg(name.empty() ? check.sources.text(range) : name);
        return error_value();
    }
    const std::vector<SlotKind> layout = check.types.layout(given.type);
    const SourceRange before = check.emit.location();
    check.emit.set_location(range);
    check.emit.emit_pair(OpCode::CheckGiven, value.reg, 0, static_cast<unsigned>(layout[0]),
                         text_constant(check, name.empty() ? check.sources.text(range) : name));
    check.emit.set_location(before);
    return given;
}

void check_unset(Check& check, const Value& value, std::string_view name,
                 const SourceRange& range) {
    const SourceRange before = check.emit.location();
    check.emit.set_location(range);
    const auto check_parts = [&](auto&& self, Type type, Reg reg, const std::string& path) -> void {
        if (check.type_info(type).is_optional) return;
        if (check.kind(type) == TypeKind::Struct) {
            for (const Member& member : check.types.struct_of(type).members) {
                self(self, member.type, static_cast<Reg>(reg + member.offset),
                     path + '.' + member.name);
            }
            return;
        }
        const std::vector<SlotKind> layout = check.types.layout(type);
        if (layout.size() != 1 || layout[0] == SlotKind::Array) return;
        check.emit.emit_pair(OpCode::CheckGiven, reg, 0, static_cast<unsigned>(layout[0]),
                             text_constant(check, path));
    };
    check_parts(check_parts, value.type, value.reg, std::string(name));
    check.emit.set_location(before);
}

Value given(Check& check, const Expr& expr) {
    const ExprId operand = expr.child[0];
    const Expr& inner = check.ast()[operand];
    Value value;
    if (inner.kind == ExprKind::Name && look_up(check, operand).symbol >= 0) {
        const std::int32_t index = find(check, check.text(inner.text)).symbol;
        Symbol& symbol = check.scopes[index];
        symbol.is_read = true;
        if (symbol.storage == Symbol::Storage::Local) {
            value = in_registers(symbol.type, symbol.reg);
            if (!check.type_info(symbol.type).is_optional && !symbol.may_be_unset &&
                check.kind(symbol.type) != TypeKind::Struct) {
                check.report(diag::AlwaysGiven, expr.range).arg(symbol.name);
                return constant_integer(1, types::kBool);
            }
        }
    }
    if (inner.kind == ExprKind::Member && asks_library(check, inner.child[0])) {
        value = library_value(check, operand, inner.child[0], false);
        if (!check.type_info(value.type).is_optional) {
            if (!check.is_error(value))
                check.report(diag::AlwaysGiven, expr.range).arg(check.sources.text(inner.range));
            return constant_integer(1, types::kBool);
        }
    }
    if (value.form == Value::Form::None) {
        const std::optional<Lvalue> found = lvalue(check, operand);
        if (!found) return error_value();
        value = load(check, *found, inner.range, false, kNoReg);
    }
    return is_given(check, value);
}

Value is_given(Check& check, const Value& value) {
    if (check.is_error(value)) return value;
    const std::vector<SlotKind> layout = check.types.layout(value.type);
    const Reg reg = check.emit.take(1);
    if (check.kind(value.type) != TypeKind::Struct) {
        check.emit.emit(OpCode::IsGiven, reg, value.reg, static_cast<unsigned>(layout[0]));
        return in_registers(types::kBool, reg);
    }
    // A point is given as soon as one of its components is. A list in a struct is there from the
    // start and tells nothing, unless there is nothing else.
    const bool has_lists_only = std::ranges::count(layout, SlotKind::Array) == std::ssize(layout);
    check.emit.emit_integer(OpCode::LoadI, reg, 0, 0);
    const Reg part = check.emit.take(1);
    for (std::size_t i = 0; i < layout.size(); ++i) {
        if (layout[i] == SlotKind::Array && !has_lists_only) continue;
        check.emit.emit(OpCode::IsGiven, part, static_cast<unsigned>(value.reg + i),
                        static_cast<unsigned>(layout[i]));
        check.emit.emit(OpCode::OrI, reg, reg, part);
    }
    return in_registers(types::kBool, reg);
}

Value coalesce(Check& check, ExprId id, Type expected) {
    const Expr& expr = check.ast()[id];
    const Expr& left = check.ast()[expr.child[0]];
    Value value;
    const bool is_path = left.kind == ExprKind::Name || left.kind == ExprKind::Index ||
                         left.kind == ExprKind::Member;
    value = is_path ? unchecked(check, expr.child[0]) : expression(check, expr.child[0], expected);
    if (check.is_error(value)) {
        expression(check, expr.child[1], expected);
        return error_value();
    }
    const bool may_be_missing = check.type_info(value.type).is_optional || check.body.last_unset ||
                                check.kind(value.type) == TypeKind::Struct;
    if (!may_be_missing)
        check.report(diag::AlwaysGiven, left.range).arg(check.sources.text(left.range));
    const Type other_type = type_of(check, expr.child[1]);
    // `a ?? b` with an optional b stays optional.
    const bool stays_optional = check.type_info(other_type).is_optional;
    const Type plain = check.types.given(value.type);
    const Type type = stays_optional ? check.types.optional(plain) : plain;
    const std::uint16_t slots = check.type_info(plain).slots;
    const Reg result = check.emit.take(slots);
    copy_value(check, value, result);
    Label done;
    if (check.kind(plain) == TypeKind::Struct) {
        const Value answer = is_given(check, in_registers(plain, result));
        check.emit.jump(OpCode::JumpIf, done, answer.reg);
    } else {
        check.emit.jump(OpCode::JumpGiven, done, result, 0,
                        static_cast<unsigned>(check.types.layout(plain)[0]));
    }
    const Reg above = check.emit.mark();
    const Value second = convert(check, expression(check, expr.child[1], plain), type,
                                 check.ast()[expr.child[1]].range, {});
    if (check.is_error(second)) return error_value();
    copy_value(check, second, result);
    check.emit.release_to(above);
    check.emit.bind(done);
    return in_registers(type, result);
}

Value unchecked(Check& check, ExprId id) {
    const Value value = unchecked_kind(check, id);
    note_value(check, id, value);
    return value;
}

namespace {

Value unchecked_kind(Check& check, ExprId id) {
    check.body.last_unset = false;
    const Expr& expr = check.ast()[id];
    if (expr.kind == ExprKind::Name) {
        const Found found = look_up(check, id);
        if (found.symbol >= 0 && check.scopes[found.symbol].storage == Symbol::Storage::Local) {
            check.body.last_unset = check.scopes[found.symbol].may_be_unset;
            return symbol_value(check, found.symbol, expr.range, false);
        }
        return name_value(check, id, kNoReg);
    }
    if (expr.kind == ExprKind::Member) {
        if (asks_library(check, expr.child[0]))
            return library_value(check, id, expr.child[0], false);
        const Expr& owner = check.ast()[expr.child[0]];
        if (owner.kind == ExprKind::Name &&
            (check.text(owner.text) == "position" || check.text(owner.text) == "state") &&
            find(check, check.text(owner.text)).symbol < 0) {
            return member(check, id);
        }
    }
    const std::optional<Lvalue> found = lvalue(check, id);
    if (!found) return error_value();
    check.body.last_unset = found->may_be_unset;
    return load(check, *found, expr.range, false, kNoReg);
}

}  // namespace

void assume_given(Check& check, ExprId condition, bool sense) {
    const Expr& expr = check.ast()[condition];
    if (expr.kind == ExprKind::Unary && expr.op == Operator::Not) {
        assume_given(check, expr.child[0], !sense);
        return;
    }
    const bool splits = expr.kind == ExprKind::Binary && ((expr.op == Operator::And && sense) ||
                                                          (expr.op == Operator::Or && !sense));
    if (splits) {
        assume_given(check, expr.child[0], sense);
        assume_given(check, expr.child[1], sense);
        return;
    }
    if (expr.kind != ExprKind::Given || check.ast()[expr.child[0]].kind != ExprKind::Name) return;
    const Found found = find(check, check.text(check.ast()[expr.child[0]].text));
    if (found.symbol < 0) return;
    Symbol& symbol = check.scopes[found.symbol];
    if (symbol.storage != Symbol::Storage::Local || check.kind(symbol.type) == TypeKind::Struct)
        return;
    symbol.givenness = sense ? Givenness::Given : Givenness::NotGiven;
}

}  // namespace kadr::sema
