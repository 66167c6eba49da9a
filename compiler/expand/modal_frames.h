// modal_frames.h — what a change of the frame does to all that is known. For the room expand only.
#pragma once

#include "expand/modal.h"
#include "nc/effects.h"

namespace kadr::expand {

/// Another frame acts: the tool stays where it is, its position is another one.
void set_frame(ModalState& state, const control::ProgramFrame& next, SourceId source);
/// The frame becomes what its steps make.
void take_steps(ModalState& state, SourceId source);
/// One more step, in the frames that blocks have programmed and in those of their text alike.
template <typename Change>
void change_steps(ModalState& state, SourceId source, Change change) {
    state.frame.change(change);
    take_steps(state, source);
}
/// A factor that is none is the control's alarm, or a mirror.
void scale_frame(ModalState& state, const nc::FrameChange& change, SourceId source);
void rotate_frame(ModalState& state, const nc::FrameChange& change, SourceId source,
                  const nc::Rules& target);

}  // namespace kadr::expand
