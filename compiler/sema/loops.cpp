// loops.cpp — loops: the condition stands behind the body, so that a pass costs one jump.
#include "sema/loops.h"

#include <charconv>
#include <optional>

#include "base/diagnostics/sema.h"
#include "sema/checking.h"
#include "sema/conditions.h"
#include "sema/convert.h"
#include "sema/expressions.h"
#include "sema/globals.h"
#include "sema/lvalues.h"
#include "sema/naming.h"
#include "sema/optionals.h"
#include "sema/scope.h"
#include "sema/statements.h"
#include "sema/texts.h"
#include "sema/type_declarations.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;
using syntax::Stmt;
using syntax::StmtKind;

namespace {

void jump_if_quietly(Check& check, syntax::ExprId condition, Label& top, int depth);
void note_pass(Check& check, const Stmt& stmt);
void check_named_global(Check& check, syntax::ExprId id);
bool is_plain_constant(const Check& check, syntax::ExprId id);

}  // namespace

namespace {

/// Does a `break` leave this statement's loop? Not looking into loops and switches inside.
bool breaks(const syntax::Ast& ast, syntax::StmtId id) {
    if (!id.is_valid()) return false;
    const Stmt& stmt = ast[id];
    switch (stmt.kind) {
        case StmtKind::Break: return true;
        case StmtKind::Block:
            for (const syntax::StmtId inner : ast.stmts(stmt.statements)) {
                if (breaks(ast, inner)) return true;
            }
            return false;
        case StmtKind::If: return breaks(ast, stmt.statement[0]) || breaks(ast, stmt.statement[1]);
        case StmtKind::With: return breaks(ast, stmt.statement[0]);
        default: return false;
    }
}

bool is_always(const syntax::Ast& ast, ExprId id) {
    return !id.is_valid() || (ast[id].kind == ExprKind::Bool && ast[id].integer != 0);
}

}  // namespace

void jump_out(Check& check, bool is_break, const SourceRange& range) {
    for (std::size_t i = check.here.loops.size(); i-- > 0;) {
        LoopScope& loop = check.here.loops[i];
        if (!is_break && loop.on_continue == nullptr) continue;  // a switch
        if (check.here.with_depth > loop.with_depth) {
            check.emit.emit_pair(OpCode::LeaveWith, 0, 0,
                                 static_cast<unsigned>(check.here.with_depth - loop.with_depth), 0,
                                 statement_id(check, range));
        }
        check.emit.jump(OpCode::Jump, is_break ? *loop.on_break : *loop.on_continue);
        return;
    }
    check.report(diag::OutsideLoop, range).arg(is_break ? "break" : "continue");
}

Completion while_statement(Check& check, const Stmt& stmt) {
    Label top;
    Label again;
    Label done;
    const int depth = check.here.loop_depth++;
    check.scopes.forget_flow();
    check.emit.emit_pair(OpCode::LoopStart, 0, 0, 0, 0, depth);
    check.emit.jump(OpCode::Jump, again);
    check.emit.bind(top);
    check.here.loops.push_back({&done, &again, check.here.with_depth});
    const FlowState before = check.scopes.flow();
    assume_given(check, stmt.expression[0], true);
    statement(check, stmt.statement[0]);
    check.scopes.join_flow(before);
    check.emit.bind(again);
    note_statement(check, head_range(check, stmt));
    jump_if(check, stmt.expression[0], true, top, depth);
    check.here.loops.pop_back();
    check.emit.bind(done);
    --check.here.loop_depth;
    return completion(
        !(is_always(check.ast(), stmt.expression[0]) && !breaks(check.ast(), stmt.statement[0])));
}

Completion do_statement(Check& check, const Stmt& stmt) {
    Label top;
    Label again;
    Label done;
    const int depth = check.here.loop_depth++;
    check.scopes.forget_flow();
    check.emit.emit_pair(OpCode::LoopStart, 0, 0, 0, 0, depth);
    check.emit.bind(top);
    check.here.loops.push_back({&done, &again, check.here.with_depth});
    statement(check, stmt.statement[0]);
    check.emit.bind(again);
    note_statement(check, check.ast()[stmt.expression[0]].range);
    jump_if(check, stmt.expression[0], true, top, depth);
    check.here.loops.pop_back();
    check.emit.bind(done);
    --check.here.loop_depth;
    return completion(
        !(is_always(check.ast(), stmt.expression[0]) && !breaks(check.ast(), stmt.statement[0])));
}

