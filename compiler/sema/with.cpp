// with.cpp — modal words and frames that a brace ends; what `preserves` names.
#include "sema/with.h"

#include "base/diagnostics/sema.h"
#include "sema/block_fillings.h"
#include "sema/block_words.h"
#include "sema/blocks.h"
#include "sema/calls.h"
#include "sema/checking.h"
#include "sema/expressions.h"
#include "sema/naming.h"
#include "sema/orienting.h"
#include "sema/statements.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::Word;

/// `frames`, and in `preserves G90, F, S` the values of these words.
ModalMask named_state(const Check& check, const Word& word) {
    const std::string_view name = check.text(word.address);
    if (name == "FRAMES" || name == "frames") return kFrameBit;
    if (word.form != Word::Form::Bare) return 0;
    return name == "F" ? kFeedBit : name == "S" ? kSpeedBit : 0;
}

namespace {

/// What a planned block sets for good; `is_modal` becomes false if it also does something once.
ModalMask modal_mask(const nc::BlockPlan& plan, bool& is_modal) {
    const nc::Block& block = plan.block;
    ModalMask mask = block.motion != nc::Function::None ? group_bit(nc::Group::Motion) : 0;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const nc::Group group = nc::info(block.functions[i].function).group;
        if (group == nc::Group::NonModal) is_modal = false;
        else mask |= group_bit(group);
    }
    const auto add_slot = [&](std::size_t slot) {
        if (slot == static_cast<std::size_t>(nc::Slot::Feed)) mask |= kFeedBit;
        else if (slot == static_cast<std::size_t>(nc::Slot::Speed)) mask |= kSpeedBit;
        else is_modal = false;
    };
    for (std::size_t slot = 0; slot < nc::kSlots; ++slot) {
        if ((block.given >> slot & 1u) != 0) add_slot(slot);
    }
    for (const nc::Hole& hole : plan.holes) {
        if (!hole.is_argument) add_slot(hole.index);
    }
    return mask;
}

}  // namespace

ModalMask words_mask(Check& check, std::span<const Word> words, bool is_preserves) {
    const std::string_view keyword = is_preserves ? "preserves" : "with";
    ModalMask mask = 0;
    if (!is_preserves && !words.empty()) {
        // Words of one block belong together: `with G43 H3`.
        const std::optional<nc::BlockPlan> plan = plan_words(check, words);
        bool is_modal = true;
        if (plan) mask = modal_mask(*plan, is_modal);
        if (is_modal) return mask;
    }
    for (const Word& word : words) {
        if (const ModalMask named = named_state(check, word); named != 0) {
            mask |= named;
            continue;
        }
        const std::optional<nc::BlockPlan> plan = plan_words(check, {&word, 1});
        if (!plan) continue;
        bool is_modal = true;
        mask |= modal_mask(*plan, is_modal);
        if (!is_modal)
            check.report(diag::NotModal, word.range).arg(word_text(check, word)).arg(keyword);
    }
    return mask;
}

namespace {

/// The functions of the vocabulary that hold until another one: `work_offset(2)`.
const nc::FunctionInfo* modal_function(std::string_view name) {
    const std::optional<nc::Function> function = nc::find_function(name);
    if (!function || *function == nc::Function::None || nc::is_no_command(*function))
        return nullptr;
    const nc::FunctionInfo& info = nc::info(*function);
    return info.group == nc::Group::NonModal ? nullptr : &info;
}

/// The frames that `with` can undo.
std::optional<std::pair<nc::Function, WithFrame>> frame_change(std::string_view name) {
    if (name == "shift") return std::pair{nc::Function::Shift, WithFrame::Shift};
    if (name == "rotate") return std::pair{nc::Function::Rotate, WithFrame::Rotate};
    if (name == "scale") return std::pair{nc::Function::Scale, WithFrame::Scale};
    if (name == "mirror") return std::pair{nc::Function::Mirror, WithFrame::Mirror};
    return std::nullopt;
}

}  // namespace

/// A scale gives at least one factor; a mirror and a motion to the reference point name an axis.
Done require_least(Check& check, const nc::FunctionInfo& info, std::span<const ExprId> bound,
                   const Expr& expr) {
    const bool is_scale = info.function == nc::Function::Scale;
    const bool names_axes =
        info.function == nc::Function::Mirror || info.function == nc::Function::ReferencePoint;
    if (!is_scale && !names_axes) return kDone;
    const auto wanted = is_scale ? nc::Dimension::Factor : nc::Dimension::Length;
    std::string_view first;
    for (std::size_t i = 0; i < bound.size(); ++i) {
        if (info.parameters[i].dimension != wanted) continue;
        if (bound[i].is_valid()) return kDone;
        if (first.empty()) first = info.parameters[i].name;
    }
    check.report(diag::ArgumentMissing, expr.range).arg(info.name).arg(first);
    return kFailed;
}

