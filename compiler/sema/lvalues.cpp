// lvalues.cpp — what can be assigned and referred to: variables, members, elements; and assignment.
#include "sema/lvalues.h"

#include <algorithm>

#include "base/diagnostics/sema.h"
#include "base/text.h"
#include "sema/calls.h"
#include "sema/checking.h"
#include "sema/composites.h"
#include "sema/convert.h"
#include "sema/expressions.h"
#include "sema/globals.h"
#include "sema/operators.h"
#include "sema/optionals.h"
#include "sema/scope.h"
#include "sema/unknown_names.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;

namespace {

std::optional<Lvalue> member_lvalue(Check& check, syntax::ExprId id);
std::optional<Lvalue> element_lvalue(Check& check, syntax::ExprId id);
std::optional<Lvalue> character_lvalue(Check& check, const Lvalue& whole, const syntax::Expr& expr);

}  // namespace

std::optional<Lvalue> lvalue(Check& check, ExprId id) {
    const Expr& expr = check.ast()[id];
    std::optional<Lvalue> found;
    switch (expr.kind) {
        case ExprKind::Name: found = name_lvalue(check, id); break;
        case ExprKind::Member: found = member_lvalue(check, id); break;
        case ExprKind::Index: found = element_lvalue(check, id); break;
        case ExprKind::Invalid: break;
        default: check.report(diag::NotAPlace, expr.range); break;
    }
    if (found) check.record.note_type(check.here.module, id, found->type);
    return found;
}

namespace {

/// Whether anything has read the local variable of this name so far. Assigning it is no reading,
/// but what is assigned to a reference the caller reads.
bool is_read(const Check& check, ExprId id) {
    if (check.ast()[id].kind != ExprKind::Name) return true;
    const Found found = find(check, check.text(check.ast()[id].text));
    if (found.symbol < 0) return true;
    const Symbol& symbol = check.scopes[found.symbol];
    return symbol.is_read || symbol.storage == Symbol::Storage::Reference;
}

}  // namespace

std::optional<Lvalue> name_lvalue(Check& check, ExprId id) {
    const Expr& expr = check.ast()[id];
    const std::string_view name = check.text(expr.text);
    if (name.empty()) return std::nullopt;
    const Found found = look_up(check, id);
    Lvalue lvalue;
    lvalue.root = name;
    const Symbol* symbol = nullptr;
    if (found.symbol >= 0) {
        Symbol& local = check.scopes[found.symbol];
        local.is_read = true;
        symbol = &local;
        lvalue.symbol = found.symbol;
        lvalue.storage = local.storage == Symbol::Storage::Reference ? Lvalue::Storage::Reference
                                                                     : Lvalue::Storage::Local;
        lvalue.reg = local.reg;
    } else if (found.name != nullptr && found.name->what == Name::What::Variable) {
        check_unambiguous(check, name, expr.range);
        check_global(check, found.name->index, check.here.is_startup);
        symbol = &check.names.global(found.name->index).symbol;
        lvalue.storage = Lvalue::Storage::Global;
        lvalue.offset = symbol->global;
    } else if (found.name != nullptr) {
        check.report(diag::NotAPlace, expr.range);
        return std::nullopt;
    } else {
        if (name == "pi" || name == "position" || name == "state") {
            check.report(diag::NotAPlace, expr.range);
        } else {
            report_unknown(check, name, expr.range);
        }
        return std::nullopt;
    }
    if (check.kind(symbol->type) == TypeKind::Error) return std::nullopt;
    lvalue.type = symbol->type;
    lvalue.is_const = symbol->is_const;
    lvalue.may_be_unset = symbol->may_be_unset && symbol->givenness != Givenness::Given;
    if (found.symbol < 0) lvalue.may_be_unset = symbol->may_be_unset;
    lvalue.root_range = symbol->range;
    if (symbol->storage == Symbol::Storage::Constant) {
        // A folded constant has no registers; give it some for what reads parts of it.
        lvalue.storage = Lvalue::Storage::Local;
        lvalue.reg = in_register(check, symbol->constant);
        lvalue.symbol = -1;
        lvalue.is_const = true;
    }
    return lvalue;
}