namespace {

/// `i++`, `i += 2`, `i--` on a whole local variable and a comparison with a variable or a constant:
/// one instruction a pass.
bool counting_loop(Check& check, const Stmt& stmt, Label& top, int depth) {
    const ExprId condition = stmt.expression[0];
    const ExprId step_id = stmt.expression[1];
    if (!condition.is_valid() || !step_id.is_valid()) return false;
    const Expr& step_expr = check.ast()[step_id];
    const Expr& compare = check.ast()[condition];
    std::int64_t step = 0;
    if (step_expr.kind == ExprKind::Unary) {
        if (step_expr.op == Operator::PreIncrement || step_expr.op == Operator::PostIncrement)
            step = 1;
        if (step_expr.op == Operator::PreDecrement || step_expr.op == Operator::PostDecrement)
            step = -1;
    } else if (step_expr.kind == ExprKind::Assign &&
               check.ast()[step_expr.child[1]].kind == ExprKind::Int) {
        const std::int64_t value = check.ast()[step_expr.child[1]].integer;
        if (value > 30000) return false;
        if (step_expr.op == Operator::AddAssign) step = value;
        if (step_expr.op == Operator::SubtractAssign) step = -value;
    }
    if (step == 0 || check.ast()[step_expr.child[0]].kind != ExprKind::Name) return false;
    const bool ordered = compare.kind == ExprKind::Binary && compare.op >= Operator::Less &&
                         compare.op <= Operator::GreaterEqual;
    if (!ordered || check.ast()[compare.child[0]].kind != ExprKind::Name) return false;
    const auto local_int = [&](ExprId id) -> const Symbol* {
        if (check.ast()[id].kind != ExprKind::Name) return nullptr;
        const Found found = look_up(check, id);
        if (found.symbol < 0) return nullptr;
        const Symbol& symbol = check.scopes[found.symbol];
        return symbol.type == types::kInt && !symbol.may_be_unset ? &symbol : nullptr;
    };
    const Symbol* counter = local_int(step_expr.child[0]);
    if (counter == nullptr || counter->storage != Symbol::Storage::Local || counter->is_const ||
        local_int(compare.child[0]) != counter) {
        return false;
    }
    Reg limit = 0;
    const Symbol* limit_symbol = local_int(compare.child[1]);
    if (limit_symbol != nullptr && limit_symbol->storage == Symbol::Storage::Local) {
        check.scopes[look_up(check, compare.child[1]).symbol].is_read = true;
        limit = limit_symbol->reg;
    } else if (check.body.for_limit != kNoReg) {
        limit = check.body.for_limit;
    } else {
        return false;
    }
    const OpCode op = compare.op == Operator::Less        ? OpCode::ForLtI
                      : compare.op == Operator::LessEqual ? OpCode::ForLeI
                      : compare.op == Operator::Greater   ? OpCode::ForGtI
                                                          : OpCode::ForGeI;
    check.emit.set_location(step_expr.range);
    check.emit.jump(op, top, counter->reg, limit,
                    static_cast<std::uint16_t>(static_cast<std::int16_t>(step)), depth);
    return true;
}

}  // namespace

