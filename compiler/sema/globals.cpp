#include "sema/globals.h"

#include "base/diagnostics/sema.h"
#include "sema/checking.h"
#include "sema/composites.h"
#include "sema/contours.h"
#include "sema/convert.h"
#include "sema/expressions.h"
#include "sema/functions.h"
#include "sema/naming.h"
#include "sema/type_declarations.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::DeclKind;

void check_global(Check& check, std::uint32_t index, bool on_demand) {
    GlobalVariable& global = check.names.global(index);
    if (global.state == GlobalVariable::State::Done) return;
    const syntax::Ast& tree = *check.names.module(global.module).ast;
    const Decl& decl = tree[global.decl];
    if (global.state == GlobalVariable::State::Checking) {
        check.report(diag::CircularConstant, decl.name_range).arg(tree.text(decl.name));
        global.state = GlobalVariable::State::Done;  // reported once
        return;
    }
    global.state = GlobalVariable::State::Checking;
    const Finding finding(check);
    const std::uint32_t module = std::exchange(check.here.module, global.module);
    const Units units = std::exchange(check.here.units, check.names.module(global.module).units);
    const SourceRange location = check.emit.location();
    check.emit.set_location(decl.range);

    Symbol symbol;
    symbol.name = tree.text(decl.name);
    symbol.range = decl.name_range;
    symbol.decl = global.decl;
    symbol.checked = global.symbol.checked;
    symbol.is_const = decl.is_const;
    symbol.type = decl.type.is_valid() ? resolve_type(check, decl.type) : types::kError;
    if (decl.is_const && !decl.value.is_valid())
        check.report(diag::ConstWithoutValue, decl.name_range).arg(symbol.name);
    const std::uint32_t began = check.emit.here();
    if (!on_demand) note_statement(check, decl.range);
    const Reg mark = check.emit.mark();
    Value value = error_value();
    const bool is_body = decl.kind == DeclKind::Contour;
    if (is_body) {
        symbol.type = types::kContour;
        value = in_registers(types::kContour, check.emit.take(1));
        value.is_fresh = true;
        contour_body(check, decl, value.reg);
    } else if (decl.value.is_valid()) {
        value = expression(check, decl.value, symbol.type);
        if (decl.type.is_valid()) {
            value = convert(check, value, symbol.type, tree[decl.value].range, symbol.name);
        } else {
            symbol.type = value.type;
            if (symbol.type == types::kVoid) {
                check.report(diag::VoidValue, tree[decl.value].range);
                symbol.type = types::kError;
            }
        }
    }
    if (decl.is_const && value.is_constant()) {
        symbol.storage = Symbol::Storage::Constant;
        symbol.constant = value;
    } else {
        if (on_demand && !check.is_error(value)) {
            check.report(diag::UsedBeforeDefinition, decl.name_range).arg(symbol.name);
        }
        symbol.storage = Symbol::Storage::Global;
        symbol.global = check.code->globals;
        const std::uint16_t slots = check.type_info(symbol.type).slots;
        const bool had_room = check.code->globals <= kMostGlobals;
        check.code->globals += slots;
        if (had_room && check.code->globals > kMostGlobals)
            check.report(diag::GlobalsTooLarge, symbol.range).arg(std::size_t{kMostGlobals});
        symbol.may_be_unset = !decl.value.is_valid() && !is_body;
        Reg reg = 0;
        if (decl.value.is_valid() || is_body) {
            reg = in_register(check, value);
            if (value.is_variable && check.types.holds_array(symbol.type)) {
                const Reg copy = check.emit.take(slots);
                copy_value(check, value, copy);
                reg = copy;
            }
        } else {
            reg = check.emit.take(slots);
            if (check.is_optional_type(decl)) emit_unset(check, symbol.type, reg);
            else emit_initial(check, symbol.type, reg);
        }
        if (slots > 0) check.emit.emit_pair(OpCode::StoreGlobal, reg, 0, slots, symbol.global);
    }
    if (!on_demand) drop_empty_statement(check, began);
    report_overflow(check, symbol.name, symbol.range);
    check.emit.release_to(mark);
    check.emit.set_location(location);
    check.here.module = module;
    check.here.units = units;
    check.record.set_type(symbol.checked, symbol.type);
    check.names.global(index).symbol = symbol;
    check.names.global(index).state = GlobalVariable::State::Done;
}

}  // namespace kadr::sema
