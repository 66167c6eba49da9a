// lvalues.cpp — what can be assigned and referred to: variables, members, elements; and assignment.
#include <algorithm>

#include "base/diagnostics/sema.h"
#include "base/text.h"
#include "sema/checker.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;

std::optional<Lvalue> Checker::lvalue(ExprId id) {
    const Expr& expr = ast()[id];
    std::optional<Lvalue> found;
    switch (expr.kind) {
        case ExprKind::Name: found = name_lvalue(id); break;
        case ExprKind::Member: found = member_lvalue(id); break;
        case ExprKind::Index: found = element_lvalue(id); break;
        case ExprKind::Invalid: break;
        default: report(diag::NotAPlace, expr.range); break;
    }
    if (found) record_.note_type(module_, id, found->type);
    return found;
}

/// Whether anything has read the local variable of this name so far. Assigning it is no reading,
/// but what is assigned to a reference the caller reads.
bool Checker::is_read(ExprId id) const {
    if (ast()[id].kind != ExprKind::Name) return true;
    const Found found = find(text(ast()[id].text));
    if (found.symbol < 0) return true;
    const Symbol& symbol = symbols_[static_cast<std::size_t>(found.symbol)];
    return symbol.is_read || symbol.storage == Symbol::Storage::Reference;
}

std::optional<Lvalue> Checker::name_lvalue(ExprId id) {
    const Expr& expr = ast()[id];
    const std::string_view name = text(expr.text);
    if (name.empty()) return std::nullopt;
    const Found found = look_up(id);
    Lvalue lvalue;
    lvalue.root = name;
    const Symbol* symbol = nullptr;
    if (found.symbol >= 0) {
        Symbol& local = symbols_[static_cast<std::size_t>(found.symbol)];
        local.is_read = true;
        symbol = &local;
        lvalue.symbol = found.symbol;
        lvalue.storage = local.storage == Symbol::Storage::Reference ? Lvalue::Storage::Reference
                                                                     : Lvalue::Storage::Local;
        lvalue.reg = local.reg;
    } else if (found.name != nullptr && found.name->what == Name::What::Variable) {
        check_unambiguous(name, expr.range);
        check_global(found.name->index, is_startup_);
        symbol = &globals_[found.name->index].symbol;
        lvalue.storage = Lvalue::Storage::Global;
        lvalue.offset = symbol->global;
    } else if (found.name != nullptr) {
        report(diag::NotAPlace, expr.range);
        return std::nullopt;
    } else {
        if (name == "pi" || name == "position" || name == "state") {
            report(diag::NotAPlace, expr.range);
        } else {
            report_unknown(name, expr.range);
        }
        return std::nullopt;
    }
    if (kind(symbol->type) == TypeKind::Error) return std::nullopt;
    lvalue.type = symbol->type;
    lvalue.is_const = symbol->is_const;
    lvalue.is_loop_variable = symbol->is_loop_variable;
    lvalue.may_be_unset = symbol->may_be_unset && symbol->givenness != Givenness::Given;
    if (found.symbol < 0) lvalue.may_be_unset = symbol->may_be_unset;
    lvalue.root_range = symbol->range;
    if (symbol->storage == Symbol::Storage::Constant) {
        // A folded constant has no registers; give it some for what reads parts of it.
        lvalue.storage = Lvalue::Storage::Local;
        lvalue.reg = in_register(symbol->constant);
        lvalue.symbol = -1;
        lvalue.is_const = true;
    }
    return lvalue;
}

std::optional<Lvalue> Checker::owner_lvalue(ExprId id) {
    const Expr& expr = ast()[id];
    const bool is_path = expr.kind == ExprKind::Name || expr.kind == ExprKind::Index ||
                         expr.kind == ExprKind::Member;
    if (is_path) return lvalue(id);
    const Value value = expression(id);
    if (is_error(value)) return std::nullopt;
    if (kind(value.type) == TypeKind::Void) {
        report(diag::VoidValue, expr.range);
        return std::nullopt;
    }
    Lvalue lvalue;
    lvalue.type = value.type;
    lvalue.reg = in_register(value);
    lvalue.is_temporary = true;
    return lvalue;
}

