// operators.cpp — arithmetic: what fits together, and what it becomes.
#include <cmath>

#include "base/diagnostics/sema.h"
#include "sema/arithmetic.h"
#include "sema/checker.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;

namespace {

/// Bytes. A longer text is joined when the program runs, so that the code does not grow with the
/// square of what is added up.
constexpr std::size_t kMostFoldedText = std::size_t{1} << 14;

}  // namespace

std::string_view spelling(Operator op) {
    switch (op) {
        case Operator::Plus:
        case Operator::Add:
        case Operator::AddAssign: return "+";
        case Operator::Minus:
        case Operator::Subtract:
        case Operator::SubtractAssign: return "-";
        case Operator::Multiply:
        case Operator::MultiplyAssign: return "*";
        case Operator::Divide:
        case Operator::DivideAssign: return "/";
        case Operator::Modulo:
        case Operator::ModuloAssign: return "%";
        case Operator::Less: return "<";
        case Operator::LessEqual: return "<=";
        case Operator::Greater: return ">";
        case Operator::GreaterEqual: return ">=";
        case Operator::Equal: return "==";
        case Operator::NotEqual: return "!=";
        case Operator::BitAnd: return "&";
        case Operator::BitOr: return "|";
        case Operator::BitXor: return "^";
        case Operator::BitNot: return "~";
        case Operator::ShiftLeft: return "<<";
        case Operator::ShiftRight: return ">>";
        case Operator::And: return "&&";
        case Operator::Or: return "||";
        case Operator::Not: return "!";
        case Operator::Contains: return "contains";
        case Operator::Coalesce: return "??";
        default: return "=";
    }
}

// ---------------------------------------------------------------- unary

Value Checker::unary(ExprId id, Type expected, Reg hint) {
    const Expr& expr = ast()[id];
    if (expr.op == Operator::Not) return truth(id, hint);
    const SourceRange range = ast()[expr.child[0]].range;
    Value value = require_given(expression(expr.child[0], expected), range, {});
    if (is_error(value)) return value;
    const TypeKind k = kind(value.type);
    if (expr.op == Operator::BitNot) {
        if (k != TypeKind::Int) {
            report(diag::OperandType, range).arg("~").arg(type_name(value.type));
            return error_value();
        }
        if (value.is_constant()) return constant_integer(~value.constant.integer, types::kInt);
        const Reg reg = hint != kNoReg ? hint : emit_.take(1);
        emit_.emit(OpCode::NotI, reg, value.reg);
        return in_registers(types::kInt, reg);
    }
    if (k == TypeKind::Struct && (value.type == types::kPoint || value.type == types::kVector)) {
        if (expr.op == Operator::Plus) return value;
        const Reg reg = emit_.take(3);
        for (unsigned i = 0; i < 3; ++i) emit_.emit(OpCode::NegF, reg + i, value.reg + i);
        return in_registers(value.type, reg);
    }
    if (k != TypeKind::Int && k != TypeKind::Real) {
        report(diag::OperandType, range).arg(spelling(expr.op)).arg(type_name(value.type));
        return error_value();
    }
    if (expr.op == Operator::Plus) return value;
    if (value.is_constant()) {
        if (k == TypeKind::Real) {
            Value negative = constant_number(-value.constant.number, value.type);
            negative.origin = value.origin;
            return negative;
        }
        return fold_integers(Operator::Subtract, 0, value.constant.integer, expr.range);
    }
    const Reg reg = hint != kNoReg ? hint : emit_.take(1);
    emit_.emit(k == TypeKind::Int ? OpCode::NegI : OpCode::NegF, reg, value.reg);
    Value negative = in_registers(value.type, reg);
    negative.origin = value.origin;
    return negative;
}

// ---------------------------------------------------------------- binary

