// statements.cpp — statements: variables, branches, contracts, messages.
#include <algorithm>

#include "base/diagnostics/sema.h"
#include "sema/checker.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::StmtId;
using syntax::StmtKind;

std::uint32_t Checker::statement_id(const SourceRange& range) {
    const auto id = static_cast<std::uint32_t>(code_->statements.size());
    code_->statements.push_back(range);
    return id;
}

Checker::Completion Checker::block(syntax::List list, const SourceRange& range) {
    const OuterScope outer = enter_scope(range);
    const Reg mark = emit_.mark();
    bool reachable = true;
    bool said = false;
    for (const StmtId id : ast().stmts(list)) {
        if (!reachable && !said && ast()[id].kind != StmtKind::Empty) {
            report(diag::Unreachable, ast()[id].range);
            said = true;
        }
        if (native_pending_ && !is_check(id)) emit_native_cycle();
        const Completion completion = statement(id);
        reachable = reachable && completion == Completion::Normal;
        // `error(…); return 0;` is written so that the reader sees the end.
        if (ast()[id].kind == StmtKind::ErrorStmt) said = true;
    }
    leave_scope(outer);
    emit_.release_to(mark);
    return completion(reachable);
}

Checker::Completion Checker::statement(StmtId id) {
    if (!id.is_valid()) return Completion::Normal;
    look_at_clock();
    if (is_late_) return Completion::Normal;
    const Stmt& stmt = ast()[id];
    const SourceRange before = emit_.location();
    emit_.set_location(stmt.range);
    const Reg mark = emit_.mark();
    const StmtId outer = std::exchange(block_, id);
    Completion completion = Completion::Normal;
    bool keeps_registers = false;
    warn_of_empty_body(stmt);
    switch (stmt.kind) {
        case StmtKind::Invalid:
        case StmtKind::Empty: break;
        case StmtKind::Block: completion = block(stmt.statements, stmt.range); break;
        case StmtKind::Expression: expression_statement(stmt); break;
        case StmtKind::Declaration:
            variable(stmt.declaration);
            keeps_registers = true;
            break;
        case StmtKind::If: completion = if_statement(stmt); break;
        case StmtKind::While: completion = while_statement(stmt); break;
        case StmtKind::DoWhile: completion = do_statement(stmt); break;
        case StmtKind::For: completion = for_statement(stmt); break;
        case StmtKind::ForEach: completion = for_each(stmt); break;
        case StmtKind::Switch: completion = switch_statement(stmt); break;
        case StmtKind::Case: break;
        case StmtKind::Break:
        case StmtKind::Continue:
            jump_out(stmt.kind == StmtKind::Break, stmt.range);
            completion = Completion::Abrupt;
            break;
        case StmtKind::Return:
            return_statement(stmt);
            completion = Completion::Abrupt;
            break;
        case StmtKind::Words: words_statement(stmt); break;
        case StmtKind::With: completion = with_statement(stmt); break;
        case StmtKind::Note: text_statement(stmt, OpCode::EmitText, 0); break;
        case StmtKind::Raw: text_statement(stmt, OpCode::EmitText, 1); break;
        case StmtKind::Units: {
            const std::string_view name = text(stmt.text);
            const Units asked = name == "mm" ? Units::Metric : Units::Inch;
            // The first statement of a program was taken into account before; elsewhere the units
            // of a file do not change.
            if (asked != units_) report(diag::UnitsPlace, stmt.range);
            break;
        }
        case StmtKind::Require: check_statement(stmt, true); break;
        case StmtKind::Assert: check_statement(stmt, false); break;
        case StmtKind::ErrorStmt:
            text_statement(stmt, OpCode::UserError, 0);
            completion = Completion::Abrupt;
            break;
        case StmtKind::WarnStmt: text_statement(stmt, OpCode::UserWarning, 0); break;
        case StmtKind::Close:
            if (contour_depth_ == 0) report(diag::CloseOutside, stmt.range);
            emit_.emit(OpCode::CloseContour);
            break;
        case StmtKind::Assume: assume_statement(stmt); break;
        case StmtKind::Expect: expect_statement(stmt); break;
    }
    if (!keeps_registers) emit_.release_to(mark);
    block_ = outer;
    emit_.set_location(before);
    return completion;
}