std::optional<Lvalue> owner_lvalue(Check& check, ExprId id) {
    const Expr& expr = check.ast()[id];
    const bool is_path = expr.kind == ExprKind::Name || expr.kind == ExprKind::Index ||
                         expr.kind == ExprKind::Member;
    if (is_path) return lvalue(check, id);
    const Value value = expression(check, id);
    if (check.is_error(value)) return std::nullopt;
    if (check.kind(value.type) == TypeKind::Void) {
        check.report(diag::VoidValue, expr.range);
        return std::nullopt;
    }
    Lvalue lvalue;
    lvalue.type = value.type;
    lvalue.reg = in_register(check, value);
    lvalue.is_temporary = true;
    return lvalue;
}

std::optional<Lvalue> part_lvalue(Check& check, const Lvalue& whole, ExprId id) {
    const Expr& expr = check.ast()[id];
    const std::string_view name = check.text(expr.text);
    if (name.empty()) return std::nullopt;
    if (check.kind(whole.type) != TypeKind::Struct) {
        if (check.kind(whole.type) != TypeKind::Error) {
            check.report(diag::UnknownMember, expr.range)
                .arg(check.type_name(whole.type))
                .arg(name);
        }
        return std::nullopt;
    }
    const StructInfo& info = check.types.struct_of(whole.type);
    const auto found = std::find_if(info.members.begin(), info.members.end(),
                                    [&](const Member& m) { return m.name == name; });
    if (found == info.members.end()) {
        auto builder = check.report(diag::UnknownMember, expr.range);
        builder.arg(info.name).arg(name);
        std::vector<std::string_view> names;
        for (const Member& member : info.members) names.push_back(member.name);
        if (const auto near = nearest_name(name, names.data(), names.size())) {
            builder.fix("did you mean " + quoted(*near) + "?");
        }
        return std::nullopt;
    }
    check.record.note_use(check.here.module, id, found->symbol);
    Lvalue part = whole;
    part.symbol = -1;
    part.type = found->type;
    if (whole.storage == Lvalue::Storage::Local) {
        part.reg = static_cast<Reg>(whole.reg + found->offset);
    } else {
        part.offset += found->offset;
    }
    if (check.kind(part.type) == TypeKind::Error) return std::nullopt;
    return part;
}

namespace {

std::optional<Lvalue> member_lvalue(Check& check, ExprId id) {
    const Expr& expr = check.ast()[id];
    const Expr& owner = check.ast()[expr.child[0]];
    if (owner.kind == ExprKind::Name && find(check, check.text(owner.text)).symbol < 0 &&
        find(check, check.text(owner.text)).name == nullptr &&
        (check.text(owner.text) == "position" || check.text(owner.text) == "state")) {
        const Value value = member(check, id);
        if (check.is_error(value)) return std::nullopt;
        Lvalue lvalue;
        lvalue.type = value.type;
        lvalue.reg = value.reg;
        lvalue.is_temporary = true;
        return lvalue;
    }
    const std::optional<Lvalue> whole = owner_lvalue(check, expr.child[0]);
    if (!whole) return std::nullopt;
    if (const std::optional<Value> property = property_value(check, *whole, expr)) {
        if (check.is_error(*property)) return std::nullopt;
        Lvalue lvalue;
        lvalue.type = property->type;
        lvalue.reg = in_register(check, *property);
        lvalue.is_temporary = true;
        return lvalue;
    }
    return part_lvalue(check, *whole, id);
}

std::optional<Lvalue> element_lvalue(Check& check, ExprId id) {
    const Expr& expr = check.ast()[id];
    const std::optional<Lvalue> array = owner_lvalue(check, expr.child[0]);
    if (!array) {
        expression(check, expr.child[1], types::kInt);
        return std::nullopt;
    }
    if (check.kind(array->type) == TypeKind::String) return character_lvalue(check, *array, expr);
    if (check.kind(array->type) != TypeKind::Array) {
        if (check.kind(array->type) != TypeKind::Error) {
            check.report(diag::NotAnArray, check.ast()[expr.child[0]].range)
                .arg(check.type_name(array->type));
        }
        return std::nullopt;
    }
    Value handle = load(check, *array, check.ast()[expr.child[0]].range, true, kNoReg);
    handle = require_given(check, handle, check.ast()[expr.child[0]].range, {});
    const TypeInfo info = check.type_info(check.types.given(array->type));
    const SourceRange index_range = check.ast()[expr.child[1]].range;
    Value index = expression(check, expr.child[1], types::kInt);
    index = convert(check, index, types::kInt, index_range, "the index");
    if (check.is_error(handle) || check.is_error(index)) return std::nullopt;
    if (index.is_constant()) {
        const std::int64_t at = index.constant.integer;
        if (at < 0 || (info.count >= 0 && at >= info.count)) {
            check.report(diag::IndexRange, index_range)
                .arg(at)
                .arg(info.count >= 0 ? "0 to " + std::to_string(info.count - 1)
                                     : std::string("0 and more"));
            return std::nullopt;
        }
    }
    Lvalue lvalue;
    lvalue.storage = Lvalue::Storage::Element;
    lvalue.type = info.element;
    lvalue.reg = handle.reg;
    lvalue.index = in_register(check, index);
    lvalue.stride = check.type_info(info.element).slots;
    lvalue.is_const = array->is_const;
    lvalue.is_temporary = array->is_temporary;
    lvalue.is_contour_part = array->is_contour_part || info.is_contour;
    lvalue.may_be_unset = info.count >= 0;
    lvalue.root = array->root;
    lvalue.root_range = array->root_range;
    if (check.kind(lvalue.type) == TypeKind::Error) return std::nullopt;
    return lvalue;
}

/// A character of a string: a string of its own, which cannot be assigned.
std::optional<Lvalue> character_lvalue(Check& check, const Lvalue& whole, const Expr& expr) {
    Value string = load(check, whole, check.ast()[expr.child[0]].range, true, kNoReg);
    string = require_given(check, string, check.ast()[expr.child[0]].range, {});
    const SourceRange index_range = check.ast()[expr.child[1]].range;
    const Value index = convert(check, expression(check, expr.child[1], types::kInt), types::kInt,
                                index_range, "the index");
    if (check.is_error(string) || check.is_error(index)) return std::nullopt;
    if (index.is_constant() && index.constant.integer < 0) {
        check.report(diag::IndexRange, index_range).arg(index.constant.integer).arg("0 and more");
        return std::nullopt;
    }
    Lvalue lvalue;
    lvalue.type = types::kString;
    const Reg from = in_register(check, string);
    const Reg at = in_register(check, index);
    lvalue.reg = check.emit.take(1);
    lvalue.is_temporary = true;
    check.emit.set_location(expr.range);
    check.emit.emit(OpCode::CharacterOf, lvalue.reg, from, at);
    return lvalue;
}

}  // namespace

