// builtins.cpp — the functions that the language has by itself: NC's mathematics, conversions.
#include "sema/builtins.h"

#include <array>

#include "base/diagnostics/sema.h"
#include "sema/arithmetic.h"
#include "sema/builtin_calls.h"
#include "sema/checking.h"
#include "sema/contours.h"
#include "sema/convert.h"
#include "sema/expressions.h"
#include "sema/operators.h"
#include "sema/optionals.h"
#include "sema/orienting.h"
#include "sema/tests.h"
#include "sema/texts.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;

namespace {

Value length_as(Check& check, Type type, const syntax::Expr& expr, std::string_view name);
Value distance_call(Check& check, const syntax::Expr& expr);

}  // namespace

namespace {

constexpr std::array<std::string_view, 48> kBuiltinNames = {
    "abs",      "acos",    "asin",   "atan",         "atan2",         "attempt",  "begun_near",
    "cbrt",     "ceil",    "cos",    "crossings",    "dialect",       "dialects", "diameter",
    "distance", "execute", "exp",    "expect_error", "floor",         "follow",   "follow_start",
    "hypot",    "image",   "inside", "int",          "intersections", "length",   "ln",
    "log",      "log10",   "max",    "min",          "mod",           "nearest",  "offset",
    "orient",   "pow",     "real",   "reverse",      "round",         "sign",     "sin",
    "sqrt",     "table",   "tan",    "tcp",          "text",          "trunc",
};

constexpr std::array<std::string_view, 6> kArrayMethods = {"append", "insert", "remove",
                                                           "pop",    "clear",  "count"};
constexpr std::array<std::string_view, 3> kTextMethods = {"part", "find", "count"};

}  // namespace

std::span<const std::string_view> builtin_names() { return kBuiltinNames; }
std::span<const std::string_view> array_methods() { return kArrayMethods; }
std::span<const std::string_view> text_methods() { return kTextMethods; }

std::vector<std::string_view> members_of(const TypeTable& types, Type type) {
    std::vector<std::string_view> names;
    switch (types[type].kind) {
        case TypeKind::Struct:
            for (const Member& member : types.struct_of(type).members) names.push_back(member.name);
            break;
        case TypeKind::Array:
            if (types[type].is_contour) {
                names = contour_properties();
                names.emplace_back("count");
            } else {
                names.assign(kArrayMethods.begin(), kArrayMethods.end());
                names.emplace_back("length");
            }
            break;
        case TypeKind::String:
            names.assign(kTextMethods.begin(), kTextMethods.end());
            names.emplace_back("length");
            break;
        case TypeKind::Execution:
            for (const FigureInfo& figure : all_figures()) names.push_back(figure.name);
            break;
        case TypeKind::Enum:
        case TypeKind::Error:
        case TypeKind::Void:
        case TypeKind::Bool:
        case TypeKind::Int:
        case TypeKind::Real:
        case TypeKind::Feed:
        case TypeKind::Speed:
        case TypeKind::Range: break;
    }
    return names;
}

Done require_argument_count(Check& check, const Expr& expr, std::string_view name,
                            std::size_t least, std::size_t most) {
    const auto arguments = check.ast().exprs(expr.list);
    for (const ExprId item : arguments) {
        const Expr& argument = check.ast()[item];
        if (argument.kind == ExprKind::Argument && !argument.text.is_empty()) {
            check.report(diag::UnknownArgument, argument.range)
                .arg(name)
                .arg(check.text(argument.text));
            return kFailed;
        }
    }
    if (arguments.size() >= least && arguments.size() <= most) return kDone;
    const std::string count = least == most ? std::to_string(least)
                              : most > 100  ? std::to_string(least) + " or more"
                                            : std::to_string(least) + " or " + std::to_string(most);
    check.report(diag::ArgumentCount, expr.range).arg(name).arg(count).arg(arguments.size());
    return kFailed;
}