void Checker::variable(syntax::DeclId id) {
    const Decl& decl = ast()[id];
    if (decl.kind == syntax::DeclKind::Contour) {
        contour_variable(id);
        return;
    }
    Symbol symbol;
    symbol.name = text(decl.name);
    symbol.range = decl.name_range;
    symbol.decl = id;
    symbol.is_const = decl.is_const;
    symbol.type = decl.type.is_valid() ? resolve_type(decl.type) : types::kError;
    if (symbol.type == types::kVoid) {
        report(diag::VoidValue, decl.range);
        symbol.type = types::kError;
    }
    if (decl.type.is_valid() && ast()[decl.type].is_reference)
        report(diag::ReferencePlace, ast()[decl.type].range);
    const std::string_view outer = std::exchange(declared_, text(decl.name));
    if (decl.is_const && !decl.value.is_valid())
        report(diag::ConstWithoutValue, decl.name_range).arg(symbol.name);
    if (decl.value.is_valid()) {
        symbol.is_row = is_as_given(decl.value);
        const SourceRange range = ast()[decl.value].range;
        if (decl.type.is_valid() && kind(symbol.type) != TypeKind::Error) {
            const std::uint16_t slots = type_info(symbol.type).slots;
            const Reg mark = emit_.mark();
            symbol.reg = emit_.take(slots);
            const bool is_single = slots == 1 && kind(symbol.type) != TypeKind::Array;
            const Value value =
                expression(decl.value, symbol.type, is_single ? symbol.reg : kNoReg);
            if (is_plain_number(value)) symbol.origin = value.origin;
            const bool stays_open = type_info(value.type).is_optional;
            const Value converted = convert(value, symbol.type, range, symbol.name);
            if (decl.is_const && converted.is_constant() && !is_error(converted)) {
                symbol.storage = Symbol::Storage::Constant;
                symbol.constant = converted;
                emit_.release_to(mark);
            } else {
                if (!is_error(converted)) copy_value(converted, symbol.reg);
                emit_.release_to(static_cast<Reg>(symbol.reg + slots));
            }
            symbol.givenness = stays_open ? Givenness::Perhaps : Givenness::Given;
        } else {
            const Reg mark = emit_.mark();
            const Value value = expression(decl.value, symbol.type);
            if (kind(value.type) == TypeKind::Void) {
                report(diag::VoidValue, range);
                symbol.type = types::kError;
            } else if (!decl.type.is_valid()) {
                symbol.type = value.type;
            }
            if (is_plain_number(value)) symbol.origin = value.origin;
            if (decl.is_const && value.is_constant()) {
                symbol.storage = Symbol::Storage::Constant;
                symbol.constant = value;
                emit_.release_to(mark);
            } else {
                const std::uint16_t slots = type_info(symbol.type).slots;
                const Reg above = emit_.take(slots);
                if (!is_error(value) && kind(value.type) != TypeKind::Void)
                    copy_value(value, above);
                if (above != mark && slots > 0) {
                    emit_.emit(slots == 1 ? OpCode::Move : OpCode::MoveN, mark, above,
                               slots == 1 ? 0u : slots);
                }
                emit_.release_to(mark);
                symbol.reg = emit_.take(slots);
                symbol.givenness =
                    type_info(symbol.type).is_optional ? Givenness::Perhaps : Givenness::Given;
            }
        }
    } else {
        symbol.reg = emit_.take(type_info(symbol.type).slots);
        if (is_optional_type(decl)) emit_unset(symbol.type, symbol.reg);
        else emit_initial(symbol.type, symbol.reg);
        const TypeKind k = kind(symbol.type);
        symbol.may_be_unset =
            k != TypeKind::Array && k != TypeKind::Error && !type_info(symbol.type).is_optional;
        symbol.givenness = k == TypeKind::Array || k == TypeKind::Error ? Givenness::Given
                           : k == TypeKind::Struct                      ? Givenness::Perhaps
                                                                        : Givenness::NotGiven;
    }
    declared_ = outer;
    add_symbol(symbol);
}

void Checker::expression_statement(const Stmt& stmt) {
    const Expr& expr = ast()[stmt.expression[0]];
    const bool is_shown = module_ == 0 && stmt.range.begin >= options_.shown_from;
    statement_ = statement_id(stmt.range);
    switch (expr.kind) {
        case ExprKind::Assign: assign(stmt.expression[0], false); return;
        case ExprKind::Unary:
            if (expr.op >= syntax::Operator::PreIncrement &&
                expr.op <= syntax::Operator::PostDecrement) {
                step(stmt.expression[0], false);
                return;
            }
            break;
        case ExprKind::Call:
            if (is_shown) show(stmt.expression[0]);
            else expression(stmt.expression[0]);
            return;
        case ExprKind::Invalid: return;
        default: break;
    }
    if (is_shown) return show(stmt.expression[0]);
    const std::size_t errors = sink_.errors;
    expression(stmt.expression[0]);
    if (errors == sink_.errors) report(diag::UselessExpression, expr.range);
}

