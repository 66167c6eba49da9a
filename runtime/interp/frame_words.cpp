// frame_words.cpp — words of frames: work offsets, shifts, rotations, scales.
#include <algorithm>
#include <bit>

#include "base/assert.h"
#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/executor.h"
#include "interp/motions.h"
#include "interp/programmed_frames.h"
#include "interp/radius_compensation.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;

ProgrammedFrames::ProgrammedFrames(Channel& channel)
    : channel_(channel),
      work_offsets_(channel.state.frame.work_offsets),
      work_offset_(channel.state.frame.work_offset),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      comp_(channel.state.stage.comp),
      unplaced_(channel.state.motion.unplaced),
      axes_(channel.state.axes),
      modal_cycles_(channel.state.cycle.modal_cycles) {}

void ProgrammedFrames::select_work_offset(const Block& block, std::int64_t number) {
    if (number < 0 || number > rules_.work_offsets) {
        reporter_.report(diag::WorkOffsetUnknown, block, Function::WorkOffset).arg(number);
        return;
    }
    frames_.select_work_offset(work_offset_frame(number));
    select_stored_bases();
    work_offset_ = number;
    frame_changed();
}

/// Where the compensation lies within the frames, the cutter comes off its contour meanwhile.
void ProgrammedFrames::let_comp_go(const Block& block, const Invocation& invocation) {
    if (!comp_.is_on() || !rules_.comp_is_innermost || block.is_of_cycle()) return;
    if (nc::has_fact(invocation.function, nc::Fact::LetsCompGo))
        channel_.compensation.send_comp(
            {CompChange::Kind::LetGo, {}, modal_.plane, 0, position_.base(), {}, {}});
}

/// X, Y and Z of a function of frames, or all axes.
control::FrameWords ProgrammedFrames::words_of_frame(const Block& block,
                                                     const Invocation& invocation) const {
    constexpr std::size_t kX =
        parameter_of_all<"x", Function::Shift, Function::ShiftAdd, Function::ShiftAxes,
                         Function::ShiftAxesAdd, Function::ShiftCoarse, Function::ShiftFine,
                         Function::Mirror, Function::MirrorOff, Function::SetPosition,
                         Function::SetPositionAxes, Function::PositionReset>();
    const bool is_of_axes = nc::has_fact(invocation.function, nc::Fact::AllAxes);
    const double x_scale = rules_.shift_in_diameter ? axes_.word_scale[index(Axis::X)] : 1;
    return frame_words(block, invocation, kX, x_scale,
                       is_of_axes ? std::size_t{6} : std::size_t{3});
}

void ProgrammedFrames::change_frame(const Block& block, const Invocation& invocation,
                                    void (control::Frames::*change)(const control::FrameWords&)) {
    let_comp_go(block, invocation);
    const control::FrameWords words = words_of_frame(block, invocation);
    if (reporter_.has_ended() ||
        !require_named_axes(block, invocation, static_cast<AxisMask>(words.given)))
        return;
    (frames_.*change)(words);
    frame_changed();
}

Done ProgrammedFrames::require_no_places(const Block& block, const Invocation& invocation) {
    if (!modal_cycles_.modal.is_active) return kDone;
    reporter_.report(diag::SetPositionInCycle, block, invocation.function);
    return kFailed;
}

void ProgrammedFrames::set_position(const Block& block, const Invocation& invocation) {
    if (!require_no_places(block, invocation)) return;
    let_comp_go(block, invocation);
    const control::FrameWords words = words_of_frame(block, invocation);
    if (reporter_.has_ended() ||
        !require_named_axes(block, invocation, static_cast<AxisMask>(words.given)))
        return;
    frames_.set_position(words, position_.here(), position_.base());
    name_position(words);
}

