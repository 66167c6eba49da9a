// statements.cpp — statements: variables, branches, contracts, messages.
#include "sema/statements.h"

#include <algorithm>

#include "base/diagnostics/sema.h"
#include "sema/blocks.h"
#include "sema/checking.h"
#include "sema/composites.h"
#include "sema/conditions.h"
#include "sema/contours.h"
#include "sema/convert.h"
#include "sema/empty_body.h"
#include "sema/expressions.h"
#include "sema/loops.h"
#include "sema/lvalues.h"
#include "sema/naming.h"
#include "sema/native_cycles.h"
#include "sema/optionals.h"
#include "sema/scope.h"
#include "sema/tests.h"
#include "sema/texts.h"
#include "sema/type_declarations.h"
#include "sema/values.h"
#include "sema/with.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::StmtId;
using syntax::StmtKind;

namespace {

void variable(Check& check, syntax::DeclId id);
void expression_statement(Check& check, const syntax::Stmt& stmt);
Completion if_statement(Check& check, const syntax::Stmt& stmt);
Completion switch_statement(Check& check, const syntax::Stmt& stmt);
void return_statement(Check& check, const syntax::Stmt& stmt);
bool is_own_local(const Check& check, syntax::ExprId id);
void check_statement(Check& check, const syntax::Stmt& stmt, bool is_require);
void text_statement(Check& check, const syntax::Stmt& stmt, OpCode op, unsigned kind);

}  // namespace

std::uint32_t statement_id(Check& check, const SourceRange& range) {
    const auto id = static_cast<std::uint32_t>(check.code->statements.size());
    check.code->statements.push_back(range);
    return id;
}

Completion block(Check& check, syntax::List list, const SourceRange& range) {
    const Scopes::Outer outer = check.scopes.enter(range);
    const Reg mark = check.emit.mark();
    bool reachable = true;
    bool said = false;
    for (const StmtId id : check.ast().stmts(list)) {
        if (!reachable && !said && check.ast()[id].kind != StmtKind::Empty) {
            check.report(diag::Unreachable, check.ast()[id].range);
            said = true;
        }
        if (check.body.native_pending && !is_check(check, id)) emit_native_cycle(check);
        const Completion completion = statement(check, id);
        reachable = reachable && completion == Completion::Normal;
        // `error(…); return 0;` is written so that the reader sees the end.
        if (check.ast()[id].kind == StmtKind::ErrorStmt) said = true;
    }
    leave_scope(check, outer);
    check.emit.release_to(mark);
    return completion(reachable);
}

Completion statement(Check& check, StmtId id) {
    if (!id.is_valid()) return Completion::Normal;
    look_at_clock(check);
    if (check.clock.is_late) return Completion::Normal;
    const Stmt& stmt = check.ast()[id];
    const SourceRange before = check.emit.location();
    check.emit.set_location(stmt.range);
    const Reg mark = check.emit.mark();
    const StmtId outer = std::exchange(check.here.block, id);
    Completion completion = Completion::Normal;
    bool keeps_registers = false;
    warn_of_empty_body(check, stmt);
    const std::uint32_t began = check.emit.here();
    note_statement(check, stmt);
    switch (stmt.kind) {
        case StmtKind::Invalid:
        case StmtKind::Empty: break;
        case StmtKind::Block: completion = block(check, stmt.statements, stmt.range); break;
        case StmtKind::Expression: expression_statement(check, stmt); break;
        case StmtKind::Declaration:
            variable(check, stmt.declaration);
            keeps_registers = true;
            break;
        case StmtKind::If: completion = if_statement(check, stmt); break;
        case StmtKind::While: completion = while_statement(check, stmt); break;
        case StmtKind::DoWhile: completion = do_statement(check, stmt); break;
        case StmtKind::For: completion = for_statement(check, stmt); break;
        case StmtKind::ForEach: completion = for_each(check, stmt); break;
        case StmtKind::Switch: completion = switch_statement(check, stmt); break;
        case StmtKind::Case: break;
        case StmtKind::Break:
        case StmtKind::Continue:
            jump_out(check, stmt.kind == StmtKind::Break, stmt.range);
            completion = Completion::Abrupt;
            break;
        case StmtKind::Return:
            return_statement(check, stmt);
            completion = Completion::Abrupt;
            break;
        case StmtKind::Words: words_statement(check, stmt); break;
        case StmtKind::With: completion = with_statement(check, stmt); break;
        case StmtKind::Note: text_statement(check, stmt, OpCode::EmitText, 0); break;
        case StmtKind::Raw: text_statement(check, stmt, OpCode::EmitText, 1); break;
        case StmtKind::Units: {
            const std::string_view name = check.text(stmt.text);
            const Units asked = name == "mm" ? Units::Metric : Units::Inch;
            // The first statement of a program was taken into account before; elsewhere the units
            // of a file do not change.
            if (asked != check.here.units) check.report(diag::UnitsPlace, stmt.range);
            break;
        }
        case StmtKind::Require: check_statement(check, stmt, true); break;
        case StmtKind::Assert: check_statement(check, stmt, false); break;
        case StmtKind::ErrorStmt:
            text_statement(check, stmt, OpCode::UserError, 0);
            completion = Completion::Abrupt;
            break;
        case StmtKind::WarnStmt: text_statement(check, stmt, OpCode::UserWarning, 0); break;
        case StmtKind::Close:
            if (check.here.contour_depth == 0) check.report(diag::CloseOutside, stmt.range);
            check.emit.emit(OpCode::CloseContour);
            break;
        case StmtKind::Assume: assume_statement(check, stmt); break;
        case StmtKind::Expect: expect_statement(check, stmt); break;
    }
    drop_empty_statement(check, began);
    if (!keeps_registers) check.emit.release_to(mark);
    check.here.block = outer;
    check.emit.set_location(before);
    return completion;
}