Completion for_statement(Check& check, const Stmt& stmt) {
    const Scopes::Outer outer = check.scopes.enter(stmt.range);
    const Reg mark = check.emit.mark();
    if (stmt.statement[0].is_valid()) statement(check, stmt.statement[0]);
    Label top;
    Label next;
    Label done;
    const int depth = check.here.loop_depth++;
    check.scopes.forget_flow();
    // A whole constant as the limit gets a register for the time of the loop.
    const Reg outer_limit = std::exchange(check.body.for_limit, kNoReg);
    const ExprId condition = stmt.expression[0];
    if (condition.is_valid() && check.ast()[condition].kind == ExprKind::Binary) {
        const ExprId end = check.ast()[condition].child[1];
        check_named_global(check, end);
        if (is_plain_constant(check, end)) {
            const Value limit = expression(check, end);
            if (limit.is_constant() && check.kind(limit.type) == TypeKind::Int)
                check.body.for_limit = in_register(check, limit);
        }
    }
    const Reg this_limit = check.body.for_limit;
    check.emit.emit_pair(OpCode::LoopStart, 0, 0, 0, 0, depth);
    if (condition.is_valid()) jump_if(check, condition, false, done);
    check.emit.bind(top);
    check.here.loops.push_back({&done, &next, check.here.with_depth});
    const FlowState before = check.scopes.flow();
    if (condition.is_valid()) assume_given(check, condition, true);
    check.body.for_limit = kNoReg;
    statement(check, stmt.statement[1]);
    check.body.for_limit = this_limit;
    check.scopes.join_flow(before);
    check.emit.bind(next);
    note_pass(check, stmt);
    if (!counting_loop(check, stmt, top, depth)) {
        if (stmt.expression[1].is_valid()) {
            const Expr& step_expr = check.ast()[stmt.expression[1]];
            const Reg above = check.emit.mark();
            check.emit.set_location(step_expr.range);
            if (step_expr.kind == ExprKind::Assign) assign(check, stmt.expression[1], false);
            else if (step_expr.kind == ExprKind::Unary && step_expr.op >= Operator::PreIncrement &&
                     step_expr.op <= Operator::PostDecrement) {
                step(check, stmt.expression[1], false);
            } else {
                expression(check, stmt.expression[1]);
            }
            check.emit.release_to(above);
        }
        if (condition.is_valid()) jump_if_quietly(check, condition, top, depth);
        else check.emit.jump(OpCode::Loop, top, 0, 0, 0, depth);
    }
    check.here.loops.pop_back();
    check.emit.bind(done);
    check.body.for_limit = outer_limit;
    --check.here.loop_depth;
    leave_scope(check, outer);
    check.emit.release_to(mark);
    return completion(
        !(is_always(check.ast(), condition) && !breaks(check.ast(), stmt.statement[1])));
}

