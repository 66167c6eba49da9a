// curves.cpp — curves: a function of points by a parameter, and `follow`, which fits blocks to it.
//
// A curve becomes two functions: one gives the point at a value of the parameter, one gives the
// range of the parameter. Both have the curve's own parameters.
#include "sema/curves.h"

#include <array>

#include "base/diagnostics/sema.h"
#include "sema/calls.h"
#include "sema/checking.h"
#include "sema/scope.h"
#include "sema/statements.h"
#include "sema/type_declarations.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;

void curve_body(Check& check, const FunctionDecl& function, const Decl& decl) {
    const Decl running = check.ast()[check.ast().decls(decl.members)[0]];
    const Type type = resolve_type(check, running.type);
    if (function.is_limits) {
        const Reg first = check.emit.take(2);
        const std::array<ExprId, 2> ends = {decl.value, decl.value_to};
        for (std::size_t i = 0; i < 2; ++i) {
            check.emit.set_location(check.ast()[ends[i]].range);
            expression_in(check, ends[i], type, static_cast<Reg>(first + i),
                          check.text(running.name));
        }
        check.emit.emit(OpCode::Return, first, 0, 2);
        return;
    }
    if (check.kind(type) != TypeKind::Real && check.kind(type) != TypeKind::Error) {
        check.report(diag::CurveParameter, check.ast()[running.type].range)
            .arg(check.text(running.name))
            .arg(check.type_name(type));
    }
    // x, y and z are variables of the body; what is not assigned stays not given.
    const Reg point = check.emit.take(3);
    emit_unset(check, types::kPoint, point);
    const auto first = static_cast<std::int32_t>(check.scopes.all().size());
    static constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
        Symbol symbol;
        symbol.name = kNames[i];
        symbol.type = types::kLengthType;
        symbol.reg = static_cast<Reg>(point + i);
        symbol.may_be_unset = true;
        symbol.givenness = Givenness::NotGiven;
        symbol.range = decl.name_range;
        add_symbol(check, symbol);
    }
    // Parameters that only the range uses are used.
    for (Symbol& symbol : check.scopes.all()) symbol.is_read = true;
    // No scope of its own: a variable `x` in the body would hide the coordinate.
    for (const syntax::StmtId id : check.ast().stmts(check.ast()[decl.body].statements))
        statement(check, id);
    bool is_empty = true;
    for (std::int32_t i = 0; i < 3; ++i)
        is_empty = is_empty && check.scopes[first + i].givenness == Givenness::NotGiven;
    if (is_empty) check.report(diag::CurveEmpty, decl.name_range).arg(check.text(decl.name));
    check.emit.set_location(decl.name_range);
    check.emit.emit(OpCode::Return, point, 0, 3);
}

std::optional<ExprId> curve_argument(Check& check, const Expr& expr) {
    const auto arguments = check.ast().exprs(expr.list);
    if (arguments.empty()) return std::nullopt;
    const Expr& first = check.ast()[arguments[0]];
    ExprId id = arguments[0];
    if (first.kind == ExprKind::Argument) {
        if (!first.text.is_empty() && check.text(first.text) != "curve") return std::nullopt;
        id = first.child[0];
    }
    if (check.ast()[id].kind != ExprKind::Call) return std::nullopt;
    const Expr& callee = check.ast()[check.ast()[id].child[0]];
    if (callee.kind != ExprKind::Name) return std::nullopt;
    const Found found = find(check, check.text(callee.text));
    const bool is_curve =
        found.symbol < 0 && found.name != nullptr && found.name->what == Name::What::Curve;
    return is_curve ? std::optional(id) : std::nullopt;
}