Value load(Check& check, const Lvalue& lvalue, const SourceRange& range, bool checked, Reg hint) {
    if (lvalue.symbol >= 0 && lvalue.storage == Lvalue::Storage::Local) {
        return symbol_value(check, lvalue.symbol, range, checked);
    }
    const std::uint16_t slots = check.type_info(lvalue.type).slots;
    Value value = in_registers(lvalue.type, lvalue.reg);
    const auto target = [&] {
        return hint != kNoReg && slots == 1 ? hint : check.emit.take(slots);
    };
    switch (lvalue.storage) {
        case Lvalue::Storage::Local: break;
        case Lvalue::Storage::Global:
            value.reg = target();
            check.emit.emit_pair(OpCode::LoadGlobal, value.reg, 0, slots, lvalue.offset);
            break;
        case Lvalue::Storage::Reference:
            value.reg = target();
            check.emit.emit_pair(OpCode::LoadRef, value.reg, lvalue.reg, slots, lvalue.offset);
            break;
        case Lvalue::Storage::Element:
            value.reg = target();
            if (lvalue.stride == 1)
                check.emit.emit(OpCode::LoadElement, value.reg, lvalue.reg, lvalue.index);
            else {
                check.emit.emit_pair(OpCode::LoadElementN, value.reg, lvalue.reg, lvalue.index,
                                     lvalue.offset, slots);
            }
            break;
    }
    value.is_variable = !lvalue.is_temporary;
    value.is_fresh = lvalue.is_temporary;
    if (checked && lvalue.may_be_unset) check_unset(check, value, check.sources.text(range), range);
    return value;
}

Done require_assignable(Check& check, const Lvalue& lvalue, const SourceRange& range) {
    if (lvalue.is_contour_part) {
        check.report(diag::ContourPartAssigned, range);
        return kFailed;
    }
    if (lvalue.is_temporary) {
        check.report(diag::NotAPlace, range);
        return kFailed;
    }
    if (lvalue.is_const) {
        check.report(diag::ConstAssigned, range)
            .arg(lvalue.root)
            .note(lvalue.root_range, "it is declared `const` here");
        return kFailed;
    }
    return kDone;
}

