// conditions.cpp — comparison and logic, as jumps where a statement asks and as values elsewhere.
#include "sema/conditions.h"

#include "base/diagnostics/sema.h"
#include "sema/checking.h"
#include "sema/convert.h"
#include "sema/expressions.h"
#include "sema/operators.h"
#include "sema/optionals.h"
#include "sema/scope.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;

namespace {

Value contains_struct(Check& check, const Value& array, const Value& part);

}  // namespace

namespace {

bool is_comparison(Operator op) { return op >= Operator::Less && op <= Operator::NotEqual; }

}  // namespace

/// Whether a value is what a table, a list that is gone through or the caller gave, and nothing has
/// been worked out of it.
bool is_as_given(const Check& check, ExprId id) {
    while (check.ast()[id].kind == ExprKind::Member || check.ast()[id].kind == ExprKind::Index)
        id = check.ast()[id].child[0];
    if (check.ast()[id].kind == ExprKind::TypedCall) return true;
    if (check.ast()[id].kind != ExprKind::Name) return false;
    const Found found = find(check, check.text(check.ast()[id].text));
    if (found.symbol >= 0) {
        const Symbol& symbol = check.scopes[found.symbol];
        return (symbol.is_parameter || symbol.is_row) && !symbol.is_assigned;
    }
    if (found.name == nullptr || found.name->what != Name::What::Variable) return false;
    const GlobalVariable& global = check.names.global(found.name->index);
    const syntax::Ast& tree = *check.names.module(global.module).ast;
    const ExprId initial = tree[global.decl].value;
    return global.symbol.is_const && initial.is_valid() &&
           tree[initial].kind == ExprKind::TypedCall;
}

namespace {

/// Real numbers that were calculated are hardly ever equal. What the user gave, a parameter or a
/// row of a table, and constants may be compared: they are the same number or they are not.
void warn_equality(Check& check, const Expr& expr, const Value& left, const Value& right) {
    if (check.here.module != 0 || check.here.function == nullptr) return;
    if (!check.types.is_numeric(left.type) || !check.types.is_numeric(right.type)) return;
    if (check.kind(left.type) == TypeKind::Int && check.kind(right.type) == TypeKind::Int) return;
    // `0.1 + 0.2` is a constant that carries rounding like any other sum.
    const auto is_calculated = [&](const Value& value, ExprId id) {
        // Whole numbers have no rounding; a minus changes none.
        while (check.ast()[id].kind == ExprKind::Unary) id = check.ast()[id].child[0];
        const ExprKind form = check.ast()[id].kind;
        return check.kind(value.type) != TypeKind::Int && form != ExprKind::Real &&
               form != ExprKind::Int && form != ExprKind::Name && form != ExprKind::Member;
    };
    const auto is_given_here = [&](const Value& value, ExprId id) {
        return (value.is_constant() && !is_calculated(value, id)) || is_as_given(check, id);
    };
    if (left.is_constant() && right.is_constant()) return;
    if (is_given_here(left, expr.child[0]) && is_given_here(right, expr.child[1])) return;
    check.report(diag::RealEquality, expr.range)
        .arg(spelling(expr.op))
        .fix(expr.op == Operator::Equal
                 ? "compare with a tolerance: `abs(a - b) < 0.001mm`, or with `<=` or `>=`"
                 : "compare with a tolerance: `abs(a - b) > 0.001mm`, or with `<` or `>`");
}

std::optional<ComparedSides> comparison(Check& check, const Expr& expr) {
    const std::optional<Sides> sides = compared_sides(check, expr);
    if (!sides) return std::nullopt;
    const bool is_equality = expr.op == Operator::Equal || expr.op == Operator::NotEqual;
    std::optional<ComparedSides> found = compare(check, expr, sides->left, sides->right);
    if (found && is_equality) warn_equality(check, expr, sides->left, sides->right);
    return found;
}

}  // namespace