namespace {

void variable(Check& check, syntax::DeclId id) {
    const Decl& decl = check.ast()[id];
    if (decl.kind == syntax::DeclKind::Contour) {
        contour_variable(check, id);
        return;
    }
    Symbol symbol;
    symbol.name = check.text(decl.name);
    symbol.range = decl.name_range;
    symbol.decl = id;
    symbol.is_const = decl.is_const;
    symbol.type = decl.type.is_valid() ? resolve_type(check, decl.type) : types::kError;
    if (symbol.type == types::kVoid) {
        check.report(diag::VoidValue, decl.range);
        symbol.type = types::kError;
    }
    if (decl.type.is_valid() && check.ast()[decl.type].is_reference)
        check.report(diag::ReferencePlace, check.ast()[decl.type].range);
    const std::string_view outer = std::exchange(check.here.declared, check.text(decl.name));
    if (decl.is_const && !decl.value.is_valid())
        check.report(diag::ConstWithoutValue, decl.name_range).arg(symbol.name);
    if (decl.value.is_valid()) {
        symbol.is_row = is_as_given(check, decl.value);
        const SourceRange range = check.ast()[decl.value].range;
        if (decl.type.is_valid() && check.kind(symbol.type) != TypeKind::Error) {
            const std::uint16_t slots = check.type_info(symbol.type).slots;
            const Reg mark = check.emit.mark();
            symbol.reg = check.emit.take(slots);
            const bool is_single = slots == 1 && check.kind(symbol.type) != TypeKind::Array;
            const Value value =
                expression(check, decl.value, symbol.type, is_single ? symbol.reg : kNoReg);
            if (is_plain_number(check, value)) symbol.origin = value.origin;
            const bool stays_open = check.type_info(value.type).is_optional;
            const Value converted = convert(check, value, symbol.type, range, symbol.name);
            if (decl.is_const && converted.is_constant() && !check.is_error(converted)) {
                symbol.storage = Symbol::Storage::Constant;
                symbol.constant = converted;
                check.emit.release_to(mark);
            } else {
                if (!check.is_error(converted)) copy_value(check, converted, symbol.reg);
                check.emit.release_to(static_cast<Reg>(symbol.reg + slots));
            }
            symbol.givenness = stays_open ? Givenness::Perhaps : Givenness::Given;
        } else {
            const Reg mark = check.emit.mark();
            const Value value = expression(check, decl.value, symbol.type);
            if (check.kind(value.type) == TypeKind::Void) {
                check.report(diag::VoidValue, range);
                symbol.type = types::kError;
            } else if (!decl.type.is_valid()) {
                symbol.type = value.type;
            }
            if (is_plain_number(check, value)) symbol.origin = value.origin;
            if (decl.is_const && value.is_constant()) {
                symbol.storage = Symbol::Storage::Constant;
                symbol.constant = value;
                check.emit.release_to(mark);
            } else {
                const std::uint16_t slots = check.type_info(symbol.type).slots;
                const Reg above = check.emit.take(slots);
                if (!check.is_error(value) && check.kind(value.type) != TypeKind::Void)
                    copy_value(check, value, above);
                if (above != mark && slots > 0) {
                    check.emit.emit(slots == 1 ? OpCode::Move : OpCode::MoveN, mark, above,
                                    slots == 1 ? 0u : slots);
                }
                check.emit.release_to(mark);
                symbol.reg = check.emit.take(slots);
                symbol.givenness = check.type_info(symbol.type).is_optional ? Givenness::Perhaps
                                                                            : Givenness::Given;
            }
        }
    } else {
        symbol.reg = check.emit.take(check.type_info(symbol.type).slots);
        if (check.is_optional_type(decl)) emit_unset(check, symbol.type, symbol.reg);
        else emit_initial(check, symbol.type, symbol.reg);
        const TypeKind k = check.kind(symbol.type);
        symbol.may_be_unset = k != TypeKind::Array && k != TypeKind::Error &&
                              !check.type_info(symbol.type).is_optional;
        symbol.givenness = k == TypeKind::Array || k == TypeKind::Error ? Givenness::Given
                           : k == TypeKind::Struct                      ? Givenness::Perhaps
                                                                        : Givenness::NotGiven;
    }
    check.here.declared = outer;
    add_symbol(check, symbol);
}

void expression_statement(Check& check, const Stmt& stmt) {
    const Expr& expr = check.ast()[stmt.expression[0]];
    const bool is_shown = check.here.module == 0 && stmt.range.begin >= check.options.shown_from;
    check.here.statement = statement_id(check, stmt.range);
    switch (expr.kind) {
        case ExprKind::Assign: assign(check, stmt.expression[0], false); return;
        case ExprKind::Unary:
            if (expr.op >= syntax::Operator::PreIncrement &&
                expr.op <= syntax::Operator::PostDecrement) {
                step(check, stmt.expression[0], false);
                return;
            }
            break;
        case ExprKind::Call:
            if (is_shown) show(check, stmt.expression[0]);
            else expression(check, stmt.expression[0]);
            return;
        case ExprKind::Invalid: return;
        default: break;
    }
    if (is_shown) return show(check, stmt.expression[0]);
    const std::size_t errors = check.sink.errors;
    expression(check, stmt.expression[0]);
    if (errors == check.sink.errors) check.report(diag::UselessExpression, expr.range);
}

Completion if_statement(Check& check, const Stmt& stmt) {
    const ExprId condition = stmt.expression[0];
    Label otherwise;
    const std::uint32_t start = check.emit.here();
    const FlowState before = check.scopes.flow();
    jump_if(check, condition, false, otherwise);
    // What a constant condition excludes is still checked, but does not count for the flow.
    const bool never = otherwise.pending.size() == 1 && check.emit.here() == start + 1 &&
                       check.code->instructions[start].op == OpCode::Jump;
    const bool always = otherwise.pending.empty() && check.emit.here() == start;
    assume_given(check, condition, true);
    const bool then_ends = statement(check, stmt.statement[0]) == Completion::Normal;
    const FlowState after_then = check.scopes.flow();
    check.scopes.set_flow(before);
    assume_given(check, condition, false);
    if (!stmt.statement[1].is_valid()) {
        check.emit.bind(otherwise);
        if (then_ends) check.scopes.join_flow(after_then);
        return completion(!always || then_ends || check.ast()[condition].kind != ExprKind::Bool);
    }
    Label done;
    if (then_ends) check.emit.jump(OpCode::Jump, done);
    check.emit.bind(otherwise);
    const bool else_ends = statement(check, stmt.statement[1]) == Completion::Normal;
    check.emit.bind(done);
    if (then_ends && else_ends) check.scopes.join_flow(after_then);
    else if (then_ends) check.scopes.set_flow(after_then);
    if (never) return completion(else_ends);
    return completion(then_ends || else_ends);
}

Completion switch_statement(Check& check, const Stmt& stmt) {
    const SourceRange range = check.ast()[stmt.expression[0]].range;
    const Value chosen = require_given(check, expression(check, stmt.expression[0]), range, {});
    const TypeKind k = check.kind(chosen.type);
    const bool fits =
        k == TypeKind::Int || k == TypeKind::Enum || k == TypeKind::String || k == TypeKind::Bool;
    if (!fits && k != TypeKind::Error)
        check.report(diag::SwitchType, range).arg(check.type_name(chosen.type));
    Value value = chosen;
    if (fits) {
        const Reg kept = check.emit.take(1);
        copy_value(check, chosen, kept);
        value = in_registers(chosen.type, kept);
    }
    const auto cases = check.ast().stmts(stmt.statements);
    std::vector<Label> labels(cases.size());
    Label done;
    std::int64_t default_case = -1;
    struct Choice {
        std::int64_t first, last;
        SourceRange range;
    };
    std::vector<Choice> choices;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Stmt& entry = check.ast()[cases[i]];
        const auto values = check.ast().exprs(entry.expressions);
        if (values.empty()) {
            if (default_case >= 0) {
                check.report(diag::CaseTwice, entry.range)
                    .arg("default")
                    .note(check.ast()[cases[static_cast<std::size_t>(default_case)]].range,
                          "it stands here");
            }
            default_case = static_cast<std::int64_t>(i);
        }
        for (const ExprId id : values) {
            const SourceRange at = check.ast()[id].range;
            const bool is_range = check.ast()[id].kind == ExprKind::Range;
            const ExprId first_id = is_range ? check.ast()[id].child[0] : id;
            const Value first =
                convert(check, expression(check, first_id, value.type), value.type, at, "the case");
            const Value last =
                is_range ? convert(check, expression(check, check.ast()[id].child[1], value.type),
                                   value.type, at, "the case")
                         : first;
            if (!fits || check.is_error(first) || check.is_error(last)) continue;
            if (!first.is_constant() || !last.is_constant() || (is_range && k != TypeKind::Int)) {
                check.report(diag::NotConstant, at).arg("a case");
                continue;
            }
            const auto same = std::ranges::find_if(choices, [&](const Choice& other) {
                return other.first <= last.constant.integer && other.last >= first.constant.integer;
            });
            if (same != choices.end()) {
                check.report(diag::CaseTwice, at)
                    .arg(check.sources.text(at))
                    .note(same->range, "it stands here");
                continue;
            }
            choices.push_back({first.constant.integer, last.constant.integer, at});
            const Reg mark = check.emit.mark();
            if (k == TypeKind::String) {
                const Reg order = check.emit.take(1);
                check.emit.emit(OpCode::CompareText, order, value.reg, in_register(check, first));
                check.emit.jump(OpCode::JumpEqIK, labels[i], order);
            } else if (is_range) {
                Label next;
                const Reg low = in_register(check, first);
                const Reg high = in_register(check, last);
                check.emit.jump(OpCode::JumpLtI, next, value.reg, low);
                check.emit.jump(OpCode::JumpLeI, labels[i], value.reg, high);
                check.emit.bind(next);
            } else if (first.constant.integer >= -32768 && first.constant.integer <= 32767) {
                check.emit.jump(
                    OpCode::JumpEqIK, labels[i], value.reg, 0,
                    static_cast<std::uint16_t>(static_cast<std::int16_t>(first.constant.integer)));
            } else {
                check.emit.jump(OpCode::JumpEqI, labels[i], value.reg, in_register(check, first));
            }
            check.emit.release_to(mark);
        }
    }
    if (default_case >= 0)
        check.emit.jump(OpCode::Jump, labels[static_cast<std::size_t>(default_case)]);
    else check.emit.jump(OpCode::Jump, done);

