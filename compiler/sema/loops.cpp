// loops.cpp — loops: the condition stands behind the body, so that a pass costs one jump.
#include <charconv>
#include <optional>

#include "base/diagnostics/sema.h"
#include "sema/checker.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Operator;
using syntax::Stmt;
using syntax::StmtKind;

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

void Checker::jump_out(bool is_break, const SourceRange& range) {
    for (std::size_t i = loops_.size(); i-- > 0;) {
        LoopScope& loop = loops_[i];
        if (!is_break && loop.on_continue == nullptr) continue;  // a switch
        if (with_depth_ > loop.with_depth) {
            emit_.emit_pair(OpCode::LeaveWith, 0, 0,
                            static_cast<unsigned>(with_depth_ - loop.with_depth), 0,
                            statement_id(range));
        }
        emit_.jump(OpCode::Jump, is_break ? *loop.on_break : *loop.on_continue);
        return;
    }
    report(diag::OutsideLoop, range).arg(is_break ? "break" : "continue");
}

Checker::Completion Checker::while_statement(const Stmt& stmt) {
    Label top;
    Label check;
    Label done;
    const int depth = loop_depth_++;
    forget_givenness();
    emit_.emit_pair(OpCode::LoopStart, 0, 0, 0, 0, depth);
    emit_.jump(OpCode::Jump, check);
    emit_.bind(top);
    loops_.push_back({&done, &check, with_depth_});
    const std::vector<Givenness> before = remember_givenness();
    assume_given(stmt.expression[0], true);
    statement(stmt.statement[0]);
    merge_givenness(before);
    emit_.bind(check);
    jump_if(stmt.expression[0], true, top, depth);
    loops_.pop_back();
    emit_.bind(done);
    --loop_depth_;
    return completion(!(is_always(ast(), stmt.expression[0]) && !breaks(ast(), stmt.statement[0])));
}

Checker::Completion Checker::do_statement(const Stmt& stmt) {
    Label top;
    Label check;
    Label done;
    const int depth = loop_depth_++;
    forget_givenness();
    emit_.emit_pair(OpCode::LoopStart, 0, 0, 0, 0, depth);
    emit_.bind(top);
    loops_.push_back({&done, &check, with_depth_});
    statement(stmt.statement[0]);
    emit_.bind(check);
    jump_if(stmt.expression[0], true, top, depth);
    loops_.pop_back();
    emit_.bind(done);
    --loop_depth_;
    return completion(!(is_always(ast(), stmt.expression[0]) && !breaks(ast(), stmt.statement[0])));
}

/// `i++`, `i += 2`, `i--` on a whole local variable and a comparison with a variable or a constant:
/// one instruction a pass.
bool Checker::counting_loop(const Stmt& stmt, Label& top, int depth) {
    const ExprId condition = stmt.expression[0];
    const ExprId step_id = stmt.expression[1];
    if (!condition.is_valid() || !step_id.is_valid()) return false;
    const Expr& step_expr = ast()[step_id];
    const Expr& compare = ast()[condition];
    std::int64_t step = 0;
    if (step_expr.kind == ExprKind::Unary) {
        if (step_expr.op == Operator::PreIncrement || step_expr.op == Operator::PostIncrement)
            step = 1;
        if (step_expr.op == Operator::PreDecrement || step_expr.op == Operator::PostDecrement)
            step = -1;
    } else if (step_expr.kind == ExprKind::Assign &&
               ast()[step_expr.child[1]].kind == ExprKind::Int) {
        const std::int64_t value = ast()[step_expr.child[1]].integer;
        if (value > 30000) return false;
        if (step_expr.op == Operator::AddAssign) step = value;
        if (step_expr.op == Operator::SubtractAssign) step = -value;
    }
    if (step == 0 || ast()[step_expr.child[0]].kind != ExprKind::Name) return false;
    const bool ordered = compare.kind == ExprKind::Binary && compare.op >= Operator::Less &&
                         compare.op <= Operator::GreaterEqual;
    if (!ordered || ast()[compare.child[0]].kind != ExprKind::Name) return false;
    const auto local_int = [&](ExprId id) -> const Symbol* {
        if (ast()[id].kind != ExprKind::Name) return nullptr;
        const Found found = look_up(id);
        if (found.symbol < 0) return nullptr;
        const Symbol& symbol = symbols_[static_cast<std::size_t>(found.symbol)];
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
        symbols_[static_cast<std::size_t>(limit_symbol - symbols_.data())].is_read = true;
        limit = limit_symbol->reg;
    } else if (for_limit_ != kNoReg) {
        limit = for_limit_;
    } else {
        return false;
    }
    const OpCode op = compare.op == Operator::Less        ? OpCode::ForLtI
                      : compare.op == Operator::LessEqual ? OpCode::ForLeI
                      : compare.op == Operator::Greater   ? OpCode::ForGtI
                                                          : OpCode::ForGeI;
    emit_.set_location(step_expr.range);
    emit_.jump(op, top, counter->reg, limit,
               static_cast<std::uint16_t>(static_cast<std::int16_t>(step)), depth);
    return true;
}