std::optional<Lvalue> Checker::part_lvalue(const Lvalue& whole, ExprId id) {
    const Expr& expr = ast()[id];
    const std::string_view name = text(expr.text);
    if (name.empty()) return std::nullopt;
    if (kind(whole.type) != TypeKind::Struct) {
        if (kind(whole.type) != TypeKind::Error) {
            report(diag::UnknownMember, expr.range).arg(type_name(whole.type)).arg(name);
        }
        return std::nullopt;
    }
    const StructInfo& info = types_.struct_of(whole.type);
    const auto found = std::find_if(info.members.begin(), info.members.end(),
                                    [&](const Member& m) { return m.name == name; });
    if (found == info.members.end()) {
        auto builder = report(diag::UnknownMember, expr.range);
        builder.arg(info.name).arg(name);
        std::vector<std::string_view> names;
        for (const Member& member : info.members) names.push_back(member.name);
        if (const auto near = nearest_name(name, names.data(), names.size())) {
            builder.fix("did you mean " + quoted(*near) + "?");
        }
        return std::nullopt;
    }
    record_.note_use(module_, id, found->symbol);
    Lvalue part = whole;
    part.symbol = -1;
    part.type = found->type;
    if (whole.storage == Lvalue::Storage::Local) {
        part.reg = static_cast<Reg>(whole.reg + found->offset);
    } else {
        part.offset += found->offset;
    }
    if (kind(part.type) == TypeKind::Error) return std::nullopt;
    return part;
}

std::optional<Lvalue> Checker::member_lvalue(ExprId id) {
    const Expr& expr = ast()[id];
    const Expr& owner = ast()[expr.child[0]];
    if (owner.kind == ExprKind::Name && find(text(owner.text)).symbol < 0 &&
        find(text(owner.text)).name == nullptr &&
        (text(owner.text) == "position" || text(owner.text) == "state")) {
        const Value value = member(id);
        if (is_error(value)) return std::nullopt;
        Lvalue lvalue;
        lvalue.type = value.type;
        lvalue.reg = value.reg;
        lvalue.is_temporary = true;
        return lvalue;
    }
    const std::optional<Lvalue> whole = owner_lvalue(expr.child[0]);
    if (!whole) return std::nullopt;
    if (const std::optional<Value> property = property_value(*whole, expr)) {
        if (is_error(*property)) return std::nullopt;
        Lvalue lvalue;
        lvalue.type = property->type;
        lvalue.reg = in_register(*property);
        lvalue.is_temporary = true;
        return lvalue;
    }
    return part_lvalue(*whole, id);
}

