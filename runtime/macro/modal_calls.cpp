// modal_calls.cpp — calls that are made behind the blocks that come.
#include <algorithm>
#include <utility>

#include "base/diagnostics/control.h"
#include "macro/named_shape.h"
#include "macro/program_state.h"

namespace kadr::macro {

using nc::Block;
using nc::CallForm;
using nc::ControlStatement;
using nc::Function;

namespace {

/// Whether an axis moves in the block, as far as words tell.
bool moves(const Block& block) {
    if ((block.given & (nc::kTargetSlots | nc::kPolarSlots)) != 0) return true;
    // A full circle names no end, and an arc may say the angle that it goes.
    const bool is_arc_said = (block.given & (nc::kArcSlots | bit(nc::Slot::Opening))) != 0;
    if (is_arc_said &&
        (block.motion == Function::None || nc::has_fact(block.motion, nc::Fact::Circle)))
        return true;
    return block.find(Function::ReferenceReturn) != nullptr ||
           block.find(Function::ReferencePoint) != nullptr;
}

}  // namespace

Program::State::Outcome Program::State::call_modal(CompiledLine& line,
                                                   const ControlStatement& statement, Block& out) {
    auto prepared = std::make_shared<PreparedCall>();
    const Outcome done = prepare(line, statement, *prepared);
    if (!goes_on(done)) return done;
    prepared->is_modal = true;
    const int most = language.rules.most_modal_calls;
    if (most == 1) modal_calls.clear();
    if (static_cast<int>(modal_calls.size()) >= most)
        return fail(line, diag::ModalCallsTooDeep, statement.span, {std::to_string(most)});
    modal_calls.push_back(std::move(prepared));
    // Where a cycle can be called so as well, this call takes its place.
    if (most != 1 || !out.add(Function::CycleModal)) return Outcome::Nothing;
    keeps_modal_calls = true;
    return Outcome::Block;
}

Program::State::Outcome Program::State::end_modal(CompiledLine& line,
                                                  const ControlStatement& statement) {
    if (modal_calls.empty() && !language.rules.end_modal_alone)
        return fail(line, diag::ModalCallMissing, statement.span);
    if (!modal_calls.empty()) modal_calls.pop_back();
    return Outcome::Nothing;
}

/// The modal call that a block of the program which runs makes; null: none.
const PreparedCall* Program::State::active_modal_call() const {
    const std::size_t count = std::min(frame->modal_limit, modal_calls.size());
    return count == 0 ? nullptr : modal_calls[count - 1].get();
}

/// The code of the modal call that acts; without one that which ends it.
double Program::State::modal_call_code() const {
    const PreparedCall* const active = active_modal_call();
    if (active != nullptr && active->form != nullptr) return active->form->number;
    const auto end =
        std::ranges::find(language.calls.calls, CallForm::Kind::EndModal, &CallForm::kind);
    return end == language.calls.calls.end() ? 0 : end->number;
}

bool Program::State::takes_blocks() const {
    const PreparedCall* const active = active_modal_call();
    return active != nullptr && active->form != nullptr &&
           active->form->modal == CallForm::Modal::Block;
}

/// Behind a block that moves an axis the modal call is made.
void Program::State::call_behind(const Block& block, std::string_view text_of_line,
                                 std::uint64_t number) {
    const bool is_path = !std::exchange(moves_alone, false);
    if (is_only_checking) return;
    if (block.find(Function::CycleModal) != nullptr) {
        if (!keeps_modal_calls) modal_calls.clear();
        keeps_modal_calls = false;
        return;
    }
    const PreparedCall* const active = active_modal_call();
    if (active == nullptr || is_left_out(block)) return;
    const bool is_pattern = interpreter != nullptr && block.find(Function::Cycle) != nullptr &&
                            goes_to_places(dialect.cycles()[block.cycle]);
    if (is_pattern) return call_at_places(block, *active, text_of_line, number);
    if (!moves(block) || !is_path) return;
    due = *active;
    due->site = std::make_shared<nc::CallSite>(
        nc::CallSite{lines.place(text_of_line, number, {0, 1}), frame->site});
}

/// The modal call that the block before has made.
Program::State::Outcome Program::State::begin_due() {
    CompiledLine here;
    here.text = due->site->place.text;
    const Outcome done = begin(here, *due);
    if (done == Outcome::Wait) return done;
    due.reset();
    if (!begins) return done;
    begins->modal_limit =
        begins->call.is_shape ? 0 : std::min(frame->modal_limit, modal_calls.size()) - 1;
    perform_call();
    return done;
}

/// The words of the block are the arguments of the modal call.
Program::State::Outcome Program::State::call_with_block(CompiledLine& line) {
    const PreparedCall* const active = active_modal_call();
    if (active == nullptr) return Outcome::Nothing;
    PreparedCall call = *active;
    const nc::Call& words = line.line.calls[0];
    Outcome done = prepare_letters(line, words, call);
    if (!goes_on(done)) return done;
    call.site = std::make_shared<nc::CallSite>(
        nc::CallSite{lines.place(line.text, line.place.line.line, words.span), frame->site});
    done = begin(line, call);
    if (begins) begins->modal_limit = std::min(frame->modal_limit, modal_calls.size()) - 1;
    return done;
}

}  // namespace kadr::macro