void note_assignment(Check& check, const Lvalue& lvalue) {
    if (lvalue.symbol < 0) return;
    Symbol& symbol = check.scopes[lvalue.symbol];
    symbol.givenness = Givenness::Given;
    symbol.is_assigned = true;
}

namespace {

void store(Check& check, const Lvalue& lvalue, const Value& value, const SourceRange& range) {
    if (!require_assignable(check, lvalue, range)) return;
    const std::uint16_t slots = check.type_info(lvalue.type).slots;
    if (lvalue.storage == Lvalue::Storage::Local) {
        copy_value(check, value, lvalue.reg);
        return;
    }
    Reg reg = 0;
    if (value.form == Value::Form::InRegister &&
        !(value.is_variable && check.types.holds_array(value.type))) {
        reg = value.reg;
    } else {
        reg = check.emit.take(slots);
        copy_value(check, value, reg);
    }
    switch (lvalue.storage) {
        case Lvalue::Storage::Local: break;
        case Lvalue::Storage::Global:
            check.emit.emit_pair(OpCode::StoreGlobal, reg, 0, slots, lvalue.offset);
            break;
        case Lvalue::Storage::Reference:
            check.emit.emit_pair(OpCode::StoreRef, reg, lvalue.reg, slots, lvalue.offset);
            break;
        case Lvalue::Storage::Element:
            if (lvalue.stride == 1)
                check.emit.emit(OpCode::StoreElement, reg, lvalue.reg, lvalue.index);
            else {
                check.emit.emit_pair(OpCode::StoreElementN, reg, lvalue.reg, lvalue.index,
                                     lvalue.offset, slots);
            }
            break;
    }
}

}  // namespace

Reg reference_to(Check& check, const Lvalue& lvalue) {
    const Reg reg = check.emit.take(1);
    switch (lvalue.storage) {
        case Lvalue::Storage::Local: check.emit.emit(OpCode::RefLocal, reg, lvalue.reg); break;
        case Lvalue::Storage::Global:
            check.emit.emit_pair(OpCode::RefGlobal, reg, 0, 0, lvalue.offset);
            break;
        case Lvalue::Storage::Reference:
            check.emit.emit_pair(OpCode::RefOffset, reg, lvalue.reg, 0, lvalue.offset);
            break;
        case Lvalue::Storage::Element:
            check.emit.emit_pair(OpCode::RefElement, reg, lvalue.reg, lvalue.index, lvalue.offset);
            break;
    }
    return reg;
}

// ---------------------------------------------------------------- assignment

