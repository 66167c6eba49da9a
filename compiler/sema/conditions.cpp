// conditions.cpp — comparison and logic, as jumps where a statement asks and as values elsewhere.
#include "base/diagnostics/sema.h"
#include "sema/checker.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;

namespace {

bool is_comparison(Operator op) { return op >= Operator::Less && op <= Operator::NotEqual; }

}  // namespace

/// Whether a value is what a table, a list that is gone through or the caller gave, and nothing has
/// been worked out of it.
bool Checker::is_as_given(ExprId id) const {
    while (ast()[id].kind == ExprKind::Member || ast()[id].kind == ExprKind::Index)
        id = ast()[id].child[0];
    if (ast()[id].kind == ExprKind::TypedCall) return true;
    if (ast()[id].kind != ExprKind::Name) return false;
    const Found found = find(text(ast()[id].text));
    if (found.symbol >= 0) {
        const Symbol& symbol = symbols_[static_cast<std::size_t>(found.symbol)];
        return (symbol.is_parameter || symbol.is_row) && !symbol.is_assigned;
    }
    if (found.name == nullptr || found.name->what != Name::What::Variable) return false;
    const GlobalVariable& global = globals_[found.name->index];
    const syntax::Ast& tree = *modules_[global.module].ast;
    const ExprId initial = tree[global.decl].value;
    return global.symbol.is_const && initial.is_valid() &&
           tree[initial].kind == ExprKind::TypedCall;
}

/// Real numbers that were calculated are hardly ever equal. What the user gave, a parameter or a
/// row of a table, and constants may be compared: they are the same number or they are not.
void Checker::warn_equality(const Expr& expr, const Value& left, const Value& right) {
    if (module_ != 0 || function_ == nullptr) return;
    if (!types_.is_numeric(left.type) || !types_.is_numeric(right.type)) return;
    if (kind(left.type) == TypeKind::Int && kind(right.type) == TypeKind::Int) return;
    // `0.1 + 0.2` is a constant that carries rounding like any other sum.
    const auto is_calculated = [&](const Value& value, ExprId id) {
        // Whole numbers have no rounding; a minus changes none.
        while (ast()[id].kind == ExprKind::Unary) id = ast()[id].child[0];
        const ExprKind form = ast()[id].kind;
        return kind(value.type) != TypeKind::Int && form != ExprKind::Real &&
               form != ExprKind::Int && form != ExprKind::Name && form != ExprKind::Member;
    };
    const auto is_given_here = [&](const Value& value, ExprId id) {
        return (value.is_constant() && !is_calculated(value, id)) || is_as_given(id);
    };
    if (left.is_constant() && right.is_constant()) return;
    if (is_given_here(left, expr.child[0]) && is_given_here(right, expr.child[1])) return;
    report(diag::RealEquality, expr.range)
        .arg(spelling(expr.op))
        .fix(expr.op == Operator::Equal
                 ? "compare with a tolerance: `abs(a - b) < 0.001mm`, or with `<=` or `>=`"
                 : "compare with a tolerance: `abs(a - b) > 0.001mm`, or with `<` or `>`");
}

std::optional<Checker::ComparedSides> Checker::comparison(const Expr& expr) {
    const std::optional<Sides> sides = compared_sides(expr);
    if (!sides) return std::nullopt;
    const bool is_equality = expr.op == Operator::Equal || expr.op == Operator::NotEqual;
    std::optional<ComparedSides> found = compare(expr, sides->left, sides->right);
    if (found && is_equality) warn_equality(expr, sides->left, sides->right);
    return found;
}

/// Both sides of a comparison, each evaluated once and given.
std::optional<Checker::Sides> Checker::compared_sides(const Expr& expr) {
    const SourceRange left_range = ast()[expr.child[0]].range;
    const SourceRange right_range = ast()[expr.child[1]].range;
    Value left = expression(expr.child[0]);
    if (left.is_variable && writes(expr.child[1])) {
        const Reg copy = emit_.take(type_info(left.type).slots);
        left.is_fresh = true;
        copy_value(left, copy);
        left = in_registers(left.type, copy);
    }
    const bool is_braces = ast()[expr.child[1]].kind == ExprKind::Braces;
    Value right = expression(expr.child[1], is_braces ? left.type : types::kError);
    if (is_error(left) || is_error(right)) return std::nullopt;
    left = require_given(left, left_range, {});
    right = require_given(right, right_range, {});
    if (is_error(left) || is_error(right)) return std::nullopt;
    return Sides{left, right};
}