    check.here.loops.push_back({&done, nullptr, check.here.with_depth});
    const FlowState before = check.scopes.flow();
    FlowState merged = before;
    bool ends = true;
    bool all_leave = default_case >= 0;
    const std::size_t breaks = done.pending.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        check.emit.bind(labels[i]);
        if (ends && i > 0) check.scopes.join_flow(before);
        else check.scopes.set_flow(before);
        ends = block(check, check.ast()[cases[i]].statements, check.ast()[cases[i]].range) ==
               Completion::Normal;
        check.scopes.join_into(merged);
    }
    check.here.loops.pop_back();
    const bool breaks_out = done.pending.size() > breaks;
    check.scopes.set_flow(merged);
    check.emit.bind(done);
    if (cases.empty()) return Completion::Normal;
    return completion(!(all_leave && !ends && !breaks_out));
}

}  // namespace

void leave_function(Check& check, const SourceRange& range) {
    const SourceRange before = check.emit.location();
    check.emit.set_location(range);
    if (check.here.with_depth > 0) {
        check.emit.emit_pair(OpCode::LeaveWith, 0, 0, static_cast<unsigned>(check.here.with_depth),
                             0, statement_id(check, range));
    }
    if (check.body.has_preserves) check.emit.emit(OpCode::CheckPreserves);
    check.emit.set_location(before);
}

