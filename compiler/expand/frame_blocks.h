// frame_blocks.h — frames as blocks, and where the tool is in a new one. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// The values of frames that a block has itself: mirrors that all end, factors that are some, and
/// an angle of less than a revolution, which is all that controls take (F 3.7 G68: ±360).
Done settle_frame(Running& run, nc::Block& block, std::uint32_t at);
/// Executes ChangeFrame: the frame of a `with`.
Done change_frame(Running& run, const Instruction& instruction, const Slot* registers,
                  std::uint32_t at);
/// No frame of the language is what the steps make.
Done refuse_frame(Running& run, control::FrameFormFault why, std::uint32_t at);
/// The writer needs to know where the tool is in the new frame: for arcs, for F of helices, and
/// where the control has no words for coordinates and distances beside each other.
void write_position(Running& run, const sema::Plan& plan, const sema::Instruction& instruction,
                    std::uint32_t at);
/// Frames have radii in the language; a control may take them as what X is: X of them times a
/// factor.
void scale_frame_x(const Running& run, nc::Block& block, double factor);
/// Writes the change from the present frame to another one in functions that every control has: the
/// whole shift, which deletes all else, then mirrors, scale and rotation anew, in the order in
/// which FANUC takes them. An unequal scale stands inside the rotation.
void write_frame(Running& run, const control::ProgramFrame& next, SourceId source, std::uint32_t at,
                 unsigned depth);
/// The whole frame of the program, where the control may have taken it off: written on top of
/// itself it is the same. S 7.1.
void put_frame_again(Running& run, SourceId source, std::uint32_t at, unsigned depth);

}  // namespace kadr::expand