/// Both sides of a comparison, each evaluated once and given.
std::optional<Sides> compared_sides(Check& check, const Expr& expr) {
    const SourceRange left_range = check.ast()[expr.child[0]].range;
    const SourceRange right_range = check.ast()[expr.child[1]].range;
    Value left = expression(check, expr.child[0]);
    if (left.is_variable && writes(check, expr.child[1])) {
        const Reg copy = check.emit.take(check.type_info(left.type).slots);
        left.is_fresh = true;
        copy_value(check, left, copy);
        left = in_registers(left.type, copy);
    }
    const bool is_braces = check.ast()[expr.child[1]].kind == ExprKind::Braces;
    Value right = expression(check, expr.child[1], is_braces ? left.type : types::kError);
    if (check.is_error(left) || check.is_error(right)) return std::nullopt;
    left = require_given(check, left, left_range, {});
    right = require_given(check, right, right_range, {});
    if (check.is_error(left) || check.is_error(right)) return std::nullopt;
    return Sides{left, right};
}

namespace {

/// Equal if every part is; parts that are not given are equal to each other.
void emit_equality(Check& check, Type type, Reg left, Reg right, Reg all) {
    const std::vector<SlotKind> layout = check.types.layout(type);
    const Reg part = check.emit.take(1);
    check.emit.emit_integer(OpCode::LoadI, all, 0, 1);
    for (std::size_t i = 0; i < layout.size(); ++i) {
        check.emit
            .emit(OpCode::EqualPart, part, static_cast<unsigned>(left + i),
                  static_cast<unsigned>(right + i))
            .immediate.pair = {static_cast<std::int32_t>(layout[i]), 0};
        check.emit.emit(OpCode::AndI, all, all, part);
    }
}

}  // namespace

std::optional<ComparedSides> compare(Check& check, const Expr& expr, Value left, Value right) {
    ComparedSides result;
    result.op = expr.op;
    const bool is_equality = expr.op == Operator::Equal || expr.op == Operator::NotEqual;
    const TypeKind a = check.kind(left.type);
    const TypeKind b = check.kind(right.type);
    if (check.types.is_numeric(left.type) && check.types.is_numeric(right.type)) {
        if (a == TypeKind::Int && b == TypeKind::Int) {
            result.left = left;
            result.right = right;
            return result;
        }
        if (!match_quantities(check, left, right, expr)) return std::nullopt;
        const bool is_family =
            check.kind(left.type) == TypeKind::Feed || check.kind(left.type) == TypeKind::Speed;
        result.is_real = true;
        result.left = to_real(check, left);
        result.right = to_real(check, right);
        if (is_family && !(left.is_constant() && right.is_constant())) {
            result.left = in_registers(left.type, in_register(check, result.left));
            result.right = in_registers(right.type, in_register(check, result.right));
            check.emit.emit(OpCode::SameForm, result.left.reg, result.right.reg);
        }
        return result;
    }
    if (a == TypeKind::String && b == TypeKind::String) {
        if (left.is_constant() && right.is_constant()) {
            const int order =
                check.code->texts[static_cast<std::size_t>(left.constant.integer)].compare(
                    check.code->texts[static_cast<std::size_t>(right.constant.integer)]);
            result.left = constant_integer(order, types::kInt);
            result.right = constant_integer(0, types::kInt);
            return result;
        }
        const Reg x = in_register(check, left);
        const Reg y = in_register(check, right);
        const Reg reg = check.emit.take(1);
        check.emit.emit(OpCode::CompareText, reg, x, y);
        result.left = in_registers(types::kInt, reg);
        result.right = constant_integer(0, types::kInt);
        return result;
    }
    if (is_equality && left.type == right.type && (a == TypeKind::Bool || a == TypeKind::Enum)) {
        result.left = left;
        result.right = right;
        return result;
    }
    if (is_equality && left.type == right.type && a == TypeKind::Struct &&
        !check.types.holds_array(left.type)) {
        const Reg all = check.emit.take(1);
        emit_equality(check, left.type, left.reg, right.reg, all);
        result.left = in_registers(types::kBool, all);
        result.right = constant_integer(1, types::kBool);
        return result;
    }
    auto message = check.report(diag::OperandPair, expr.range);
    message.arg(spelling(expr.op)).arg(check.type_name(left.type)).arg(check.type_name(right.type));
    // `1 < n < 3`: the first comparison is a truth value.
    const Expr& first = check.ast()[expr.child[0]];
    const bool is_chain =
        a == TypeKind::Bool && first.kind == ExprKind::Binary && is_comparison(first.op);
    if (is_chain) {
        const auto written = [&](ExprId id) {
            return std::string(check.sources.text(check.ast()[id].range));
        };
        const std::string both = std::string(check.sources.text(first.range)) + " && " +
                                 written(first.child[1]) + ' ' + std::string(spelling(expr.op)) +
                                 ' ' + written(expr.child[1]);
        message.fix(expr.range, both, "each comparison stands by itself");
    }
    return std::nullopt;
}