Value assign(Check& check, ExprId id, bool is_value) {
    const Expr& expr = check.ast()[id];
    const SourceRange target_range = check.ast()[expr.child[0]].range;
    const SourceRange value_range = check.ast()[expr.child[1]].range;
    const bool was_read = is_read(check, expr.child[0]);
    const std::optional<Lvalue> target = lvalue(check, expr.child[0]);
    if (target && target->symbol >= 0 && !is_value) check.scopes[target->symbol].is_read = was_read;
    if (!target) {
        expression(check, expr.child[1]);
        return error_value();
    }
    if (!require_assignable(check, *target, target_range)) return error_value();
    const bool is_local = target->storage == Lvalue::Storage::Local;
    const std::uint16_t slots = check.type_info(target->type).slots;
    const std::string_view what = target->symbol >= 0 || target->root.empty()
                                      ? target->root
                                      : check.sources.text(target_range);
    if (expr.op == Operator::Assign) {
        const TypeKind value_kind = check.ast()[expr.child[1]].kind == ExprKind::Binary ||
                                            check.ast()[expr.child[1]].kind == ExprKind::Unary ||
                                            check.ast()[expr.child[1]].kind == ExprKind::Call
                                        ? check.kind(target->type)
                                        : TypeKind::Error;
        // The value of an operator can be computed right where it belongs.
        const bool direct = is_local && slots == 1 && value_kind != TypeKind::Error &&
                            value_kind != TypeKind::Array && value_kind != TypeKind::String;
        Value value = expression(check, expr.child[1], target->type, direct ? target->reg : kNoReg);
        if (target->symbol >= 0)
            check.scopes[target->symbol].origin =
                is_plain_number(check, value) ? value.origin : Origin::Any;
        const bool stays_open = check.type_info(value.type).is_optional;
        value = convert(check, value, target->type, value_range, what);
        if (check.is_error(value)) {
            note_assignment(check, *target);
            return value;
        }
        store(check, *target, value, target_range);
        note_assignment(check, *target);
        if (target->symbol >= 0 && check.type_info(target->type).is_optional) {
            // An optional assigned to an optional may carry "not given" over.
            if (stays_open) check.scopes[target->symbol].givenness = Givenness::Perhaps;
        }
        if (!is_value) return in_registers(types::kVoid, 0);
        return is_local ? load(check, *target, target_range, false, kNoReg) : value;
    }
    Operator op = Operator::Add;
    switch (expr.op) {
        case Operator::SubtractAssign: op = Operator::Subtract; break;
        case Operator::MultiplyAssign: op = Operator::Multiply; break;
        case Operator::DivideAssign: op = Operator::Divide; break;
        case Operator::ModuloAssign: op = Operator::Modulo; break;
        case Operator::ShiftLeftAssign: op = Operator::ShiftLeft; break;
        case Operator::ShiftRightAssign: op = Operator::ShiftRight; break;
        case Operator::BitAndAssign: op = Operator::BitAnd; break;
        case Operator::BitXorAssign: op = Operator::BitXor; break;
        case Operator::BitOrAssign: op = Operator::BitOr; break;
        default: break;
    }
    const Value old = load(check, *target, target_range, true, kNoReg);
    if (target->symbol >= 0) check.scopes[target->symbol].origin = Origin::Any;
    if (target->symbol >= 0 && !is_value) check.scopes[target->symbol].is_read = was_read;
    const bool is_sum = op == Operator::Add || op == Operator::Subtract;
    Value right = expression(check, expr.child[1], is_sum ? target->type : types::kError);
    if (check.is_error(old) || check.is_error(right)) return error_value();
    const bool direct = is_local && slots == 1 && check.kind(target->type) != TypeKind::String;
    Expr operation = expr;
    operation.op = op;
    Value result = binary_values(check, op, old, right, operation, direct ? target->reg : kNoReg);
    result = convert(check, result, target->type, expr.range, what);
    if (check.is_error(result)) return result;
    store(check, *target, result, target_range);
    note_assignment(check, *target);
    return is_value ? result : in_registers(types::kVoid, 0);
}

Value step(Check& check, ExprId id, bool is_value) {
    const Expr& expr = check.ast()[id];
    const SourceRange range = check.ast()[expr.child[0]].range;
    const bool was_read = is_read(check, expr.child[0]);
    const std::optional<Lvalue> target = lvalue(check, expr.child[0]);
    if (!target || !require_assignable(check, *target, range)) return error_value();
    const Value old = require_given(check, load(check, *target, range, true, kNoReg), range, {});
    if (target->symbol >= 0 && !is_value) check.scopes[target->symbol].is_read = was_read;
    if (check.is_error(old)) return old;
    const bool is_int = check.kind(old.type) == TypeKind::Int;
    if (!is_int && old.type != types::kReal) {
        const bool counts_up =
            expr.op == Operator::PreIncrement || expr.op == Operator::PostIncrement;
        auto message = check.report(diag::OperandType, range);
        message.arg(counts_up ? "++" : "--").arg(check.type_name(old.type));
        if (check.types.is_numeric(old.type)) {
            message.fix("numbers count so; say by how much: `" +
                        std::string(check.sources.text(range)) + (counts_up ? " += …`" : " -= …`"));
        }
        return error_value();
    }
    const bool up = expr.op == Operator::PreIncrement || expr.op == Operator::PostIncrement;
    const bool before = expr.op == Operator::PreIncrement || expr.op == Operator::PreDecrement;
    Reg kept = old.reg;
    if (is_value && !before) {
        kept = check.emit.take(1);
        check.emit.emit(OpCode::Move, kept, old.reg);
    }
    const bool is_local = target->storage == Lvalue::Storage::Local;
    const Reg reg = is_local ? target->reg : check.emit.take(1);
    if (is_int) check.emit.emit_integer(OpCode::AddIK, reg, old.reg, up ? 1 : -1);
    else check.emit.emit_number(OpCode::AddFK, reg, old.reg, up ? 1 : -1);
    if (!is_local) store(check, *target, in_registers(old.type, reg), range);
    if (!is_value) return in_registers(types::kVoid, 0);
    Value value = in_registers(old.type, before ? reg : kept);
    value.is_variable = before && is_local;
    return value;
}

}  // namespace kadr::sema
