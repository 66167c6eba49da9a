// input_frames.h — frames of another control, written as the target has them. For the room expand
// only.
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
/// The function may stand where the present frame acts: the control takes mirror, scale
/// and rotation in this order, and inside them nothing before them.
Done require_free_frame(Running& run, nc::Function function, std::uint32_t at);
/// The axes that are not named keep the shift that they have.
void adapt_shift(Running& run, nc::Block& block, nc::Invocation& shift);
/// A centre that is not named is where the tool stands.
Done complete_center(Running& run, nc::Block& block, nc::Invocation& invocation, std::uint32_t at);

}  // namespace kadr::expand