Value Checker::binary(ExprId id, Type expected, Reg hint) {
    const Expr& expr = ast()[id];
    switch (expr.op) {
        case Operator::Coalesce: return coalesce(id, expected);
        case Operator::And:
        case Operator::Or:
        case Operator::Less:
        case Operator::LessEqual:
        case Operator::Greater:
        case Operator::GreaterEqual:
        case Operator::Equal:
        case Operator::NotEqual: return truth(id, hint);
        case Operator::Contains: return contains(expr, hint);
        default: break;
    }
    // The links of a chain, the last one first.
    std::vector<ExprId> links;
    for (ExprId link = id; ast()[link].is_chain_link(); link = ast()[link].child[0]) {
        links.push_back(link);
    }
    const SourceRange location = emit_.location();
    const Reg mark = emit_.mark();
    const Expr& first = ast()[links.back()];
    emit_.set_location(first.range);
    Value value = expression(first.child[0], operand_type(first));
    if (value.is_constant() && kind(value.type) == TypeKind::String) {
        value = with_literals(value, links);
    }
    while (!links.empty()) {
        const ExprId link = links.back();
        links.pop_back();
        emit_.set_location(ast()[link].range);
        value = chain_link(ast()[link], value, mark, links.empty() ? hint : kNoReg);
    }
    emit_.set_location(location);
    return value;
}

/// A constant text and the literals that are added to it, joined in one go: a text for every link
/// would take memory with the square of the chain. Takes the links of those literals off.
Value Checker::with_literals(const Value& start, std::vector<ExprId>& links) {
    std::string all = code_->texts[static_cast<std::size_t>(start.constant.integer)];
    for (; !links.empty(); links.pop_back()) {
        const Expr& link = ast()[links.back()];
        const Expr& right = ast()[link.child[1]];
        const bool is_literal = right.kind == ExprKind::String && right.list.count == 0;
        if (link.op != Operator::Add || !is_literal) break;
        all += text(right.text);
    }
    return constant_text(all);
}

/// `+` and `-` hand the expected type down, so that braces know what they are.
Type Checker::operand_type(const Expr& expr) {
    const bool same_type = expr.op == Operator::Add || expr.op == Operator::Subtract;
    const bool is_braces = ast()[expr.child[0]].kind == ExprKind::Braces ||
                           ast()[expr.child[1]].kind == ExprKind::Braces;
    return same_type && is_braces ? types::kPoint : types::kError;
}

/// One operator of a chain: `left`, which stands in registers from `mark` on, and what is right of
/// it.
Value Checker::chain_link(const Expr& expr, Value left, Reg mark, Reg hint) {
    if (left.is_variable && writes(expr.child[1])) {
        // `i + i++`: what stands left is read first.
        const Reg copy = emit_.take(type_info(left.type).slots);
        left.is_fresh = true;
        copy_value(left, copy);
        left = in_registers(left.type, copy);
    }
    const Value right = expression(expr.child[1], operand_type(expr));
    if (is_error(left) || is_error(right)) return error_value();
    Value result = binary_values(expr.op, left, right, expr, hint);
    if (result.form == Value::Form::InRegister && type_info(result.type).slots == 1 &&
        !result.is_variable && result.reg != hint && result.reg > mark) {
        // The operands' registers are free again; the result moves down. The last instruction is
        // the one that made it, so its target can be changed instead of copying.
        Instruction& last = code_->instructions.back();
        if (last.a == result.reg && is_pure(last.op)) {
            emit_.release_to(mark);
            last.a = emit_.take(1);
            result.reg = last.a;
        }
    }
    return result;
}

bool Checker::is_pure(OpCode op) {
    return (op >= OpCode::AddI && op <= OpCode::MathI) || op == OpCode::Concat ||
           op == OpCode::Format;
}

