// modal_positions.h — where blocks lead, and what makes a position unknown. For the room expand
// only.
#pragma once

#include "expand/modal.h"
#include "nc/effects.h"

namespace kadr::expand {

/// `G92`: the position gets coordinates by name.
void name_position(ModalState& state, const nc::FrameChange& change);
/// The tool stays where it is; its X is another number then.
void set_diameter(ModalState& state, bool is_on, bool was_known);
/// The zero point moves along one axis (1 is X), in a frame that turns along some.
void lose_corrected(ModalState& state, double axis);
/// Where the tool is along these axes, the control alone knows.
void lose_axes(ModalState& state, AxisMask axes);
/// Another system, and the control alone knows where the tool stands in it.
void lose_system(ModalState& state);
/// Data of the zero point that acts move it along the axes that they name: in a rotated or
/// tilted system along all of X, Y, Z.
void write_offset(ModalState& state, const nc::Block& block, const nc::Effect& effect);
/// Another zero point is another system.
void select_work_offset(ModalState& state, double number);
/// Where the words of the block have brought its axes, only the control knows.
void lose_words(ModalState& state, const nc::Block& block, const nc::Effect& effect);
/// A point of the machine: where it is in the program, the control knows.
void go_to_point(ModalState& state, const nc::Block& block, const nc::Effect& effect);
/// Where the words of a block lead.
void take_targets(ModalState& state, const nc::Block& block);

}  // namespace kadr::expand
