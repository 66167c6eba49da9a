// program_places.cpp — patterns of positions (HOLES1) at which a program is called that was made
// modal.
//
// The interpreter goes from position to position, the program knows what is called there: the block
// of the pattern ends its batch, the interpreter stands at the first position, the call begins as
// behind a motion, and when it has returned the interpreter goes on to the next position.
#include "macro/program_run.h"

namespace kadr::macro {

using nc::Block;
using nc::Function;
using nc::Group;

namespace {

/// Between the positions the interpreter moves at rapid and counts from the origin; the other codes
/// are those from before the pattern.
nc::ModalFunctions modal_between_positions(const CallsAtPositions& calls) {
    nc::ModalFunctions out = calls.modal_before;
    out[static_cast<std::size_t>(Group::Motion)] = Function::Rapid;
    out[static_cast<std::size_t>(Group::Distance)] = Function::Absolute;
    return out;
}

}  // namespace

/// The modal call is made at the positions of this block's pattern.
void ModalCalls::call_at_positions(const Block& block, const PreparedCall& active,
                                   std::string_view text_of_line, std::uint64_t number) {
    CallsAtPositions& calls = run_.frame->at_positions.emplace();
    calls.call = active;
    calls.call.site = std::make_shared<nc::CallSite>(
        nc::CallSite{run_.lines.location(text_of_line, number, {0, 1}), run_.frame->site});
    calls.line = block.line;
    calls.number = number;
    calls.modal_before = run_.lines.modes().modal();
    Block ignored{};
    run_.lines.modes().restore(modal_between_positions(calls), ignored);
}

/// The tool stands at a position: the call; behind it on to the next one, which the interpreter
/// does behind a block that takes back the codes of the program that was called. Behind the last
/// position those act again that acted before the pattern.
Outcome ModalCalls::go_on_at_positions(Block& out) {
    if (run_.counts.given > 0) return Outcome::Wait;
    CallsAtPositions& calls = *run_.frame->at_positions;
    const bool is_at_pattern_position = run_.interpreter->is_at_pattern_position();
    if (is_at_pattern_position && !calls.has_called) {
        calls.has_called = true;
        due_ = calls.call;
        return begin_due();
    }
    run_.lines.modes().restore(
        is_at_pattern_position ? modal_between_positions(calls) : calls.modal_before, out);
    const bool says_something = out.function_count > 0 || out.motion != Function::None;
    out.line = calls.line;
    run_.kept.add(out.line, calls.number, calls.call.site->location.text, &run_.text().name,
                  run_.frame->site);
    if (run_.frame->site) run_.name_call(out);
    if (is_at_pattern_position) {
        calls.has_called = false;
        run_.interpreter->leave_pattern_position();
        if (!says_something) out.kind = Block::Kind::Comment;
        return Outcome::Block;
    }
    run_.frame->at_positions.reset();
    return says_something ? Outcome::Block : Outcome::Nothing;
}

/// A return that goes elsewhere leaves the positions that are left.
void ModalCalls::leave_pattern_positions(RunningProgram& of) {
    if (!of.at_positions) return;
    of.at_positions.reset();
    run_.interpreter->leave_pattern();
}

}  // namespace kadr::macro
