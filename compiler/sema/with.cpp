// with.cpp — modal words and frames that a brace ends; what `preserves` names.
#include "base/diagnostics/sema.h"
#include "sema/checker.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::Word;

/// `frames`, and in `preserves G90, F, S` the values of these words.
ModalMask Checker::named_state(const Word& word) const {
    const std::string_view name = text(word.address);
    if (name == "FRAMES" || name == "frames") return kFrameBit;
    if (word.form != Word::Form::Bare) return 0;
    return name == "F" ? kFeedBit : name == "S" ? kSpeedBit : 0;
}

/// What a planned block sets for good; `is_modal` becomes false if it also does something once.
ModalMask Checker::modal_mask(const nc::BlockPlan& plan, bool& is_modal) const {
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

ModalMask Checker::words_mask(std::span<const Word> words, bool is_preserves) {
    const std::string_view keyword = is_preserves ? "preserves" : "with";
    ModalMask mask = 0;
    if (!is_preserves && !words.empty()) {
        // Words of one block belong together: `with G43 H3`.
        const std::optional<nc::BlockPlan> plan = plan_words(words);
        bool is_modal = true;
        if (plan) mask = modal_mask(*plan, is_modal);
        if (is_modal) return mask;
    }
    for (const Word& word : words) {
        if (const ModalMask named = named_state(word); named != 0) {
            mask |= named;
            continue;
        }
        const std::optional<nc::BlockPlan> plan = plan_words({&word, 1});
        if (!plan) continue;
        bool is_modal = true;
        mask |= modal_mask(*plan, is_modal);
        if (!is_modal) report(diag::NotModal, word.range).arg(word_text(word)).arg(keyword);
    }
    return mask;
}

namespace {

/// The functions of the vocabulary that hold until another one: `work_offset(2)`.
const nc::FunctionInfo* modal_function(std::string_view name) {
    const std::optional<nc::Function> function = nc::find_function(name);
    if (!function || *function == nc::Function::None || nc::has_fact(*function, nc::Fact::ReadOnly))
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
Done Checker::require_least(const nc::FunctionInfo& info, std::span<const ExprId> bound,
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
    report(diag::ArgumentMissing, expr.range).arg(info.name).arg(first);
    return kFailed;
}

void Checker::frame_call(ExprId id) {
    const Expr& expr = ast()[id];
    if (expr.kind == ExprKind::Invalid) return;
    const Expr& callee = ast()[expr.kind == ExprKind::Call ? expr.child[0] : id];
    const std::string_view name =
        callee.kind == ExprKind::Name ? text(callee.text) : std::string_view();
    const auto change = frame_change(name);
    if (expr.kind == ExprKind::Call && name == "tcp") {
        tcp_call(expr);
        return;
    }
    if (expr.kind == ExprKind::Call && !change) {
        if (const nc::FunctionInfo* function = modal_function(name)) {
            call_vocabulary(*function, expr);
            return;
        }
    }
    if (expr.kind != ExprKind::Call || !change) {
        report(diag::WithCall, expr.range).arg(sources_.text(callee.range));
        return;
    }
    const nc::FunctionInfo& info = nc::info(change->first);
    std::vector<std::string_view> names;
    for (const nc::Parameter& parameter : info.parameters) names.push_back(parameter.name);
    const auto bound = bind_arguments(expr, name, names, {});
    if (!bound) return;
    if (!require_least(info, *bound, expr)) return;
    const Reg first = emit_.take(static_cast<unsigned>(names.size()));
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto reg = static_cast<Reg>(first + i);
        if (!(*bound)[i].is_valid()) {
            if (!info.parameters[i].is_optional) {
                report(diag::ArgumentMissing, expr.range).arg(name).arg(names[i]);
            }
            emit_.emit_number(OpCode::LoadF, reg, 0, kNotGivenNumber);
            continue;
        }
        const SourceRange range = ast()[(*bound)[i]].range;
        const Reg mark = emit_.mark();
        Value value = expression((*bound)[i]);
        if (info.parameters[i].dimension == nc::Dimension::Length &&
            !require_no_diameter(value, range, names[i]))
            value = error_value();
        const std::optional<Value> named = named_axis(info, info.parameters[i], value, range);
        if (!named) emit_.emit_number(OpCode::LoadF, reg, 0, kNotGivenNumber);
        else fill_value(*named, info.parameters[i].dimension, range, names[i], reg);
        emit_.release_to(mark);
    }
    emit_.set_location(expr.range);
    emit_.emit_pair(OpCode::ChangeFrame, first, static_cast<unsigned>(change->second),
                    static_cast<unsigned>(loop_depth_), 0, statement_id(expr.range));
}

/// What the head of a `with` sets, words and calls.
ModalMask Checker::with_mask(const Stmt& stmt) {
    ModalMask mask = words_mask(ast().word_run(stmt.words), false);
    for (const ExprId id : ast().exprs(stmt.expressions)) {
        const Expr& expr = ast()[id];
        if (expr.kind != ExprKind::Call || ast()[expr.child[0]].kind != ExprKind::Name) continue;
        const std::string_view name = text(ast()[expr.child[0]].text);
        if (frame_change(name)) mask |= kFrameBit;
        else if (name == "tcp") mask |= group_bit(nc::Group::Transformation);
        else if (const nc::FunctionInfo* function = modal_function(name))
            mask |= group_bit(function->group);
    }
    return mask;
}

Checker::Completion Checker::with_statement(const Stmt& stmt) {
    const auto words = ast().word_run(stmt.words);
    const std::size_t errors = sink_.errors;
    const ModalMask mask = with_mask(stmt);
    // The source of the block is the head of the statement, not its whole body.
    SourceRange head = stmt.range;
    if (stmt.statement[0].is_valid() && ast()[stmt.statement[0]].range.begin > head.begin) {
        head.end = ast()[stmt.statement[0]].range.begin;
    }
    emit_.set_location(head);
    emit_.emit_pair(OpCode::EnterWith, 0, 0, 0, mask, statement_id(head));
    ++with_depth_;
    if (!words.empty() && errors == sink_.errors) emit_words(words, {}, head);
    for (const ExprId id : ast().exprs(stmt.expressions)) {
        const Reg mark = emit_.mark();
        frame_call(id);
        emit_.release_to(mark);
    }
    const Completion body = statement(stmt.statement[0]);
    if (body == Completion::Normal) {
        const SourceRange end{stmt.range.file, stmt.range.end > 0 ? stmt.range.end - 1 : 0,
                              stmt.range.end};
        emit_.set_location(end);
        emit_.emit_pair(OpCode::LeaveWith, 0, 0, 1, 0, statement_id(end));
    }
    --with_depth_;
    return body;
}

}  // namespace kadr::sema