Checker::Completion Checker::if_statement(const Stmt& stmt) {
    const ExprId condition = stmt.expression[0];
    Label otherwise;
    const std::uint32_t start = emit_.here();
    const std::vector<Givenness> before = remember_givenness();
    jump_if(condition, false, otherwise);
    // What a constant condition excludes is still checked, but does not count for the flow.
    const bool never = otherwise.pending.size() == 1 && emit_.here() == start + 1 &&
                       code_->instructions[start].op == OpCode::Jump;
    const bool always = otherwise.pending.empty() && emit_.here() == start;
    assume_given(condition, true);
    const bool then_ends = statement(stmt.statement[0]) == Completion::Normal;
    const std::vector<Givenness> after_then = remember_givenness();
    set_givenness(before);
    assume_given(condition, false);
    if (!stmt.statement[1].is_valid()) {
        emit_.bind(otherwise);
        if (then_ends) merge_givenness(after_then);
        return completion(!always || then_ends || ast()[condition].kind != ExprKind::Bool);
    }
    Label done;
    if (then_ends) emit_.jump(OpCode::Jump, done);
    emit_.bind(otherwise);
    const bool else_ends = statement(stmt.statement[1]) == Completion::Normal;
    emit_.bind(done);
    if (then_ends && else_ends) merge_givenness(after_then);
    else if (then_ends) set_givenness(after_then);
    if (never) return completion(else_ends);
    return completion(then_ends || else_ends);
}

Checker::Completion Checker::switch_statement(const Stmt& stmt) {
    const SourceRange range = ast()[stmt.expression[0]].range;
    const Value chosen = require_given(expression(stmt.expression[0]), range, {});
    const TypeKind k = kind(chosen.type);
    const bool fits =
        k == TypeKind::Int || k == TypeKind::Enum || k == TypeKind::String || k == TypeKind::Bool;
    if (!fits && k != TypeKind::Error) report(diag::SwitchType, range).arg(type_name(chosen.type));
    Value value = chosen;
    if (fits) {
        const Reg kept = emit_.take(1);
        copy_value(chosen, kept);
        value = in_registers(chosen.type, kept);
    }
    const auto cases = ast().stmts(stmt.statements);
    std::vector<Label> labels(cases.size());
    Label done;
    std::int64_t default_case = -1;
    struct Choice {
        std::int64_t first, last;
        SourceRange range;
    };
    std::vector<Choice> choices;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Stmt& entry = ast()[cases[i]];
        const auto values = ast().exprs(entry.expressions);
        if (values.empty()) {
            if (default_case >= 0) {
                report(diag::CaseTwice, entry.range)
                    .arg("default")
                    .note(ast()[cases[static_cast<std::size_t>(default_case)]].range,
                          "it stands here");
            }
            default_case = static_cast<std::int64_t>(i);
        }
        for (const ExprId id : values) {
            const SourceRange at = ast()[id].range;
            const bool is_range = ast()[id].kind == ExprKind::Range;
            const ExprId first_id = is_range ? ast()[id].child[0] : id;
            const Value first =
                convert(expression(first_id, value.type), value.type, at, "the case");
            const Value last = is_range ? convert(expression(ast()[id].child[1], value.type),
                                                  value.type, at, "the case")
                                        : first;
            if (!fits || is_error(first) || is_error(last)) continue;
            if (!first.is_constant() || !last.is_constant() || (is_range && k != TypeKind::Int)) {
                report(diag::NotConstant, at).arg("a case");
                continue;
            }
            const auto same = std::ranges::find_if(choices, [&](const Choice& other) {
                return other.first <= last.constant.integer && other.last >= first.constant.integer;
            });
            if (same != choices.end()) {
                report(diag::CaseTwice, at)
                    .arg(sources_.text(at))
                    .note(same->range, "it stands here");
                continue;
            }
            choices.push_back({first.constant.integer, last.constant.integer, at});
            const Reg mark = emit_.mark();
            if (k == TypeKind::String) {
                const Reg order = emit_.take(1);
                emit_.emit(OpCode::CompareText, order, value.reg, in_register(first));
                emit_.jump(OpCode::JumpEqIK, labels[i], order);
            } else if (is_range) {
                Label next;
                const Reg low = in_register(first);
                const Reg high = in_register(last);
                emit_.jump(OpCode::JumpLtI, next, value.reg, low);
                emit_.jump(OpCode::JumpLeI, labels[i], value.reg, high);
                emit_.bind(next);
            } else if (first.constant.integer >= -32768 && first.constant.integer <= 32767) {
                emit_.jump(
                    OpCode::JumpEqIK, labels[i], value.reg, 0,
                    static_cast<std::uint16_t>(static_cast<std::int16_t>(first.constant.integer)));
            } else {
                emit_.jump(OpCode::JumpEqI, labels[i], value.reg, in_register(first));
            }
            emit_.release_to(mark);
        }
    }
    if (default_case >= 0) emit_.jump(OpCode::Jump, labels[static_cast<std::size_t>(default_case)]);
    else emit_.jump(OpCode::Jump, done);

    loops_.push_back({&done, nullptr, with_depth_});
    const std::vector<Givenness> before = remember_givenness();
    std::vector<Givenness> merged = before;
    bool ends = true;
    bool all_leave = default_case >= 0;
    const std::size_t breaks = done.pending.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        emit_.bind(labels[i]);
        if (ends && i > 0) merge_givenness(before);
        else set_givenness(before);
        ends = block(ast()[cases[i]].statements, ast()[cases[i]].range) == Completion::Normal;
        for (std::size_t s = 0; s < merged.size() && s < varying_.size(); ++s) {
            if (merged[s] != symbols_[varying_[s]].givenness) merged[s] = Givenness::Perhaps;
        }
    }
    loops_.pop_back();
    const bool breaks_out = done.pending.size() > breaks;
    set_givenness(merged);
    emit_.bind(done);
    if (cases.empty()) return Completion::Normal;
    return completion(!(all_leave && !ends && !breaks_out));
}

