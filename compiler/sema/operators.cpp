// operators.cpp — arithmetic: what fits together, and what it becomes.
#include "sema/operators.h"

#include <cmath>

#include "base/diagnostics/sema.h"
#include "sema/arithmetic.h"
#include "sema/checking.h"
#include "sema/conditions.h"
#include "sema/convert.h"
#include "sema/expressions.h"
#include "sema/optionals.h"
#include "sema/origins.h"
#include "sema/texts.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;

namespace {

bool is_pure(OpCode op);
Value with_literals(Check& check, const Value& start, std::vector<syntax::ExprId>& links);
Type operand_type(Check& check, const syntax::Expr& expr);
Value chain_link(Check& check, const syntax::Expr& expr, Value left, Reg mark, Reg hint);
Value bits(Check& check, syntax::Operator op, const Value& left, const Value& right,
           const syntax::Expr& expr, Reg hint);
Value vectors(Check& check, syntax::Operator op, const Value& left, const Value& right,
              const syntax::Expr& expr);
Value fold_integers(Check& check, syntax::Operator op, std::int64_t a, std::int64_t b,
                    const SourceRange& range);
Value families(Check& check, syntax::Operator op, const Value& left, const Value& right,
               const syntax::Expr& expr, Reg hint);

}  // namespace

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

Value unary(Check& check, ExprId id, Type expected, Reg hint) {
    const Expr& expr = check.ast()[id];
    if (expr.op == Operator::Not) return truth(check, id, hint);
    const SourceRange range = check.ast()[expr.child[0]].range;
    Value value = require_given(check, expression(check, expr.child[0], expected), range, {});
    if (check.is_error(value)) return value;
    const TypeKind k = check.kind(value.type);
    if (expr.op == Operator::BitNot) {
        if (k != TypeKind::Int) {
            check.report(diag::OperandType, range).arg("~").arg(check.type_name(value.type));
            return error_value();
        }
        if (value.is_constant()) return constant_integer(~value.constant.integer, types::kInt);
        const Reg reg = hint != kNoReg ? hint : check.emit.take(1);
        check.emit.emit(OpCode::NotI, reg, value.reg);
        return in_registers(types::kInt, reg);
    }
    if (k == TypeKind::Struct && (value.type == types::kPoint || value.type == types::kVector)) {
        if (expr.op == Operator::Plus) return value;
        const Reg reg = check.emit.take(3);
        for (unsigned i = 0; i < 3; ++i) check.emit.emit(OpCode::NegF, reg + i, value.reg + i);
        return in_registers(value.type, reg);
    }
    if (k != TypeKind::Int && k != TypeKind::Real) {
        check.report(diag::OperandType, range)
            .arg(spelling(expr.op))
            .arg(check.type_name(value.type));
        return error_value();
    }
    if (expr.op == Operator::Plus) return value;
    if (value.is_constant()) {
        if (k == TypeKind::Real) {
            Value negative = constant_number(-value.constant.number, value.type);
            negative.origin = value.origin;
            return negative;
        }
        return fold_integers(check, Operator::Subtract, 0, value.constant.integer, expr.range);
    }
    const Reg reg = hint != kNoReg ? hint : check.emit.take(1);
    check.emit.emit(k == TypeKind::Int ? OpCode::NegI : OpCode::NegF, reg, value.reg);
    Value negative = in_registers(value.type, reg);
    negative.origin = value.origin;
    return negative;
}

// ---------------------------------------------------------------- binary