std::optional<Value> numeric_argument(Check& check, ExprId item, std::string_view name) {
    const ExprId id =
        check.ast()[item].kind == ExprKind::Argument ? check.ast()[item].child[0] : item;
    Value value = require_given(check, expression(check, id), check.ast()[id].range, {});
    if (check.is_error(value)) return std::nullopt;
    if (!check.types.is_numeric(value.type)) {
        check.report(diag::OperandType, check.ast()[id].range)
            .arg(name)
            .arg(check.type_name(value.type));
        return std::nullopt;
    }
    return value;
}

namespace {

Value math_value(Check& check, Math function, const Value& a, Type type, const SourceRange& range,
                 Reg hint) {
    if (a.is_constant()) {
        const MathResult result = evaluate(function, a.constant.number);
        if (!result) {
            check.report(diag::ConstantFault, range).arg(describe(result.error()));
            return error_value();
        }
        return constant_number(*result, type);
    }
    const Reg reg = hint != kNoReg ? hint : check.emit.take(1);
    check.emit.emit(OpCode::Math1, reg, a.reg, static_cast<unsigned>(function));
    return in_registers(type, reg);
}

Value math_value(Check& check, Math function, const Value& a, const Value& b, Type type,
                 const SourceRange& range, Reg hint) {
    if (a.is_constant() && b.is_constant()) {
        const MathResult result = evaluate(function, a.constant.number, b.constant.number);
        if (!result) {
            check.report(diag::ConstantFault, range).arg(describe(result.error()));
            return error_value();
        }
        return constant_number(*result, type);
    }
    const Reg x = in_register(check, a);
    const Reg y = in_register(check, b);
    const Reg reg = hint != kNoReg ? hint : check.emit.take(1);
    check.emit.emit_pair(OpCode::Math2, reg, x, y, static_cast<std::int64_t>(function));
    return in_registers(type, reg);
}

Value math_call(Check& check, Math function, const Expr& expr, std::string_view name, Reg hint) {
    if (!require_argument_count(check, expr, name, 1, 1)) return error_value();
    const ExprId item = check.ast().exprs(expr.list)[0];
    const std::optional<Value> argument = numeric_argument(check, item, name);
    if (!argument) return error_value();
    const bool keeps = function == Math::Abs;
    const bool any = keeps || function == Math::Sign;
    if (check.kind(argument->type) == TypeKind::Int && any) {
        if (argument->is_constant()) {
            const std::int64_t n = argument->constant.integer;
            const std::optional<std::int64_t> amount = magnitude(n);
            if (keeps && !amount) {
                check.report(diag::ConstantFault, expr.range)
                    .arg("the whole number leaves 64 bits");
                return error_value();
            }
            return constant_integer(keeps ? *amount : (n > 0) - (n < 0), types::kInt);
        }
        const Reg reg = hint != kNoReg ? hint : check.emit.take(1);
        check.emit.emit_pair(OpCode::MathI, reg, argument->reg, 0,
                             static_cast<std::int64_t>(function));
        return in_registers(types::kInt, reg);
    }
    const Value value = to_real(check, *argument);
    const Quantity quantity = check.type_info(value.type).quantity;
    const bool is_plain = check.kind(value.type) == TypeKind::Real && quantity.is_number();
    if (!any && !is_plain) {
        check.report(diag::DimensionMismatch, check.ast()[item].range)
            .arg(quoted(name))
            .arg("number")
            .arg(check.kind(value.type) == TypeKind::Real ? describe(quantity)
                                                          : check.type_name(value.type));
        return error_value();
    }
    if (function == Math::Sign) {
        const Value result = math_value(check, function, value, types::kReal, expr.range, kNoReg);
        if (check.is_error(result)) return result;
        if (result.is_constant())
            return constant_integer(static_cast<std::int64_t>(result.constant.number), types::kInt);
        check.emit.emit(OpCode::ToInt, result.reg, result.reg,
                        static_cast<unsigned>(Rounding::Trunc));
        return in_registers(types::kInt, result.reg);
    }
    const bool gives_angle =
        function == Math::AsinDeg || function == Math::AcosDeg || function == Math::AtanDeg;
    const Type type = keeps ? value.type : gives_angle ? types::kAngleType : types::kReal;
    return math_value(check, function, value, type, expr.range, hint);
}

Value trigonometric(Check& check, OpCode op, const Expr& expr, std::string_view name, Reg hint) {
    if (!require_argument_count(check, expr, name, 1, 1)) return error_value();
    const ExprId item = check.ast().exprs(expr.list)[0];
    const std::optional<Value> argument = numeric_argument(check, item, name);
    if (!argument) return error_value();
    // A bare number is degrees, as on every control.
    const Value angle = convert(check, *argument, types::kAngleType, check.ast()[item].range, name);
    if (check.is_error(angle)) return angle;
    if (op == OpCode::Math1)
        return math_value(check, Math::TanDeg, angle, types::kReal, expr.range, hint);
    if (angle.is_constant()) {
        return constant_number(
            op == OpCode::SinDeg ? sin_deg(angle.constant.number) : cos_deg(angle.constant.number),
            types::kReal);
    }
    const Reg reg = hint != kNoReg ? hint : check.emit.take(1);
    check.emit.emit(op, reg, angle.reg);
    return in_registers(types::kReal, reg);
}

/// `sqrt` and `cbrt`, with the dimension of the root.
Value root_call(Check& check, int degree, const Expr& expr, std::string_view name) {
    if (!require_argument_count(check, expr, name, 1, 1)) return error_value();
    const ExprId item = check.ast().exprs(expr.list)[0];
    const std::optional<Value> argument = numeric_argument(check, item, name);
    if (!argument) return error_value();
    const Value value = to_real(check, *argument);
    const std::optional<Quantity> quantity = root(check.type_info(value.type).quantity, degree);
    if (check.kind(value.type) != TypeKind::Real || !quantity) {
        check.report(diag::RootOfQuantity, check.ast()[item].range)
            .arg(degree == 2 ? "square" : "cube")
            .arg(check.kind(value.type) == TypeKind::Real
                     ? describe(check.type_info(value.type).quantity)
                     : check.type_name(value.type));
        return error_value();
    }
    const Type type = check.types.real(*quantity);
    if (degree == 3) return math_value(check, Math::Cbrt, value, type, expr.range, kNoReg);
    if (value.is_constant()) {
        if (value.constant.number < 0) {
            check.report(diag::ConstantFault, expr.range).arg(describe(MathFault::NegativeRoot));
            return error_value();
        }
        return constant_number(std::sqrt(value.constant.number), type);
    }
    const Reg reg = check.emit.take(1);
    check.emit.emit(OpCode::Sqrt, reg, value.reg);
    return in_registers(type, reg);
}

Value power_call(Check& check, const Expr& expr) {
    if (!require_argument_count(check, expr, "pow", 2, 2)) return error_value();
    const auto arguments = check.ast().exprs(expr.list);
    const std::optional<Value> base = numeric_argument(check, arguments[0], "pow");
    const std::optional<Value> exponent = numeric_argument(check, arguments[1], "pow");
    if (!base || !exponent) return error_value();
    const Value a = to_real(check, *base);
    const Value b = to_real(check, *exponent);
    const auto is_plain = [&](const Value& v) {
        return check.kind(v.type) == TypeKind::Real && check.type_info(v.type).quantity.is_number();
    };
    if (!is_plain(b)) {
        check.report(diag::DimensionMismatch, check.ast()[arguments[1]].range)
            .arg("the exponent")
            .arg("number")
            .arg(check.type_name(b.type));
        return error_value();
    }
    Type type = types::kReal;
    if (!is_plain(a)) {
        // The dimension of the result must be known now: a whole constant exponent.
        const bool is_whole = b.is_constant() &&
                              b.constant.number == std::trunc(b.constant.number) &&
                              std::fabs(b.constant.number) <= 8;
        if (!is_whole || check.kind(a.type) != TypeKind::Real) {
            check.report(diag::PowerOfQuantity, expr.range).arg(check.type_name(a.type));
            return error_value();
        }
        type = check.types.real(
            power(check.type_info(a.type).quantity, static_cast<int>(b.constant.number)));
    }
    return math_value(check, Math::Pow, a, b, type, expr.range, kNoReg);
}

Value round_call(Check& check, Rounding rounding, const Expr& expr, std::string_view name) {
    if (!require_argument_count(check, expr, name, 1, 2)) return error_value();
    const auto arguments = check.ast().exprs(expr.list);
    const std::optional<Value> argument = numeric_argument(check, arguments[0], name);
    if (!argument) return error_value();
    const bool is_plain = check.kind(argument->type) == TypeKind::Real &&
                          check.type_info(argument->type).quantity.is_number();
    if (check.kind(argument->type) == TypeKind::Feed ||
        check.kind(argument->type) == TypeKind::Speed) {
        check.report(diag::OperandType, check.ast()[arguments[0]].range)
            .arg(name)
            .arg(check.type_name(argument->type));
        return error_value();
    }
    if (arguments.size() == 1) {
        if (check.kind(argument->type) == TypeKind::Int) return *argument;
        if (is_plain) {
            if (argument->is_constant()) {
                const std::optional<std::int64_t> whole =
                    to_integer(argument->constant.number, rounding);
                if (!whole) {
                    check.report(diag::ConstantFault, expr.range)
                        .arg("the whole number leaves 64 bits");
                    return error_value();
                }
                return constant_integer(*whole, types::kInt);
            }
            const Reg reg = check.emit.take(1);
            check.emit.emit(OpCode::ToInt, reg, argument->reg, static_cast<unsigned>(rounding));
            return in_registers(types::kInt, reg);
        }
    }
    // With a dimension: to a multiple of the second argument, else of one unit of the file.
    const Value value = to_real(check, *argument);
    double unit = bare_factor(check.type_info(value.type).quantity, check.here.units);
    if (arguments.size() == 2) {
        const std::optional<Value> step = numeric_argument(check, arguments[1], name);
        if (!step) return error_value();
        const Value converted =
            convert(check, *step, value.type, check.ast()[arguments[1]].range, "the step");
        if (check.is_error(converted)) return converted;
        if (!converted.is_constant() || !(converted.constant.number > 0)) {
            check.report(diag::NotConstant, check.ast()[arguments[1]].range)
                .arg("the step of the rounding");
            return error_value();
        }
        unit = converted.constant.number;
    }
    if (value.is_constant()) {
        return constant_number(round_to_unit(value.constant.number, rounding, unit), value.type);
    }
    const Reg reg = check.emit.take(1);
    check.emit.emit_number(OpCode::RoundF, reg, value.reg, unit, static_cast<unsigned>(rounding));
    return in_registers(value.type, reg);
}

Value extreme(Check& check, Math function, const Expr& expr, std::string_view name) {
    if (!require_argument_count(check, expr, name, 2, 1000)) return error_value();
    const auto arguments = check.ast().exprs(expr.list);
    std::optional<Value> result = numeric_argument(check, arguments[0], name);
    if (!result) return error_value();
    for (std::size_t i = 1; i < arguments.size(); ++i) {
        std::optional<Value> next = numeric_argument(check, arguments[i], name);
        if (!next) return error_value();
        Value left = *result;
        Value right = *next;
        if (check.kind(left.type) == TypeKind::Int && check.kind(right.type) == TypeKind::Int) {
            if (left.is_constant() && right.is_constant()) {
                const bool first = function == Math::Min
                                       ? left.constant.integer < right.constant.integer
                                       : left.constant.integer > right.constant.integer;
                result = first ? left : right;
                continue;
            }
            const Reg x = in_register(check, left);
            const Reg y = in_register(check, right);
            const Reg reg = check.emit.take(1);
            check.emit.emit_pair(OpCode::MathI, reg, x, y, static_cast<std::int64_t>(function));
            result = in_registers(types::kInt, reg);
            continue;
        }
        if (!match_quantities(check, left, right, expr)) return error_value();
        const bool is_family =
            check.kind(left.type) == TypeKind::Feed || check.kind(left.type) == TypeKind::Speed;
        left = to_real(check, left);
        right = to_real(check, right);
        if (is_family && !(left.is_constant() && right.is_constant())) {
            left = in_registers(left.type, in_register(check, left));
            right = in_registers(right.type, in_register(check, right));
            check.emit.emit(OpCode::SameForm, left.reg, right.reg);
        }
        result = math_value(check, function, left, right, left.type, expr.range, kNoReg);
        if (check.is_error(*result)) return *result;
    }
    return *result;
}

Value mod_call(Check& check, const Expr& expr) {
    if (!require_argument_count(check, expr, "mod", 2, 2)) return error_value();
    const auto arguments = check.ast().exprs(expr.list);
    const std::optional<Value> a = numeric_argument(check, arguments[0], "mod");
    const std::optional<Value> b = numeric_argument(check, arguments[1], "mod");
    if (!a || !b) return error_value();
    Expr operation = expr;
    operation.op = syntax::Operator::Modulo;
    return arithmetic(check, syntax::Operator::Modulo, *a, *b, operation, kNoReg);
}

struct MathRow {
    std::string_view name;
    Math function;
};
constexpr MathRow kOneNumber[] = {
    {"abs", Math::Abs},      {"sign", Math::Sign},    {"asin", Math::AsinDeg},
    {"acos", Math::AcosDeg}, {"atan", Math::AtanDeg}, {"exp", Math::Exp},
    {"ln", Math::Ln},        {"log", Math::Ln},       {"log10", Math::Log10},
};

}  // namespace

