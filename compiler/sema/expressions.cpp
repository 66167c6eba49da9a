// expressions.cpp — expressions by their kind: literals, names, `? :`.
#include <cmath>

#include "base/diagnostics/sema.h"
#include "sema/checker.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;

Value Checker::expression(ExprId id, Type expected, Reg hint) {
    if (!id.is_valid()) return error_value();
    const SourceRange before = emit_.location();
    emit_.set_location(ast()[id].range);
    const Value value = expression_kind(id, expected, hint);
    emit_.set_location(before);
    note_value(id, value);
    return value;
}

/// What an expression came to, for those who ask later; a literal says itself what it is.
void Checker::note_value(ExprId id, const Value& value) {
    const bool is_literal = ast()[id].kind <= ExprKind::String;
    if (!value.is_constant() || is_literal) return record_.note_type(module_, id, value.type);
    ConstantValue constant{value.type, value.constant, {}};
    const bool is_text = kind(value.type) == TypeKind::String;
    if (is_text && value.constant.integer != kNotGivenInteger) {
        constant.text = code_->texts[static_cast<std::size_t>(value.constant.integer)];
        constant.slot = {};
    }
    record_.note_value(module_, id, constant);
}

Value Checker::expression_kind(ExprId id, Type expected, Reg hint) {
    const Expr& expr = ast()[id];
    switch (expr.kind) {
        case ExprKind::Invalid: return error_value();
        case ExprKind::Bool: return constant_integer(expr.integer, types::kBool);
        case ExprKind::Int: return constant_integer(expr.integer, types::kInt);
        case ExprKind::Real: return number_literal(expr);
        case ExprKind::String: return string(id, hint);
        case ExprKind::Format: return expression(expr.child[0], expected, hint);
        case ExprKind::Name:
            // Where an optional is expected, not given is as good as a value.
            return type_info(expected).is_optional ? unchecked(id) : name_value(id, hint);
        case ExprKind::Unary:
            return expr.op >= Operator::PreIncrement && expr.op <= Operator::PostDecrement
                       ? step(id, true)
                       : unary(id, expected, hint);
        case ExprKind::Binary: return binary(id, expected, hint);
        case ExprKind::Conditional: return conditional(id, expected, hint);
        case ExprKind::Assign: return assign(id, true);
        case ExprKind::Call: return call(id, hint);
        case ExprKind::Argument: return expression(expr.child[0], expected, hint);
        case ExprKind::Index: {
            const std::optional<Lvalue> found = lvalue(id);
            return found ? load(*found, expr.range, true, hint) : error_value();
        }
        case ExprKind::Member: return member(id);
        case ExprKind::Given: return given(expr);
        case ExprKind::Braces: return braces(id, expected, hint);
        case ExprKind::Range: {
            const Reg reg = emit_.take(2);
            expression_in(expr.child[0], types::kInt, reg, "the start of the range");
            expression_in(expr.child[1], types::kInt, static_cast<Reg>(reg + 1),
                          "the end of the range");
            return in_registers(types::kRange, reg);
        }
        case ExprKind::TypedCall: return table(expr);
    }
    return error_value();
}

Value Checker::number_literal(const Expr& expr) {
    const UnitInfo unit = unit_info(expr.unit);
    if (expr.unit == syntax::Unit::None) {
        Value number = constant_number(expr.number, types::kReal);
        number.origin = origin_of_literal(expr.number, sources_.text(expr.range));
        return number;
    }
    // Exact where the unit's factor is the reciprocal of a whole number: 200mm/min is 200/60.
    const double inverse = 1.0 / unit.factor;
    const double whole = std::nearbyint(inverse);
    const bool divides = unit.factor < 1 && std::fabs(inverse - whole) < 1e-9;
    const double value = divides ? expr.number / whole : expr.number * unit.factor;
    return constant_number(value, types_.real(unit.quantity));
}

