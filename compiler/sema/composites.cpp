// composites.cpp — points, structs and arrays in braces; members.
#include "sema/composites.h"

#include <algorithm>
#include <array>

#include "base/diagnostics/sema.h"
#include "sema/builtins.h"
#include "sema/calls.h"
#include "sema/checking.h"
#include "sema/library_tools.h"
#include "sema/lvalues.h"
#include "sema/optionals.h"
#include "sema/scope.h"
#include "sema/texts.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;

namespace {

Value brace_array(Check& check, syntax::ExprId id, Type type);
Value brace_struct(Check& check, syntax::ExprId id, Type type, Reg hint);
void fill_members(Check& check, syntax::ExprId id, Type type, Reg reg);
void emit_member(Check& check, const Member& member, Reg reg);
Value position_member(Check& check, const syntax::Expr& expr, bool is_position);

}  // namespace

Value braces(Check& check, ExprId id, Type expected, Reg hint) {
    const Expr& expr = check.ast()[id];
    const Type plain = check.types.given(expected);
    if (check.kind(plain) == TypeKind::Array && !check.is_contour(plain))
        return brace_array(check, id, plain);
    if (check.kind(plain) == TypeKind::Struct) return brace_struct(check, id, plain, kNoReg);
    if (check.kind(expected) != TypeKind::Error) {
        check.report(diag::BracesPlace, expr.range).arg(check.type_name(expected));
        return error_value();
    }
    // Without a type from outside, two or three values are a point.
    if (expr.list.count >= 1 && expr.list.count <= 3)
        return brace_struct(check, id, types::kPoint, hint);
    check.report(diag::BracesWithoutType, expr.range);
    return error_value();
}

namespace {

Value brace_array(Check& check, ExprId id, Type type) {
    const Expr& expr = check.ast()[id];
    const TypeInfo info = check.type_info(type);
    const Reg array = check.emit.take(1);
    check.emit.emit_pair(OpCode::NewArray, array, 0, 0, layout_constant(check, info.element));
    if (info.count >= 0 && expr.list.count != static_cast<std::uint64_t>(info.count)) {
        check.report(diag::ElementCount, expr.range)
            .arg(info.count)
            .arg(std::to_string(expr.list.count));
    }
    const Reg mark = check.emit.mark();
    const Reg element = check.emit.take(check.type_info(info.element).slots);
    for (const ExprId item : std::vector<ExprId>(check.ast().exprs(expr.list).begin(),
                                                 check.ast().exprs(expr.list).end())) {
        if (check.ast()[item].kind == ExprKind::Argument) {
            check.report(diag::NamedElement, check.ast()[item].range)
                .arg(check.text(check.ast()[item].text));
            continue;
        }
        expression_in(check, item, info.element, element, "the element");
        check.emit.set_location(check.ast()[item].range);
        check.emit.emit(OpCode::Append, array, element);
    }
    check.emit.set_location(expr.range);
    check.emit.release_to(mark);
    Value value = in_registers(type, array);
    value.is_fresh = true;
    return value;
}

Value brace_struct(Check& check, ExprId id, Type type, Reg hint) {
    const Reg reg = hint != kNoReg ? hint : check.emit.take(check.type_info(type).slots);
    fill_members(check, id, type, reg);
    Value value = in_registers(type, reg);
    value.is_fresh = true;
    return value;
}

void fill_members(Check& check, ExprId id, Type type, Reg reg) {
    const Expr& expr = check.ast()[id];
    const StructInfo info = check.types.struct_of(type);
    std::vector<ExprId> values(info.members.size());
    std::size_t next = 0;
    for (const ExprId item : check.ast().exprs(expr.list)) {
        const Expr& argument = check.ast()[item];
        std::size_t member = next;
        ExprId value = item;
        if (argument.kind == ExprKind::Argument) {
            value = argument.child[0];
            if (!argument.text.is_empty()) {
                const auto found = std::find_if(
                    info.members.begin(), info.members.end(),
                    [&](const Member& m) { return m.name == check.text(argument.text); });
                if (found == info.members.end()) {
                    check.report(diag::UnknownMember, argument.range)
                        .arg(info.name)
                        .arg(check.text(argument.text));
                    continue;
                }
                member = static_cast<std::size_t>(found - info.members.begin());
                check.record.note_use(check.here.module, item, found->symbol);
            }
        }
        if (member >= info.members.size()) {
            check.report(diag::TooManyValues, argument.range)
                .arg(info.name)
                .arg(info.members.size());
            break;
        }
        if (values[member].is_valid()) {
            check.report(diag::ArgumentTwice, argument.range)
                .arg(info.name)
                .arg(info.members[member].name);
            continue;
        }
        values[member] = value;
        next = member + 1;
    }
    for (std::size_t i = 0; i < info.members.size(); ++i) {
        const Member& member = info.members[i];
        const auto target = static_cast<Reg>(reg + member.offset);
        if (values[i].is_valid()) {
            expression_in(check, values[i], member.type, target, member.name);
        } else {
            if (!member.initial.is_valid() && !check.type_info(member.type).is_optional &&
                check.kind(member.type) != TypeKind::Array &&
                check.kind(member.type) != TypeKind::Struct) {
                check.report(diag::MemberMissing, expr.range).arg(info.name).arg(member.name);
            }
            emit_member(check, member, target);
        }
    }
}

bool has_defaults(const Check& check, Type type) {
    const TypeInfo& info = check.type_info(type);
    if (info.kind == TypeKind::Array)
        return !info.is_optional && info.count >= 0 && has_defaults(check, info.element);
    if (info.kind != TypeKind::Struct) return false;
    return std::ranges::any_of(check.types.struct_of(type).members, [&](const Member& member) {
        return member.initial.is_valid() ||
               (!member.may_be_unset && has_defaults(check, member.type));
    });
}

/// A member that got no value: its default, or what a variable of its type begins with.
void emit_member(Check& check, const Member& member, Reg reg) {
    if (!member.initial.is_valid()) {
        if (member.may_be_unset) emit_unset(check, member.type, reg);
        else emit_initial(check, member.type, reg);
        return;
    }
    const std::uint32_t here = std::exchange(check.here.module, member.module);
    const Units before = std::exchange(check.here.units, check.names.module(member.module).units);
    expression_in(check, member.initial, member.type, reg, member.name);
    check.here.module = here;
    check.here.units = before;
}

}  // namespace

