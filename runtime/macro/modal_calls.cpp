// modal_calls.cpp — calls that are made behind the blocks that come.
#include "macro/modal_calls.h"

#include <algorithm>
#include <utility>

#include "base/diagnostics/control.h"
#include "macro/named_shape.h"
#include "macro/program_run.h"

namespace kadr::macro {

using nc::Block;
using nc::CallForm;
using nc::ControlStatement;
using nc::Function;

namespace {

/// Whether an axis moves in the block, as far as words tell.
bool moves(const Block& block) {
    if ((block.given & (nc::kTargetSlots | nc::kPolarSlots)) != 0) return true;
    // A full circle names no end, and an arc may give the angle that it goes.
    const bool is_arc_given = (block.given & (nc::kArcSlots | bit(nc::Slot::Opening))) != 0;
    if (is_arc_given &&
        (block.motion == Function::None || nc::has_fact(block.motion, nc::Fact::Circle)))
        return true;
    return block.find(Function::ReferenceReturn) != nullptr ||
           block.find(Function::ReferencePoint) != nullptr;
}

}  // namespace

Outcome ModalCalls::begin(CompiledLine& line, const ControlStatement& statement, Block& out) {
    auto prepared = std::make_shared<PreparedCall>();
    const Outcome done = run_.call_preparation.prepare(line, statement, *prepared);
    if (!goes_on(done)) return done;
    run_.show_way(WayTaken::Kind::Call, line.program_line.line, *prepared->unit,
                  prepared->unit->begin);
    prepared->is_modal = true;
    const int most = run_.language.rules.most_modal_calls;
    if (most == 1) calls_.clear();
    if (static_cast<int>(calls_.size()) >= most)
        return run_.fail(line, diag::ModalCallsTooDeep, statement.span, {std::to_string(most)});
    calls_.push_back(std::move(prepared));
    // Where a cycle can be called so as well, this call takes its place.
    if (most != 1 || !out.add(Function::CycleModal)) return Outcome::Nothing;
    keeps_calls_ = true;
    return Outcome::Block;
}

Outcome ModalCalls::end(CompiledLine& line, const ControlStatement& statement) {
    if (calls_.empty() && !run_.language.rules.end_modal_alone)
        return run_.fail(line, diag::ModalCallMissing, statement.span);
    if (!calls_.empty()) calls_.pop_back();
    return Outcome::Nothing;
}

/// The modal call that a block of the program which runs makes; null: none.
const PreparedCall* ModalCalls::acting() const {
    const std::size_t count = std::min(run_.frame->modal_limit, calls_.size());
    return count == 0 ? nullptr : calls_[count - 1].get();
}

/// The code of the modal call that acts; without one that which ends it.
double ModalCalls::code() const {
    const PreparedCall* const active = acting();
    if (active != nullptr && active->form != nullptr) return active->form->number;
    const auto end =
        std::ranges::find(run_.language.calls.calls, CallForm::Kind::EndModal, &CallForm::kind);
    return end == run_.language.calls.calls.end() ? 0 : end->number;
}

bool ModalCalls::takes_blocks() const {
    const PreparedCall* const active = acting();
    return active != nullptr && active->form != nullptr &&
           active->form->modal == CallForm::Modal::Block;
}

/// Behind a block that moves an axis the modal call is made.
void ModalCalls::call_behind(const Block& block, std::string_view text_of_line,
                             std::uint64_t number) {
    const bool is_path = !std::exchange(moves_alone_, false);
    if (run_.phase.is_only_checking) return;
    if (block.find(Function::CycleModal) != nullptr) {
        if (!keeps_calls_) calls_.clear();
        keeps_calls_ = false;
        return;
    }
    const PreparedCall* const active = acting();
    if (active == nullptr || run_.is_left_out(block)) return;
    const bool is_pattern = run_.interpreter != nullptr && block.find(Function::Cycle) != nullptr &&
                            goes_to_positions(run_.dialect.cycles()[block.cycle]);
    if (is_pattern) return call_at_positions(block, *active, text_of_line, number);
    if (!moves(block) || !is_path) return;
    due_ = *active;
    due_->site = std::make_shared<nc::CallSite>(
        nc::CallSite{run_.lines.location(text_of_line, number, {0, 1}), run_.frame->site});
}

/// The modal call that the block before has made.
Outcome ModalCalls::begin_due() {
    CompiledLine here;
    here.text = due_->site->location.text;
    const Outcome done = run_.calls.begin(here, *due_);
    if (done == Outcome::Wait) return done;
    due_.reset();
    RunningProgram* const next = run_.calls.begun();
    if (next == nullptr) return done;
    next->modal_limit =
        next->call.is_shape ? 0 : std::min(run_.frame->modal_limit, calls_.size()) - 1;
    run_.calls.perform();
    return done;
}

/// The words of the block are the arguments of the modal call.
Outcome ModalCalls::call_with_block(CompiledLine& line) {
    const PreparedCall* const active = acting();
    if (active == nullptr) return Outcome::Nothing;
    PreparedCall call = *active;
    const nc::Call& words = line.line.calls[0];
    Outcome done = run_.call_preparation.prepare_letters(line, words, call);
    if (!goes_on(done)) return done;
    call.site = std::make_shared<nc::CallSite>(nc::CallSite{
        run_.lines.location(line.text, line.program_line.line.line, words.span), run_.frame->site});
    done = run_.calls.begin(line, call);
    if (RunningProgram* const next = run_.calls.begun())
        next->modal_limit = std::min(run_.frame->modal_limit, calls_.size()) - 1;
    return done;
}

}  // namespace kadr::macro