std::optional<Lvalue> Checker::element_lvalue(ExprId id) {
    const Expr& expr = ast()[id];
    const std::optional<Lvalue> array = owner_lvalue(expr.child[0]);
    if (!array) {
        expression(expr.child[1], types::kInt);
        return std::nullopt;
    }
    if (kind(array->type) == TypeKind::String) return character_lvalue(*array, expr);
    if (kind(array->type) != TypeKind::Array) {
        if (kind(array->type) != TypeKind::Error) {
            report(diag::NotAnArray, ast()[expr.child[0]].range).arg(type_name(array->type));
        }
        return std::nullopt;
    }
    Value handle = load(*array, ast()[expr.child[0]].range, true, kNoReg);
    handle = require_given(handle, ast()[expr.child[0]].range, {});
    const TypeInfo info = type_info(types_.given(array->type));
    const SourceRange index_range = ast()[expr.child[1]].range;
    Value index = expression(expr.child[1], types::kInt);
    index = convert(index, types::kInt, index_range, "the index");
    if (is_error(handle) || is_error(index)) return std::nullopt;
    if (index.is_constant()) {
        const std::int64_t at = index.constant.integer;
        if (at < 0 || (info.count >= 0 && at >= info.count)) {
            report(diag::IndexRange, index_range)
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
    lvalue.index = in_register(index);
    lvalue.stride = type_info(info.element).slots;
    lvalue.is_const = array->is_const;
    lvalue.is_temporary = array->is_temporary;
    lvalue.is_contour_part = array->is_contour_part || info.is_contour;
    lvalue.may_be_unset = info.count >= 0;
    lvalue.root = array->root;
    lvalue.root_range = array->root_range;
    if (kind(lvalue.type) == TypeKind::Error) return std::nullopt;
    return lvalue;
}

/// A character of a string: a string of its own, which cannot be assigned.
std::optional<Lvalue> Checker::character_lvalue(const Lvalue& whole, const Expr& expr) {
    Value string = load(whole, ast()[expr.child[0]].range, true, kNoReg);
    string = require_given(string, ast()[expr.child[0]].range, {});
    const SourceRange index_range = ast()[expr.child[1]].range;
    const Value index =
        convert(expression(expr.child[1], types::kInt), types::kInt, index_range, "the index");
    if (is_error(string) || is_error(index)) return std::nullopt;
    if (index.is_constant() && index.constant.integer < 0) {
        report(diag::IndexRange, index_range).arg(index.constant.integer).arg("0 and more");
        return std::nullopt;
    }
    Lvalue lvalue;
    lvalue.type = types::kString;
    const Reg from = in_register(string);
    const Reg at = in_register(index);
    lvalue.reg = emit_.take(1);
    lvalue.is_temporary = true;
    emit_.set_location(expr.range);
    emit_.emit(OpCode::CharacterOf, lvalue.reg, from, at);
    return lvalue;
}

Value Checker::load(const Lvalue& lvalue, const SourceRange& range, bool checked, Reg hint) {
    if (lvalue.symbol >= 0 && lvalue.storage == Lvalue::Storage::Local) {
        return symbol_value(lvalue.symbol, range, checked);
    }
    const std::uint16_t slots = type_info(lvalue.type).slots;
    Value value = in_registers(lvalue.type, lvalue.reg);
    const auto target = [&] { return hint != kNoReg && slots == 1 ? hint : emit_.take(slots); };
    switch (lvalue.storage) {
        case Lvalue::Storage::Local: break;
        case Lvalue::Storage::Global:
            value.reg = target();
            emit_.emit_pair(OpCode::LoadGlobal, value.reg, 0, slots, lvalue.offset);
            break;
        case Lvalue::Storage::Reference:
            value.reg = target();
            emit_.emit_pair(OpCode::LoadRef, value.reg, lvalue.reg, slots, lvalue.offset);
            break;
        case Lvalue::Storage::Element:
            value.reg = target();
            if (lvalue.stride == 1)
                emit_.emit(OpCode::LoadElement, value.reg, lvalue.reg, lvalue.index);
            else {
                emit_.emit_pair(OpCode::LoadElementN, value.reg, lvalue.reg, lvalue.index,
                                lvalue.offset, slots);
            }
            break;
    }
    value.is_variable = !lvalue.is_temporary;
    value.is_fresh = lvalue.is_temporary;
    if (checked && lvalue.may_be_unset) check_unset(value, sources_.text(range), range);
    return value;
}

Done Checker::require_assignable(const Lvalue& lvalue, const SourceRange& range) {
    if (lvalue.is_contour_part) {
        report(diag::ContourPartAssigned, range);
        return kFailed;
    }
    if (lvalue.is_temporary) {
        report(diag::NotAPlace, range);
        return kFailed;
    }
    if (lvalue.is_const) {
        report(diag::ConstAssigned, range)
            .arg(lvalue.root)
            .note(lvalue.root_range, "it is declared `const` here");
        return kFailed;
    }
    return kDone;
}

void Checker::note_assignment(const Lvalue& lvalue) {
    if (lvalue.symbol < 0) return;
    Symbol& symbol = symbols_[static_cast<std::size_t>(lvalue.symbol)];
    symbol.givenness = Givenness::Given;
    symbol.is_assigned = true;
}

void Checker::store(const Lvalue& lvalue, const Value& value, const SourceRange& range) {
    if (!require_assignable(lvalue, range)) return;
    const std::uint16_t slots = type_info(lvalue.type).slots;
    if (lvalue.storage == Lvalue::Storage::Local) {
        copy_value(value, lvalue.reg);
        return;
    }
    Reg reg = 0;
    if (value.form == Value::Form::InRegister &&
        !(value.is_variable && types_.holds_array(value.type))) {
        reg = value.reg;
    } else {
        reg = emit_.take(slots);
        copy_value(value, reg);
    }
    switch (lvalue.storage) {
        case Lvalue::Storage::Local: break;
        case Lvalue::Storage::Global:
            emit_.emit_pair(OpCode::StoreGlobal, reg, 0, slots, lvalue.offset);
            break;
        case Lvalue::Storage::Reference:
            emit_.emit_pair(OpCode::StoreRef, reg, lvalue.reg, slots, lvalue.offset);
            break;
        case Lvalue::Storage::Element:
            if (lvalue.stride == 1) emit_.emit(OpCode::StoreElement, reg, lvalue.reg, lvalue.index);
            else {
                emit_.emit_pair(OpCode::StoreElementN, reg, lvalue.reg, lvalue.index, lvalue.offset,
                                slots);
            }
            break;
    }
}

Reg Checker::reference_to(const Lvalue& lvalue) {
    const Reg reg = emit_.take(1);
    switch (lvalue.storage) {
        case Lvalue::Storage::Local: emit_.emit(OpCode::RefLocal, reg, lvalue.reg); break;
        case Lvalue::Storage::Global:
            emit_.emit_pair(OpCode::RefGlobal, reg, 0, 0, lvalue.offset);
            break;
        case Lvalue::Storage::Reference:
            emit_.emit_pair(OpCode::RefOffset, reg, lvalue.reg, 0, lvalue.offset);
            break;
        case Lvalue::Storage::Element:
            emit_.emit_pair(OpCode::RefElement, reg, lvalue.reg, lvalue.index, lvalue.offset);
            break;
    }
    return reg;
}

// ---------------------------------------------------------------- assignment

Value Checker::assign(ExprId id, bool is_value) {
    const Expr& expr = ast()[id];
    const SourceRange target_range = ast()[expr.child[0]].range;
    const SourceRange value_range = ast()[expr.child[1]].range;
    const bool was_read = is_read(expr.child[0]);
    const std::optional<Lvalue> target = lvalue(expr.child[0]);
    if (target && target->symbol >= 0 && !is_value)
        symbols_[static_cast<std::size_t>(target->symbol)].is_read = was_read;
    if (!target) {
        expression(expr.child[1]);
        return error_value();
    }
    if (!require_assignable(*target, target_range)) return error_value();
    const bool is_local = target->storage == Lvalue::Storage::Local;
    const std::uint16_t slots = type_info(target->type).slots;
    const std::string_view what =
        target->symbol >= 0 || target->root.empty() ? target->root : sources_.text(target_range);
    if (expr.op == Operator::Assign) {
        const TypeKind value_kind = ast()[expr.child[1]].kind == ExprKind::Binary ||
                                            ast()[expr.child[1]].kind == ExprKind::Unary ||
                                            ast()[expr.child[1]].kind == ExprKind::Call
                                        ? kind(target->type)
                                        : TypeKind::Error;
        // The value of an operator can be computed right where it belongs.
        const bool direct = is_local && slots == 1 && value_kind != TypeKind::Error &&
                            value_kind != TypeKind::Array && value_kind != TypeKind::String;
        Value value = expression(expr.child[1], target->type, direct ? target->reg : kNoReg);
        if (target->symbol >= 0)
            symbols_[static_cast<std::size_t>(target->symbol)].origin =
                is_plain_number(value) ? value.origin : Origin::Any;
        const bool stays_open = type_info(value.type).is_optional;
        value = convert(value, target->type, value_range, what);
        if (is_error(value)) {
            note_assignment(*target);
            return value;
        }
        store(*target, value, target_range);
        note_assignment(*target);
        if (target->symbol >= 0 && type_info(target->type).is_optional) {
            // An optional assigned to an optional may carry "not given" over.
            if (stays_open)
                symbols_[static_cast<std::size_t>(target->symbol)].givenness = Givenness::Perhaps;
        }
        if (!is_value) return in_registers(types::kVoid, 0);
        return is_local ? load(*target, target_range, false, kNoReg) : value;
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
    const Value old = load(*target, target_range, true, kNoReg);
    if (target->symbol >= 0)
        symbols_[static_cast<std::size_t>(target->symbol)].origin = Origin::Any;
    if (target->symbol >= 0 && !is_value)
        symbols_[static_cast<std::size_t>(target->symbol)].is_read = was_read;
    const bool is_sum = op == Operator::Add || op == Operator::Subtract;
    Value right = expression(expr.child[1], is_sum ? target->type : types::kError);
    if (is_error(old) || is_error(right)) return error_value();
    const bool direct = is_local && slots == 1 && kind(target->type) != TypeKind::String;
    Expr operation = expr;
    operation.op = op;
    Value result = binary_values(op, old, right, operation, direct ? target->reg : kNoReg);
    result = convert(result, target->type, expr.range, what);
    if (is_error(result)) return result;
    store(*target, result, target_range);
    note_assignment(*target);
    return is_value ? result : in_registers(types::kVoid, 0);
}

Value Checker::step(ExprId id, bool is_value) {
    const Expr& expr = ast()[id];
    const SourceRange range = ast()[expr.child[0]].range;
    const bool was_read = is_read(expr.child[0]);
    const std::optional<Lvalue> target = lvalue(expr.child[0]);
    if (!target || !require_assignable(*target, range)) return error_value();
    const Value old = require_given(load(*target, range, true, kNoReg), range, {});
    if (target->symbol >= 0 && !is_value)
        symbols_[static_cast<std::size_t>(target->symbol)].is_read = was_read;
    if (is_error(old)) return old;
    const bool is_int = kind(old.type) == TypeKind::Int;
    if (!is_int && old.type != types::kReal) {
        const bool counts_up =
            expr.op == Operator::PreIncrement || expr.op == Operator::PostIncrement;
        auto message = report(diag::OperandType, range);
        message.arg(counts_up ? "++" : "--").arg(type_name(old.type));
        if (types_.is_numeric(old.type)) {
            message.fix("numbers count so; say by how much: `" + std::string(sources_.text(range)) +
                        (counts_up ? " += …`" : " -= …`"));
        }
        return error_value();
    }
    const bool up = expr.op == Operator::PreIncrement || expr.op == Operator::PostIncrement;
    const bool before = expr.op == Operator::PreIncrement || expr.op == Operator::PreDecrement;
    Reg kept = old.reg;
    if (is_value && !before) {
        kept = emit_.take(1);
        emit_.emit(OpCode::Move, kept, old.reg);
    }
    const bool is_local = target->storage == Lvalue::Storage::Local;
    const Reg reg = is_local ? target->reg : emit_.take(1);
    if (is_int) emit_.emit_integer(OpCode::AddIK, reg, old.reg, up ? 1 : -1);
    else emit_.emit_number(OpCode::AddFK, reg, old.reg, up ? 1 : -1);
    if (!is_local) store(*target, in_registers(old.type, reg), range);
    if (!is_value) return in_registers(types::kVoid, 0);
    Value value = in_registers(old.type, before ? reg : kept);
    value.is_variable = before && is_local;
    return value;
}

}  // namespace kadr::sema