namespace {

/// Behind a pass of a `for`: its step and its condition.
void note_pass(Check& check, const Stmt& stmt) {
    const ExprId at = stmt.expression[1].is_valid() ? stmt.expression[1] : stmt.expression[0];
    note_statement(check, at.is_valid() ? check.ast()[at].range : head_range(check, stmt));
}

/// The condition a second time: what it had to report was reported the first time.
void jump_if_quietly(Check& check, ExprId condition, Label& top, int depth) {
    const DryRun dry_run(check);
    jump_if(check, condition, true, top, depth);
}

/// What a global is, is known when it has been checked; it may stand further down.
void check_named_global(Check& check, ExprId id) {
    if (check.ast()[id].kind != ExprKind::Name) return;
    const Found found = find(check, check.text(check.ast()[id].text));
    if (found.symbol >= 0 || found.name == nullptr) return;
    if (found.name->what == Name::What::Variable)
        check_global(check, found.name->index, check.here.is_startup);
}

bool is_plain_constant(const Check& check, ExprId id) {
    const Expr& expr = check.ast()[id];
    if (expr.kind == ExprKind::Int) return true;
    if (expr.kind != ExprKind::Name) return false;
    const Found found = find(check, check.text(expr.text));
    if (found.symbol >= 0) {
        return check.scopes[found.symbol].storage == Symbol::Storage::Constant;
    }
    if (found.name == nullptr || found.name->what != Name::What::Variable) return false;
    return check.names.global(found.name->index).symbol.storage == Symbol::Storage::Constant;
}

/// A whole number that stands in the source with its sign; of `1..n` nobody knows what n will be.
std::optional<std::int64_t> written_number(std::string_view text) {
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_whole = error == std::errc() && end == text.data() + text.size();
    return is_whole ? std::optional(number) : std::nullopt;
}

/// `3..1` runs not at all: a range does not run backwards.
void warn_of_empty_range(Check& check, const Expr& range) {
    const auto first = written_number(check.sources.text(check.ast()[range.child[0]].range));
    const auto last = written_number(check.sources.text(check.ast()[range.child[1]].range));
    if (!first || !last || *first <= *last) return;
    check.report(diag::EmptyRange, range.range)
        .arg(check.sources.text(range.range))
        .fix("downwards counts `for (int i = " + std::to_string(*first) +
             "; i >= " + std::to_string(*last) + "; i--)`");
}

void for_range(Check& check, const Stmt& stmt) {
    const Decl& decl = check.ast()[stmt.declaration];
    // `for (int i : 1..6)`: both ends included.
    Symbol symbol;
    symbol.name = check.text(decl.name);
    symbol.range = decl.name_range;
    symbol.decl = stmt.declaration;
    symbol.is_read = true;  // to count passes is use enough
    symbol.type = decl.type.is_valid() ? resolve_type(check, decl.type) : types::kInt;
    symbol.is_const = decl.is_const;
    if (symbol.type != types::kInt && check.kind(symbol.type) != TypeKind::Error) {
        check.report(diag::RangeType, decl.range).arg(check.type_name(symbol.type));
        symbol.type = types::kInt;
    }
    const Expr& range = check.ast()[stmt.expression[0]];
    const Reg hidden = check.emit.take(2);  // the counter and the end, out of the body's reach
    expression_in(check, range.child[0], types::kInt, hidden, "the start of the range");
    expression_in(check, range.child[1], types::kInt, static_cast<Reg>(hidden + 1),
                  "the end of the range");
    warn_of_empty_range(check, range);
    symbol.reg = check.emit.take(1);
    const Reg counter = symbol.reg;
    add_symbol(check, symbol);
    Label top;
    Label next;
    Label done;
    const int depth = check.here.loop_depth++;
    check.scopes.forget_flow();
    check.emit.emit_pair(OpCode::LoopStart, 0, 0, 0, 0, depth);
    check.emit.jump(OpCode::JumpLtI, done, static_cast<Reg>(hidden + 1), hidden);
    check.emit.bind(top);
    check.emit.emit(OpCode::Move, counter, hidden);
    check.here.loops.push_back({&done, &next, check.here.with_depth});
    const FlowState before = check.scopes.flow();
    statement(check, stmt.statement[0]);
    check.scopes.join_flow(before);
    check.here.loops.pop_back();
    check.emit.bind(next);
    note_statement(check, decl.range);
    check.emit.jump(OpCode::ForLeI, top, hidden, static_cast<Reg>(hidden + 1), 1, depth);
    check.emit.bind(done);
    --check.here.loop_depth;
}

/// The characters of a string as an array for `for`.
Value characters(Check& check, const Value& string, bool is_reference, const Decl& decl,
                 const SourceRange& range) {
    if (is_reference) {
        check.report(diag::NotAPlace, decl.range);
        return error_value();
    }
    const Reg from = in_register(check, string);
    const Reg reg = check.emit.take(1);
    check.emit.set_location(range);
    check.emit.emit_pair(OpCode::SplitText, reg, from, 0, layout_constant(check, types::kString));
    return in_registers(check.types.array(types::kString, -1), reg);
}

}  // namespace

