// seeing.cpp — what somebody who looks on sees of a program that stands: calls and values.
#include <optional>

#include "expand/expander.h"
#include "expand/running.h"
#include "expand/text_format.h"

namespace kadr::expand {

using sema::NamedVariable;
using sema::ShownForm;

namespace {

/// Registers that a form takes, to be looked for behind a reference.
std::uint32_t slots_of(const sema::Code& code, const ShownForm& form) {
    if (form.kind != ShownForm::Kind::Members) return 1;
    std::uint32_t slots = 0;
    for (const ShownForm::Part& part : form.parts)
        slots = std::max(slots, part.slot + slots_of(code, code.shown_forms[part.form]));
    return slots;
}

/// A value and its form.
struct Seen {
    const Slot* slots = nullptr;  // null: there is none any more
    std::uint32_t form = 0;
};

Seen part_of(const sema::Code& code, Heap& heap, const Seen& whole, std::uint32_t index) {
    const ShownForm& form = code.shown_forms[whole.form];
    if (form.kind == ShownForm::Kind::Members && index < form.parts.size())
        return {whole.slots + form.parts[index].slot, form.parts[index].form};
    const bool is_list = form.kind == ShownForm::Kind::List;
    if (!is_list || !sema::is_given(*whole.slots, static_cast<unsigned>(form.slot))) return {};
    const Heap::ArrayView elements = heap.array(whole.slots->integer);
    if (index >= elements.count) return {};
    return {elements.slots + std::size_t{index} * elements.stride, form.parts[0].form};
}

std::int64_t parts_of(const sema::Code& code, Heap& heap, const Seen& value) {
    const ShownForm& form = code.shown_forms[value.form];
    switch (form.kind) {
        case ShownForm::Kind::Members: return static_cast<std::int64_t>(form.parts.size());
        case ShownForm::Kind::List:
            return sema::is_given(*value.slots, static_cast<unsigned>(form.slot))
                       ? heap.array(value.slots->integer).count
                       : 0;
        case ShownForm::Kind::Plain:
        case ShownForm::Kind::Contour: break;
    }
    return 0;
}

}  // namespace

bool Expander::is_waiting() const { return run_->status.is_running(); }

std::vector<RunningCall> Expander::running_calls() const {
    std::vector<RunningCall> calls;
    const CallStack& frames = run_->vm.calls;
    const auto is_startup = [](const CallFrame& frame) {
        return frame.function->kind == sema::FunctionKind::Startup;
    };
    // Globals get their values in front of the program, which has not begun.
    const std::size_t first = frames.size() > 1 && is_startup(frames[1]) ? 1 : 0;
    for (std::size_t i = first; i < frames.size(); ++i) {
        const bool is_last = i + 1 == frames.size();
        const std::uint32_t at = is_last ? run_->vm.pc : frames[i + 1].return_to - 1;
        const bool is_called = i > 0 && !is_startup(frames[i]);
        calls.push_back(
            {frames[i].function, at, frames[i].base, is_called ? frames[i].return_to : 0});
    }
    return calls;
}

SeenValue Expander::see(const RunningCall& call, const NamedVariable& variable,
                        std::span<const std::uint32_t> path) const {
    const sema::Code& code = run_->code;
    Heap& heap = run_->vm.heap;
    Slot constant = variable.constant;
    Seen seen{nullptr, variable.form};
    using S = NamedVariable::Storage;
    switch (variable.storage) {
        case S::Register: seen.slots = run_->vm.stack.data() + call.base + variable.first; break;
        case S::Global: seen.slots = run_->vm.stack.data() + variable.first; break;
        case S::Constant:
            if (code.shown_forms[variable.form].slot == sema::SlotKind::Text)
                constant.integer =
                    Heap::constant_text(static_cast<std::uint32_t>(variable.constant.integer));
            seen.slots = &constant;
            break;
        case S::Reference: {
            const std::int64_t to = run_->vm.stack[call.base + variable.first].integer;
            seen.slots = to >= 0 ? run_->vm.stack.data() + to
                                 : heap.referred(to, slots_of(code, code.shown_forms[seen.form]));
            break;
        }
    }
    for (std::size_t i = 0; i < path.size() && seen.slots != nullptr; ++i)
        seen = part_of(code, heap, seen, path[i]);
    if (seen.slots == nullptr) return {"gone", &code.shown_forms[variable.form], 0};
    return {shown(*run_, seen.form, seen.slots, !path.empty()), &code.shown_forms[seen.form],
            parts_of(code, heap, seen)};
}

}  // namespace kadr::expand
