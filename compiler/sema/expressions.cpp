// expressions.cpp — expressions by their kind: literals, names, `? :`.
#include "sema/expressions.h"

#include <cmath>

#include "base/diagnostics/sema.h"
#include "sema/calls.h"
#include "sema/checking.h"
#include "sema/composites.h"
#include "sema/conditions.h"
#include "sema/convert.h"
#include "sema/globals.h"
#include "sema/library_tools.h"
#include "sema/lvalues.h"
#include "sema/operators.h"
#include "sema/optionals.h"
#include "sema/origins.h"
#include "sema/scope.h"
#include "sema/texts.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;

namespace {

Value expression_kind(Check& check, syntax::ExprId id, Type expected, Reg hint);
Value number_literal(Check& check, const syntax::Expr& expr);
Value conditional(Check& check, syntax::ExprId id, Type expected, Reg hint);

}  // namespace

Value expression(Check& check, ExprId id, Type expected, Reg hint) {
    if (!id.is_valid()) return error_value();
    const SourceRange before = check.emit.location();
    check.emit.set_location(check.ast()[id].range);
    const Value value = expression_kind(check, id, expected, hint);
    check.emit.set_location(before);
    note_value(check, id, value);
    return value;
}

/// What an expression came to, for those who ask later; a literal says itself what it is.
void note_value(Check& check, ExprId id, const Value& value) {
    const bool is_literal = check.ast()[id].kind <= ExprKind::String;
    if (!value.is_constant() || is_literal)
        return check.record.note_type(check.here.module, id, value.type);
    ConstantValue constant{value.type, value.constant, {}};
    const bool is_text = check.kind(value.type) == TypeKind::String;
    if (is_text && value.constant.integer != kNotGivenInteger) {
        constant.text = check.code->texts[static_cast<std::size_t>(value.constant.integer)];
        constant.slot = {};
    }
    check.record.note_value(check.here.module, id, constant);
}

namespace {

Value expression_kind(Check& check, ExprId id, Type expected, Reg hint) {
    const Expr& expr = check.ast()[id];
    switch (expr.kind) {
        case ExprKind::Invalid: return error_value();
        case ExprKind::Bool: return constant_integer(expr.integer, types::kBool);
        case ExprKind::Int: return constant_integer(expr.integer, types::kInt);
        case ExprKind::Real: return number_literal(check, expr);
        case ExprKind::String: return string(check, id, hint);
        case ExprKind::Format: return expression(check, expr.child[0], expected, hint);
        case ExprKind::Name:
            // Where an optional is expected, not given is as good as a value.
            return check.type_info(expected).is_optional ? unchecked(check, id)
                                                         : name_value(check, id, hint);
        case ExprKind::Unary:
            return expr.op >= Operator::PreIncrement && expr.op <= Operator::PostDecrement
                       ? step(check, id, true)
                       : unary(check, id, expected, hint);
        case ExprKind::Binary: return binary(check, id, expected, hint);
        case ExprKind::Conditional: return conditional(check, id, expected, hint);
        case ExprKind::Assign: return assign(check, id, true);
        case ExprKind::Call: return call(check, id, hint);
        case ExprKind::Argument: return expression(check, expr.child[0], expected, hint);
        case ExprKind::Index: {
            const std::optional<Lvalue> found = lvalue(check, id);
            return found ? load(check, *found, expr.range, true, hint) : error_value();
        }
        case ExprKind::Member:
            return check.type_info(expected).is_optional && asks_library(check, expr.child[0])
                       ? library_value(check, id, expr.child[0], false)
                       : member(check, id);
        case ExprKind::Given: return given(check, expr);
        case ExprKind::Braces: return braces(check, id, expected, hint);
        case ExprKind::Range: {
            const Reg reg = check.emit.take(2);
            expression_in(check, expr.child[0], types::kInt, reg, "the start of the range");
            expression_in(check, expr.child[1], types::kInt, static_cast<Reg>(reg + 1),
                          "the end of the range");
            return in_registers(types::kRange, reg);
        }
        case ExprKind::TypedCall: return table(check, expr);
    }
    return error_value();
}

Value number_literal(Check& check, const Expr& expr) {
    const UnitInfo unit = unit_info(expr.unit);
    if (expr.unit == syntax::Unit::None) {
        Value number = constant_number(expr.number, types::kReal);
        number.origin = origin_of_literal(expr.number, check.sources.text(expr.range));
        return number;
    }
    // Exact where the unit's factor is the reciprocal of a whole number: 200mm/min is 200/60.
    const double inverse = 1.0 / unit.factor;
    const double whole = std::nearbyint(inverse);
    const bool divides = unit.factor < 1 && std::fabs(inverse - whole) < 1e-9;
    const double value = divides ? expr.number / whole : expr.number * unit.factor;
    return constant_number(value, check.types.real(unit.quantity));
}

}  // namespace