Value follow_curve(Check& check, const Expr& expr, std::string_view name, ExprId curve) {
    static constexpr std::array<std::string_view, 5> kNames = {"curve", "feed", "tolerance", "arcs",
                                                               "nurbs"};
    const bool is_start = name == "follow_start";
    const Value none = is_start ? error_value() : in_registers(types::kVoid, 0);
    const auto bound = bind_arguments(check, expr, name, kNames, {});
    const Expr& call = check.ast()[curve];
    const Found found = look_up(check, call.child[0]);
    const std::uint32_t index = found.name->index;
    check.names.want(index);
    check.names.want(index + 1);
    const FunctionDecl limits = check.names.function(index + 1);
    std::vector<std::string_view> names;
    for (const ParameterDecl& parameter : limits.parameters) names.push_back(parameter.name);
    const auto arguments = bind_arguments(check, call, limits.name, names, limits.range);
    if (!bound || !arguments) return none;
    note_arguments(check, limits, call);

    const auto options = static_cast<unsigned>(CurveSlot::Arguments);
    const std::uint16_t slots = limits.parameter_slots;
    const Reg first = check.emit.take(options + slots);
    const auto reg_of = [&](CurveSlot slot) {
        return static_cast<Reg>(first + static_cast<unsigned>(slot));
    };
    const Reg values = reg_of(CurveSlot::Arguments);
    std::uint32_t given = 0;
    for (std::size_t i = 0; i < limits.parameters.size(); ++i) {
        const ParameterDecl& parameter = limits.parameters[i];
        if ((*arguments)[i].is_valid()) {
            pass_argument(check, parameter, (*arguments)[i], values);
            given |= 1u << i;
        } else if (parameter.is_required) {
            check.report(diag::ArgumentMissing, call.range)
                .arg(limits.name)
                .arg(parameter.name)
                .note(parameter.range, "it is declared here");
        }
    }
    const auto option = [&](std::size_t i, CurveSlot slot, Type type) {
        const ExprId id = (*bound)[i];
        if (id.is_valid()) expression_in(check, id, type, reg_of(slot), kNames[i]);
        return id.is_valid();
    };
    if (!option(1, CurveSlot::Feed, check.types.optional(types::kFeed)))
        emit_unset(check, check.types.optional(types::kFeed), reg_of(CurveSlot::Feed));
    if (!option(2, CurveSlot::Tolerance, types::kLengthType))
        check.emit.emit_number(OpCode::LoadF, reg_of(CurveSlot::Tolerance), 0, kCurveTolerance);
    if (!option(3, CurveSlot::Arcs, types::kBool))
        check.emit.emit_integer(OpCode::LoadI, reg_of(CurveSlot::Arcs), 0, 1);
    if (!option(4, CurveSlot::Nurbs, types::kBool))
        check.emit.emit_integer(OpCode::LoadI, reg_of(CurveSlot::Nurbs), 0, 0);

    // The limits; the window of a call is overwritten, so the arguments are copied into it.
    check.emit.set_location(call.range);
    const auto statement = static_cast<std::int32_t>(statement_id(check, expr.range));
    const Reg window = check.emit.take(std::max(3u, slots + 1u));
    if (slots > 0) check.emit.emit(OpCode::MoveN, window, values, slots);
    check.emit.emit_pair(OpCode::Call, window, index + 2,
                         static_cast<unsigned>(check.here.loop_depth), statement,
                         static_cast<std::int32_t>(given));
    check.emit.emit(OpCode::MoveN, reg_of(CurveSlot::From), window, 2);
    if (is_start) {
        if (slots > 0) check.emit.emit(OpCode::MoveN, window, values, slots);
        check.emit.emit(OpCode::Move, static_cast<Reg>(window + slots), reg_of(CurveSlot::From));
        check.emit.emit_pair(OpCode::Call, window, index + 1,
                             static_cast<unsigned>(check.here.loop_depth), statement,
                             static_cast<std::int32_t>(given | 1u << limits.parameters.size()));
        Value value = in_registers(types::kPoint, window);
        value.is_fresh = true;
        return value;
    }
    check.emit.emit_pair(OpCode::FollowCurve, first, 0,
                         static_cast<unsigned>(check.here.loop_depth), index + 1, statement);
    check.emit.emit_pair(OpCode::CurveEnd, 0, 0, 0,
                         static_cast<std::int64_t>(given | 1u << limits.parameters.size()));
    return none;
}

}  // namespace kadr::sema
