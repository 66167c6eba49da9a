// contours.cpp — contours: blocks kept as a value, what can be asked of them and made of them, and
// `follow`, which turns them into blocks again.
#include "sema/contours.h"

#include <array>

#include "base/diagnostics/sema.h"
#include "sema/builtins.h"
#include "sema/calls.h"
#include "sema/checking.h"
#include "sema/convert.h"
#include "sema/curves.h"
#include "sema/expressions.h"
#include "sema/scope.h"
#include "sema/statements.h"
#include "sema/texts.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;

namespace {

Value follow_call(Check& check, const syntax::Expr& expr, std::string_view name);

}  // namespace

namespace {

struct Property {
    std::string_view name;
    ContourFunction function;
};

constexpr Property kProperties[] = {
    {"length", ContourFunction::Length},
    {"area", ContourFunction::Area},
    {"is_closed", ContourFunction::IsClosed},
    {"is_clockwise", ContourFunction::IsClockwise},
    {"is_diameter", ContourFunction::IsDiameter},
    {"start", ContourFunction::Start},
    {"end", ContourFunction::End},
    {"min", ContourFunction::Min},
    {"max", ContourFunction::Max},
};

constexpr Quantity kArea{2, 0, 0, 0};

}  // namespace

std::vector<std::string_view> contour_properties() {
    std::vector<std::string_view> names;
    for (const Property& property : kProperties) names.push_back(property.name);
    return names;
}

// ---------------------------------------------------------------- declarations

/// The statements run with the blocks being kept; loops around cannot be left from here.
void contour_body(Check& check, const Decl& decl, Reg target) {
    check.emit.set_location(decl.name_range);
    check.emit.emit(OpCode::BeginContour);
    std::vector<LoopScope> loops;
    std::swap(loops, check.here.loops);
    ++check.here.contour_depth;
    statement(check, decl.body);
    --check.here.contour_depth;
    std::swap(loops, check.here.loops);
    check.emit.set_location(decl.name_range);
    check.emit.emit_pair(OpCode::EndContour, target, 0, 0, layout_constant(check, types::kElement));
}

void contour_variable(Check& check, syntax::DeclId id) {
    const Decl& decl = check.ast()[id];
    Symbol symbol;
    symbol.name = check.text(decl.name);
    symbol.range = decl.name_range;
    symbol.decl = id;
    symbol.type = types::kContour;
    symbol.reg = check.emit.take(1);
    contour_body(check, decl, symbol.reg);
    add_symbol(check, symbol);
}

// ---------------------------------------------------------------- questions

namespace {

Value contour_value(Check& check, ContourFunction function, Type result, Reg arguments,
                    const SourceRange& range) {
    const Reg reg = check.emit.take(check.type_info(result).slots);
    const TypeInfo info = check.type_info(result);
    const std::uint32_t layout =
        info.kind == TypeKind::Array ? layout_constant(check, info.element) : 0;
    check.emit.set_location(range);
    check.emit.emit_pair(OpCode::ContourValue, reg, arguments, 0,
                         static_cast<std::int64_t>(function), layout);
    Value value = in_registers(result, reg);
    value.is_fresh = true;
    return value;
}

}  // namespace

std::optional<Value> contour_property(Check& check, const Value& contour, const Expr& expr) {
    const std::string_view name = check.text(expr.text);
    for (const Property& property : kProperties) {
        if (property.name != name) continue;
        Type type = types::kPoint;
        switch (property.function) {
            case ContourFunction::Length: type = types::kLengthType; break;
            case ContourFunction::Area: type = check.types.real(kArea); break;
            case ContourFunction::IsClosed:
            case ContourFunction::IsDiameter:
            case ContourFunction::IsClockwise: type = types::kBool; break;
            default: break;
        }
        return contour_value(check, property.function, type, contour.reg, expr.range);
    }
    return std::nullopt;
}

// ---------------------------------------------------------------- functions