Value symbol_value(Check& check, std::int32_t index, const SourceRange& range, bool checked) {
    Symbol& symbol = check.scopes[index];
    symbol.is_read = true;
    if (symbol.storage == Symbol::Storage::Constant) return symbol.constant;
    Value value = in_registers(symbol.type, symbol.reg);
    value.is_variable = true;
    value.origin = symbol.origin;
    const bool is_optional = check.type_info(symbol.type).is_optional;
    if (checked && symbol.givenness == Givenness::NotGiven &&
        (is_optional || symbol.may_be_unset)) {
        check.report(diag::NotGiven, range)
            .arg(symbol.name)
            .note(symbol.range, "it is declared here");
        symbol.givenness = Givenness::Perhaps;  // reported once
        return error_value();
    }
    if (is_optional && symbol.givenness == Givenness::Given && checked) {
        value.type = check.types.given(value.type);
    }
    if (symbol.may_be_unset && symbol.givenness != Givenness::Given && checked && !is_optional) {
        check_unset(check, value, symbol.unset_name.empty() ? symbol.name : symbol.unset_name,
                    range);
    }
    return value;
}

Value name_value(Check& check, ExprId id, Reg hint) {
    const Expr& expr = check.ast()[id];
    const std::string_view name = check.text(expr.text);
    const Found found = look_up(check, id);
    if (found.symbol >= 0 && check.scopes[found.symbol].storage != Symbol::Storage::Reference) {
        return symbol_value(check, found.symbol, expr.range, true);
    }
    if (found.symbol < 0 && found.name != nullptr) {
        check_unambiguous(check, name, expr.range);
        switch (found.name->what) {
            case Name::What::EnumMember:
                return constant_integer(found.name->member, found.name->type);
            case Name::What::Variable: {
                check_global(check, found.name->index, check.here.is_startup);
                const Symbol& symbol = check.names.global(found.name->index).symbol;
                if (symbol.storage == Symbol::Storage::Constant) return symbol.constant;
                break;
            }
            case Name::What::Function:
                check.report(diag::FunctionAsValue, expr.range)
                    .arg(name)
                    .fix("call it: `" + std::string(name) + "(…)`");
                return error_value();
            case Name::What::Type:
                check.report(diag::TypeAsValue, expr.range).arg(name);
                return error_value();
            case Name::What::Curve:
                check.report(diag::CurveAsValue, expr.range).arg(name);
                return error_value();
        }
    }
    if (found.symbol < 0 && found.name == nullptr && name == "pi") {
        Value pi = constant_number(3.14159265358979323846, types::kReal);
        pi.origin = Origin::Radians;
        return pi;
    }
    if (found.symbol < 0 && found.name == nullptr && name == "position") {
        const Reg reg = check.emit.take(3);
        for (unsigned i = 0; i < 3; ++i) check.emit.emit(OpCode::Position, reg + i, 0, i);
        return in_registers(types::kPoint, reg);
    }
    const std::optional<Lvalue> lvalue = name_lvalue(check, id);
    return lvalue ? load(check, *lvalue, expr.range, true, hint) : error_value();
}

