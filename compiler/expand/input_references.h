// input_references.h — work offsets, machine coordinates and reference points of another control.
// For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// Machine coordinates as the control reaches them: at rapid whatever acts, or with the tool
/// length, which no other control does.
Done adapt_machine(Running& run, nc::Block& block, const sema::Plan& plan, std::uint32_t at);
/// On the control of the source a work offset acts from the start; the target has another one.
void say_offset(Running& run, const sema::Plan& plan, const Instruction& instruction,
                std::uint32_t at);
/// A return to the reference point that goes over no intermediate point, for a target without words
/// for the motion there.
void say_reference(Running& run, nc::Block& block);
/// A return over an intermediate point, for a target that goes straight: at rapid to that point,
/// then on.
void go_over_position(Running& run, SourceId source);

}  // namespace kadr::expand
