// composites.cpp — points, structs and arrays in braces; members.
#include <algorithm>
#include <array>

#include "base/diagnostics/sema.h"
#include "sema/builtins.h"
#include "sema/checker.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;

Value Checker::braces(ExprId id, Type expected, Reg hint) {
    const Expr& expr = ast()[id];
    const Type plain = types_.given(expected);
    if (kind(plain) == TypeKind::Array && !is_contour(plain)) return brace_array(id, plain);
    if (kind(plain) == TypeKind::Struct) return brace_struct(id, plain, kNoReg);
    if (kind(expected) != TypeKind::Error) {
        report(diag::BracesPlace, expr.range).arg(type_name(expected));
        return error_value();
    }
    // Without a type from outside, two or three values are a point.
    if (expr.list.count >= 1 && expr.list.count <= 3) return brace_struct(id, types::kPoint, hint);
    report(diag::BracesWithoutType, expr.range);
    return error_value();
}

Value Checker::brace_array(ExprId id, Type type) {
    const Expr& expr = ast()[id];
    const TypeInfo info = type_info(type);
    const Reg array = emit_.take(1);
    emit_.emit_pair(OpCode::NewArray, array, 0, 0, layout_constant(info.element));
    if (info.count >= 0 && expr.list.count != static_cast<std::uint64_t>(info.count)) {
        report(diag::ElementCount, expr.range).arg(info.count).arg(std::to_string(expr.list.count));
    }
    const Reg mark = emit_.mark();
    const Reg element = emit_.take(type_info(info.element).slots);
    for (const ExprId item :
         std::vector<ExprId>(ast().exprs(expr.list).begin(), ast().exprs(expr.list).end())) {
        if (ast()[item].kind == ExprKind::Argument) {
            report(diag::NamedElement, ast()[item].range).arg(text(ast()[item].text));
            continue;
        }
        expression_in(item, info.element, element, "the element");
        emit_.set_location(ast()[item].range);
        emit_.emit(OpCode::Append, array, element);
    }
    emit_.set_location(expr.range);
    emit_.release_to(mark);
    Value value = in_registers(type, array);
    value.is_fresh = true;
    return value;
}

Value Checker::brace_struct(ExprId id, Type type, Reg hint) {
    const Reg reg = hint != kNoReg ? hint : emit_.take(type_info(type).slots);
    fill_members(id, type, reg);
    Value value = in_registers(type, reg);
    value.is_fresh = true;
    return value;
}

void Checker::fill_members(ExprId id, Type type, Reg reg) {
    const Expr& expr = ast()[id];
    const StructInfo info = types_.struct_of(type);
    std::vector<ExprId> values(info.members.size());
    std::size_t next = 0;
    for (const ExprId item : ast().exprs(expr.list)) {
        const Expr& argument = ast()[item];
        std::size_t member = next;
        ExprId value = item;
        if (argument.kind == ExprKind::Argument) {
            value = argument.child[0];
            if (!argument.text.is_empty()) {
                const auto found =
                    std::find_if(info.members.begin(), info.members.end(),
                                 [&](const Member& m) { return m.name == text(argument.text); });
                if (found == info.members.end()) {
                    report(diag::UnknownMember, argument.range)
                        .arg(info.name)
                        .arg(text(argument.text));
                    continue;
                }
                member = static_cast<std::size_t>(found - info.members.begin());
                record_.note_use(module_, item, found->symbol);
            }
        }
        if (member >= info.members.size()) {
            report(diag::TooManyValues, argument.range).arg(info.name).arg(info.members.size());
            break;
        }
        if (values[member].is_valid()) {
            report(diag::ArgumentTwice, argument.range)
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
            expression_in(values[i], member.type, target, member.name);
        } else {
            if (!member.initial.is_valid() && !type_info(member.type).is_optional &&
                kind(member.type) != TypeKind::Array && kind(member.type) != TypeKind::Struct) {
                report(diag::MemberMissing, expr.range).arg(info.name).arg(member.name);
            }
            emit_member(member, target);
        }
    }
}

bool Checker::has_defaults(Type type) const {
    const TypeInfo& info = type_info(type);
    if (info.kind == TypeKind::Array)
        return !info.is_optional && info.count >= 0 && has_defaults(info.element);
    if (info.kind != TypeKind::Struct) return false;
    return std::ranges::any_of(types_.struct_of(type).members, [&](const Member& member) {
        return member.initial.is_valid() || (!member.may_be_unset && has_defaults(member.type));
    });
}