/// What a variable without a value holds: nothing but the defaults of a struct's members.
void emit_initial(Check& check, Type type, Reg reg) {
    if (!has_defaults(check, type)) return emit_unset(check, type, reg);
    if (check.kind(type) == TypeKind::Struct) {
        const StructInfo info = check.types.struct_of(type);
        for (const Member& member : info.members)
            emit_member(check, member, static_cast<Reg>(reg + member.offset));
        return;
    }
    const TypeInfo info = check.type_info(type);
    const Reg mark = check.emit.mark();
    const Reg index = check.emit.take(2);  // and the number of elements
    const Reg element = check.emit.take(check.type_info(info.element).slots);
    Label top;
    check.emit.emit_pair(OpCode::NewArray, reg, 0, 0, layout_constant(check, info.element));
    check.emit.emit_integer(OpCode::LoadI, index, 0, 0);
    check.emit.emit_integer(OpCode::LoadI, index + 1u, 0, info.count);
    check.emit.bind(top);
    emit_initial(check, info.element, element);
    check.emit.emit(OpCode::Append, reg, element);
    check.emit.emit_integer(OpCode::AddIK, index, index, 1);
    check.emit.jump(OpCode::JumpLtI, top, index, index + 1u);
    check.emit.release_to(mark);
}

// ---------------------------------------------------------------- members