void jump_compare(Check& check, const ComparedSides& comparison, bool sense, Label& label,
                  int depth) {
    Operator op = comparison.op;
    Value left = comparison.left;
    Value right = comparison.right;
    if (!sense) {
        // Numbers that are not given never get here, so the opposite of < is >=.
        switch (op) {
            case Operator::Less: op = Operator::GreaterEqual; break;
            case Operator::LessEqual: op = Operator::Greater; break;
            case Operator::Greater: op = Operator::LessEqual; break;
            case Operator::GreaterEqual: op = Operator::Less; break;
            case Operator::Equal: op = Operator::NotEqual; break;
            default: op = Operator::Equal; break;
        }
    }
    const auto mirrored = [](Operator o) {
        switch (o) {
            case Operator::Less: return Operator::Greater;
            case Operator::LessEqual: return Operator::GreaterEqual;
            case Operator::Greater: return Operator::Less;
            case Operator::GreaterEqual: return Operator::LessEqual;
            default: return o;
        }
    };
    const bool is_loop = depth >= 0;
    const int second = is_loop ? depth : 0;
    if (!comparison.is_real) {
        if (left.is_constant() && !right.is_constant()) {
            std::swap(left, right);
            op = mirrored(op);
        }
        const bool small = right.is_constant() && right.constant.integer >= -32768 &&
                           right.constant.integer <= 32767;
        if (small && !left.is_constant()) {
            const auto k =
                static_cast<std::uint16_t>(static_cast<std::int16_t>(right.constant.integer));
            OpCode code = OpCode::JumpEqIK;
            switch (op) {
                case Operator::Less: code = is_loop ? OpCode::LoopLtIK : OpCode::JumpLtIK; break;
                case Operator::LessEqual:
                    code = is_loop ? OpCode::LoopLeIK : OpCode::JumpLeIK;
                    break;
                case Operator::Greater: code = is_loop ? OpCode::LoopGtIK : OpCode::JumpGtIK; break;
                case Operator::GreaterEqual:
                    code = is_loop ? OpCode::LoopGeIK : OpCode::JumpGeIK;
                    break;
                case Operator::NotEqual:
                    code = is_loop ? OpCode::LoopNeIK : OpCode::JumpNeIK;
                    break;
                default: break;
            }
            if (code != OpCode::JumpEqIK || !is_loop) {
                check.emit.jump(code, label, left.reg, 0, k, second);
                return;
            }
        }
    }
    if (op == Operator::Greater || op == Operator::GreaterEqual) {
        std::swap(left, right);
        op = mirrored(op);
    }
    const Reg x = in_register(check, left);
    const Reg y = in_register(check, right);
    const bool real = comparison.is_real;
    if (is_loop && (op == Operator::Equal || (real && op == Operator::NotEqual))) {
        // Rare at the end of a loop: compare, then the general form.
        const Reg answer = check.emit.take(1);
        const OpCode code =
            real ? (op == Operator::Equal ? OpCode::EqF : OpCode::NeF) : OpCode::EqI;
        check.emit.emit(code, answer, x, y);
        check.emit.jump(OpCode::LoopIf, label, answer, 0, 0, second);
        return;
    }
    OpCode code = OpCode::JumpEqI;
    switch (op) {
        case Operator::Less:
            code = is_loop ? (real ? OpCode::LoopLtF : OpCode::LoopLtI)
                           : (real ? OpCode::JumpLtF : OpCode::JumpLtI);
            break;
        case Operator::LessEqual:
            code = is_loop ? (real ? OpCode::LoopLeF : OpCode::LoopLeI)
                           : (real ? OpCode::JumpLeF : OpCode::JumpLeI);
            break;
        case Operator::NotEqual:
            code = is_loop ? OpCode::LoopNeI : (real ? OpCode::JumpNeF : OpCode::JumpNeI);
            break;
        default: code = real ? OpCode::JumpEqF : OpCode::JumpEqI; break;
    }
    check.emit.jump(code, label, x, y, 0, second);
}