Checker::Completion Checker::for_statement(const Stmt& stmt) {
    const OuterScope outer = enter_scope(stmt.range);
    const Reg mark = emit_.mark();
    if (stmt.statement[0].is_valid()) statement(stmt.statement[0]);
    Label top;
    Label next;
    Label done;
    const int depth = loop_depth_++;
    forget_givenness();
    // A whole constant as the limit gets a register for the time of the loop.
    const Reg outer_limit = std::exchange(for_limit_, kNoReg);
    const ExprId condition = stmt.expression[0];
    if (condition.is_valid() && ast()[condition].kind == ExprKind::Binary) {
        const ExprId end = ast()[condition].child[1];
        check_named_global(end);
        if (is_plain_constant(end)) {
            const Value limit = expression(end);
            if (limit.is_constant() && kind(limit.type) == TypeKind::Int)
                for_limit_ = in_register(limit);
        }
    }
    const Reg this_limit = for_limit_;
    emit_.emit_pair(OpCode::LoopStart, 0, 0, 0, 0, depth);
    if (condition.is_valid()) jump_if(condition, false, done);
    emit_.bind(top);
    loops_.push_back({&done, &next, with_depth_});
    const std::vector<Givenness> before = remember_givenness();
    if (condition.is_valid()) assume_given(condition, true);
    for_limit_ = kNoReg;
    statement(stmt.statement[1]);
    for_limit_ = this_limit;
    merge_givenness(before);
    emit_.bind(next);
    if (!counting_loop(stmt, top, depth)) {
        if (stmt.expression[1].is_valid()) {
            const Expr& step_expr = ast()[stmt.expression[1]];
            const Reg above = emit_.mark();
            emit_.set_location(step_expr.range);
            if (step_expr.kind == ExprKind::Assign) assign(stmt.expression[1], false);
            else if (step_expr.kind == ExprKind::Unary && step_expr.op >= Operator::PreIncrement &&
                     step_expr.op <= Operator::PostDecrement) {
                step(stmt.expression[1], false);
            } else {
                expression(stmt.expression[1]);
            }
            emit_.release_to(above);
        }
        if (condition.is_valid()) jump_if_quietly(condition, top, depth);
        else emit_.jump(OpCode::Loop, top, 0, 0, 0, depth);
    }
    loops_.pop_back();
    emit_.bind(done);
    for_limit_ = outer_limit;
    --loop_depth_;
    leave_scope(outer);
    emit_.release_to(mark);
    return completion(!(is_always(ast(), condition) && !breaks(ast(), stmt.statement[1])));
}

/// The condition a second time: what it had to report was reported the first time.
void Checker::jump_if_quietly(ExprId condition, Label& top, int depth) {
    const Trial trial(*this);
    jump_if(condition, true, top, depth);
}

/// What a global is, is known when it has been checked; it may stand further down.
void Checker::check_named_global(ExprId id) {
    if (ast()[id].kind != ExprKind::Name) return;
    const Found found = find(text(ast()[id].text));
    if (found.symbol >= 0 || found.name == nullptr) return;
    if (found.name->what == Name::What::Variable) check_global(found.name->index, is_startup_);
}

bool Checker::is_plain_constant(ExprId id) const {
    const Expr& expr = ast()[id];
    if (expr.kind == ExprKind::Int) return true;
    if (expr.kind != ExprKind::Name) return false;
    const Found found = find(text(expr.text));
    if (found.symbol >= 0) {
        return symbols_[static_cast<std::size_t>(found.symbol)].storage ==
               Symbol::Storage::Constant;
    }
    if (found.name == nullptr || found.name->what != Name::What::Variable) return false;
    return globals_[found.name->index].symbol.storage == Symbol::Storage::Constant;
}