Value binary(Check& check, ExprId id, Type expected, Reg hint) {
    const Expr& expr = check.ast()[id];
    switch (expr.op) {
        case Operator::Coalesce: return coalesce(check, id, expected);
        case Operator::And:
        case Operator::Or:
        case Operator::Less:
        case Operator::LessEqual:
        case Operator::Greater:
        case Operator::GreaterEqual:
        case Operator::Equal:
        case Operator::NotEqual: return truth(check, id, hint);
        case Operator::Contains: return contains(check, expr, hint);
        default: break;
    }
    // The links of a chain, the last one first.
    std::vector<ExprId> links;
    for (ExprId link = id; check.ast()[link].is_chain_link(); link = check.ast()[link].child[0]) {
        links.push_back(link);
    }
    const SourceRange location = check.emit.location();
    const Reg mark = check.emit.mark();
    const Expr& first = check.ast()[links.back()];
    check.emit.set_location(first.range);
    Value value = expression(check, first.child[0], operand_type(check, first));
    if (value.is_constant() && check.kind(value.type) == TypeKind::String) {
        value = with_literals(check, value, links);
    }
    while (!links.empty()) {
        const ExprId link = links.back();
        links.pop_back();
        check.emit.set_location(check.ast()[link].range);
        value = chain_link(check, check.ast()[link], value, mark, links.empty() ? hint : kNoReg);
    }
    check.emit.set_location(location);
    return value;
}

namespace {

/// A constant text and the literals that are added to it, joined in one go: a text for every link
/// would take memory with the square of the chain. Takes the links of those literals off.
Value with_literals(Check& check, const Value& start, std::vector<ExprId>& links) {
    std::string all = check.code->texts[static_cast<std::size_t>(start.constant.integer)];
    for (; !links.empty(); links.pop_back()) {
        const Expr& link = check.ast()[links.back()];
        const Expr& right = check.ast()[link.child[1]];
        const bool is_literal = right.kind == ExprKind::String && right.list.count == 0;
        if (link.op != Operator::Add || !is_literal) break;
        all += check.text(right.text);
    }
    return constant_text(check, all);
}

/// `+` and `-` hand the expected type down, so that braces know what they are.
Type operand_type(Check& check, const Expr& expr) {
    const bool same_type = expr.op == Operator::Add || expr.op == Operator::Subtract;
    const bool is_braces = check.ast()[expr.child[0]].kind == ExprKind::Braces ||
                           check.ast()[expr.child[1]].kind == ExprKind::Braces;
    return same_type && is_braces ? types::kPoint : types::kError;
}

/// One operator of a chain: `left`, which stands in registers from `mark` on, and what is right of
/// it.
Value chain_link(Check& check, const Expr& expr, Value left, Reg mark, Reg hint) {
    if (left.is_variable && writes(check, expr.child[1])) {
        // `i + i++`: what stands left is read first.
        const Reg copy = check.emit.take(check.type_info(left.type).slots);
        left.is_fresh = true;
        copy_value(check, left, copy);
        left = in_registers(left.type, copy);
    }
    const Value right = expression(check, expr.child[1], operand_type(check, expr));
    if (check.is_error(left) || check.is_error(right)) return error_value();
    Value result = binary_values(check, expr.op, left, right, expr, hint);
    if (result.form == Value::Form::InRegister && check.type_info(result.type).slots == 1 &&
        !result.is_variable && result.reg != hint && result.reg > mark) {
        // The operands' registers are free again; the result moves down. The last instruction is
        // the one that made it, so its target can be changed instead of copying.
        Instruction& last = check.code->instructions.back();
        if (last.a == result.reg && is_pure(last.op)) {
            check.emit.release_to(mark);
            last.a = check.emit.take(1);
            result.reg = last.a;
        }
    }
    return result;
}

bool is_pure(OpCode op) {
    return (op >= OpCode::AddI && op <= OpCode::MathI) || op == OpCode::Concat ||
           op == OpCode::Format;
}

}  // namespace