namespace {

void frame_call(Check& check, ExprId id) {
    const Expr& expr = check.ast()[id];
    if (expr.kind == ExprKind::Invalid) return;
    const Expr& callee = check.ast()[expr.kind == ExprKind::Call ? expr.child[0] : id];
    const std::string_view name =
        callee.kind == ExprKind::Name ? check.text(callee.text) : std::string_view();
    const auto change = frame_change(name);
    if (expr.kind == ExprKind::Call && name == "tcp") {
        tcp_call(check, expr);
        return;
    }
    if (expr.kind == ExprKind::Call && !change) {
        if (const nc::FunctionInfo* function = modal_function(name)) {
            call_vocabulary(check, *function, expr);
            return;
        }
    }
    if (expr.kind != ExprKind::Call || !change) {
        check.report(diag::WithCall, expr.range).arg(check.sources.text(callee.range));
        return;
    }
    const nc::FunctionInfo& info = nc::info(change->first);
    std::vector<std::string_view> names;
    for (const nc::Parameter& parameter : info.parameters) names.push_back(parameter.name);
    const auto bound = bind_arguments(check, expr, name, names, {});
    if (!bound) return;
    if (!require_least(check, info, *bound, expr)) return;
    const Reg first = check.emit.take(static_cast<unsigned>(names.size()));
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto reg = static_cast<Reg>(first + i);
        if (!(*bound)[i].is_valid()) {
            if (!info.parameters[i].is_optional) {
                check.report(diag::ArgumentMissing, expr.range).arg(name).arg(names[i]);
            }
            check.emit.emit_number(OpCode::LoadF, reg, 0, kNotGivenNumber);
            continue;
        }
        const SourceRange range = check.ast()[(*bound)[i]].range;
        const Reg mark = check.emit.mark();
        Value value = expression(check, (*bound)[i]);
        if (info.parameters[i].dimension == nc::Dimension::Length &&
            !require_no_diameter(check, value, range, names[i]))
            value = error_value();
        const std::optional<Value> named =
            named_axis(check, info, info.parameters[i], value, range);
        if (!named) check.emit.emit_number(OpCode::LoadF, reg, 0, kNotGivenNumber);
        else fill_value(check, *named, info.parameters[i].dimension, range, names[i], reg);
        check.emit.release_to(mark);
    }
    check.emit.set_location(expr.range);
    check.emit.emit_pair(OpCode::ChangeFrame, first, static_cast<unsigned>(change->second),
                         static_cast<unsigned>(check.here.loop_depth), 0,
                         statement_id(check, expr.range));
}

}  // namespace

/// What the head of a `with` sets, words and calls.
ModalMask with_mask(Check& check, const Stmt& stmt) {
    ModalMask mask = words_mask(check, check.ast().word_run(stmt.words), false);
    for (const ExprId id : check.ast().exprs(stmt.expressions)) {
        const Expr& expr = check.ast()[id];
        if (expr.kind != ExprKind::Call || check.ast()[expr.child[0]].kind != ExprKind::Name)
            continue;
        const std::string_view name = check.text(check.ast()[expr.child[0]].text);
        if (frame_change(name)) mask |= kFrameBit;
        else if (name == "tcp") mask |= group_bit(nc::Group::Transformation);
        else if (const nc::FunctionInfo* function = modal_function(name))
            mask |= group_bit(function->group);
    }
    return mask;
}

Completion with_statement(Check& check, const Stmt& stmt) {
    const auto words = check.ast().word_run(stmt.words);
    const std::size_t errors = check.sink.errors;
    const ModalMask mask = with_mask(check, stmt);
    // The source of the block is the head of the statement, not its whole body.
    SourceRange head = stmt.range;
    if (stmt.statement[0].is_valid() && check.ast()[stmt.statement[0]].range.begin > head.begin) {
        head.end = check.ast()[stmt.statement[0]].range.begin;
    }
    check.emit.set_location(head);
    check.emit.emit_pair(OpCode::EnterWith, 0, 0, 0, mask, statement_id(check, head));
    ++check.here.with_depth;
    if (!words.empty() && errors == check.sink.errors) emit_words(check, words, {}, head);
    for (const ExprId id : check.ast().exprs(stmt.expressions)) {
        const Reg mark = check.emit.mark();
        frame_call(check, id);
        check.emit.release_to(mark);
    }
    const Completion body = statement(check, stmt.statement[0]);
    if (body == Completion::Normal) {
        const SourceRange end{stmt.range.file, stmt.range.end > 0 ? stmt.range.end - 1 : 0,
                              stmt.range.end};
        check.emit.set_location(end);
        note_statement(check, end);
        check.emit.emit_pair(OpCode::LeaveWith, 0, 0, 1, 0, statement_id(check, end));
    }
    --check.here.with_depth;
    return body;
}

}  // namespace kadr::sema