namespace {

/// A whole number that stands in the source with its sign; of `1..n` nobody knows what n will be.
std::optional<std::int64_t> written_number(std::string_view text) {
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_whole = error == std::errc() && end == text.data() + text.size();
    return is_whole ? std::optional(number) : std::nullopt;
}

}  // namespace

/// `3..1` runs not at all: a range does not run backwards.
void Checker::warn_of_empty_range(const Expr& range) {
    const auto first = written_number(sources_.text(ast()[range.child[0]].range));
    const auto last = written_number(sources_.text(ast()[range.child[1]].range));
    if (!first || !last || *first <= *last) return;
    report(diag::EmptyRange, range.range)
        .arg(sources_.text(range.range))
        .fix("downwards counts `for (int i = " + std::to_string(*first) +
             "; i >= " + std::to_string(*last) + "; i--)`");
}

void Checker::for_range(const Stmt& stmt) {
    const Decl& decl = ast()[stmt.declaration];
    // `for (int i : 1..6)`: both ends included.
    Symbol symbol;
    symbol.name = text(decl.name);
    symbol.range = decl.name_range;
    symbol.decl = stmt.declaration;
    symbol.is_read = true;  // to count passes is use enough
    symbol.type = decl.type.is_valid() ? resolve_type(decl.type) : types::kInt;
    symbol.is_const = decl.is_const;
    if (symbol.type != types::kInt && kind(symbol.type) != TypeKind::Error) {
        report(diag::RangeType, decl.range).arg(type_name(symbol.type));
        symbol.type = types::kInt;
    }
    const Expr& range = ast()[stmt.expression[0]];
    const Reg hidden = emit_.take(2);  // the counter and the end, out of the body's reach
    expression_in(range.child[0], types::kInt, hidden, "the start of the range");
    expression_in(range.child[1], types::kInt, static_cast<Reg>(hidden + 1),
                  "the end of the range");
    warn_of_empty_range(range);
    symbol.reg = emit_.take(1);
    const Reg counter = symbol.reg;
    add_symbol(symbol);
    Label top;
    Label next;
    Label done;
    const int depth = loop_depth_++;
    forget_givenness();
    emit_.emit_pair(OpCode::LoopStart, 0, 0, 0, 0, depth);
    emit_.jump(OpCode::JumpLtI, done, static_cast<Reg>(hidden + 1), hidden);
    emit_.bind(top);
    emit_.emit(OpCode::Move, counter, hidden);
    loops_.push_back({&done, &next, with_depth_});
    const std::vector<Givenness> before = remember_givenness();
    statement(stmt.statement[0]);
    merge_givenness(before);
    loops_.pop_back();
    emit_.bind(next);
    emit_.jump(OpCode::ForLeI, top, hidden, static_cast<Reg>(hidden + 1), 1, depth);
    emit_.bind(done);
    --loop_depth_;
}

/// The characters of a string as an array for `for`.
Value Checker::characters(const Value& string, bool is_reference, const Decl& decl,
                          const SourceRange& range) {
    if (is_reference) {
        report(diag::NotAPlace, decl.range);
        return error_value();
    }
    const Reg from = in_register(string);
    const Reg reg = emit_.take(1);
    emit_.set_location(range);
    emit_.emit_pair(OpCode::SplitText, reg, from, 0, layout_constant(types::kString));
    return in_registers(types_.array(types::kString, -1), reg);
}

