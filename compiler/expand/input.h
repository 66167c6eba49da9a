// input.h — blocks written in the manner of another control. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// Whether a function of the plan has no word in the target, but a frame does the same.
bool needs_frame(const Running& run, const sema::Plan& plan);
/// Whether one of its functions is written as the whole frame that it leaves.
bool needs_frame(const Running& run, const sema::Plan& plan, std::size_t invocation);
/// The frame that the functions leave is written by shift, rotation and mirrors; what else stands
/// in the block comes behind it.
Done emit_frame(Running& run, const sema::Plan& plan, const Instruction& instruction,
                const Slot* registers, std::uint32_t at);
/// Arguments are in the block; the modal state is that before it.
Done adapt(Running& run, nc::Block& block, const sema::Plan& plan, std::uint32_t at);
/// The words of a source mean this block in some planes only: one of them acts.
Done require_plane_of_source(Running& run, const sema::Plan& plan, std::uint32_t at);
/// On the control of the source a work offset acts from the start; the target has another one.
void say_offset(Running& run, const sema::Plan& plan, const Instruction& instruction,
                std::uint32_t at);
/// The block may move, with the tool length and the feed that act.
Done check_move(Running& run, const nc::Block& block, std::uint32_t at);
/// An increment behind a change of the frame: some controls travel the change as well.
Done adapt_increments(Running& run, nc::Block& block, const sema::Plan& plan, std::uint32_t at);
/// An arc all of whose words are in `plan` and that names no end.
bool is_whole_circle(const Running& run, const sema::Plan& plan);
/// What names no axis as the first motion behind a rotation, a full circle or a cycle, gets a block
/// before it that does: to where the tool stands already.
Done write_positions(Running& run, SourceId source, std::uint32_t at, unsigned depth);
/// What stands under incremental dimensions for the program does so for the text again.
void return_to_increments(Running& run, nc::Block& block);
/// A return to the reference point that goes over no intermediate point, for a target without words
/// for the motion there.
void say_reference(Running& run, nc::Block& block);
/// A return over an intermediate point, for a target that goes straight: at rapid to that point,
/// then on.
void go_over_position(Running& run, SourceId source);
/// The common core has the words of both ways: those that the target has not are written in its
/// own.
Done take_core_offsets(Running& run, nc::Block& block, std::uint32_t at);

}  // namespace kadr::expand