namespace {

template <typename T>
bool holds(Operator op, T a, T b) {
    switch (op) {
        case Operator::Less: return a < b;
        case Operator::LessEqual: return a <= b;
        case Operator::Greater: return a > b;
        case Operator::GreaterEqual: return a >= b;
        case Operator::Equal: return a == b;
        default: return a != b;
    }
}

void check_condition(Check& check, const Value& value, const SourceRange& range) {
    if (check.is_error(value) || check.kind(value.type) == TypeKind::Bool) return;
    auto message = check.report(diag::ConditionType, range);
    message.arg(check.type_name(value.type));
    if (check.kind(value.type) != TypeKind::Int && check.kind(value.type) != TypeKind::Real) return;
    const std::string_view source = check.sources.text(range.file);
    const std::string operand(check.sources.text(range));
    const std::size_t before = source.substr(0, range.begin).find_last_not_of(" \t\r\n");
    const std::size_t behind = source.find_first_not_of(" \t\r\n", range.end);
    const bool is_negated = before != source.npos && source[before] == '!';
    const bool is_compared = behind != source.npos && source.substr(behind).starts_with("==");
    if (is_negated && is_compared)
        message.fix("`!` denies what stands directly behind it: `" + operand + " != …` compares");
    else if (is_negated)
        message.fix("compare it: `" + operand + " == 0` in place of `!" + operand + '`');
    else if (operand[0] >= '0' && operand[0] <= '9')  // `n == 2 || 3`
        message.fix("a comparison says both sides, as `n == " + operand + '`');
    else message.fix("compare it: `" + operand + " != 0`");
}

}  // namespace