Completion for_each(Check& check, const Stmt& stmt) {
    const Scopes::Outer outer = check.scopes.enter(stmt.range);
    const Reg mark = check.emit.mark();
    const Decl& decl = check.ast()[stmt.declaration];
    const auto leave = [&] {
        leave_scope(check, outer);
        check.emit.release_to(mark);
    };
    if (check.ast()[stmt.expression[0]].kind == ExprKind::Range) {
        for_range(check, stmt);
        leave();
        return Completion::Normal;
    }
    const SourceRange range = check.ast()[stmt.expression[0]].range;
    const bool is_reference = decl.type.is_valid() && check.ast()[decl.type].is_reference;
    const Type written = decl.type.is_valid() ? resolve_type(check, decl.type) : types::kError;
    const Type wanted =
        check.kind(written) != TypeKind::Error ? check.types.array(written, -1) : types::kError;
    const bool is_braces = check.ast()[stmt.expression[0]].kind == ExprKind::Braces;
    const std::optional<Lvalue> source =
        is_braces ? std::nullopt : owner_lvalue(check, stmt.expression[0]);
    Value list = is_braces ? expression(check, stmt.expression[0], wanted)
                 : source  ? load(check, *source, range, true, kNoReg)
                           : error_value();
    list = require_given(check, list, range, {});
    if (check.kind(list.type) == TypeKind::String)
        list = characters(check, list, is_reference, decl, range);
    Symbol symbol;
    symbol.name = check.text(decl.name);
    symbol.range = decl.name_range;
    symbol.decl = stmt.declaration;
    symbol.is_read = true;  // to count passes is use enough
    symbol.type = written;
    symbol.is_row = true;
    symbol.is_const = decl.is_const;
    if (check.kind(list.type) != TypeKind::Array) {
        if (!check.is_error(list))
            check.report(diag::NotAnArray, range).arg(check.type_name(list.type));
        symbol.reg = check.emit.take(std::max<unsigned>(1, check.type_info(written).slots));
        add_symbol(check, symbol);
        check.here.loops.push_back({nullptr, nullptr, check.here.with_depth});
        Label nowhere;
        check.here.loops.back() = {&nowhere, &nowhere, check.here.with_depth};
        statement(check, stmt.statement[0]);
        check.here.loops.pop_back();
        check.emit.bind(nowhere);
        leave();
        return Completion::Normal;
    }
    const Type element = check.type_info(list.type).element;
    if (!decl.type.is_valid()) symbol.type = element;
    const std::uint16_t slots = check.type_info(element).slots;
    const Reg handle = check.emit.take(1);
    // Without `&` the elements are those that the list has now, whatever the body does to it.
    const bool may_change = !is_reference && source && !source->is_temporary && !source->is_const;
    check.emit.emit(may_change && !check.is_contour(list.type) ? OpCode::CopyArray : OpCode::Move,
                    handle, list.reg);
    const Reg hidden = check.emit.take(2);  // index, count
    const std::uint16_t symbol_slots =
        is_reference ? 1 : std::max<std::uint16_t>(1, check.type_info(symbol.type).slots);
    symbol.reg = check.emit.take(symbol_slots);
    if (is_reference) {
        symbol.storage = Symbol::Storage::Reference;
        if (symbol.type != element && check.kind(symbol.type) != TypeKind::Error) {
            check_places(check, element, symbol.type, decl.range, symbol.name);
        }
        if (source && !source->is_temporary && source->is_const && !decl.is_const)
            symbol.is_const = true;
    }
    const Symbol copy = symbol;
    add_symbol(check, symbol);
    Label top;
    Label next;
    Label done;
    const int depth = check.here.loop_depth++;
    check.scopes.forget_flow();
    check.emit.emit_integer(OpCode::LoadI, hidden, 0, 0);
    check.emit.emit_pair(OpCode::LoopStart, 0, 0, 0, 0, depth);
    check.emit.emit(OpCode::CountArray, static_cast<Reg>(hidden + 1), handle);
    check.emit.jump(OpCode::JumpLeI, done, static_cast<Reg>(hidden + 1), hidden);
    check.emit.bind(top);
    Lvalue at;
    at.storage = Lvalue::Storage::Element;
    at.type = element;
    at.reg = handle;
    at.index = hidden;
    at.stride = slots;
    at.may_be_unset = check.type_info(list.type).count >= 0;
    at.root = "the element";
    const Reg above = check.emit.mark();
    if (is_reference) {
        check.emit.emit(OpCode::Move, copy.reg, reference_to(check, at));
    } else {
        const Value item =
            convert(check, load(check, at, range, true, copy.type == element ? copy.reg : kNoReg),
                    copy.type, decl.range, copy.name);
        if (!check.is_error(item)) copy_value(check, item, copy.reg);
    }
    check.emit.release_to(above);
    check.here.loops.push_back({&done, &next, check.here.with_depth});
    const FlowState before = check.scopes.flow();
    statement(check, stmt.statement[0]);
    check.scopes.join_flow(before);
    check.here.loops.pop_back();
    check.emit.bind(next);
    note_statement(check, decl.range);
    // The list may have grown or shrunk meanwhile.
    check.emit.emit(OpCode::CountArray, static_cast<Reg>(hidden + 1), handle);
    check.emit.jump(OpCode::ForLtI, top, hidden, static_cast<Reg>(hidden + 1), 1, depth);
    check.emit.bind(done);
    --check.here.loop_depth;
    leave();
    return Completion::Normal;
}

}  // namespace kadr::sema