Value Checker::binary_values(Operator op, Value left, Value right, const Expr& expr, Reg hint) {
    left = require_given(left, ast()[expr.child[0]].range, {});
    right = require_given(right, ast()[expr.child[1]].range, {});
    if (is_error(left) || is_error(right)) return error_value();
    const TypeKind a = kind(left.type);
    const TypeKind b = kind(right.type);
    if (op == Operator::Add && (a == TypeKind::String || b == TypeKind::String)) {
        left = text_of(left, ast()[expr.child[0]].range);
        right = text_of(right, ast()[expr.child[1]].range);
        if (is_error(left) || is_error(right)) return error_value();
        if (left.is_constant() && right.is_constant()) {
            const std::string& a_text =
                code_->texts[static_cast<std::size_t>(left.constant.integer)];
            const std::string& b_text =
                code_->texts[static_cast<std::size_t>(right.constant.integer)];
            if (a_text.size() + b_text.size() <= kMostFoldedText) {
                return constant_text(a_text + b_text);
            }
        }
        const Reg x = in_register(left);
        const Reg y = in_register(right);
        const Reg reg = hint != kNoReg ? hint : emit_.take(1);
        emit_.emit(OpCode::Concat, reg, x, y);
        return in_registers(types::kString, reg);
    }
    switch (op) {
        case Operator::BitAnd:
        case Operator::BitOr:
        case Operator::BitXor:
        case Operator::ShiftLeft:
        case Operator::ShiftRight: return bits(op, left, right, expr, hint);
        default: break;
    }
    if (a == TypeKind::Struct || b == TypeKind::Struct) return vectors(op, left, right, expr);
    if (!types_.is_numeric(left.type) || !types_.is_numeric(right.type)) {
        const bool is_left = !types_.is_numeric(left.type);
        const Value& wrong = is_left ? left : right;
        report(diag::OperandType, ast()[expr.child[is_left ? 0 : 1]].range)
            .arg(spelling(op))
            .arg(type_name(wrong.type));
        return error_value();
    }
    const Origin origin = origin_of_result(op, left, right);
    Value result = arithmetic(op, left, right, expr, hint);
    result.origin = origin;
    return result;
}

/// `d^2`, where `^` is meant as a power.
void Checker::fix_power(const Expr& expr, const Value& left, const Value& right,
                        DiagnosticBuilder& builder) {
    const Expr& base = ast()[expr.child[0]];
    const std::string name(sources_.text(base.range));
    const bool is_square = right.is_constant() && kind(right.type) == TypeKind::Int &&
                           right.constant.integer == 2 && base.kind == ExprKind::Name;
    const std::string product = name + '*' + name;
    // Whether a word takes the square of a length, only the author knows: `G0 X=d^2;`.
    if (is_square && !type_info(left.type).quantity.is_number())
        builder.fix("a power is a product, `" + product +
                    "`, or `pow(a, n)`: that of a length is " + "an area");
    else if (is_square) builder.fix(expr.range, product, "a power is a product, or `pow(a, n)`");
    else builder.fix("a power is `pow(a, n)`; `^` joins the bits of whole numbers");
}

/// `n^2` with whole numbers: valid, and hardly ever meant.
void Checker::warn_of_power(const Expr& expr, const Value& left, const Value& right) {
    const Expr& exponent = ast()[expr.child[1]];
    const std::string_view digit = sources_.text(exponent.range);
    const bool is_power = kind(left.type) == TypeKind::Int && exponent.kind == ExprKind::Int &&
                          digit.size() == 1 && digit[0] >= '2' && digit[0] <= '9';
    if (!is_power) return;
    auto builder = report(diag::BitsAsPower, expr.range);
    builder.arg(sources_.text(ast()[expr.child[0]].range)).arg(digit);
    fix_power(expr, left, right, builder);
}

