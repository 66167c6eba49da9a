#include "expand/modal_frames.h"

#include <algorithm>

namespace kadr::expand {

using nc::Function;
using nc::Group;

namespace {

void note_drift(ModalState& state, std::size_t axis, bool is_known, double by) {
    // Frames move X by its radius.
    if (!is_known || (axis == 0 && state.is_diameter))
        state.drifts.lose(static_cast<AxisMask>(1u << axis));
    state.drifts.add(axis, by);
}

}  // namespace

void set_frame(ModalState& state, const control::ProgramFrame& next, SourceId source) {
    const control::ProgramFrame& frame = state.frame.now();
    control::KnownPoint point;
    for (std::size_t i = 0; i < 3; ++i) {
        point.value[i] = state.position[i];
        point.is_known[i] = state.position.knows(i);
    }
    if (state.is_diameter) point.value[0] /= 2;  // frames have radii
    control::KnownPoint moved = change_frame(point, frame, next);
    if (state.is_diameter) moved.value[0] *= 2;
    for (std::size_t i = 0; i < 3; ++i) {
        if (next.differs(frame, i)) {
            note_drift(state, i, point.is_known[i] && moved.is_known[i],
                       moved.value[i] - state.position[i]);
        }
        state.position.restate(i, moved.value[i], moved.is_known[i]);
    }
    if (state.lost.has(sema::kFrameBit)) state.position.lose(kLinearXYZ);
    // Where a program turns and does not tell whether its X is a diameter, the control knows alone
    // what a frame makes of it.
    const bool may_be_diameter =
        state[Group::Diameter] == Function::None && state[Group::Plane] == Function::PlaneZx;
    if (may_be_diameter && next.differs(frame, 0)) state.position.lose(bit(Axis::X));
    state.owed.owe_position();
    // A control that has its rotation innermost writes it again behind every other change.
    const bool turns = next.angle_deg != 0 || frame.angle_deg != 0;
    if (turns && next != frame)
        state.drifts.turn((next.angle_deg != 0 ? next : frame).plane_mask());
    state.frame.set(next, source);
}

void take_steps(ModalState& state, SourceId source) {
    const control::ProgramFrame next = state.frame.made();
    if (state.frame.has_fault()) state.position.lose(kLinearXYZ);
    set_frame(state, next, source);
}

void scale_frame(ModalState& state, const nc::FrameChange& change, SourceId source) {
    if (std::ranges::any_of(change.factors, [](double factor) { return !(factor > 0); })) {
        state.position.lose(kLinearXYZ);
        return;
    }
    change_steps(state, source, [&](auto& all) { all.scale(change.factors, change.values); });
}

void rotate_frame(ModalState& state, const nc::FrameChange& change, SourceId source,
                  const nc::Rules& target) {
    state.frame.rotate(change.angle_deg, state[Group::Plane], change.values,
                       target.rotate_outside_scale);
    take_steps(state, source);
}

}  // namespace kadr::expand
