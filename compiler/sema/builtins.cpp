// builtins.cpp — the functions that the language has by itself: NC's mathematics, conversions.
#include "sema/builtins.h"

#include <array>

#include "base/diagnostics/sema.h"
#include "sema/arithmetic.h"
#include "sema/checker.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;

namespace {

constexpr std::array<std::string_view, 48> kNames = {
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

std::span<const std::string_view> builtin_names() { return kNames; }
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

Done Checker::require_argument_count(const Expr& expr, std::string_view name, std::size_t least,
                                     std::size_t most) {
    const auto arguments = ast().exprs(expr.list);
    for (const ExprId item : arguments) {
        const Expr& argument = ast()[item];
        if (argument.kind == ExprKind::Argument && !argument.text.is_empty()) {
            report(diag::UnknownArgument, argument.range).arg(name).arg(text(argument.text));
            return kFailed;
        }
    }
    if (arguments.size() >= least && arguments.size() <= most) return kDone;
    const std::string count = least == most ? std::to_string(least)
                              : most > 100  ? std::to_string(least) + " or more"
                                            : std::to_string(least) + " or " + std::to_string(most);
    report(diag::ArgumentCount, expr.range).arg(name).arg(count).arg(arguments.size());
    return kFailed;
}

std::optional<Value> Checker::numeric_argument(ExprId item, std::string_view name) {
    const ExprId id = ast()[item].kind == ExprKind::Argument ? ast()[item].child[0] : item;
    Value value = require_given(expression(id), ast()[id].range, {});
    if (is_error(value)) return std::nullopt;
    if (!types_.is_numeric(value.type)) {
        report(diag::OperandType, ast()[id].range).arg(name).arg(type_name(value.type));
        return std::nullopt;
    }
    return value;
}

Value Checker::math_value(Math function, const Value& a, Type type, const SourceRange& range,
                          Reg hint) {
    if (a.is_constant()) {
        const MathResult result = evaluate(function, a.constant.number);
        if (!result) {
            report(diag::ConstantFault, range).arg(describe(result.error()));
            return error_value();
        }
        return constant_number(*result, type);
    }
    const Reg reg = hint != kNoReg ? hint : emit_.take(1);
    emit_.emit(OpCode::Math1, reg, a.reg, static_cast<unsigned>(function));
    return in_registers(type, reg);
}

Value Checker::math_value(Math function, const Value& a, const Value& b, Type type,
                          const SourceRange& range, Reg hint) {
    if (a.is_constant() && b.is_constant()) {
        const MathResult result = evaluate(function, a.constant.number, b.constant.number);
        if (!result) {
            report(diag::ConstantFault, range).arg(describe(result.error()));
            return error_value();
        }
        return constant_number(*result, type);
    }
    const Reg x = in_register(a);
    const Reg y = in_register(b);
    const Reg reg = hint != kNoReg ? hint : emit_.take(1);
    emit_.emit_pair(OpCode::Math2, reg, x, y, static_cast<std::int64_t>(function));
    return in_registers(type, reg);
}

Value Checker::math_call(Math function, const Expr& expr, std::string_view name, Reg hint) {
    if (!require_argument_count(expr, name, 1, 1)) return error_value();
    const ExprId item = ast().exprs(expr.list)[0];
    const std::optional<Value> argument = numeric_argument(item, name);
    if (!argument) return error_value();
    const bool keeps = function == Math::Abs;
    const bool any = keeps || function == Math::Sign;
    if (kind(argument->type) == TypeKind::Int && any) {
        if (argument->is_constant()) {
            const std::int64_t n = argument->constant.integer;
            const std::optional<std::int64_t> amount = magnitude(n);
            if (keeps && !amount) {
                report(diag::ConstantFault, expr.range).arg("the whole number leaves 64 bits");
                return error_value();
            }
            return constant_integer(keeps ? *amount : (n > 0) - (n < 0), types::kInt);
        }
        const Reg reg = hint != kNoReg ? hint : emit_.take(1);
        emit_.emit_pair(OpCode::MathI, reg, argument->reg, 0, static_cast<std::int64_t>(function));
        return in_registers(types::kInt, reg);
    }
    const Value value = to_real(*argument);
    const Quantity quantity = type_info(value.type).quantity;
    const bool is_plain = kind(value.type) == TypeKind::Real && quantity.is_number();
    if (!any && !is_plain) {
        report(diag::DimensionMismatch, ast()[item].range)
            .arg(quoted(name))
            .arg("number")
            .arg(kind(value.type) == TypeKind::Real ? describe(quantity) : type_name(value.type));
        return error_value();
    }
    if (function == Math::Sign) {
        const Value result = math_value(function, value, types::kReal, expr.range, kNoReg);
        if (is_error(result)) return result;
        if (result.is_constant())
            return constant_integer(static_cast<std::int64_t>(result.constant.number), types::kInt);
        emit_.emit(OpCode::ToInt, result.reg, result.reg, static_cast<unsigned>(Rounding::Trunc));
        return in_registers(types::kInt, result.reg);
    }
    const bool gives_angle =
        function == Math::AsinDeg || function == Math::AcosDeg || function == Math::AtanDeg;
    const Type type = keeps ? value.type : gives_angle ? types::kAngleType : types::kReal;
    return math_value(function, value, type, expr.range, hint);
}

Value Checker::trigonometric(OpCode op, const Expr& expr, std::string_view name, Reg hint) {
    if (!require_argument_count(expr, name, 1, 1)) return error_value();
    const ExprId item = ast().exprs(expr.list)[0];
    const std::optional<Value> argument = numeric_argument(item, name);
    if (!argument) return error_value();
    // A bare number is degrees, as on every control.
    const Value angle = convert(*argument, types::kAngleType, ast()[item].range, name);
    if (is_error(angle)) return angle;
    if (op == OpCode::Math1) return math_value(Math::TanDeg, angle, types::kReal, expr.range, hint);
    if (angle.is_constant()) {
        return constant_number(
            op == OpCode::SinDeg ? sin_deg(angle.constant.number) : cos_deg(angle.constant.number),
            types::kReal);
    }
    const Reg reg = hint != kNoReg ? hint : emit_.take(1);
    emit_.emit(op, reg, angle.reg);
    return in_registers(types::kReal, reg);
}

/// `sqrt` and `cbrt`, with the dimension of the root.
Value Checker::root_call(int degree, const Expr& expr, std::string_view name) {
    if (!require_argument_count(expr, name, 1, 1)) return error_value();
    const ExprId item = ast().exprs(expr.list)[0];
    const std::optional<Value> argument = numeric_argument(item, name);
    if (!argument) return error_value();
    const Value value = to_real(*argument);
    const std::optional<Quantity> quantity = root(type_info(value.type).quantity, degree);
    if (kind(value.type) != TypeKind::Real || !quantity) {
        report(diag::RootOfQuantity, ast()[item].range)
            .arg(degree == 2 ? "square" : "cube")
            .arg(kind(value.type) == TypeKind::Real ? describe(type_info(value.type).quantity)
                                                    : type_name(value.type));
        return error_value();
    }
    const Type type = types_.real(*quantity);
    if (degree == 3) return math_value(Math::Cbrt, value, type, expr.range, kNoReg);
    if (value.is_constant()) {
        if (value.constant.number < 0) {
            report(diag::ConstantFault, expr.range).arg(describe(MathFault::NegativeRoot));
            return error_value();
        }
        return constant_number(std::sqrt(value.constant.number), type);
    }
    const Reg reg = emit_.take(1);
    emit_.emit(OpCode::Sqrt, reg, value.reg);
    return in_registers(type, reg);
}

Value Checker::power_call(const Expr& expr) {
    if (!require_argument_count(expr, "pow", 2, 2)) return error_value();
    const auto arguments = ast().exprs(expr.list);
    const std::optional<Value> base = numeric_argument(arguments[0], "pow");
    const std::optional<Value> exponent = numeric_argument(arguments[1], "pow");
    if (!base || !exponent) return error_value();
    const Value a = to_real(*base);
    const Value b = to_real(*exponent);
    const auto is_plain = [&](const Value& v) {
        return kind(v.type) == TypeKind::Real && type_info(v.type).quantity.is_number();
    };
    if (!is_plain(b)) {
        report(diag::DimensionMismatch, ast()[arguments[1]].range)
            .arg("the exponent")
            .arg("number")
            .arg(type_name(b.type));
        return error_value();
    }
    Type type = types::kReal;
    if (!is_plain(a)) {
        // The dimension of the result must be known now: a whole constant exponent.
        const bool is_whole = b.is_constant() &&
                              b.constant.number == std::trunc(b.constant.number) &&
                              std::fabs(b.constant.number) <= 8;
        if (!is_whole || kind(a.type) != TypeKind::Real) {
            report(diag::PowerOfQuantity, expr.range).arg(type_name(a.type));
            return error_value();
        }
        type = types_.real(power(type_info(a.type).quantity, static_cast<int>(b.constant.number)));
    }
    return math_value(Math::Pow, a, b, type, expr.range, kNoReg);
}

Value Checker::round_call(Rounding rounding, const Expr& expr, std::string_view name) {
    if (!require_argument_count(expr, name, 1, 2)) return error_value();
    const auto arguments = ast().exprs(expr.list);
    const std::optional<Value> argument = numeric_argument(arguments[0], name);
    if (!argument) return error_value();
    const bool is_plain =
        kind(argument->type) == TypeKind::Real && type_info(argument->type).quantity.is_number();
    if (kind(argument->type) == TypeKind::Feed || kind(argument->type) == TypeKind::Speed) {
        report(diag::OperandType, ast()[arguments[0]].range)
            .arg(name)
            .arg(type_name(argument->type));
        return error_value();
    }
    if (arguments.size() == 1) {
        if (kind(argument->type) == TypeKind::Int) return *argument;
        if (is_plain) {
            if (argument->is_constant()) {
                const std::optional<std::int64_t> whole =
                    to_integer(argument->constant.number, rounding);
                if (!whole) {
                    report(diag::ConstantFault, expr.range).arg("the whole number leaves 64 bits");
                    return error_value();
                }
                return constant_integer(*whole, types::kInt);
            }
            const Reg reg = emit_.take(1);
            emit_.emit(OpCode::ToInt, reg, argument->reg, static_cast<unsigned>(rounding));
            return in_registers(types::kInt, reg);
        }
    }
    // With a dimension: to a multiple of the second argument, else of one unit of the file.
    const Value value = to_real(*argument);
    double unit = bare_factor(type_info(value.type).quantity, units_);
    if (arguments.size() == 2) {
        const std::optional<Value> step = numeric_argument(arguments[1], name);
        if (!step) return error_value();
        const Value converted = convert(*step, value.type, ast()[arguments[1]].range, "the step");
        if (is_error(converted)) return converted;
        if (!converted.is_constant() || !(converted.constant.number > 0)) {
            report(diag::NotConstant, ast()[arguments[1]].range).arg("the step of the rounding");
            return error_value();
        }
        unit = converted.constant.number;
    }
    if (value.is_constant()) {
        return constant_number(round_to_unit(value.constant.number, rounding, unit), value.type);
    }
    const Reg reg = emit_.take(1);
    emit_.emit_number(OpCode::RoundF, reg, value.reg, unit, static_cast<unsigned>(rounding));
    return in_registers(value.type, reg);
}

Value Checker::extreme(Math function, const Expr& expr, std::string_view name) {
    if (!require_argument_count(expr, name, 2, 1000)) return error_value();
    const auto arguments = ast().exprs(expr.list);
    std::optional<Value> result = numeric_argument(arguments[0], name);
    if (!result) return error_value();
    for (std::size_t i = 1; i < arguments.size(); ++i) {
        std::optional<Value> next = numeric_argument(arguments[i], name);
        if (!next) return error_value();
        Value left = *result;
        Value right = *next;
        if (kind(left.type) == TypeKind::Int && kind(right.type) == TypeKind::Int) {
            if (left.is_constant() && right.is_constant()) {
                const bool first = function == Math::Min
                                       ? left.constant.integer < right.constant.integer
                                       : left.constant.integer > right.constant.integer;
                result = first ? left : right;
                continue;
            }
            const Reg x = in_register(left);
            const Reg y = in_register(right);
            const Reg reg = emit_.take(1);
            emit_.emit_pair(OpCode::MathI, reg, x, y, static_cast<std::int64_t>(function));
            result = in_registers(types::kInt, reg);
            continue;
        }
        if (!match_quantities(left, right, expr)) return error_value();
        const bool is_family =
            kind(left.type) == TypeKind::Feed || kind(left.type) == TypeKind::Speed;
        left = to_real(left);
        right = to_real(right);
        if (is_family && !(left.is_constant() && right.is_constant())) {
            left = in_registers(left.type, in_register(left));
            right = in_registers(right.type, in_register(right));
            emit_.emit(OpCode::SameForm, left.reg, right.reg);
        }
        result = math_value(function, left, right, left.type, expr.range, kNoReg);
        if (is_error(*result)) return *result;
    }
    return *result;
}

Value Checker::mod_call(const Expr& expr) {
    if (!require_argument_count(expr, "mod", 2, 2)) return error_value();
    const auto arguments = ast().exprs(expr.list);
    const std::optional<Value> a = numeric_argument(arguments[0], "mod");
    const std::optional<Value> b = numeric_argument(arguments[1], "mod");
    if (!a || !b) return error_value();
    Expr operation = expr;
    operation.op = syntax::Operator::Modulo;
    return arithmetic(syntax::Operator::Modulo, *a, *b, operation, kNoReg);
}

namespace {

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

std::optional<Value> Checker::builtin(std::string_view name, const Expr& expr, Reg hint) {
    if (const std::optional<Value> value = contour_function(name, expr)) return value;
    for (const MathRow& row : kOneNumber) {
        if (row.name == name) {
            if (name == "atan" && expr.list.count == 2) return builtin("atan2", expr, hint);
            return math_call(row.function, expr, name, hint);
        }
    }
    if (name == "sin") return trigonometric(OpCode::SinDeg, expr, name, hint);
    if (name == "cos") return trigonometric(OpCode::CosDeg, expr, name, hint);
    if (name == "tan") return trigonometric(OpCode::Math1, expr, name, hint);
    if (name == "sqrt") return root_call(2, expr, name);
    if (name == "cbrt") return root_call(3, expr, name);
    if (name == "pow") return power_call(expr);
    if (name == "floor") return round_call(Rounding::Floor, expr, name);
    if (name == "ceil") return round_call(Rounding::Ceil, expr, name);
    if (name == "round") return round_call(Rounding::Round, expr, name);
    if (name == "trunc" || name == "int") return round_call(Rounding::Trunc, expr, name);
    if (name == "min") return extreme(Math::Min, expr, name);
    if (name == "max") return extreme(Math::Max, expr, name);
    if (name == "mod") return mod_call(expr);
    if (name == "atan2" || name == "hypot") {
        if (!require_argument_count(expr, name, 2, 2)) return error_value();
        const auto arguments = ast().exprs(expr.list);
        std::optional<Value> a = numeric_argument(arguments[0], name);
        std::optional<Value> b = numeric_argument(arguments[1], name);
        if (!a || !b) return error_value();
        Value left = to_real(*a);
        Value right = to_real(*b);
        if (!match_quantities(left, right, expr)) return error_value();
        if (kind(left.type) != TypeKind::Real) left = plain_form(left, 0);
        if (kind(right.type) != TypeKind::Real) right = plain_form(right, 0);
        const bool is_angle = name == "atan2";
        return math_value(is_angle ? Math::Atan2Deg : Math::Hypot, left, right,
                          is_angle ? types::kAngleType : left.type, expr.range, hint);
    }
    if (name == "real") {
        if (!require_argument_count(expr, name, 1, 1)) return error_value();
        const ExprId item = ast().exprs(expr.list)[0];
        const std::optional<Value> value = numeric_argument(item, name);
        if (!value) return error_value();
        return convert(*value, types::kReal, ast()[item].range, name);
    }
    if (const std::optional<Value> value = test_builtin(name, expr)) return *value;
    if (name == "text") {
        if (!require_argument_count(expr, name, 1, 1)) return error_value();
        const ExprId item = ast().exprs(expr.list)[0];
        return text_of(require_given(expression(item), ast()[item].range, {}), ast()[item].range);
    }
    if (name == "image") {
        report(diag::ImageType, expr.range)
            .arg("image(…)")
            .fix("name the struct that takes it: `image<picture>(…)`");
        return error_value();
    }
    if (name == "table") {
        report(diag::TableType, expr.range)
            .arg("table(…)")
            .fix("name the struct of a row: `table<row>(…)`");
        return error_value();
    }
    if (name == "orient") return orient_call(expr);
    if (name == "tcp") return tcp_call(expr);
    if (name == "distance") return distance_call(expr);
    if (name == "diameter") return length_as(types::kDiameter, expr, name);
    if (name == "length") return length_as(types::kLengthType, expr, name);
    return std::nullopt;
}

/// A length as a diameter: `diameter(2*r)`; a diameter as a length of the same measure:
/// `length(d)`.
Value Checker::length_as(Type type, const Expr& expr, std::string_view name) {
    if (!require_argument_count(expr, name, 1, 1)) return error_value();
    const ExprId item = ast().exprs(expr.list)[0];
    const std::optional<Value> value = numeric_argument(item, name);
    if (!value) return error_value();
    const bool is_length =
        kind(value->type) == TypeKind::Real && type_info(value->type).quantity == kLength;
    if (is_length) return retyped(*value, type);
    return convert(*value, type, ast()[item].range, name);
}

/// Distance of two points in the coordinates that they have: both the same ones.
Value Checker::distance_call(const Expr& expr) {
    if (!require_argument_count(expr, "distance", 2, 2)) return error_value();
    const auto arguments = ast().exprs(expr.list);
    const Reg a = expression_in(arguments[0], types::kPoint, kNoReg, "the first point");
    const Reg b = expression_in(arguments[1], types::kPoint, kNoReg, "the second point");
    check_same_parts(a, arguments[0], b, arguments[1]);
    Label any;
    emit_.jump(OpCode::JumpIf, any, is_given(in_registers(types::kPoint, a)).reg);
    emit_.emit_pair(OpCode::CheckGiven, a, 0, static_cast<unsigned>(SlotKind::Number),
                    text_constant(sources_.text(ast()[arguments[0]].range)));
    emit_.bind(any);
    const Reg sum = emit_.take(1);
    const Reg part = emit_.take(1);
    emit_.emit_number(OpCode::LoadF, sum, 0, 0);
    for (unsigned i = 0; i < 3; ++i) {
        Label next;
        emit_.jump(OpCode::JumpNotGiven, next, a + i, 0, static_cast<unsigned>(SlotKind::Number));
        emit_.emit(OpCode::SubF, part, a + i, b + i);
        emit_.emit_pair(OpCode::Math2, sum, sum, part, static_cast<std::int64_t>(Math::Hypot));
        emit_.bind(next);
    }
    return in_registers(types::kLengthType, sum);
}

}  // namespace kadr::sema