Value binary_values(Check& check, Operator op, Value left, Value right, const Expr& expr,
                    Reg hint) {
    left = require_given(check, left, check.ast()[expr.child[0]].range, {});
    right = require_given(check, right, check.ast()[expr.child[1]].range, {});
    if (check.is_error(left) || check.is_error(right)) return error_value();
    const TypeKind a = check.kind(left.type);
    const TypeKind b = check.kind(right.type);
    if (op == Operator::Add && (a == TypeKind::String || b == TypeKind::String)) {
        left = text_of(check, left, check.ast()[expr.child[0]].range);
        right = text_of(check, right, check.ast()[expr.child[1]].range);
        if (check.is_error(left) || check.is_error(right)) return error_value();
        if (left.is_constant() && right.is_constant()) {
            const std::string& a_text =
                check.code->texts[static_cast<std::size_t>(left.constant.integer)];
            const std::string& b_text =
                check.code->texts[static_cast<std::size_t>(right.constant.integer)];
            if (a_text.size() + b_text.size() <= kMostFoldedText) {
                return constant_text(check, a_text + b_text);
            }
        }
        const Reg x = in_register(check, left);
        const Reg y = in_register(check, right);
        const Reg reg = hint != kNoReg ? hint : check.emit.take(1);
        check.emit.emit(OpCode::Concat, reg, x, y);
        return in_registers(types::kString, reg);
    }
    switch (op) {
        case Operator::BitAnd:
        case Operator::BitOr:
        case Operator::BitXor:
        case Operator::ShiftLeft:
        case Operator::ShiftRight: return bits(check, op, left, right, expr, hint);
        default: break;
    }
    if (a == TypeKind::Struct || b == TypeKind::Struct)
        return vectors(check, op, left, right, expr);
    if (!check.types.is_numeric(left.type) || !check.types.is_numeric(right.type)) {
        const bool is_left = !check.types.is_numeric(left.type);
        const Value& wrong = is_left ? left : right;
        check.report(diag::OperandType, check.ast()[expr.child[is_left ? 0 : 1]].range)
            .arg(spelling(op))
            .arg(check.type_name(wrong.type));
        return error_value();
    }
    const Origin origin = origin_of_result(check, op, left, right);
    Value result = arithmetic(check, op, left, right, expr, hint);
    result.origin = origin;
    return result;
}