Value Checker::bits(Operator op, const Value& left, const Value& right, const Expr& expr,
                    Reg hint) {
    const bool both_bool = kind(left.type) == TypeKind::Bool &&
                           kind(right.type) == TypeKind::Bool && op != Operator::ShiftLeft &&
                           op != Operator::ShiftRight;
    if (!both_bool && (kind(left.type) != TypeKind::Int || kind(right.type) != TypeKind::Int)) {
        const bool is_left = kind(left.type) != TypeKind::Int;
        auto builder = report(diag::OperandType, ast()[expr.child[is_left ? 0 : 1]].range);
        builder.arg(spelling(op)).arg(type_name(is_left ? left.type : right.type));
        if (op == Operator::BitXor) fix_power(expr, left, right, builder);
        return error_value();
    }
    if (op == Operator::BitXor) warn_of_power(expr, left, right);
    const bool is_shift = op == Operator::ShiftLeft || op == Operator::ShiftRight;
    if (is_shift && right.is_constant() &&
        (right.constant.integer < 0 || right.constant.integer > 62)) {
        report(diag::ShiftRange, ast()[expr.child[1]].range).arg(right.constant.integer);
        return error_value();
    }
    if (left.is_constant() && right.is_constant() && op != Operator::ShiftLeft) {
        const std::int64_t x = left.constant.integer;
        const std::int64_t y = right.constant.integer;
        const std::int64_t value = op == Operator::BitAnd   ? (x & y)
                                   : op == Operator::BitOr  ? (x | y)
                                   : op == Operator::BitXor ? (x ^ y)
                                                            : (x >> y);
        return constant_integer(value, left.type);
    }
    const OpCode code = op == Operator::BitAnd      ? OpCode::AndI
                        : op == Operator::BitOr     ? OpCode::OrI
                        : op == Operator::BitXor    ? OpCode::XorI
                        : op == Operator::ShiftLeft ? OpCode::ShlI
                                                    : OpCode::ShrI;
    const Reg x = in_register(left);
    const Reg y = in_register(right);
    const Reg reg = hint != kNoReg ? hint : emit_.take(1);
    emit_.emit(code, reg, x, y);
    return in_registers(left.type, reg);
}

/// A coordinate that only one of two points has would get lost.
void Checker::check_same_parts(Reg left, ExprId left_text, Reg right, ExprId right_text) {
    for (unsigned i = 0; i < 3; ++i) {
        const auto name = [&](ExprId id) {
            return static_cast<std::int64_t>(
                text_constant(std::string(sources_.text(ast()[id].range)) + '.' + "xyz"[i]));
        };
        emit_.emit_pair(OpCode::SameGiven, left + i, right + i, 0, name(left_text),
                        name(right_text));
    }
}

Value Checker::vectors(Operator op, const Value& left, const Value& right, const Expr& expr) {
    const auto is_vector = [&](const Value& v) {
        return v.type == types::kPoint || v.type == types::kVector;
    };
    const bool is_sum = op == Operator::Add || op == Operator::Subtract;
    if (is_sum && is_vector(left) && left.type == right.type) {
        check_same_parts(left.reg, expr.child[0], right.reg, expr.child[1]);
        const Reg reg = emit_.take(3);
        for (unsigned i = 0; i < 3; ++i) {
            emit_.emit(op == Operator::Add ? OpCode::AddF : OpCode::SubF, reg + i, left.reg + i,
                       right.reg + i);
        }
        return in_registers(left.type, reg);
    }
    const bool is_product = op == Operator::Multiply && (is_vector(left) != is_vector(right));
    if (is_product || (op == Operator::Divide && is_vector(left) && !is_vector(right))) {
        const Value& vector = is_vector(left) ? left : right;
        Value scale = is_vector(left) ? right : left;
        const bool is_number =
            kind(scale.type) == TypeKind::Int ||
            (kind(scale.type) == TypeKind::Real && type_info(scale.type).quantity.is_number());
        // A direction times a length is a point: `{0.6, 0.8} * 10mm`.
        const bool makes_point = op == Operator::Multiply && vector.type == types::kVector &&
                                 kind(scale.type) == TypeKind::Real &&
                                 type_info(scale.type).quantity == kLength;
        if (is_number || makes_point) {
            const Reg factor = in_register(to_real(scale));
            const Reg reg = emit_.take(3);
            for (unsigned i = 0; i < 3; ++i) {
                emit_.emit(op == Operator::Multiply ? OpCode::MulF : OpCode::DivF, reg + i,
                           vector.reg + i, factor);
            }
            return in_registers(makes_point ? types::kPoint : vector.type, reg);
        }
    }
    report(diag::OperandPair, expr.range)
        .arg(spelling(op))
        .arg(type_name(left.type))
        .arg(type_name(right.type));
    return error_value();
}