void Checker::leave_function(const SourceRange& range) {
    const SourceRange before = emit_.location();
    emit_.set_location(range);
    if (with_depth_ > 0) {
        emit_.emit_pair(OpCode::LeaveWith, 0, 0, static_cast<unsigned>(with_depth_), 0,
                        statement_id(range));
    }
    if (has_preserves_) emit_.emit(OpCode::CheckPreserves);
    emit_.set_location(before);
}

void Checker::return_statement(const Stmt& stmt) {
    if (contour_depth_ > 0) {
        report(diag::ReturnInContour, stmt.range);
        return;
    }
    const Type result = function_ != nullptr ? function_->result : types::kVoid;
    if (!stmt.expression[0].is_valid()) {
        if (result != types::kVoid && kind(result) != TypeKind::Error) {
            report(diag::ReturnWithoutValue, stmt.range)
                .arg(function_->name)
                .arg(type_name(result));
        }
        leave_function(stmt.range);
        emit_.emit(OpCode::Return, 0, 0, 0);
        return;
    }
    const SourceRange range = ast()[stmt.expression[0]].range;
    if (result == types::kVoid) {
        const Value value = expression(stmt.expression[0]);
        if (!is_error(value)) {
            report(diag::ReturnWithValue, range)
                .arg(function_ != nullptr ? function_->name : "")
                .fix("`return;` alone leaves it");
        }
        return;
    }
    Value value = convert(expression(stmt.expression[0], result), result, range, "the result");
    if (is_error(value)) return;
    const std::uint16_t slots = type_info(result).slots;
    // A local array leaves with the function: no copy. One that others see is copied.
    Reg reg = 0;
    const bool copies =
        value.is_variable && types_.holds_array(result) && !is_own_local(stmt.expression[0]);
    if (value.is_constant() || copies) {
        reg = emit_.take(slots);
        copy_value(value, reg);
    } else {
        reg = value.reg;
    }
    leave_function(stmt.range);
    emit_.emit(OpCode::Return, reg, 0, slots);
}

bool Checker::is_own_local(ExprId id) const {
    if (ast()[id].kind != ExprKind::Name) return false;
    const Found found = find(text(ast()[id].text));
    return found.symbol >= 0 &&
           symbols_[static_cast<std::size_t>(found.symbol)].storage == Symbol::Storage::Local;
}

void Checker::check_statement(const Stmt& stmt, bool is_require) {
    Label good;
    jump_if(stmt.expression[0], true, good);
    Reg reg = 0;
    const bool has_text = stmt.expression[1].is_valid();
    if (has_text) {
        reg = emit_.take(1);
        Value value = expression(stmt.expression[1], types::kString);
        value = text_of(value, ast()[stmt.expression[1]].range);
        if (!is_error(value)) copy_value(value, reg);
    }
    emit_.set_location(stmt.range);
    emit_.emit_pair(is_require ? OpCode::RequireFailed : OpCode::AssertFailed, reg,
                    has_text ? 0 : 1, 0,
                    text_constant(sources_.text(ast()[stmt.expression[0]].range)));
    emit_.bind(good);
    // Behind `require(given b)`, b is given.
    assume_given(stmt.expression[0], true);
}

void Checker::text_statement(const Stmt& stmt, OpCode op, unsigned kind_of_text) {
    const SourceRange range = ast()[stmt.expression[0]].range;
    Value value =
        text_of(require_given(expression(stmt.expression[0], types::kString), range, {}), range);
    if (is_error(value)) return;
    const Reg reg = in_register(value);
    emit_.set_location(stmt.range);
    if (op == OpCode::EmitText && is_in_test()) report_test_block(stmt.range);
    if (op == OpCode::EmitText) {
        emit_.emit_pair(op, reg, kind_of_text, static_cast<unsigned>(loop_depth_), 0,
                        statement_id(stmt.range));
    } else {
        emit_.emit(op, reg);
    }
}

}  // namespace kadr::sema