Value Checker::symbol_value(std::int32_t index, const SourceRange& range, bool checked) {
    Symbol& symbol = symbols_[static_cast<std::size_t>(index)];
    symbol.is_read = true;
    if (symbol.storage == Symbol::Storage::Constant) return symbol.constant;
    Value value = in_registers(symbol.type, symbol.reg);
    value.is_variable = true;
    value.origin = symbol.origin;
    const bool is_optional = type_info(symbol.type).is_optional;
    if (checked && symbol.givenness == Givenness::NotGiven &&
        (is_optional || symbol.may_be_unset)) {
        report(diag::NotGiven, range).arg(symbol.name).note(symbol.range, "it is declared here");
        symbol.givenness = Givenness::Perhaps;  // reported once
        return error_value();
    }
    if (is_optional && symbol.givenness == Givenness::Given && checked) {
        value.type = types_.given(value.type);
    }
    if (symbol.may_be_unset && symbol.givenness != Givenness::Given && checked && !is_optional) {
        check_unset(value, symbol.unset_name.empty() ? symbol.name : symbol.unset_name, range);
    }
    return value;
}

Value Checker::name_value(ExprId id, Reg hint) {
    const Expr& expr = ast()[id];
    const std::string_view name = text(expr.text);
    const Found found = look_up(id);
    if (found.symbol >= 0 &&
        symbols_[static_cast<std::size_t>(found.symbol)].storage != Symbol::Storage::Reference) {
        return symbol_value(found.symbol, expr.range, true);
    }
    if (found.symbol < 0 && found.name != nullptr) {
        check_unambiguous(name, expr.range);
        switch (found.name->what) {
            case Name::What::EnumMember:
                return constant_integer(found.name->member, found.name->type);
            case Name::What::Variable: {
                check_global(found.name->index, is_startup_);
                const Symbol& symbol = globals_[found.name->index].symbol;
                if (symbol.storage == Symbol::Storage::Constant) return symbol.constant;
                break;
            }
            case Name::What::Function:
                report(diag::FunctionAsValue, expr.range)
                    .arg(name)
                    .fix("call it: `" + std::string(name) + "(…)`");
                return error_value();
            case Name::What::Type:
                report(diag::TypeAsValue, expr.range).arg(name);
                return error_value();
            case Name::What::Curve:
                report(diag::CurveAsValue, expr.range).arg(name);
                return error_value();
        }
    }
    if (found.symbol < 0 && found.name == nullptr && name == "pi") {
        Value pi = constant_number(3.14159265358979323846, types::kReal);
        pi.origin = Origin::Radians;
        return pi;
    }
    if (found.symbol < 0 && found.name == nullptr && name == "position") {
        const Reg reg = emit_.take(3);
        for (unsigned i = 0; i < 3; ++i) emit_.emit(OpCode::Position, reg + i, 0, i);
        return in_registers(types::kPoint, reg);
    }
    const std::optional<Lvalue> lvalue = name_lvalue(id);
    return lvalue ? load(*lvalue, expr.range, true, hint) : error_value();
}