std::optional<Value> builtin(Check& check, std::string_view name, const Expr& expr, Reg hint) {
    if (const std::optional<Value> value = contour_function(check, name, expr)) return value;
    for (const MathRow& row : kOneNumber) {
        if (row.name == name) {
            if (name == "atan" && expr.list.count == 2) return builtin(check, "atan2", expr, hint);
            return math_call(check, row.function, expr, name, hint);
        }
    }
    if (name == "sin") return trigonometric(check, OpCode::SinDeg, expr, name, hint);
    if (name == "cos") return trigonometric(check, OpCode::CosDeg, expr, name, hint);
    if (name == "tan") return trigonometric(check, OpCode::Math1, expr, name, hint);
    if (name == "sqrt") return root_call(check, 2, expr, name);
    if (name == "cbrt") return root_call(check, 3, expr, name);
    if (name == "pow") return power_call(check, expr);
    if (name == "floor") return round_call(check, Rounding::Floor, expr, name);
    if (name == "ceil") return round_call(check, Rounding::Ceil, expr, name);
    if (name == "round") return round_call(check, Rounding::Round, expr, name);
    if (name == "trunc" || name == "int") return round_call(check, Rounding::Trunc, expr, name);
    if (name == "min") return extreme(check, Math::Min, expr, name);
    if (name == "max") return extreme(check, Math::Max, expr, name);
    if (name == "mod") return mod_call(check, expr);
    if (name == "atan2" || name == "hypot") {
        if (!require_argument_count(check, expr, name, 2, 2)) return error_value();
        const auto arguments = check.ast().exprs(expr.list);
        std::optional<Value> a = numeric_argument(check, arguments[0], name);
        std::optional<Value> b = numeric_argument(check, arguments[1], name);
        if (!a || !b) return error_value();
        Value left = to_real(check, *a);
        Value right = to_real(check, *b);
        if (!match_quantities(check, left, right, expr)) return error_value();
        if (check.kind(left.type) != TypeKind::Real) left = plain_form(check, left, 0);
        if (check.kind(right.type) != TypeKind::Real) right = plain_form(check, right, 0);
        const bool is_angle = name == "atan2";
        return math_value(check, is_angle ? Math::Atan2Deg : Math::Hypot, left, right,
                          is_angle ? types::kAngleType : left.type, expr.range, hint);
    }
    if (name == "real") {
        if (!require_argument_count(check, expr, name, 1, 1)) return error_value();
        const ExprId item = check.ast().exprs(expr.list)[0];
        const std::optional<Value> value = numeric_argument(check, item, name);
        if (!value) return error_value();
        return convert(check, *value, types::kReal, check.ast()[item].range, name);
    }
    if (const std::optional<Value> value = test_builtin(check, name, expr)) return *value;
    if (name == "text") {
        if (!require_argument_count(check, expr, name, 1, 1)) return error_value();
        const ExprId item = check.ast().exprs(expr.list)[0];
        return text_of(check,
                       require_given(check, expression(check, item), check.ast()[item].range, {}),
                       check.ast()[item].range);
    }
    if (name == "image") {
        check.report(diag::ImageType, expr.range)
            .arg("image(…)")
            .fix("name the struct that takes it: `image<picture>(…)`");
        return error_value();
    }
    if (name == "table") {
        check.report(diag::TableType, expr.range)
            .arg("table(…)")
            .fix("name the struct of a row: `table<row>(…)`");
        return error_value();
    }
    if (name == "orient") return orient_call(check, expr);
    if (name == "tcp") return tcp_call(check, expr);
    if (name == "distance") return distance_call(check, expr);
    if (name == "diameter") return length_as(check, types::kDiameter, expr, name);
    if (name == "length") return length_as(check, types::kLengthType, expr, name);
    return std::nullopt;
}