/// Equal if every part is; parts that are not given are equal to each other.
void Checker::emit_equality(Type type, Reg left, Reg right, Reg all) {
    const std::vector<SlotKind> layout = types_.layout(type);
    const Reg part = emit_.take(1);
    emit_.emit_integer(OpCode::LoadI, all, 0, 1);
    for (std::size_t i = 0; i < layout.size(); ++i) {
        emit_
            .emit(OpCode::EqualPart, part, static_cast<unsigned>(left + i),
                  static_cast<unsigned>(right + i))
            .immediate.pair = {static_cast<std::int32_t>(layout[i]), 0};
        emit_.emit(OpCode::AndI, all, all, part);
    }
}

std::optional<Checker::ComparedSides> Checker::compare(const Expr& expr, Value left, Value right) {
    ComparedSides result;
    result.op = expr.op;
    const bool is_equality = expr.op == Operator::Equal || expr.op == Operator::NotEqual;
    const TypeKind a = kind(left.type);
    const TypeKind b = kind(right.type);
    if (types_.is_numeric(left.type) && types_.is_numeric(right.type)) {
        if (a == TypeKind::Int && b == TypeKind::Int) {
            result.left = left;
            result.right = right;
            return result;
        }
        if (!match_quantities(left, right, expr)) return std::nullopt;
        const bool is_family =
            kind(left.type) == TypeKind::Feed || kind(left.type) == TypeKind::Speed;
        result.is_real = true;
        result.left = to_real(left);
        result.right = to_real(right);
        if (is_family && !(left.is_constant() && right.is_constant())) {
            result.left = in_registers(left.type, in_register(result.left));
            result.right = in_registers(right.type, in_register(result.right));
            emit_.emit(OpCode::SameForm, result.left.reg, result.right.reg);
        }
        return result;
    }
    if (a == TypeKind::String && b == TypeKind::String) {
        if (left.is_constant() && right.is_constant()) {
            const int order = code_->texts[static_cast<std::size_t>(left.constant.integer)].compare(
                code_->texts[static_cast<std::size_t>(right.constant.integer)]);
            result.left = constant_integer(order, types::kInt);
            result.right = constant_integer(0, types::kInt);
            return result;
        }
        const Reg x = in_register(left);
        const Reg y = in_register(right);
        const Reg reg = emit_.take(1);
        emit_.emit(OpCode::CompareText, reg, x, y);
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
        !types_.holds_array(left.type)) {
        const Reg all = emit_.take(1);
        emit_equality(left.type, left.reg, right.reg, all);
        result.left = in_registers(types::kBool, all);
        result.right = constant_integer(1, types::kBool);
        return result;
    }
    auto message = report(diag::OperandPair, expr.range);
    message.arg(spelling(expr.op)).arg(type_name(left.type)).arg(type_name(right.type));
    // `1 < n < 3`: the first comparison is a truth value.
    const Expr& first = ast()[expr.child[0]];
    const bool is_chain =
        a == TypeKind::Bool && first.kind == ExprKind::Binary && is_comparison(first.op);
    if (is_chain) {
        const auto written = [&](ExprId id) { return std::string(sources_.text(ast()[id].range)); };
        const std::string both = std::string(sources_.text(first.range)) + " && " +
                                 written(first.child[1]) + ' ' + std::string(spelling(expr.op)) +
                                 ' ' + written(expr.child[1]);
        message.fix(expr.range, both, "each comparison stands by itself");
    }
    return std::nullopt;
}

void Checker::jump_compare(const ComparedSides& comparison, bool sense, Label& label, int depth) {
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
                emit_.jump(code, label, left.reg, 0, k, second);
                return;
            }
        }
    }
    if (op == Operator::Greater || op == Operator::GreaterEqual) {
        std::swap(left, right);
        op = mirrored(op);
    }
    const Reg x = in_register(left);
    const Reg y = in_register(right);
    const bool real = comparison.is_real;
    if (is_loop && (op == Operator::Equal || (real && op == Operator::NotEqual))) {
        // Rare at the end of a loop: compare, then the general form.
        const Reg answer = emit_.take(1);
        const OpCode code =
            real ? (op == Operator::Equal ? OpCode::EqF : OpCode::NeF) : OpCode::EqI;
        emit_.emit(code, answer, x, y);
        emit_.jump(OpCode::LoopIf, label, answer, 0, 0, second);
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
    emit_.jump(code, label, x, y, 0, second);
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

}  // namespace