namespace {

/// `shift`, `rotate` and `mirror` are commands as well; with a contour in front they make one.
bool takes_contour(Check& check, const Expr& expr) {
    const auto arguments = check.ast().exprs(expr.list);
    if (arguments.empty()) return false;
    const Expr& first = check.ast()[arguments[0]];
    if (first.kind == ExprKind::Argument && !first.text.is_empty())
        return check.text(first.text) == "contour";
    return check.is_contour(check.types.given(
        type_of(check, first.kind == ExprKind::Argument ? first.child[0] : arguments[0])));
}

/// A parameter of a function of contours, and its type.
struct ContourParameter {
    std::string_view name;
    Type type;
    bool is_required = true;
};

struct ContourRow {
    std::string_view name;
    ContourFunction function;
    bool is_command_too;
    std::array<ContourParameter, 4> parameters;
};

constexpr ContourRow kFunctions[] = {
    {"reverse", ContourFunction::Reverse, false, {{{"contour", types::kContour}}}},
    {"offset",
     ContourFunction::Offset,
     false,
     {{{"contour", types::kContour}, {"distance", types::kLengthType}}}},
    {"begun_near",
     ContourFunction::BegunNear,
     false,
     {{{"contour", types::kContour}, {"point", types::kPoint}}}},
    {"shift",
     ContourFunction::Shift,
     true,
     {{{"contour", types::kContour},
       {"x", types::kOptionalLength, false},
       {"y", types::kOptionalLength, false},
       {"z", types::kOptionalLength, false}}}},
    {"rotate",
     ContourFunction::Rotate,
     true,
     {{{"contour", types::kContour},
       {"angle", types::kAngleType},
       {"about", types::kPoint, false}}}},
    {"mirror",
     ContourFunction::Mirror,
     true,
     {{{"contour", types::kContour},
       {"x", types::kBool, false},
       {"y", types::kBool, false},
       {"z", types::kBool, false}}}},
    {"inside",
     ContourFunction::IsInside,
     false,
     {{{"point", types::kPoint}, {"contour", types::kContour}}}},
    {"nearest",
     ContourFunction::Nearest,
     false,
     {{{"contour", types::kContour}, {"point", types::kPoint}}}},
    {"intersections",
     ContourFunction::Intersections,
     false,
     {{{"a", types::kContour}, {"b", types::kContour}}}},
    {"crossings",
     ContourFunction::Crossings,
     false,
     {{{"contour", types::kContour},
       {"x", types::kOptionalLength, false},
       {"y", types::kOptionalLength, false},
       {"z", types::kOptionalLength, false}}}},
};

}  // namespace

std::optional<Value> contour_function(Check& check, std::string_view name, const Expr& expr) {
    if (name == "follow" || name == "follow_start") return follow_call(check, expr, name);
    for (const ContourRow& row : kFunctions) {
        if (row.name != name) continue;
        if (row.is_command_too && !takes_contour(check, expr)) return std::nullopt;
        std::vector<std::string_view> names;
        unsigned slots = 0;
        for (const ContourParameter& parameter : row.parameters) {
            if (parameter.name.empty()) break;
            names.push_back(parameter.name);
            slots += check.type_info(parameter.type).slots;
        }
        const auto bound = bind_arguments(check, expr, name, names, {});
        if (!bound) return error_value();
        // `offset` takes several contours together as well.
        const Type contours = check.types.array(types::kContour, -1);
        const bool takes_all = row.function == ContourFunction::Offset && (*bound)[0].is_valid() &&
                               (check.ast()[(*bound)[0]].kind == ExprKind::Braces ||
                                check.types.given(type_of(check, (*bound)[0])) == contours);
        const Reg first = check.emit.take(slots);
        Reg reg = first;
        for (std::size_t i = 0; i < names.size(); ++i) {
            ContourParameter parameter = row.parameters[i];
            if (takes_all && i == 0) parameter.type = contours;
            if ((*bound)[i].is_valid()) {
                // A contour is only looked at here: no copy.
                const Reg mark = check.emit.mark();
                const Value value =
                    convert(check, expression(check, (*bound)[i], parameter.type), parameter.type,
                            check.ast()[(*bound)[i]].range, parameter.name);
                if (check.is_error(value)) return value;
                if (check.kind(parameter.type) == TypeKind::Array)
                    check.emit.emit(OpCode::Move, reg, value.reg);
                else copy_value(check, value, reg);
                check.emit.release_to(mark);
            } else if (parameter.is_required) {
                check.report(diag::ArgumentMissing, expr.range).arg(name).arg(parameter.name);
                return error_value();
            } else if (parameter.type == types::kBool) {
                check.emit.emit_integer(OpCode::LoadI, reg, 0, 0);
            } else {
                emit_unset(check, parameter.type, reg);
            }
            reg = static_cast<Reg>(reg + check.type_info(parameter.type).slots);
        }
        Type result = types::kContour;
        switch (row.function) {
            case ContourFunction::Offset: result = check.types.array(types::kContour, -1); break;
            case ContourFunction::IsInside: result = types::kBool; break;
            case ContourFunction::Nearest: result = types::kPoint; break;
            case ContourFunction::Intersections:
            case ContourFunction::Crossings: result = check.types.array(types::kPoint, -1); break;
            default: break;
        }
        return contour_value(check, takes_all ? ContourFunction::OffsetAll : row.function, result,
                             first, expr.range);
    }
    return std::nullopt;
}

