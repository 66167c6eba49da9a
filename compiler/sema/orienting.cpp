// orienting.cpp — how the tool stands: `orient(…)`, by itself and behind the words of a block, and
// `tcp(on)`, under which it acts.
//
// Whatever the program has, a block gets the direction from the tip to the holder, which every
// control with such words takes; angles are worked out here.
#include <algorithm>
#include <array>

#include "base/diagnostics/expand.h"
#include "base/diagnostics/sema.h"
#include "base/diagnostics/syntax.h"
#include "sema/arithmetic.h"
#include "sema/checker.h"
#include "syntax/parse.h"

namespace kadr::sema {

using nc::Function;
using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;

namespace {

/// What `orient` takes: the direction by its components, or rotated about X by `a`, the new Y by
/// `b`.
constexpr std::array<std::string_view, 5> kOrientNames = {"i", "j", "k", "a", "b"};
constexpr std::size_t kComponents = 3;

}  // namespace

/// Whether the expression is a call of `orient`, and of no function of the program.
bool Checker::is_orient(ExprId id) const {
    if (!id.is_valid() || ast()[id].kind != ExprKind::Call) return false;
    const Expr& callee = ast()[ast()[id].child[0]];
    if (callee.kind != ExprKind::Name || text(callee.text) != "orient") return false;
    const Found found = find("orient");
    return found.symbol < 0 && found.name == nullptr;
}

/// `G0 Xd Yd;`: to the parser two points.
Done Checker::require_no_glued_point(const SourceRange& range) {
    const std::string_view spelled = sources_.text(range);
    const std::size_t end = std::min(spelled.find_first_of(" \t.+-*/([{"), spelled.size());
    const std::string_view name = spelled.substr(0, end);
    const std::size_t letters = syntax::glued_address(*modules_[module_].dialect, name);
    const Found found = find(name);
    if (letters == 0 || found.symbol >= 0 || found.name != nullptr) return kDone;
    auto builder =
        report(diag::WordWithoutValue,
               {range.file, range.begin, range.begin + static_cast<std::uint32_t>(letters)});
    builder.arg(quoted(name.substr(0, letters)));
    fix_glued(letters, range, builder);
    return kFailed;
}

/// One point and one `orient(…)`, in whatever order.
Checker::Behind Checker::behind_words(const syntax::Stmt& stmt) {
    Behind behind;
    for (const ExprId id : stmt.expression) {
        if (!id.is_valid()) continue;
        const bool is_direction = is_orient(id);
        ExprId& place = is_direction ? behind.orient : behind.point;
        if (!place.is_valid()) {
            place = id;
            continue;
        }
        if (!is_direction && !require_no_glued_point(ast()[id].range)) continue;
        report(diag::BehindWordsTwice, ast()[id].range)
            .arg(sources_.text(ast()[id].range))
            .arg(is_direction ? "direction" : "point");
    }
    return behind;
}

/// The direction that a call of `orient` gives, in the registers from `first`.
Done Checker::take_direction(const Expr& expr, Reg first) {
    const auto bound = bind_arguments(expr, "orient", kOrientNames, {});
    if (!bound) return kFailed;
    const auto is_given = [&](std::size_t i) { return (*bound)[i].is_valid(); };
    const bool by_parts = is_given(0) || is_given(1) || is_given(2);
    const bool by_angles = is_given(3) || is_given(4);
    if (by_parts == by_angles) {
        report(diag::OrientArguments, expr.range)
            .arg(by_parts ? "components and angles" : "no direction")
            .fix(
                "say the direction from the tip to the holder, `orient(i: 0.5, k: 1)`, or its "
                "angles, `orient(b: 30deg)`");
        return kFailed;
    }
    const Reg mark = emit_.mark();
    const Done taken =
        by_parts ? take_parts(*bound, first) : take_angles(*bound, expr.range, first);
    emit_.release_to(mark);
    return taken;
}

/// Numbers or lengths of any size; what is not given is 0.
Done Checker::take_parts(std::span<const ExprId> bound, Reg first) {
    for (std::size_t i = 0; i < kComponents; ++i) {
        const auto reg = static_cast<Reg>(first + i);
        if (!bound[i].is_valid()) {
            emit_.emit_number(OpCode::LoadF, reg, 0, 0);
            continue;
        }
        const std::optional<Value> argument = numeric_argument(bound[i], "orient");
        if (!argument) return kFailed;
        const Value value = to_real(*argument);
        const TypeInfo& info = type_info(value.type);
        const bool is_component =
            info.kind == TypeKind::Real && (info.quantity.is_number() || info.quantity == kLength);
        if (!is_component) {
            report(diag::DimensionMismatch, ast()[bound[i]].range)
                .arg(kOrientNames[i])
                .arg("number")
                .arg(type_name(value.type));
            return kFailed;
        }
        copy_value(value, reg);
    }
    return kDone;
}

/// Where Z comes to, rotated about X by a, then about the new Y by b: as Z of a tilted plane.
///
/// source  Rx(a)·Ry(b)·z = (sin b, −sin a·cos b, cos a·cos b)
Done Checker::take_angles(std::span<const ExprId> bound, const SourceRange& range, Reg first) {
    std::array<Value, 2> sines;
    std::array<Value, 2> cosines;
    const auto figure = [&](OpCode op, const Value& angle) {
        if (angle.is_constant()) {
            const double number = angle.constant.number;
            return constant_number(op == OpCode::SinDeg ? sin_deg(number) : cos_deg(number),
                                   types::kReal);
        }
        const Reg reg = emit_.take(1);
        emit_.emit(op, reg, angle.reg);
        return in_registers(types::kReal, reg);
    };
    for (std::size_t i = 0; i < 2; ++i) {
        const ExprId id = bound[kComponents + i];
        Value angle = constant_number(0, types::kAngleType);
        if (id.is_valid()) {
            const std::optional<Value> argument = numeric_argument(id, "orient");
            if (!argument) return kFailed;
            angle = convert(*argument, types::kAngleType, ast()[id].range,
                            kOrientNames[kComponents + i]);
            if (is_error(angle)) return kFailed;
        }
        sines[i] = figure(OpCode::SinDeg, angle);
        cosines[i] = figure(OpCode::CosDeg, angle);
    }
    const auto times = [&](const Value& a, const Value& b) {
        return emit_reals(Operator::Multiply, a, b, types::kReal, kNoReg, range);
    };
    copy_value(sines[1], first);
    copy_value(times(times(sines[0], constant_number(-1, types::kReal)), cosines[1]),
               static_cast<Reg>(first + 1));
    copy_value(times(cosines[0], cosines[1]), static_cast<Reg>(first + 2));
    return kDone;
}

/// Adds the components to a plan; their values stand in registers behind those of its fillings.
Done Checker::add_direction(Plan& plan, const SourceRange& range) {
    const bool has_room =
        plan.functions.size() + kComponents <= nc::kMaxInvocations &&
        std::size_t{plan.argument_count} + 2 * kComponents <= nc::kMaxArguments &&
        std::ranges::none_of(plan.functions, [](const nc::Invocation& call) {
            return call.function == Function::Cycle || call.function == Function::ToolVector;
        });
    if (!has_room) {
        report(diag::OrientBlock, range);
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
Value Checker::orient_call(const Expr& expr) {
    const Reg mark = emit_.mark();
    const Reg first = emit_.take(kComponents);
    emit_.set_location(expr.range);
    Plan plan;
    if (take_direction(expr, first) && add_direction(plan, expr.range)) {
        emit_.set_location(expr.range);
        emit_plan(std::move(plan), first, 0, expr.range);
    }
    emit_.release_to(mark);
    return in_registers(types::kVoid, 0);
}

/// `tcp(on)`: with the interpolation and the system that hold where nothing else is given, so that
/// every control begins alike. `tcp(off)`.
Value Checker::tcp_call(const Expr& expr) {
    const auto items = ast().exprs(expr.list);
    std::string_view word;
    if (items.size() == 1) {
        const Expr& item = ast()[items[0]];
        const bool is_named = item.kind == ExprKind::Argument && !item.text.is_empty();
        const Expr& value = item.kind == ExprKind::Argument ? ast()[item.child[0]] : item;
        if (!is_named && value.kind == ExprKind::Name) word = text(value.text);
    }
    if (word != "on" && word != "off") {
        report(diag::TcpArgument, expr.range).fix("`tcp(on)` or `tcp(off)`");
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
    const Reg mark = emit_.mark();
    const Reg first = emit_.take(1);
    emit_.set_location(expr.range);
    emit_plan(std::move(plan), first, 0, expr.range);
    emit_.release_to(mark);
    return in_registers(types::kVoid, 0);
}

}  // namespace kadr::sema