namespace {

/// `d^2`, where `^` is meant as a power.
void fix_power(Check& check, const Expr& expr, const Value& left, const Value& right,
               DiagnosticBuilder& builder) {
    const Expr& base = check.ast()[expr.child[0]];
    const std::string name(check.sources.text(base.range));
    const bool is_square = right.is_constant() && check.kind(right.type) == TypeKind::Int &&
                           right.constant.integer == 2 && base.kind == ExprKind::Name;
    const std::string product = name + '*' + name;
    // Whether a word takes the square of a length, only the author knows: `G0 X=d^2;`.
    if (is_square && !check.type_info(left.type).quantity.is_number())
        builder.fix("a power is a product, `" + product +
                    "`, or `pow(a, n)`: that of a length is " + "an area");
    else if (is_square) builder.fix(expr.range, product, "a power is a product, or `pow(a, n)`");
    else builder.fix("a power is `pow(a, n)`; `^` joins the bits of whole numbers");
}

/// `n^2` with whole numbers: valid, and hardly ever meant.
void warn_of_power(Check& check, const Expr& expr, const Value& left, const Value& right) {
    const Expr& exponent = check.ast()[expr.child[1]];
    const std::string_view digit = check.sources.text(exponent.range);
    const bool is_power = check.kind(left.type) == TypeKind::Int &&
                          exponent.kind == ExprKind::Int && digit.size() == 1 && digit[0] >= '2' &&
                          digit[0] <= '9';
    if (!is_power) return;
    auto builder = check.report(diag::BitsAsPower, expr.range);
    builder.arg(check.sources.text(check.ast()[expr.child[0]].range)).arg(digit);
    fix_power(check, expr, left, right, builder);
}

Value bits(Check& check, Operator op, const Value& left, const Value& right, const Expr& expr,
           Reg hint) {
    const bool both_bool = check.kind(left.type) == TypeKind::Bool &&
                           check.kind(right.type) == TypeKind::Bool && op != Operator::ShiftLeft &&
                           op != Operator::ShiftRight;
    if (!both_bool &&
        (check.kind(left.type) != TypeKind::Int || check.kind(right.type) != TypeKind::Int)) {
        const bool is_left = check.kind(left.type) != TypeKind::Int;
        auto builder =
            check.report(diag::OperandType, check.ast()[expr.child[is_left ? 0 : 1]].range);
        builder.arg(spelling(op)).arg(check.type_name(is_left ? left.type : right.type));
        if (op == Operator::BitXor) fix_power(check, expr, left, right, builder);
        return error_value();
    }
    if (op == Operator::BitXor) warn_of_power(check, expr, left, right);
    const bool is_shift = op == Operator::ShiftLeft || op == Operator::ShiftRight;
    if (is_shift && right.is_constant() &&
        (right.constant.integer < 0 || right.constant.integer > 62)) {
        check.report(diag::ShiftRange, check.ast()[expr.child[1]].range)
            .arg(right.constant.integer);
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
    const Reg x = in_register(check, left);
    const Reg y = in_register(check, right);
    const Reg reg = hint != kNoReg ? hint : check.emit.take(1);
    check.emit.emit(code, reg, x, y);
    return in_registers(left.type, reg);
}

}  // namespace

/// A coordinate that only one of two points has would get lost.
void check_same_parts(Check& check, Reg left, ExprId left_text, Reg right, ExprId right_text) {
    for (unsigned i = 0; i < 3; ++i) {
        const auto name = [&](ExprId id) {
            return static_cast<std::int64_t>(text_constant(
                check, std::string(check.sources.text(check.ast()[id].range)) + '.' + "xyz"[i]));
        };
        check.emit.emit_pair(OpCode::SameGiven, left + i, right + i, 0, name(left_text),
                             name(right_text));
    }
}

namespace {

Value vectors(Check& check, Operator op, const Value& left, const Value& right, const Expr& expr) {
    const auto is_vector = [&](const Value& v) {
        return v.type == types::kPoint || v.type == types::kVector;
    };
    const bool is_sum = op == Operator::Add || op == Operator::Subtract;
    if (is_sum && is_vector(left) && left.type == right.type) {
        check_same_parts(check, left.reg, expr.child[0], right.reg, expr.child[1]);
        const Reg reg = check.emit.take(3);
        for (unsigned i = 0; i < 3; ++i) {
            check.emit.emit(op == Operator::Add ? OpCode::AddF : OpCode::SubF, reg + i,
                            left.reg + i, right.reg + i);
        }
        return in_registers(left.type, reg);
    }
    const bool is_product = op == Operator::Multiply && (is_vector(left) != is_vector(right));
    if (is_product || (op == Operator::Divide && is_vector(left) && !is_vector(right))) {
        const Value& vector = is_vector(left) ? left : right;
        Value scale = is_vector(left) ? right : left;
        const bool is_number = check.kind(scale.type) == TypeKind::Int ||
                               (check.kind(scale.type) == TypeKind::Real &&
                                check.type_info(scale.type).quantity.is_number());
        // A direction times a length is a point: `{0.6, 0.8} * 10mm`.
        const bool makes_point = op == Operator::Multiply && vector.type == types::kVector &&
                                 check.kind(scale.type) == TypeKind::Real &&
                                 check.type_info(scale.type).quantity == kLength;
        if (is_number || makes_point) {
            const Reg factor = in_register(check, to_real(check, scale));
            const Reg reg = check.emit.take(3);
            for (unsigned i = 0; i < 3; ++i) {
                check.emit.emit(op == Operator::Multiply ? OpCode::MulF : OpCode::DivF, reg + i,
                                vector.reg + i, factor);
            }
            return in_registers(makes_point ? types::kPoint : vector.type, reg);
        }
    }
    check.report(diag::OperandPair, expr.range)
        .arg(spelling(op))
        .arg(check.type_name(left.type))
        .arg(check.type_name(right.type));
    return error_value();
}

/// A diameter beside a length: a constant is a diameter there; of a variable nobody knows.
Done match_diameters(Check& check, Value& left, Value& right, const Expr& expr) {
    if (is_diameter(check, left) == is_diameter(check, right)) return kDone;
    Value& other = is_diameter(check, left) ? right : left;
    if (other.is_constant()) {
        other = retyped(other, types::kDiameter);
        return kDone;
    }
    const bool is_call = expr.kind == ExprKind::Call;
    check.report(diag::MixedDimensions, expr.range)
        .arg(is_call ? check.sources.text(check.ast()[expr.child[0]].range) : spelling(expr.op))
        .arg(quantity_name(check, left.type))
        .arg(quantity_name(check, right.type))
        .fix(
            "`diameter(…)` makes a diameter of a length: of a radius, `diameter(2*r)`; "
            "the radius of a diameter is `d/2`");
    return kFailed;
}

}  // namespace

Done match_quantities(Check& check, Value& left, Value& right, const Expr& expr) {
    const auto bare = [&](const Value& v) {
        return v.is_constant() && (check.kind(v.type) == TypeKind::Int || v.type == types::kReal);
    };
    const auto is_family = [&](const Value& v) {
        return check.kind(v.type) == TypeKind::Feed || check.kind(v.type) == TypeKind::Speed;
    };
    // A family keeps its form as long as both sides agree; against a plain feed it must have that
    // form.
    if (is_family(left) && is_family(right) && left.type == right.type) return kDone;
    if (is_family(left) != is_family(right)) {
        Value& family = is_family(left) ? left : right;
        Value& other = is_family(left) ? right : left;
        if (bare(other)) {
            other = adapt_number(check, other, family.type);
            return kDone;
        }
        if (check.kind(other.type) == TypeKind::Real) {
            const Quantity q = check.type_info(other.type).quantity;
            if (const std::optional<int> form =
                    form_of(q / check.type_info(family.type).quantity, check.kind(family.type))) {
                family = plain_form(check, family, *form);
                other = retyped(other, family.type);
                return kDone;
            }
        }
    } else if (!is_family(left)) {
        const Quantity a = check.type_info(left.type).quantity;
        const Quantity b = check.type_info(right.type).quantity;
        if (a == b) return match_diameters(check, left, right, expr);
        if (bare(right)) {
            right = adapt_number(check, right, left.type);
            return kDone;
        }
        if (bare(left)) {
            left = adapt_number(check, left, right.type);
            return kDone;
        }
    }
    const bool is_settled = settle(check, left);
    if (settle(check, right) || is_settled) return match_quantities(check, left, right, expr);
    const auto words = [&](const Value& v) {
        return is_family(v) ? check.type_name(v.type) : describe(check.type_info(v.type).quantity);
    };
    const bool is_call = expr.kind == ExprKind::Call;
    check.report(diag::MixedDimensions, expr.range)
        .arg(is_call ? check.sources.text(check.ast()[expr.child[0]].range) : spelling(expr.op))
        .arg(words(left))
        .arg(words(right));
    return kFailed;
}

namespace {

Done require_finite(Check& check, double value, const SourceRange& range) {
    if (std::isfinite(value)) return kDone;
    check.report(diag::ConstantFault, range).arg("the result is too large for a number");
    return kFailed;
}

Value fold_integers(Check& check, Operator op, std::int64_t a, std::int64_t b,
                    const SourceRange& range) {
    std::int64_t result = 0;
    bool overflow = false;
    switch (op) {
        case Operator::Add: overflow = __builtin_add_overflow(a, b, &result); break;
        case Operator::Subtract: overflow = __builtin_sub_overflow(a, b, &result); break;
        case Operator::Multiply: overflow = __builtin_mul_overflow(a, b, &result); break;
        default:
            if (b == 0) {
                check.report(diag::ConstantFault, range).arg(describe(MathFault::DivisionByZero));
                return error_value();
            }
            result = remainder(a, b);
            break;
    }
    if (overflow) {
        check.report(diag::ConstantFault, range).arg("the whole number leaves 64 bits");
        return error_value();
    }
    return constant_integer(result, types::kInt);
}

Value emit_integers(Check& check, Operator op, const Value& a, const Value& b, Reg hint) {
    const auto target = [&] { return hint != kNoReg ? hint : check.emit.take(1); };
    // A constant operand goes into the instruction.
    if (op == Operator::Add || op == Operator::Multiply) {
        const OpCode code = op == Operator::Add ? OpCode::AddIK : OpCode::MulIK;
        if (b.is_constant()) {
            const Reg reg = target();
            check.emit.emit_integer(code, reg, a.reg, b.constant.integer);
            return in_registers(types::kInt, reg);
        }
        if (a.is_constant()) {
            const Reg reg = target();
            check.emit.emit_integer(code, reg, b.reg, a.constant.integer);
            return in_registers(types::kInt, reg);
        }
    }
    if (op == Operator::Subtract && b.is_constant() && b.constant.integer != kNotGivenInteger) {
        const Reg reg = target();
        check.emit.emit_integer(OpCode::AddIK, reg, a.reg, -b.constant.integer);
        return in_registers(types::kInt, reg);
    }
    const Reg x = in_register(check, a);
    const Reg y = in_register(check, b);
    const Reg reg = target();
    check.emit.emit(op == Operator::Add        ? OpCode::AddI
                    : op == Operator::Subtract ? OpCode::SubI
                    : op == Operator::Multiply ? OpCode::MulI
                                               : OpCode::ModI,
                    reg, x, y);
    return in_registers(types::kInt, reg);
}

}  // namespace

Value emit_reals(Check& check, Operator op, const Value& a, const Value& b, Type type, Reg hint,
                 const SourceRange& range) {
    if (a.is_constant() && b.is_constant()) {
        const double x = a.constant.number;
        const double y = b.constant.number;
        if ((op == Operator::Divide || op == Operator::Modulo) && y == 0) {
            check.report(diag::ConstantFault, range).arg(describe(MathFault::DivisionByZero));
            return error_value();
        }
        const double value = op == Operator::Add        ? x + y
                             : op == Operator::Subtract ? x - y
                             : op == Operator::Multiply ? x * y
                             : op == Operator::Divide   ? x / y
                                                        : std::fmod(x, y);
        if (!require_finite(check, value, range)) return error_value();
        return constant_number(value, type);
    }
    const auto target = [&] { return hint != kNoReg ? hint : check.emit.take(1); };
    if (b.is_constant() && op != Operator::Modulo) {
        const double k = b.constant.number;
        if (op == Operator::Divide && k == 0) {
            check.report(diag::ConstantFault, range).arg(describe(MathFault::DivisionByZero));
            return error_value();
        }
        const Reg reg = target();
        if (op == Operator::Add) check.emit.emit_number(OpCode::AddFK, reg, a.reg, k);
        else if (op == Operator::Subtract) check.emit.emit_number(OpCode::AddFK, reg, a.reg, -k);
        else if (op == Operator::Multiply) check.emit.emit_number(OpCode::MulFK, reg, a.reg, k);
        else check.emit.emit_number(OpCode::DivFK, reg, a.reg, k);
        return in_registers(type, reg);
    }
    if (a.is_constant() && op != Operator::Modulo) {
        const double k = a.constant.number;
        const Reg reg = target();
        if (op == Operator::Add) check.emit.emit_number(OpCode::AddFK, reg, b.reg, k);
        else if (op == Operator::Subtract) check.emit.emit_number(OpCode::SubKF, reg, b.reg, k);
        else if (op == Operator::Multiply) check.emit.emit_number(OpCode::MulFK, reg, b.reg, k);
        else check.emit.emit_number(OpCode::DivKF, reg, b.reg, k);
        return in_registers(type, reg);
    }
    const Reg x = in_register(check, a);
    const Reg y = in_register(check, b);
    const Reg reg = target();
    check.emit.emit(op == Operator::Add        ? OpCode::AddF
                    : op == Operator::Subtract ? OpCode::SubF
                    : op == Operator::Multiply ? OpCode::MulF
                    : op == Operator::Divide   ? OpCode::DivF
                                               : OpCode::ModF,
                    reg, x, y);
    return in_registers(type, reg);
}

/// Numbers: whole ones stay whole except in a division, because `X=5/2` means 2.5 on a drawing.
Value arithmetic(Check& check, Operator op, Value left, Value right, const Expr& expr, Reg hint) {
    const bool both_int =
        check.kind(left.type) == TypeKind::Int && check.kind(right.type) == TypeKind::Int;
    if (both_int && op != Operator::Divide) {
        if (left.is_constant() && right.is_constant()) {
            return fold_integers(check, op, left.constant.integer, right.constant.integer,
                                 expr.range);
        }
        return emit_integers(check, op, left, right, hint);
    }
    const bool is_sum = op == Operator::Add || op == Operator::Subtract || op == Operator::Modulo;
    const auto is_family = [&](const Value& v) {
        return check.kind(v.type) == TypeKind::Feed || check.kind(v.type) == TypeKind::Speed;
    };
    if (is_sum) {
        if (!match_quantities(check, left, right, expr)) return error_value();
        if (is_family(left)) return families(check, op, left, right, expr, hint);
        left = to_real(check, left);
        right = to_real(check, right);
        return emit_reals(check, op, left, right,
                          left.type == types::kInt ? types::kReal : left.type, hint, expr.range);
    }
    if (is_family(left) && is_family(right)) {
        if (op == Operator::Divide && left.type == right.type)
            return families(check, op, left, right, expr, hint);
        settle(check, left);
        settle(check, right);
        // A feed times a speed is that of each tooth or revolution times the revolutions of the
        // spindle.
        const bool is_per_turn =
            op == Operator::Multiply && check.kind(left.type) != check.kind(right.type);
        const auto plain = [&](const Value& v) {
            return plain_form(check, v,
                              is_per_turn && check.kind(v.type) == TypeKind::Feed ? 1 : 0);
        };
        left = plain(left);
        right = plain(right);
    }
    left = to_real(check, left);
    right = to_real(check, right);
    const Quantity a = check.type_info(left.type).quantity;
    const Quantity b = check.type_info(right.type).quantity;
    if (is_family(left) || (is_family(right) && op == Operator::Multiply)) {
        const TypeKind family = is_family(left) ? check.kind(left.type) : check.kind(right.type);
        const Type type = check.types.family(family, op == Operator::Multiply ? a * b : a / b);
        return emit_reals(check, op, left, right, type, hint, expr.range);
    }
    if (is_family(right)) {
        right = plain_form(check, right, 0);
        return emit_reals(check, op, left, right,
                          check.types.real(a / check.type_info(right.type).quantity), hint,
                          expr.range);
    }
    return emit_reals(check, op, left, right,
                      check.types.real(op == Operator::Multiply ? a * b : a / b), hint, expr.range);
}

namespace {

/// Two feeds or two speeds of which only the running program knows the form.
Value families(Check& check, Operator op, const Value& left, const Value& right, const Expr& expr,
               Reg hint) {
    if (!left.is_constant() || !right.is_constant()) {
        const Reg a = in_register(check, left);
        const Reg b = in_register(check, right);
        check.emit.emit(OpCode::SameForm, a, b);
        const Type type = op == Operator::Divide ? types::kReal : left.type;
        return emit_reals(check, op, in_registers(left.type, a), in_registers(right.type, b), type,
                          hint, expr.range);
    }
    return emit_reals(check, op, left, right, op == Operator::Divide ? types::kReal : left.type,
                      hint, expr.range);
}

}  // namespace

}  // namespace kadr::sema