// ---------------------------------------------------------------- follow

namespace {

Value follow_call(Check& check, const Expr& expr, std::string_view name) {
    if (const std::optional<ExprId> curve = curve_argument(check, expr))
        return follow_curve(check, expr, name, *curve);
    static constexpr std::array<std::string_view, kFollowSlots> kNames = {
        "contour", "feed", "left", "right", "lead_in", "lead_out", "arc_in", "arc_out"};
    const auto bound = bind_arguments(check, expr, name, kNames, {});
    const bool is_start = name == "follow_start";
    const Value none = is_start ? error_value() : in_registers(types::kVoid, 0);
    if (!bound) return none;
    if (!(*bound)[0].is_valid()) {
        check.report(diag::ArgumentMissing, expr.range).arg(name).arg("contour");
        return none;
    }
    const auto given = [&](FollowSlot slot) {
        return (*bound)[static_cast<std::size_t>(slot)].is_valid();
    };
    if (given(FollowSlot::Left) && given(FollowSlot::Right)) {
        check
            .report(diag::FollowSides,
                    check.ast()[(*bound)[static_cast<std::size_t>(FollowSlot::Right)]].range)
            .arg(name);
    }
    const bool has_side = given(FollowSlot::Left) || given(FollowSlot::Right);
    for (const FollowSlot slot : {FollowSlot::ArcIn, FollowSlot::ArcOut}) {
        if (!given(slot) || has_side) continue;
        const auto i = static_cast<std::size_t>(slot);
        check.report(diag::FollowArcSide, check.ast()[(*bound)[i]].range).arg(kNames[i]);
    }
    const Reg first = check.emit.take(kFollowSlots);
    for (std::size_t i = 0; i < kFollowSlots; ++i) {
        const auto reg = static_cast<Reg>(first + i);
        const auto slot = static_cast<FollowSlot>(i);
        Type type = types::kOptionalLength;
        if (slot == FollowSlot::Contour) type = types::kContour;
        if (slot == FollowSlot::Feed) type = check.types.optional(types::kFeed);
        const ExprId id = (*bound)[i];
        if (!id.is_valid()) {
            emit_unset(check, type, reg);
            continue;
        }
        const Reg mark = check.emit.mark();
        const Value value =
            convert(check, expression(check, id, type), type, check.ast()[id].range, kNames[i]);
        if (!check.is_error(value)) {
            if (slot == FollowSlot::Contour) check.emit.emit(OpCode::Move, reg, value.reg);
            else copy_value(check, value, reg);
        }
        check.emit.release_to(mark);
    }
    check.emit.set_location(expr.range);
    if (!is_start) {
        check.emit.emit_pair(OpCode::FollowContour, first, 0,
                             static_cast<unsigned>(check.here.loop_depth), 0,
                             statement_id(check, expr.range));
        return none;
    }
    const Reg point = check.emit.take(3);
    check.emit.emit(OpCode::FollowStart, point, first);
    return in_registers(types::kPoint, point);
}

}  // namespace

}  // namespace kadr::sema
