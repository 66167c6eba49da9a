// orienting.cpp — how the tool stands: `orient(…)`, by itself and behind the words of a block, and
// `tcp(on)`, under which it acts.
//
// Whatever the program has, a block gets the direction from the tip to the holder, which every
// control with such words takes; angles are worked out here.
#include "sema/orienting.h"

#include <algorithm>
#include <array>

#include "base/diagnostics/expand.h"
#include "base/diagnostics/sema.h"
#include "base/diagnostics/syntax.h"
#include "sema/arithmetic.h"
#include "sema/blocks.h"
#include "sema/builtin_calls.h"
#include "sema/calls.h"
#include "sema/checking.h"
#include "sema/convert.h"
#include "sema/operators.h"
#include "sema/scope.h"
#include "sema/unknown_names.h"
#include "sema/values.h"
#include "syntax/parse.h"

namespace kadr::sema {

using nc::Function;
using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;

namespace {

Done take_parts(Check& check, std::span<const syntax::ExprId> bound, Reg first);
Done take_angles(Check& check, std::span<const syntax::ExprId> bound, const SourceRange& range,
                 Reg first);

}  // namespace

namespace {

/// What `orient` takes: the direction by its components, or rotated about X by `a`, the new Y by
/// `b`.
constexpr std::array<std::string_view, 5> kOrientNames = {"i", "j", "k", "a", "b"};
constexpr std::size_t kComponents = 3;

/// Whether the expression is a call of `orient`, and of no function of the program.
bool is_orient(const Check& check, ExprId id) {
    if (!id.is_valid() || check.ast()[id].kind != ExprKind::Call) return false;
    const Expr& callee = check.ast()[check.ast()[id].child[0]];
    if (callee.kind != ExprKind::Name || check.text(callee.text) != "orient") return false;
    const Found found = find(check, "orient");
    return found.symbol < 0 && found.name == nullptr;
}

/// `G0 Xd Yd;`: to the parser two points.
Done require_no_glued_point(Check& check, const SourceRange& range) {
    const std::string_view spelled = check.sources.text(range);
    const std::size_t end = std::min(spelled.find_first_of(" \t.+-*/([{"), spelled.size());
    const std::string_view name = spelled.substr(0, end);
    const std::size_t letters = syntax::glued_address(check.dialect(), name);
    const Found found = find(check, name);
    if (letters == 0 || found.symbol >= 0 || found.name != nullptr) return kDone;
    auto builder =
        check.report(diag::WordWithoutValue,
                     {range.file, range.begin, range.begin + static_cast<std::uint32_t>(letters)});
    builder.arg(quoted(name.substr(0, letters)));
    fix_glued(letters, range, builder);
    return kFailed;
}

}  // namespace

/// One point and one `orient(…)`, in whatever order.
BehindWords behind_words(Check& check, const syntax::Stmt& stmt) {
    BehindWords behind;
    for (const ExprId id : stmt.expression) {
        if (!id.is_valid()) continue;
        const bool is_direction = is_orient(check, id);
        ExprId& place = is_direction ? behind.orient : behind.point;
        if (!place.is_valid()) {
            place = id;
            continue;
        }
        if (!is_direction && !require_no_glued_point(check, check.ast()[id].range)) continue;
        check.report(diag::BehindWordsTwice, check.ast()[id].range)
            .arg(check.sources.text(check.ast()[id].range))
            .arg(is_direction ? "direction" : "point");
    }
    return behind;
}

/// The direction that a call of `orient` gives, in the registers from `first`.
Done take_direction(Check& check, const Expr& expr, Reg first) {
    const auto bound = bind_arguments(check, expr, "orient", kOrientNames, {});
    if (!bound) return kFailed;
    const auto is_given = [&](std::size_t i) { return (*bound)[i].is_valid(); };
    const bool by_parts = is_given(0) || is_given(1) || is_given(2);
    const bool by_angles = is_given(3) || is_given(4);
    if (by_parts == by_angles) {
        check.report(diag::OrientArguments, expr.range)
            .arg(by_parts ? "components and angles" : "no direction")
            .fix(
                "say the direction from the tip to the holder, `orient(i: 0.5, k: 1)`, or its "
                "angles, `orient(b: 30deg)`");
        return kFailed;
    }
    const Reg mark = check.emit.mark();
    const Done taken =
        by_parts ? take_parts(check, *bound, first) : take_angles(check, *bound, expr.range, first);
    check.emit.release_to(mark);
    return taken;
}

namespace {

/// Numbers or lengths of any size; what is not given is 0.
Done take_parts(Check& check, std::span<const ExprId> bound, Reg first) {
    for (std::size_t i = 0; i < kComponents; ++i) {
        const auto reg = static_cast<Reg>(first + i);
        if (!bound[i].is_valid()) {
            check.emit.emit_number(OpCode::LoadF, reg, 0, 0);
            continue;
        }
        const std::optional<Value> argument = numeric_argument(check, bound[i], "orient");
        if (!argument) return kFailed;
        const Value value = to_real(check, *argument);
        const TypeInfo& info = check.type_info(value.type);
        const bool is_component =
            info.kind == TypeKind::Real && (info.quantity.is_number() || info.quantity == kLength);
        if (!is_component) {
            check.report(diag::DimensionMismatch, check.ast()[bound[i]].range)
                .arg(kOrientNames[i])
                .arg("number")
                .arg(check.type_name(value.type));
            return kFailed;
        }
        copy_value(check, value, reg);
    }
    return kDone;
}

/// Where Z comes to, rotated about X by a, then about the new Y by b: as Z of a tilted plane.
///
/// source  Rx(a)·Ry(b)·z = (sin b, −sin a·cos b, cos a·cos b)
Done take_angles(Check& check, std::span<const ExprId> bound, const SourceRange& range, Reg first) {
    std::array<Value, 2> sines;
    std::array<Value, 2> cosines;
    const auto figure = [&](OpCode op, const Value& angle) {
        if (angle.is_constant()) {
            const double number = angle.constant.number;
            return constant_number(op == OpCode::SinDeg ? sin_deg(number) : cos_deg(number),
                                   types::kReal);
        }
        const Reg reg = check.emit.take(1);
        check.emit.emit(op, reg, angle.reg);
        return in_registers(types::kReal, reg);
    };
    for (std::size_t i = 0; i < 2; ++i) {
        const ExprId id = bound[kComponents + i];
        Value angle = constant_number(0, types::kAngleType);
        if (id.is_valid()) {
            const std::optional<Value> argument = numeric_argument(check, id, "orient");
            if (!argument) return kFailed;
            angle = convert(check, *argument, types::kAngleType, check.ast()[id].range,
                            kOrientNames[kComponents + i]);
            if (check.is_error(angle)) return kFailed;
        }
        sines[i] = figure(OpCode::SinDeg, angle);
        cosines[i] = figure(OpCode::CosDeg, angle);
    }
    const auto times = [&](const Value& a, const Value& b) {
        return emit_reals(check, Operator::Multiply, a, b, types::kReal, kNoReg, range);
    };
    copy_value(check, sines[1], first);
    copy_value(check, times(times(sines[0], constant_number(-1, types::kReal)), cosines[1]),
               static_cast<Reg>(first + 1));
    copy_value(check, times(cosines[0], cosines[1]), static_cast<Reg>(first + 2));
    return kDone;
}

}  // namespace

/// Adds the components to a plan; their values stand in registers behind those of its fillings.
Done add_direction(Check& check, Plan& plan, const SourceRange& range) {
    const bool has_room =
        plan.functions.size() + kComponents <= nc::kMaxInvocations &&
        std::size_t{plan.argument_count} + 2 * kComponents <= nc::kMaxArguments &&
        std::ranges::none_of(plan.functions, [](const nc::Invocation& call) {
            return call.function == Function::Cycle || call.function == Function::ToolVector;
        });
    if (!has_room) {
        check.report(diag::OrientBlock, range);
        return kFailed;
    }
    plan.customs |= custom::kDirection;
    constexpr std::size_t kComponent = nc::parameter_of<Function::ToolVector>("component");
    constexpr std::size_t kValue = nc::parameter_of<Function::ToolVector>("value");
    for (std::size_t i = 0; i < kComponents; ++i) {
        nc::Invocation invocation;
        invocation.function = Function::ToolVector;
        invocation.first = plan.argument_count;
        invocation.given = 1u << kComponent;
        plan.arguments.emplace_back(plan.argument_count + kComponent, static_cast<double>(i));
        Filling filling;
        filling.is_argument = true;
        filling.index = static_cast<std::uint8_t>(plan.argument_count + kValue);
        filling.invocation = static_cast<std::uint8_t>(plan.functions.size());
        filling.parameter = kValue;
        plan.fillings.push_back(filling);
        plan.functions.push_back(invocation);
        plan.argument_count = static_cast<std::uint8_t>(plan.argument_count + 2);
    }
    return kDone;
}

/// `orient(…);`: the orientation changes while its tip stands.
Value orient_call(Check& check, const Expr& expr) {
    const Reg mark = check.emit.mark();
    const Reg first = check.emit.take(kComponents);
    check.emit.set_location(expr.range);
    Plan plan;
    if (take_direction(check, expr, first) && add_direction(check, plan, expr.range)) {
        check.emit.set_location(expr.range);
        emit_plan(check, std::move(plan), first, 0, expr.range);
    }
    check.emit.release_to(mark);
    return in_registers(types::kVoid, 0);
}

/// `tcp(on)`: with the interpolation and the system that hold where nothing else is given, so that
/// every control begins alike. `tcp(off)`.
Value tcp_call(Check& check, const Expr& expr) {
    const auto items = check.ast().exprs(expr.list);
    std::string_view word;
    if (items.size() == 1) {
        const Expr& item = check.ast()[items[0]];
        const bool is_named = item.kind == ExprKind::Argument && !item.text.is_empty();
        const Expr& value = item.kind == ExprKind::Argument ? check.ast()[item.child[0]] : item;
        if (!is_named && value.kind == ExprKind::Name) word = check.text(value.text);
    }
    if (word != "on" && word != "off") {
        check.report(diag::TcpArgument, expr.range).fix("`tcp(on)` or `tcp(off)`");
        return in_registers(types::kVoid, 0);
    }
    Plan plan;
    const auto add = [&](Function function) {
        nc::Invocation invocation;
        invocation.function = function;
        plan.functions.push_back(invocation);
    };
    if (word == "off") {
        add(Function::TcpOff);
    } else {
        add(Function::TcpOn);
        add(Function::OrientInWork);
        add(Function::OrientGreatCircle);
    }
    const Reg mark = check.emit.mark();
    const Reg first = check.emit.take(1);
    check.emit.set_location(expr.range);
    emit_plan(check, std::move(plan), first, 0, expr.range);
    check.emit.release_to(mark);
    return in_registers(types::kVoid, 0);
}

}  // namespace kadr::sema