/// A diameter beside a length: a constant is a diameter there; of a variable nobody knows.
Done Checker::match_diameters(Value& left, Value& right, const Expr& expr) {
    if (is_diameter(left) == is_diameter(right)) return kDone;
    Value& other = is_diameter(left) ? right : left;
    if (other.is_constant()) {
        other = retyped(other, types::kDiameter);
        return kDone;
    }
    const bool is_call = expr.kind == ExprKind::Call;
    report(diag::MixedDimensions, expr.range)
        .arg(is_call ? sources_.text(ast()[expr.child[0]].range) : spelling(expr.op))
        .arg(quantity_name(left.type))
        .arg(quantity_name(right.type))
        .fix(
            "`diameter(…)` makes a diameter of a length: of a radius, `diameter(2*r)`; "
            "the radius of a diameter is `d/2`");
    return kFailed;
}

Done Checker::match_quantities(Value& left, Value& right, const Expr& expr) {
    const auto bare = [&](const Value& v) {
        return v.is_constant() && (kind(v.type) == TypeKind::Int || v.type == types::kReal);
    };
    const auto is_family = [&](const Value& v) {
        return kind(v.type) == TypeKind::Feed || kind(v.type) == TypeKind::Speed;
    };
    // A family keeps its form as long as both sides agree; against a plain feed it must have that
    // form.
    if (is_family(left) && is_family(right) && left.type == right.type) return kDone;
    if (is_family(left) != is_family(right)) {
        Value& family = is_family(left) ? left : right;
        Value& other = is_family(left) ? right : left;
        if (bare(other)) {
            other = adapt_number(other, family.type);
            return kDone;
        }
        if (kind(other.type) == TypeKind::Real) {
            const Quantity q = type_info(other.type).quantity;
            if (const std::optional<int> form =
                    form_of(q / type_info(family.type).quantity, kind(family.type))) {
                family = plain_form(family, *form);
                other = retyped(other, family.type);
                return kDone;
            }
        }
    } else if (!is_family(left)) {
        const Quantity a = type_info(left.type).quantity;
        const Quantity b = type_info(right.type).quantity;
        if (a == b) return match_diameters(left, right, expr);
        if (bare(right)) {
            right = adapt_number(right, left.type);
            return kDone;
        }
        if (bare(left)) {
            left = adapt_number(left, right.type);
            return kDone;
        }
    }
    const bool is_settled = settle(left);
    if (settle(right) || is_settled) return match_quantities(left, right, expr);
    const auto words = [&](const Value& v) {
        return is_family(v) ? type_name(v.type) : describe(type_info(v.type).quantity);
    };
    const bool is_call = expr.kind == ExprKind::Call;
    report(diag::MixedDimensions, expr.range)
        .arg(is_call ? sources_.text(ast()[expr.child[0]].range) : spelling(expr.op))
        .arg(words(left))
        .arg(words(right));
    return kFailed;
}

Done Checker::require_finite(double value, const SourceRange& range) {
    if (std::isfinite(value)) return kDone;
    report(diag::ConstantFault, range).arg("the result is too large for a number");
    return kFailed;
}