Value member(Check& check, ExprId id) {
    const Expr& expr = check.ast()[id];
    const Expr& owner = check.ast()[expr.child[0]];
    if (owner.kind == ExprKind::Name) {
        const std::string_view name = check.text(owner.text);
        const Found found = look_up(check, expr.child[0]);
        if (found.symbol < 0 && found.name == nullptr && (name == "position" || name == "state")) {
            return position_member(check, expr, name == "position");
        }
        if (found.symbol < 0 && found.name != nullptr && found.name->what == Name::What::Type &&
            check.kind(found.name->type) == TypeKind::Enum) {
            check_unambiguous(check, name, owner.range);
            const EnumInfo& info = check.types.enum_of(found.name->type);
            for (std::size_t i = 0; i < info.members.size(); ++i) {
                if (info.members[i].first != check.text(expr.text)) continue;
                check.record.note_use(check.here.module, id, info.symbols[i]);
                return constant_integer(info.members[i].second, found.name->type);
            }
            check.report(diag::UnknownMember, expr.range).arg(name).arg(check.text(expr.text));
            return error_value();
        }
    }
    if (asks_library(check, expr.child[0])) return library_value(check, id, expr.child[0], true);
    if (owner.kind == ExprKind::Given && asks_library(check, owner.child[0])) {
        const Value value = library_value(check, id, owner.child[0], false);
        return check.type_info(value.type).is_optional ? is_given(check, value) : value;
    }
    if (owner.kind == ExprKind::Given) {
        // `given p.z` asks for the member: `given` binds looser than the point.
        const Expr& asked = check.ast()[owner.child[0]];
        const bool is_state =
            asked.kind == ExprKind::Name && find(check, check.text(asked.text)).symbol < 0 &&
            (check.text(asked.text) == "position" || check.text(asked.text) == "state");
        if (is_state)
            return is_given(check,
                            position_member(check, expr, check.text(asked.text) == "position"));
        const std::optional<Lvalue> whole = lvalue(check, owner.child[0]);
        const std::optional<Lvalue> part = whole ? part_lvalue(check, *whole, id) : std::nullopt;
        return part ? is_given(check, load(check, *part, expr.range, false, kNoReg))
                    : error_value();
    }
    const std::optional<Lvalue> whole = owner_lvalue(check, expr.child[0]);
    if (!whole) return error_value();
    if (const std::optional<Value> property = property_value(check, *whole, expr)) return *property;
    const std::optional<Lvalue> part = part_lvalue(check, *whole, id);
    return part ? load(check, *part, expr.range, true, kNoReg) : error_value();
}

namespace {

constexpr std::array<std::string_view, 9> kPositionMembers = {"x", "y", "z", "a", "b",
                                                              "c", "u", "v", "w"};

struct StateMember {
    std::string_view name;
    StateValue value;
    Type type;
    bool is_optional;  // a program may ask before it was programmed
};

constexpr StateMember kStateMembers[] = {
    {"feed", StateValue::Feed, types::kFeed, true},
    {"speed", StateValue::Speed, types::kSpeed, true},
    {"tool", StateValue::Tool, types::kInt, true},
    {"spindle", StateValue::Spindle, types::kInt, true},
    {"mirrored", StateValue::Mirrored, types::kBool, false},
    {"turned", StateValue::Turned, types::kBool, false},
    {"scaled", StateValue::Scaled, types::kBool, false},
    {"diameter", StateValue::Diameter, types::kBool, false},
};

}  // namespace

std::span<const std::string_view> position_members() { return kPositionMembers; }

std::vector<std::string_view> state_members() {
    std::vector<std::string_view> names;
    for (const StateMember& member : kStateMembers) names.push_back(member.name);
    return names;
}

namespace {

Value position_member(Check& check, const Expr& expr, bool is_position) {
    const std::string_view name = check.text(expr.text);
    const auto* const state = std::ranges::find(kStateMembers, name, &StateMember::name);
    const auto* const axis = std::ranges::find(kPositionMembers, name);
    const bool is_known =
        is_position ? axis != kPositionMembers.end() : state != std::end(kStateMembers);
    if (!is_known) {
        check.report(diag::UnknownMember, expr.range)
            .arg(is_position ? "position" : "state")
            .arg(name);
        return error_value();
    }
    const Reg reg = check.emit.take(1);
    if (!is_position) {
        check.emit.emit(OpCode::State, reg, 0, static_cast<unsigned>(state->value));
        return in_registers(state->is_optional ? check.types.optional(state->type) : state->type,
                            reg);
    }
    const auto number = static_cast<unsigned>(axis - kPositionMembers.begin());
    check.emit.emit(OpCode::Position, reg, 0, number);
    const bool is_rotary = number >= 3 && number <= 5;
    return in_registers(check.types.optional(is_rotary ? types::kAngleType : types::kLengthType),
                        reg);
}

}  // namespace

}  // namespace kadr::sema