void ProgrammedFrames::reset_position(const Block& block, const Invocation& invocation) {
    if (!require_no_places(block, invocation)) return;
    let_comp_go(block, invocation);
    if (reporter_.has_ended()) return;
    const control::FrameWords words = words_of_frame(block, invocation);
    frames_.reset_position(static_cast<AxisMask>(words.given));
    name_position(words);
}

/// The coordinates that the tool has now are those that the program has named.
void ProgrammedFrames::name_position(const control::FrameWords& words) {
    frame_changed();
    for (std::size_t i = 0; i < kAxes; ++i) {
        if (words.has(i)) position_.name(i);
    }
}

void ProgrammedFrames::rotate(const Block& block, const Invocation& invocation) {
    const double angle =
        block.argument(invocation, parameter_of<Function::Rotate>("angle"), rules_.rotation_angle);
    frames_.rotate(channel_.executor.plane_in(block), rad_from_deg(angle),
                   center_of(block, invocation));
    frame_changed();
}

void ProgrammedFrames::end_rotation() {
    if (rules_.place_behind_rotation && frames_.is_rotated())
        unplaced_ = channel_.motions.plane_mask();
    frames_.rotate_off();
    frame_changed();
}

void ProgrammedFrames::end_scaling() {
    frames_.scale_off();
    frame_changed();
}

void ProgrammedFrames::end_mirroring(const Block& block, const Invocation& invocation) {
    frames_.mirror_off(static_cast<AxisMask>(words_of_frame(block, invocation).given));
    frame_changed();
}

Done ProgrammedFrames::require_named_axes(const Block& block, const Invocation& invocation,
                                          AxisMask named) {
    const auto missing = static_cast<AxisMask>(named & ~(axes_.present | kLinearXYZ));
    if (missing == 0) return kDone;
    reporter_.report(diag::AxisMissing, block, invocation.function)
        .arg(kAxisNames[static_cast<std::size_t>(std::countr_zero(missing))]);
    return kFailed;
}

/// Center of a rotation or a scaling.
control::FrameWords ProgrammedFrames::center_of(const Block& block,
                                                const Invocation& invocation) const {
    constexpr std::size_t kX = parameter_of_all<"x", Function::Rotate, Function::Scale>();
    const double x_scale = rules_.shift_in_diameter ? axes_.word_scale[index(Axis::X)] : 1;
    control::FrameWords center = frame_words(block, invocation, kX, x_scale);
    for (std::size_t i = 0; rules_.frame_center_at_tool && i < 3; ++i) {
        if (!center.has(i)) center.values[i] = position_.here()[i];
    }
    return center;
}

void ProgrammedFrames::rotate_in_space(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kX =
        parameter_of_all<"x", Function::RotateSpace, Function::RotateSolid>();
    std::vector<control::AxisAndValue> angles;
    for (std::size_t i = 0; i < 3; ++i) {
        if (invocation.has(kX + i))
            angles.push_back({static_cast<Axis>(i), block.argument(invocation, kX + i)});
    }
    if (invocation.function == Function::RotateSpace) {
        frames_.turn(rotation_frame(angles).linear);
    } else if (angles.size() <= 2) {
        frames_.turn(solid_frame(angles).linear);
    } else {
        reporter_.report(diag::SolidAngles, block, invocation.function).arg(angles.size());
    }
    frame_changed();
}

void ProgrammedFrames::scale(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kFactors = parameter_of<Function::Scale>("fx");
    const double all = block.argument(invocation, parameter_of<Function::Scale>("factor"), 1);
    path::Vec3 factors;
    for (std::size_t i = 0; i < 3; ++i) {
        const double factor = block.argument(invocation, kFactors + i, all);
        if (factor == 0) {
            reporter_.report(diag::ScaleInvalid, block, Function::Scale).arg(factor);
            return;
        }
        factors[static_cast<Eigen::Index>(i)] = factor;
    }
    frames_.scale(factors, center_of(block, invocation));
    frame_changed();
}

void ProgrammedFrames::frame_changed() { position_.see_in(frames_); }

}  // namespace kadr::interp