Value Checker::fold_integers(Operator op, std::int64_t a, std::int64_t b,
                             const SourceRange& range) {
    std::int64_t result = 0;
    bool overflow = false;
    switch (op) {
        case Operator::Add: overflow = __builtin_add_overflow(a, b, &result); break;
        case Operator::Subtract: overflow = __builtin_sub_overflow(a, b, &result); break;
        case Operator::Multiply: overflow = __builtin_mul_overflow(a, b, &result); break;
        default:
            if (b == 0) {
                report(diag::ConstantFault, range).arg(describe(MathFault::DivisionByZero));
                return error_value();
            }
            result = remainder(a, b);
            break;
    }
    if (overflow) {
        report(diag::ConstantFault, range).arg("the whole number leaves 64 bits");
        return error_value();
    }
    return constant_integer(result, types::kInt);
}

Value Checker::emit_integers(Operator op, const Value& a, const Value& b, Reg hint) {
    const auto target = [&] { return hint != kNoReg ? hint : emit_.take(1); };
    // A constant operand goes into the instruction.
    if (op == Operator::Add || op == Operator::Multiply) {
        const OpCode code = op == Operator::Add ? OpCode::AddIK : OpCode::MulIK;
        if (b.is_constant()) {
            const Reg reg = target();
            emit_.emit_integer(code, reg, a.reg, b.constant.integer);
            return in_registers(types::kInt, reg);
        }
        if (a.is_constant()) {
            const Reg reg = target();
            emit_.emit_integer(code, reg, b.reg, a.constant.integer);
            return in_registers(types::kInt, reg);
        }
    }
    if (op == Operator::Subtract && b.is_constant() && b.constant.integer != kNotGivenInteger) {
        const Reg reg = target();
        emit_.emit_integer(OpCode::AddIK, reg, a.reg, -b.constant.integer);
        return in_registers(types::kInt, reg);
    }
    const Reg x = in_register(a);
    const Reg y = in_register(b);
    const Reg reg = target();
    emit_.emit(op == Operator::Add        ? OpCode::AddI
               : op == Operator::Subtract ? OpCode::SubI
               : op == Operator::Multiply ? OpCode::MulI
                                          : OpCode::ModI,
               reg, x, y);
    return in_registers(types::kInt, reg);
}

Value Checker::emit_reals(Operator op, const Value& a, const Value& b, Type type, Reg hint,
                          const SourceRange& range) {
    if (a.is_constant() && b.is_constant()) {
        const double x = a.constant.number;
        const double y = b.constant.number;
        if ((op == Operator::Divide || op == Operator::Modulo) && y == 0) {
            report(diag::ConstantFault, range).arg(describe(MathFault::DivisionByZero));
            return error_value();
        }
        const double value = op == Operator::Add        ? x + y
                             : op == Operator::Subtract ? x - y
                             : op == Operator::Multiply ? x * y
                             : op == Operator::Divide   ? x / y
                                                        : std::fmod(x, y);
        if (!require_finite(value, range)) return error_value();
        return constant_number(value, type);
    }
    const auto target = [&] { return hint != kNoReg ? hint : emit_.take(1); };
    if (b.is_constant() && op != Operator::Modulo) {
        const double k = b.constant.number;
        if (op == Operator::Divide && k == 0) {
            report(diag::ConstantFault, range).arg(describe(MathFault::DivisionByZero));
            return error_value();
        }
        const Reg reg = target();
        if (op == Operator::Add) emit_.emit_number(OpCode::AddFK, reg, a.reg, k);
        else if (op == Operator::Subtract) emit_.emit_number(OpCode::AddFK, reg, a.reg, -k);
        else if (op == Operator::Multiply) emit_.emit_number(OpCode::MulFK, reg, a.reg, k);
        else emit_.emit_number(OpCode::DivFK, reg, a.reg, k);
        return in_registers(type, reg);
    }
    if (a.is_constant() && op != Operator::Modulo) {
        const double k = a.constant.number;
        const Reg reg = target();
        if (op == Operator::Add) emit_.emit_number(OpCode::AddFK, reg, b.reg, k);
        else if (op == Operator::Subtract) emit_.emit_number(OpCode::SubKF, reg, b.reg, k);
        else if (op == Operator::Multiply) emit_.emit_number(OpCode::MulFK, reg, b.reg, k);
        else emit_.emit_number(OpCode::DivKF, reg, b.reg, k);
        return in_registers(type, reg);
    }
    const Reg x = in_register(a);
    const Reg y = in_register(b);
    const Reg reg = target();
    emit_.emit(op == Operator::Add        ? OpCode::AddF
               : op == Operator::Subtract ? OpCode::SubF
               : op == Operator::Multiply ? OpCode::MulF
               : op == Operator::Divide   ? OpCode::DivF
                                          : OpCode::ModF,
               reg, x, y);
    return in_registers(type, reg);
}