/// A member that got no value: its default, or what a variable of its type begins with.
void Checker::emit_member(const Member& member, Reg reg) {
    if (!member.initial.is_valid()) {
        if (member.may_be_unset) emit_unset(member.type, reg);
        else emit_initial(member.type, reg);
        return;
    }
    const std::uint32_t here = std::exchange(module_, member.module);
    const Units before = std::exchange(units_, modules_[member.module].units);
    expression_in(member.initial, member.type, reg, member.name);
    module_ = here;
    units_ = before;
}

/// What a variable without a value holds: nothing but the defaults of a struct's members.
void Checker::emit_initial(Type type, Reg reg) {
    if (!has_defaults(type)) return emit_unset(type, reg);
    if (kind(type) == TypeKind::Struct) {
        const StructInfo info = types_.struct_of(type);
        for (const Member& member : info.members)
            emit_member(member, static_cast<Reg>(reg + member.offset));
        return;
    }
    const TypeInfo info = type_info(type);
    const Reg mark = emit_.mark();
    const Reg index = emit_.take(2);  // and the number of elements
    const Reg element = emit_.take(type_info(info.element).slots);
    Label top;
    emit_.emit_pair(OpCode::NewArray, reg, 0, 0, layout_constant(info.element));
    emit_.emit_integer(OpCode::LoadI, index, 0, 0);
    emit_.emit_integer(OpCode::LoadI, index + 1u, 0, info.count);
    emit_.bind(top);
    emit_initial(info.element, element);
    emit_.emit(OpCode::Append, reg, element);
    emit_.emit_integer(OpCode::AddIK, index, index, 1);
    emit_.jump(OpCode::JumpLtI, top, index, index + 1u);
    emit_.release_to(mark);
}

// ---------------------------------------------------------------- members

Value Checker::member(ExprId id) {
    const Expr& expr = ast()[id];
    const Expr& owner = ast()[expr.child[0]];
    if (owner.kind == ExprKind::Name) {
        const std::string_view name = text(owner.text);
        const Found found = look_up(expr.child[0]);
        if (found.symbol < 0 && found.name == nullptr && (name == "position" || name == "state")) {
            return position_member(expr, name == "position");
        }
        if (found.symbol < 0 && found.name != nullptr && found.name->what == Name::What::Type &&
            kind(found.name->type) == TypeKind::Enum) {
            check_unambiguous(name, owner.range);
            const EnumInfo& info = types_.enum_of(found.name->type);
            for (std::size_t i = 0; i < info.members.size(); ++i) {
                if (info.members[i].first != text(expr.text)) continue;
                record_.note_use(module_, id, info.symbols[i]);
                return constant_integer(info.members[i].second, found.name->type);
            }
            report(diag::UnknownMember, expr.range).arg(name).arg(text(expr.text));
            return error_value();
        }
    }
    if (owner.kind == ExprKind::Given) {
        // `given p.z` asks for the member: `given` binds looser than the point.
        const Expr& asked = ast()[owner.child[0]];
        const bool is_state = asked.kind == ExprKind::Name && find(text(asked.text)).symbol < 0 &&
                              (text(asked.text) == "position" || text(asked.text) == "state");
        if (is_state) return is_given(position_member(expr, text(asked.text) == "position"));
        const std::optional<Lvalue> whole = lvalue(owner.child[0]);
        const std::optional<Lvalue> part = whole ? part_lvalue(*whole, id) : std::nullopt;
        return part ? is_given(load(*part, expr.range, false, kNoReg)) : error_value();
    }
    const std::optional<Lvalue> whole = owner_lvalue(expr.child[0]);
    if (!whole) return error_value();
    if (const std::optional<Value> property = property_value(*whole, expr)) return *property;
    const std::optional<Lvalue> part = part_lvalue(*whole, id);
    return part ? load(*part, expr.range, true, kNoReg) : error_value();
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

Value Checker::position_member(const Expr& expr, bool is_position) {
    const std::string_view name = text(expr.text);
    const auto* const state = std::ranges::find(kStateMembers, name, &StateMember::name);
    const auto* const axis = std::ranges::find(kPositionMembers, name);
    const bool is_known =
        is_position ? axis != kPositionMembers.end() : state != std::end(kStateMembers);
    if (!is_known) {
        report(diag::UnknownMember, expr.range).arg(is_position ? "position" : "state").arg(name);
        return error_value();
    }
    const Reg reg = emit_.take(1);
    if (!is_position) {
        emit_.emit(OpCode::State, reg, 0, static_cast<unsigned>(state->value));
        return in_registers(state->is_optional ? types_.optional(state->type) : state->type, reg);
    }
    const auto number = static_cast<unsigned>(axis - kPositionMembers.begin());
    emit_.emit(OpCode::Position, reg, 0, number);
    const bool is_rotary = number >= 3 && number <= 5;
    return in_registers(types_.optional(is_rotary ? types::kAngleType : types::kLengthType), reg);
}

}  // namespace kadr::sema