void Checker::check_condition(const Value& value, const SourceRange& range) {
    if (is_error(value) || kind(value.type) == TypeKind::Bool) return;
    auto message = report(diag::ConditionType, range);
    message.arg(type_name(value.type));
    if (kind(value.type) != TypeKind::Int && kind(value.type) != TypeKind::Real) return;
    const std::string_view source = sources_.text(range.file);
    const std::string operand(sources_.text(range));
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

void Checker::jump_if(ExprId id, bool sense, Label& label, int depth) {
    const Expr& expr = ast()[id];
    const SourceRange before = emit_.location();
    emit_.set_location(expr.range);
    const Reg mark = emit_.mark();
    const bool is_loop = depth >= 0;
    const int second = is_loop ? depth : 0;
    const auto jump_constant = [&](bool truth) {
        if (truth == sense)
            emit_.jump(is_loop ? OpCode::Loop : OpCode::Jump, label, 0, 0, 0, second);
    };
    if (expr.kind == ExprKind::Unary && expr.op == Operator::Not) {
        jump_if(expr.child[0], !sense, label, depth);
    } else if (expr.kind == ExprKind::Binary &&
               (expr.op == Operator::And || expr.op == Operator::Or)) {
        const bool stops_early = (expr.op == Operator::And) != sense;
        const std::vector<Givenness> states = remember_givenness();
        if (stops_early) {
            // `a && b` is false as soon as a is: both jump there.
            jump_if(expr.child[0], sense, label, depth);
            assume_given(expr.child[0], !sense);
            jump_if(expr.child[1], sense, label, depth);
        } else {
            Label past;
            jump_if(expr.child[0], !sense, past);
            assume_given(expr.child[0], sense);
            jump_if(expr.child[1], sense, label, depth);
            emit_.bind(past);
        }
        set_givenness(states);
    } else if (expr.kind == ExprKind::Binary && is_comparison(expr.op)) {
        if (const std::optional<ComparedSides> found = comparison(expr)) {
            if (found->left.is_constant() && found->right.is_constant()) {
                jump_constant(found->is_real ? holds(expr.op, found->left.constant.number,
                                                     found->right.constant.number)
                                             : holds(expr.op, found->left.constant.integer,
                                                     found->right.constant.integer));
            } else if (kind(found->left.type) == TypeKind::Bool && !found->right.is_constant() &&
                       expr.op != Operator::Equal && expr.op != Operator::NotEqual) {
                check_condition(found->left, expr.range);
            } else {
                jump_compare(*found, sense, label, depth);
            }
        }
    } else {
        const Value value = require_given(expression(id), expr.range, {});
        check_condition(value, expr.range);
        if (value.is_constant()) {
            if (!is_error(value)) jump_constant(value.constant.integer != 0);
        } else {
            const OpCode code = is_loop ? (sense ? OpCode::LoopIf : OpCode::LoopIfNot)
                                        : (sense ? OpCode::JumpIf : OpCode::JumpIfNot);
            emit_.jump(code, label, value.reg, 0, 0, second);
        }
    }
    emit_.release_to(mark);
    emit_.set_location(before);
}

/// A condition as a value: `bool b = x < y && z;`.
Value Checker::truth(ExprId id, Reg hint) {
    const Expr& expr = ast()[id];
    if (expr.kind == ExprKind::Unary) {
        const Value value = require_given(expression(expr.child[0]), expr.range, {});
        check_condition(value, ast()[expr.child[0]].range);
        if (is_error(value) || kind(value.type) != TypeKind::Bool) return error_value();
        if (value.is_constant())
            return constant_integer(value.constant.integer == 0 ? 1 : 0, types::kBool);
        const Reg reg = hint != kNoReg ? hint : emit_.take(1);
        emit_.emit(OpCode::Not, reg, value.reg);
        return in_registers(types::kBool, reg);
    }
    if (is_comparison(expr.op)) {
        const std::size_t errors = sink_.errors;
        const std::optional<ComparedSides> found = comparison(expr);
        if (!found) return errors == sink_.errors ? error_value() : error_value();
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
        const Reg x = in_register(left);
        const Reg y = in_register(right);
        const Reg reg = hint != kNoReg ? hint : emit_.take(1);
        const bool real = found->is_real;
        const OpCode code = op == Operator::Less        ? (real ? OpCode::LtF : OpCode::LtI)
                            : op == Operator::LessEqual ? (real ? OpCode::LeF : OpCode::LeI)
                            : op == Operator::Equal     ? (real ? OpCode::EqF : OpCode::EqI)
                                                        : (real ? OpCode::NeF : OpCode::NeI);
        emit_.emit(code, reg, x, y);
        return in_registers(types::kBool, reg);
    }
    // && and ||: jumps, so that the right side runs only when it decides. The result gets a
    // register of its own: the hint may be read by the condition itself.
    const Reg reg = emit_.take(1);
    Label no;
    Label done;
    jump_if(id, false, no);
    emit_.emit_integer(OpCode::LoadI, reg, 0, 1);
    emit_.jump(OpCode::Jump, done);
    emit_.bind(no);
    emit_.emit_integer(OpCode::LoadI, reg, 0, 0);
    emit_.bind(done);
    return in_registers(types::kBool, reg);
}

Value Checker::contains(const Expr& expr, Reg hint) {
    const Value whole = require_given(expression(expr.child[0]), ast()[expr.child[0]].range, {});
    const Type element =
        kind(whole.type) == TypeKind::Array ? type_info(whole.type).element : whole.type;
    Value part = expression(expr.child[1], element);
    if (is_error(whole) || is_error(part)) return error_value();
    const SourceRange range = ast()[expr.child[1]].range;
    if (kind(whole.type) == TypeKind::String) {
        part = convert(part, types::kString, range, {});
        if (is_error(part)) return part;
        const Reg x = in_register(whole);
        const Reg y = in_register(part);
        const Reg reg = hint != kNoReg ? hint : emit_.take(1);
        emit_.emit(OpCode::ContainsText, reg, x, y);
        return in_registers(types::kBool, reg);
    }
    if (kind(whole.type) == TypeKind::Array && type_info(element).slots == 1) {
        part = convert(part, element, range, {});
        if (is_error(part)) return part;
        const Reg x = in_register(whole);
        const Reg y = in_register(part);
        const Reg reg = hint != kNoReg ? hint : emit_.take(1);
        emit_.emit(OpCode::ContainsElement, reg, x, y);
        return in_registers(types::kBool, reg);
    }
    if (kind(whole.type) == TypeKind::Array && kind(element) == TypeKind::Struct &&
        !types_.holds_array(element)) {
        part = convert(part, element, range, {});
        return is_error(part) ? part : contains_struct(whole, part);
    }
    report(diag::OperandType, ast()[expr.child[0]].range)
        .arg("contains")
        .arg(type_name(whole.type));
    return error_value();
}

/// One element after the other, until one is equal.
Value Checker::contains_struct(const Value& array, const Value& part) {
    const Type element = type_info(array.type).element;
    const Reg wanted = in_register(part);
    const Reg found = emit_.take(1);
    const Reg index = emit_.take(2);  // and the number of elements
    const auto count = static_cast<Reg>(index + 1);
    const Reg item = emit_.take(type_info(element).slots);
    Label top;
    Label done;
    emit_.emit_integer(OpCode::LoadI, found, 0, 0);
    emit_.emit_integer(OpCode::LoadI, index, 0, 0);
    emit_.emit(OpCode::CountArray, count, array.reg);
    emit_.bind(top);
    emit_.jump(OpCode::JumpLeI, done, count, index);
    emit_.emit_pair(OpCode::LoadElementN, item, array.reg, index, 0, type_info(element).slots);
    const Reg mark = emit_.mark();
    emit_equality(element, item, wanted, found);
    emit_.release_to(mark);
    emit_.jump(OpCode::JumpIf, done, found);
    emit_.emit_integer(OpCode::AddIK, index, index, 1);
    emit_.jump(OpCode::Jump, top);
    emit_.bind(done);
    return in_registers(types::kBool, found);
}

}  // namespace kadr::sema