void jump_if(Check& check, ExprId id, bool sense, Label& label, int depth) {
    const Expr& expr = check.ast()[id];
    const SourceRange before = check.emit.location();
    check.emit.set_location(expr.range);
    const Reg mark = check.emit.mark();
    const bool is_loop = depth >= 0;
    const int second = is_loop ? depth : 0;
    const auto jump_constant = [&](bool truth) {
        if (truth == sense)
            check.emit.jump(is_loop ? OpCode::Loop : OpCode::Jump, label, 0, 0, 0, second);
    };
    if (expr.kind == ExprKind::Unary && expr.op == Operator::Not) {
        jump_if(check, expr.child[0], !sense, label, depth);
    } else if (expr.kind == ExprKind::Binary &&
               (expr.op == Operator::And || expr.op == Operator::Or)) {
        const bool stops_early = (expr.op == Operator::And) != sense;
        const FlowState states = check.scopes.flow();
        if (stops_early) {
            // `a && b` is false as soon as a is: both jump there.
            jump_if(check, expr.child[0], sense, label, depth);
            assume_given(check, expr.child[0], !sense);
            jump_if(check, expr.child[1], sense, label, depth);
        } else {
            Label past;
            jump_if(check, expr.child[0], !sense, past);
            assume_given(check, expr.child[0], sense);
            jump_if(check, expr.child[1], sense, label, depth);
            check.emit.bind(past);
        }
        check.scopes.set_flow(states);
    } else if (expr.kind == ExprKind::Binary && is_comparison(expr.op)) {
        if (const std::optional<ComparedSides> found = comparison(check, expr)) {
            if (found->left.is_constant() && found->right.is_constant()) {
                jump_constant(found->is_real ? holds(expr.op, found->left.constant.number,
                                                     found->right.constant.number)
                                             : holds(expr.op, found->left.constant.integer,
                                                     found->right.constant.integer));
            } else if (check.kind(found->left.type) == TypeKind::Bool &&
                       !found->right.is_constant() && expr.op != Operator::Equal &&
                       expr.op != Operator::NotEqual) {
                check_condition(check, found->left, expr.range);
            } else {
                jump_compare(check, *found, sense, label, depth);
            }
        }
    } else {
        const Value value = require_given(check, expression(check, id), expr.range, {});
        check_condition(check, value, expr.range);
        if (value.is_constant()) {
            if (!check.is_error(value)) jump_constant(value.constant.integer != 0);
        } else {
            const OpCode code = is_loop ? (sense ? OpCode::LoopIf : OpCode::LoopIfNot)
                                        : (sense ? OpCode::JumpIf : OpCode::JumpIfNot);
            check.emit.jump(code, label, value.reg, 0, 0, second);
        }
    }
    check.emit.release_to(mark);
    check.emit.set_location(before);
}

/// A condition as a value: `bool b = x < y && z;`.
Value truth(Check& check, ExprId id, Reg hint) {
    const Expr& expr = check.ast()[id];
    if (expr.kind == ExprKind::Unary) {
        const Value value = require_given(check, expression(check, expr.child[0]), expr.range, {});
        check_condition(check, value, check.ast()[expr.child[0]].range);
        if (check.is_error(value) || check.kind(value.type) != TypeKind::Bool) return error_value();
        if (value.is_constant())
            return constant_integer(value.constant.integer == 0 ? 1 : 0, types::kBool);
        const Reg reg = hint != kNoReg ? hint : check.emit.take(1);
        check.emit.emit(OpCode::Not, reg, value.reg);
        return in_registers(types::kBool, reg);
    }
    if (is_comparison(expr.op)) {
        const std::size_t errors = check.sink.errors;
        const std::optional<ComparedSides> found = comparison(check, expr);
        if (!found) return errors == check.sink.errors ? error_value() : error_value();
        if (found->left.is_constant() && found->right.is_constant()) {
            const bool answer =
                found->is_real
                    ? holds(expr.op, found->left.constant.number, found->right.constant.number)
                    : holds(expr.op, found->left.constant.integer, found->right.constant.integer);
            return constant_integer(answer ? 1 : 0, types::kBool);
        }
        Value left = found->left;
        Value right = found->right;
        Operator op = expr.op;
        if (op == Operator::Greater || op == Operator::GreaterEqual) {
            std::swap(left, right);
            op = op == Operator::Greater ? Operator::Less : Operator::LessEqual;
        }
        const Reg x = in_register(check, left);
        const Reg y = in_register(check, right);
        const Reg reg = hint != kNoReg ? hint : check.emit.take(1);
        const bool real = found->is_real;
        const OpCode code = op == Operator::Less        ? (real ? OpCode::LtF : OpCode::LtI)
                            : op == Operator::LessEqual ? (real ? OpCode::LeF : OpCode::LeI)
                            : op == Operator::Equal     ? (real ? OpCode::EqF : OpCode::EqI)
                                                        : (real ? OpCode::NeF : OpCode::NeI);
        check.emit.emit(code, reg, x, y);
        return in_registers(types::kBool, reg);
    }
    // && and ||: jumps, so that the right side runs only when it decides. The result gets a
    // register of its own: the hint may be read by the condition itself.
    const Reg reg = check.emit.take(1);
    Label no;
    Label done;
    jump_if(check, id, false, no);
    check.emit.emit_integer(OpCode::LoadI, reg, 0, 1);
    check.emit.jump(OpCode::Jump, done);
    check.emit.bind(no);
    check.emit.emit_integer(OpCode::LoadI, reg, 0, 0);
    check.emit.bind(done);
    return in_registers(types::kBool, reg);
}