Checker::Completion Checker::for_each(const Stmt& stmt) {
    const OuterScope outer = enter_scope(stmt.range);
    const Reg mark = emit_.mark();
    const Decl& decl = ast()[stmt.declaration];
    const auto leave = [&] {
        leave_scope(outer);
        emit_.release_to(mark);
    };
    if (ast()[stmt.expression[0]].kind == ExprKind::Range) {
        for_range(stmt);
        leave();
        return Completion::Normal;
    }
    const SourceRange range = ast()[stmt.expression[0]].range;
    const bool is_reference = decl.type.is_valid() && ast()[decl.type].is_reference;
    const Type written = decl.type.is_valid() ? resolve_type(decl.type) : types::kError;
    const Type wanted =
        kind(written) != TypeKind::Error ? types_.array(written, -1) : types::kError;
    const bool is_braces = ast()[stmt.expression[0]].kind == ExprKind::Braces;
    const std::optional<Lvalue> source =
        is_braces ? std::nullopt : owner_lvalue(stmt.expression[0]);
    Value list = is_braces ? expression(stmt.expression[0], wanted)
                 : source  ? load(*source, range, true, kNoReg)
                           : error_value();
    list = require_given(list, range, {});
    if (kind(list.type) == TypeKind::String) list = characters(list, is_reference, decl, range);
    Symbol symbol;
    symbol.name = text(decl.name);
    symbol.range = decl.name_range;
    symbol.decl = stmt.declaration;
    symbol.is_read = true;  // to count passes is use enough
    symbol.type = written;
    symbol.is_row = true;
    symbol.is_const = decl.is_const;
    if (kind(list.type) != TypeKind::Array) {
        if (!is_error(list)) report(diag::NotAnArray, range).arg(type_name(list.type));
        symbol.reg = emit_.take(std::max<unsigned>(1, type_info(written).slots));
        add_symbol(symbol);
        loops_.push_back({nullptr, nullptr, with_depth_});
        Label nowhere;
        loops_.back() = {&nowhere, &nowhere, with_depth_};
        statement(stmt.statement[0]);
        loops_.pop_back();
        emit_.bind(nowhere);
        leave();
        return Completion::Normal;
    }
    const Type element = type_info(list.type).element;
    if (!decl.type.is_valid()) symbol.type = element;
    const std::uint16_t slots = type_info(element).slots;
    const Reg handle = emit_.take(1);
    // Without `&` the elements are those that the list has now, whatever the body does to it.
    const bool may_change = !is_reference && source && !source->is_temporary && !source->is_const;
    emit_.emit(may_change && !is_contour(list.type) ? OpCode::CopyArray : OpCode::Move, handle,
               list.reg);
    const Reg hidden = emit_.take(2);  // index, count
    const std::uint16_t symbol_slots =
        is_reference ? 1 : std::max<std::uint16_t>(1, type_info(symbol.type).slots);
    symbol.reg = emit_.take(symbol_slots);
    if (is_reference) {
        symbol.storage = Symbol::Storage::Reference;
        if (symbol.type != element && kind(symbol.type) != TypeKind::Error) {
            check_places(element, symbol.type, decl.range, symbol.name);
        }
        if (source && !source->is_temporary && source->is_const && !decl.is_const)
            symbol.is_const = true;
    }
    const Symbol copy = symbol;
    add_symbol(symbol);
    Label top;
    Label next;
    Label done;
    const int depth = loop_depth_++;
    forget_givenness();
    emit_.emit_integer(OpCode::LoadI, hidden, 0, 0);
    emit_.emit_pair(OpCode::LoopStart, 0, 0, 0, 0, depth);
    emit_.emit(OpCode::CountArray, static_cast<Reg>(hidden + 1), handle);
    emit_.jump(OpCode::JumpLeI, done, static_cast<Reg>(hidden + 1), hidden);
    emit_.bind(top);
    Lvalue at;
    at.storage = Lvalue::Storage::Element;
    at.type = element;
    at.reg = handle;
    at.index = hidden;
    at.stride = slots;
    at.may_be_unset = type_info(list.type).count >= 0;
    at.root = "the element";
    const Reg above = emit_.mark();
    if (is_reference) {
        emit_.emit(OpCode::Move, copy.reg, reference_to(at));
    } else {
        const Value item = convert(load(at, range, true, copy.type == element ? copy.reg : kNoReg),
                                   copy.type, decl.range, copy.name);
        if (!is_error(item)) copy_value(item, copy.reg);
    }
    emit_.release_to(above);
    loops_.push_back({&done, &next, with_depth_});
    const std::vector<Givenness> before = remember_givenness();
    statement(stmt.statement[0]);
    merge_givenness(before);
    loops_.pop_back();
    emit_.bind(next);
    // The list may have grown or shrunk meanwhile.
    emit_.emit(OpCode::CountArray, static_cast<Reg>(hidden + 1), handle);
    emit_.jump(OpCode::ForLtI, top, hidden, static_cast<Reg>(hidden + 1), 1, depth);
    emit_.bind(done);
    --loop_depth_;
    leave();
    return Completion::Normal;
}

}  // namespace kadr::sema