namespace {

void return_statement(Check& check, const Stmt& stmt) {
    if (check.here.contour_depth > 0) {
        check.report(diag::ReturnInContour, stmt.range);
        return;
    }
    const Type result = check.here.function != nullptr ? check.here.function->result : types::kVoid;
    if (!stmt.expression[0].is_valid()) {
        if (result != types::kVoid && check.kind(result) != TypeKind::Error) {
            check.report(diag::ReturnWithoutValue, stmt.range)
                .arg(check.here.function->name)
                .arg(check.type_name(result));
        }
        leave_function(check, stmt.range);
        check.emit.emit(OpCode::Return, 0, 0, 0);
        return;
    }
    const SourceRange range = check.ast()[stmt.expression[0]].range;
    if (result == types::kVoid) {
        const Value value = expression(check, stmt.expression[0]);
        if (!check.is_error(value)) {
            check.report(diag::ReturnWithValue, range)
                .arg(check.here.function != nullptr ? check.here.function->name : "")
                .fix("`return;` alone leaves it");
        }
        return;
    }
    Value value =
        convert(check, expression(check, stmt.expression[0], result), result, range, "the result");
    if (check.is_error(value)) return;
    const std::uint16_t slots = check.type_info(result).slots;
    // A local array leaves with the function: no copy. One that others see is copied.
    Reg reg = 0;
    const bool copies = value.is_variable && check.types.holds_array(result) &&
                        !is_own_local(check, stmt.expression[0]);
    if (value.is_constant() || copies) {
        reg = check.emit.take(slots);
        copy_value(check, value, reg);
    } else {
        reg = value.reg;
    }
    leave_function(check, stmt.range);
    check.emit.emit(OpCode::Return, reg, 0, slots);
}

bool is_own_local(const Check& check, ExprId id) {
    if (check.ast()[id].kind != ExprKind::Name) return false;
    const Found found = find(check, check.text(check.ast()[id].text));
    return found.symbol >= 0 && check.scopes[found.symbol].storage == Symbol::Storage::Local;
}

void check_statement(Check& check, const Stmt& stmt, bool is_require) {
    Label good;
    jump_if(check, stmt.expression[0], true, good);
    Reg reg = 0;
    const bool has_text = stmt.expression[1].is_valid();
    if (has_text) {
        reg = check.emit.take(1);
        Value value = expression(check, stmt.expression[1], types::kString);
        value = text_of(check, value, check.ast()[stmt.expression[1]].range);
        if (!check.is_error(value)) copy_value(check, value, reg);
    }
    check.emit.set_location(stmt.range);
    check.emit.emit_pair(
        is_require ? OpCode::RequireFailed : OpCode::AssertFailed, reg, has_text ? 0 : 1, 0,
        text_constant(check, check.sources.text(check.ast()[stmt.expression[0]].range)));
    check.emit.bind(good);
    // BehindWords `require(given b)`, b is given.
    assume_given(check, stmt.expression[0], true);
}

void text_statement(Check& check, const Stmt& stmt, OpCode op, unsigned kind_of_text) {
    const SourceRange range = check.ast()[stmt.expression[0]].range;
    Value value = text_of(
        check,
        require_given(check, expression(check, stmt.expression[0], types::kString), range, {}),
        range);
    if (check.is_error(value)) return;
    const Reg reg = in_register(check, value);
    check.emit.set_location(stmt.range);
    if (op == OpCode::EmitText && is_in_test(check)) report_test_block(check, stmt.range);
    if (op == OpCode::EmitText) {
        check.emit.emit_pair(op, reg, kind_of_text, static_cast<unsigned>(check.here.loop_depth), 0,
                             statement_id(check, stmt.range));
    } else {
        check.emit.emit(op, reg);
    }
}

}  // namespace

}  // namespace kadr::sema