/// Numbers: whole ones stay whole except in a division, because `X=5/2` means 2.5 on a drawing.
Value Checker::arithmetic(Operator op, Value left, Value right, const Expr& expr, Reg hint) {
    const bool both_int = kind(left.type) == TypeKind::Int && kind(right.type) == TypeKind::Int;
    if (both_int && op != Operator::Divide) {
        if (left.is_constant() && right.is_constant()) {
            return fold_integers(op, left.constant.integer, right.constant.integer, expr.range);
        }
        return emit_integers(op, left, right, hint);
    }
    const bool is_sum = op == Operator::Add || op == Operator::Subtract || op == Operator::Modulo;
    const auto is_family = [&](const Value& v) {
        return kind(v.type) == TypeKind::Feed || kind(v.type) == TypeKind::Speed;
    };
    if (is_sum) {
        if (!match_quantities(left, right, expr)) return error_value();
        if (is_family(left)) return families(op, left, right, expr, hint);
        left = to_real(left);
        right = to_real(right);
        return emit_reals(op, left, right, left.type == types::kInt ? types::kReal : left.type,
                          hint, expr.range);
    }
    if (is_family(left) && is_family(right)) {
        if (op == Operator::Divide && left.type == right.type)
            return families(op, left, right, expr, hint);
        settle(left);
        settle(right);
        // A feed times a speed is that of each tooth or revolution times the revolutions of the
        // spindle.
        const bool is_per_turn = op == Operator::Multiply && kind(left.type) != kind(right.type);
        const auto plain = [&](const Value& v) {
            return plain_form(v, is_per_turn && kind(v.type) == TypeKind::Feed ? 1 : 0);
        };
        left = plain(left);
        right = plain(right);
    }
    left = to_real(left);
    right = to_real(right);
    const Quantity a = type_info(left.type).quantity;
    const Quantity b = type_info(right.type).quantity;
    if (is_family(left) || (is_family(right) && op == Operator::Multiply)) {
        const TypeKind family = is_family(left) ? kind(left.type) : kind(right.type);
        const Type type = types_.family(family, op == Operator::Multiply ? a * b : a / b);
        return emit_reals(op, left, right, type, hint, expr.range);
    }
    if (is_family(right)) {
        right = plain_form(right, 0);
        return emit_reals(op, left, right, types_.real(a / type_info(right.type).quantity), hint,
                          expr.range);
    }
    return emit_reals(op, left, right, types_.real(op == Operator::Multiply ? a * b : a / b), hint,
                      expr.range);
}

/// Two feeds or two speeds of which only the running program knows the form.
Value Checker::families(Operator op, const Value& left, const Value& right, const Expr& expr,
                        Reg hint) {
    if (!left.is_constant() || !right.is_constant()) {
        const Reg a = in_register(left);
        const Reg b = in_register(right);
        emit_.emit(OpCode::SameForm, a, b);
        const Type type = op == Operator::Divide ? types::kReal : left.type;
        return emit_reals(op, in_registers(left.type, a), in_registers(right.type, b), type, hint,
                          expr.range);
    }
    return emit_reals(op, left, right, op == Operator::Divide ? types::kReal : left.type, hint,
                      expr.range);
}

}  // namespace kadr::sema