Value contains(Check& check, const Expr& expr, Reg hint) {
    const Value whole = require_given(check, expression(check, expr.child[0]),
                                      check.ast()[expr.child[0]].range, {});
    const Type element = check.kind(whole.type) == TypeKind::Array
                             ? check.type_info(whole.type).element
                             : whole.type;
    Value part = expression(check, expr.child[1], element);
    if (check.is_error(whole) || check.is_error(part)) return error_value();
    const SourceRange range = check.ast()[expr.child[1]].range;
    if (check.kind(whole.type) == TypeKind::String) {
        part = convert(check, part, types::kString, range, {});
        if (check.is_error(part)) return part;
        const Reg x = in_register(check, whole);
        const Reg y = in_register(check, part);
        const Reg reg = hint != kNoReg ? hint : check.emit.take(1);
        check.emit.emit(OpCode::ContainsText, reg, x, y);
        return in_registers(types::kBool, reg);
    }
    if (check.kind(whole.type) == TypeKind::Array && check.type_info(element).slots == 1) {
        part = convert(check, part, element, range, {});
        if (check.is_error(part)) return part;
        const Reg x = in_register(check, whole);
        const Reg y = in_register(check, part);
        const Reg reg = hint != kNoReg ? hint : check.emit.take(1);
        check.emit.emit(OpCode::ContainsElement, reg, x, y);
        return in_registers(types::kBool, reg);
    }
    if (check.kind(whole.type) == TypeKind::Array && check.kind(element) == TypeKind::Struct &&
        !check.types.holds_array(element)) {
        part = convert(check, part, element, range, {});
        return check.is_error(part) ? part : contains_struct(check, whole, part);
    }
    check.report(diag::OperandType, check.ast()[expr.child[0]].range)
        .arg("contains")
        .arg(check.type_name(whole.type));
    return error_value();
}

namespace {

/// One element after the other, until one is equal.
Value contains_struct(Check& check, const Value& array, const Value& part) {
    const Type element = check.type_info(array.type).element;
    const Reg wanted = in_register(check, part);
    const Reg found = check.emit.take(1);
    const Reg index = check.emit.take(2);  // and the number of elements
    const auto count = static_cast<Reg>(index + 1);
    const Reg item = check.emit.take(check.type_info(element).slots);
    Label top;
    Label done;
    check.emit.emit_integer(OpCode::LoadI, found, 0, 0);
    check.emit.emit_integer(OpCode::LoadI, index, 0, 0);
    check.emit.emit(OpCode::CountArray, count, array.reg);
    check.emit.bind(top);
    check.emit.jump(OpCode::JumpLeI, done, count, index);
    check.emit.emit_pair(OpCode::LoadElementN, item, array.reg, index, 0,
                         check.type_info(element).slots);
    const Reg mark = check.emit.mark();
    emit_equality(check, element, item, wanted, found);
    check.emit.release_to(mark);
    check.emit.jump(OpCode::JumpIf, done, found);
    check.emit.emit_integer(OpCode::AddIK, index, index, 1);
    check.emit.jump(OpCode::Jump, top);
    check.emit.bind(done);
    return in_registers(types::kBool, found);
}

}  // namespace

}  // namespace kadr::sema