Value Checker::conditional(ExprId id, Type expected, Reg hint) {
    const Expr& expr = ast()[id];
    const Reg mark = emit_.mark();
    const Value condition =
        ast()[expr.child[0]].kind == ExprKind::Bool ? expression(expr.child[0]) : Value{};
    if (condition.is_constant() && kind(condition.type) == TypeKind::Bool) {
        // The other branch is checked, but leaves no code.
        const bool first = condition.constant.integer != 0;
        const ExprId other = expr.child[first ? 2 : 1];
        const std::size_t instructions = code_->instructions.size();
        const Value ignored = expression(other, expected);
        code_->instructions.resize(instructions);
        code_->locations.resize(instructions);
        emit_.release_to(mark);
        const Value chosen = expression(expr.child[first ? 1 : 2], expected, hint);
        if (is_error(ignored) || is_error(chosen)) return error_value();
        if (!types_.is_numeric(ignored.type) || !types_.is_numeric(chosen.type) ||
            kind(ignored.type) == TypeKind::Real) {
            const bool bare = ignored.is_constant() && type_info(ignored.type).quantity.is_number();
            if (!bare) convert(ignored, chosen.type, ast()[other].range, {});
        }
        return chosen;
    }
    Label otherwise;
    Label done;
    const std::vector<Givenness> before = remember_givenness();
    jump_if(expr.child[0], false, otherwise);
    assume_given(expr.child[0], true);
    emit_.release_to(mark);
    // Both branches end in the same registers; room is taken when the first one's type is known.
    const Value first = expression(expr.child[1], expected);
    if (is_error(first)) {
        emit_.bind(otherwise);
        expression(expr.child[2], expected);
        return error_value();
    }
    Type type = first.type;
    // `c ? 1 : 2.5` and `c ? 2.5 : n` are real, `c ? 0 : d` a length: the second branch decides
    // where it knows more.
    const auto is_bare = [&](const Value& v) {
        return v.is_constant() &&
               (kind(v.type) == TypeKind::Int ||
                (kind(v.type) == TypeKind::Real && type_info(v.type).quantity.is_number()));
    };
    if (expected != types::kError && kind(expected) != TypeKind::Error) {
        type = types_.is_numeric(first.type) && types_.is_numeric(expected) &&
                       (is_bare(first) || first.type == types::kInt)
                   ? expected
                   : first.type;
    } else if (is_bare(first) || first.type == types::kInt) {
        const Type second = type_of(expr.child[2]);
        const bool knows_less = second == types::kInt && kind(first.type) == TypeKind::Real;
        if (types_.is_numeric(second) && !knows_less) type = second;
    }
    if (kind(type) == TypeKind::Void) {
        report(diag::VoidValue, ast()[expr.child[1]].range);
        return error_value();
    }
    const std::uint16_t slots = type_info(type).slots;
    Value converted = convert(first, type, ast()[expr.child[1]].range, {});
    if (is_error(converted)) return error_value();
    Reg result = hint;
    if (result == kNoReg) {
        // The first value may stand in temporaries: keep those and put the result above.
        result = emit_.take(slots);
    }
    copy_value(converted, result);
    emit_.jump(OpCode::Jump, done);
    emit_.bind(otherwise);
    set_givenness(before);
    assume_given(expr.child[0], false);
    const Reg above = emit_.mark();
    Value second = expression(expr.child[2], type);
    second = convert(second, type, ast()[expr.child[2]].range, {});
    if (is_error(second)) return error_value();
    copy_value(second, result);
    emit_.release_to(above);
    emit_.bind(done);
    set_givenness(before);
    Value value = in_registers(type, result);
    value.is_fresh = types_.holds_array(type);
    return value;
}

/// The type of an expression: it is checked quietly, and the code is thrown away again.
Type Checker::type_of(ExprId id) {
    if (!id.is_valid()) return types::kError;
    // Each expression once: a chain of `? :` would otherwise be checked twice as often at each
    // link.
    const std::uint64_t key = std::uint64_t{module_} << 32 | id.index;
    if (const auto known = known_types_.find(key); known != known_types_.end())
        return known->second;
    const Trial trial(*this);
    const std::vector<Givenness> before = remember_givenness();
    const std::size_t instructions = code_->instructions.size();
    const Reg mark = emit_.mark();
    const Value value = expression(id);
    emit_.release_to(mark);
    code_->instructions.resize(instructions);
    code_->locations.resize(instructions);
    set_givenness(before);
    known_types_[key] = value.type;
    return value.type;
}

bool Checker::writes(ExprId id) {
    for (; id.is_valid() && ast()[id].is_chain_link(); id = ast()[id].child[0]) {
        if (writes(ast()[id].child[1])) return true;
    }
    if (!id.is_valid()) return false;
    const Expr& expr = ast()[id];
    switch (expr.kind) {
        case ExprKind::Assign: return true;
        case ExprKind::Unary:
            return expr.op >= Operator::PreIncrement && expr.op <= Operator::PostDecrement
                       ? true
                       : writes(expr.child[0]);
        case ExprKind::Call: return true;  // its references may write
        case ExprKind::Binary:
        case ExprKind::Conditional:
        case ExprKind::Index:
            return writes(expr.child[0]) || writes(expr.child[1]) || writes(expr.child[2]);
        default: return false;
    }
}

}  // namespace kadr::sema