namespace {

Value conditional(Check& check, ExprId id, Type expected, Reg hint) {
    const Expr& expr = check.ast()[id];
    const Reg mark = check.emit.mark();
    const Value condition = check.ast()[expr.child[0]].kind == ExprKind::Bool
                                ? expression(check, expr.child[0])
                                : Value{};
    if (condition.is_constant() && check.kind(condition.type) == TypeKind::Bool) {
        // The other branch is checked, but leaves no code.
        const bool first = condition.constant.integer != 0;
        const ExprId other = expr.child[first ? 2 : 1];
        const std::size_t instructions = check.code->instructions.size();
        const Value ignored = expression(check, other, expected);
        check.code->instructions.resize(instructions);
        check.code->locations.resize(instructions);
        check.emit.release_to(mark);
        const Value chosen = expression(check, expr.child[first ? 1 : 2], expected, hint);
        if (check.is_error(ignored) || check.is_error(chosen)) return error_value();
        if (!check.types.is_numeric(ignored.type) || !check.types.is_numeric(chosen.type) ||
            check.kind(ignored.type) == TypeKind::Real) {
            const bool bare =
                ignored.is_constant() && check.type_info(ignored.type).quantity.is_number();
            if (!bare) convert(check, ignored, chosen.type, check.ast()[other].range, {});
        }
        return chosen;
    }
    Label otherwise;
    Label done;
    const FlowState before = check.scopes.flow();
    jump_if(check, expr.child[0], false, otherwise);
    assume_given(check, expr.child[0], true);
    check.emit.release_to(mark);
    // Both branches end in the same registers; room is taken when the first one's type is known.
    const Value first = expression(check, expr.child[1], expected);
    if (check.is_error(first)) {
        check.emit.bind(otherwise);
        expression(check, expr.child[2], expected);
        return error_value();
    }
    Type type = first.type;
    // `c ? 1 : 2.5` and `c ? 2.5 : n` are real, `c ? 0 : d` a length: the second branch decides
    // where it knows more.
    const auto is_bare = [&](const Value& v) {
        return v.is_constant() && (check.kind(v.type) == TypeKind::Int ||
                                   (check.kind(v.type) == TypeKind::Real &&
                                    check.type_info(v.type).quantity.is_number()));
    };
    if (expected != types::kError && check.kind(expected) != TypeKind::Error) {
        type = check.types.is_numeric(first.type) && check.types.is_numeric(expected) &&
                       (is_bare(first) || first.type == types::kInt)
                   ? expected
                   : first.type;
    } else if (is_bare(first) || first.type == types::kInt) {
        const Type second = type_of(check, expr.child[2]);
        const bool knows_less = second == types::kInt && check.kind(first.type) == TypeKind::Real;
        if (check.types.is_numeric(second) && !knows_less) type = second;
    }
    if (check.kind(type) == TypeKind::Void) {
        check.report(diag::VoidValue, check.ast()[expr.child[1]].range);
        return error_value();
    }
    const std::uint16_t slots = check.type_info(type).slots;
    Value converted = convert(check, first, type, check.ast()[expr.child[1]].range, {});
    if (check.is_error(converted)) return error_value();
    Reg result = hint;
    if (result == kNoReg) {
        // The first value may stand in temporaries: keep those and put the result above.
        result = check.emit.take(slots);
    }
    copy_value(check, converted, result);
    check.emit.jump(OpCode::Jump, done);
    check.emit.bind(otherwise);
    check.scopes.set_flow(before);
    assume_given(check, expr.child[0], false);
    const Reg above = check.emit.mark();
    Value second = expression(check, expr.child[2], type);
    second = convert(check, second, type, check.ast()[expr.child[2]].range, {});
    if (check.is_error(second)) return error_value();
    copy_value(check, second, result);
    check.emit.release_to(above);
    check.emit.bind(done);
    check.scopes.set_flow(before);
    Value value = in_registers(type, result);
    value.is_fresh = check.types.holds_array(type);
    return value;
}

}  // namespace

/// The type of an expression: it is checked quietly, and the code is thrown away again.
Type type_of(Check& check, ExprId id) {
    if (!id.is_valid()) return types::kError;
    // Each expression once: a chain of `? :` would otherwise be checked twice as often at each
    // link.
    const std::uint64_t key = std::uint64_t{check.here.module} << 32 | id.index;
    if (const auto known = check.pools.known_types.find(key);
        known != check.pools.known_types.end())
        return known->second;
    const DryRun dry_run(check);
    const FlowState before = check.scopes.flow();
    const std::size_t instructions = check.code->instructions.size();
    const Reg mark = check.emit.mark();
    const Value value = expression(check, id);
    check.emit.release_to(mark);
    check.code->instructions.resize(instructions);
    check.code->locations.resize(instructions);
    check.scopes.set_flow(before);
    check.pools.known_types[key] = value.type;
    return value.type;
}

bool writes(Check& check, ExprId id) {
    for (; id.is_valid() && check.ast()[id].is_chain_link(); id = check.ast()[id].child[0]) {
        if (writes(check, check.ast()[id].child[1])) return true;
    }
    if (!id.is_valid()) return false;
    const Expr& expr = check.ast()[id];
    switch (expr.kind) {
        case ExprKind::Assign: return true;
        case ExprKind::Unary:
            return expr.op >= Operator::PreIncrement && expr.op <= Operator::PostDecrement
                       ? true
                       : writes(check, expr.child[0]);
        case ExprKind::Call: return true;  // its references may write
        case ExprKind::Binary:
        case ExprKind::Conditional:
        case ExprKind::Index:
            return writes(check, expr.child[0]) || writes(check, expr.child[1]) ||
                   writes(check, expr.child[2]);
        default: return false;
    }
}

}  // namespace kadr::sema