namespace {

/// A length as a diameter: `diameter(2*r)`; a diameter as a length of the same measure:
/// `length(d)`.
Value length_as(Check& check, Type type, const Expr& expr, std::string_view name) {
    if (!require_argument_count(check, expr, name, 1, 1)) return error_value();
    const ExprId item = check.ast().exprs(expr.list)[0];
    const std::optional<Value> value = numeric_argument(check, item, name);
    if (!value) return error_value();
    const bool is_length = check.kind(value->type) == TypeKind::Real &&
                           check.type_info(value->type).quantity == kLength;
    if (is_length) return retyped(*value, type);
    return convert(check, *value, type, check.ast()[item].range, name);
}

/// Distance of two points in the coordinates that they have: both the same ones.
Value distance_call(Check& check, const Expr& expr) {
    if (!require_argument_count(check, expr, "distance", 2, 2)) return error_value();
    const auto arguments = check.ast().exprs(expr.list);
    const Reg a = expression_in(check, arguments[0], types::kPoint, kNoReg, "the first point");
    const Reg b = expression_in(check, arguments[1], types::kPoint, kNoReg, "the second point");
    check_same_parts(check, a, arguments[0], b, arguments[1]);
    Label any;
    check.emit.jump(OpCode::JumpIf, any, is_given(check, in_registers(types::kPoint, a)).reg);
    check.emit.emit_pair(OpCode::CheckGiven, a, 0, static_cast<unsigned>(SlotKind::Number),
                         text_constant(check, check.sources.text(check.ast()[arguments[0]].range)));
    check.emit.bind(any);
    const Reg sum = check.emit.take(1);
    const Reg part = check.emit.take(1);
    check.emit.emit_number(OpCode::LoadF, sum, 0, 0);
    for (unsigned i = 0; i < 3; ++i) {
        Label next;
        check.emit.jump(OpCode::JumpNotGiven, next, a + i, 0,
                        static_cast<unsigned>(SlotKind::Number));
        check.emit.emit(OpCode::SubF, part, a + i, b + i);
        check.emit.emit_pair(OpCode::Math2, sum, sum, part, static_cast<std::int64_t>(Math::Hypot));
        check.emit.bind(next);
    }
    return in_registers(types::kLengthType, sum);
}

}  // namespace

}  // namespace kadr::sema
