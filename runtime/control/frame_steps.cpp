#include "control/frame_steps.h"

#include <algorithm>
#include <cmath>

namespace kadr::control {

namespace {

/// The inner frame goes on in the system of the outer one.
FrameFormFault add(ProgramFrame& outer, const ProgramFrame& inner) {
    outer.add_shift(inner.shift, inner.is_shifted);
    FrameFormFault fault = FrameFormFault::None;
    if (inner.angle_deg != 0)
        fault = outer.add_rotation(inner.angle_deg, inner.plane, inner.center);
    if (inner.has_scale()) outer.add_scale(inner.scale, {});
    if (inner.has_mirror()) outer.add_mirror(inner.is_mirrored);
    return fault;
}

}  // namespace

/// The frame of the last step, which is of this kind.
ProgramFrame& FrameSteps::last(Step::Kind kind) {
    if (steps_.empty() || steps_.back().kind != kind) {
        steps_.push_back({kind, {}});
        if (steps_.size() > kMaxSteps) join_oldest();
    }
    return steps_.back().frame;
}

void FrameSteps::join_oldest() {
    ProgramFrame both = steps_[0].frame;
    if (add(both, steps_[1].frame) != FrameFormFault::None)
        return;  // there is no such frame anyway
    steps_[1].frame = both;
    steps_.erase(steps_.begin());
}

void FrameSteps::shift(const std::array<double, 3>& by, const std::array<bool, 3>& given) {
    steps_.clear();
    shift_ = {};
    shift_.add_shift(by, given);
}

void FrameSteps::shift_add(const std::array<double, 3>& by, const std::array<bool, 3>& given) {
    (steps_.empty() ? shift_ : last(Step::Kind::Shift)).add_shift(by, given);
}

void FrameSteps::rotate(double angle_deg, nc::Function plane, const std::array<double, 3>& about) {
    ProgramFrame& frame = last(Step::Kind::Rotation);
    if (frame.add_rotation(angle_deg, plane, about) == FrameFormFault::None) return;
    ProgramFrame other;
    other.add_rotation(angle_deg, plane, about);
    steps_.push_back({Step::Kind::Rotation, other});
}

void FrameSteps::rotate_scaled(double angle_deg, nc::Function plane,
                               const std::array<double, 3>& about) {
    const auto scale = std::ranges::find(steps_, Step::Kind::Scale, &Step::kind);
    if (scale == steps_.end()) return rotate(angle_deg, plane, about);
    FrameSteps inner;
    inner.steps_.assign(scale, steps_.end());
    const KnownPoint point =
        change_frame({about, {true, true, true}}, inner.frame().frame, ProgramFrame{});
    ProgramFrame rotation;
    rotation.add_rotation(angle_deg, plane, point.value);
    steps_.insert(scale, {Step::Kind::Rotation, rotation});
}

void FrameSteps::scale(const std::array<double, 3>& by, const std::array<double, 3>& about) {
    last(Step::Kind::Scale).add_scale(by, about);
}

void FrameSteps::mirror(const std::array<bool, 3>& axes, bool replaces) {
    for (std::size_t i = 0; replaces && i < axes.size(); ++i) {
        if (axes[i]) mirror_off(1u << i);
    }
    last(Step::Kind::Mirror).add_mirror(axes);
}

void FrameSteps::mirror_off(std::uint32_t axes) {
    for (Step& step : steps_)
        if (step.kind == Step::Kind::Mirror) step.frame.remove_mirror(axes);
}

void FrameSteps::say(const ProgramFrame& frame) {
    shift(frame.shift, frame.is_shifted);
    if (frame.has_mirror()) mirror(frame.is_mirrored);
    const bool is_outside = frame.is_stretched(frame.plane);
    const auto say_rotation = [&] {
        if (frame.angle_deg != 0)
            rotate(frame.inner_angle_deg(), frame.plane, frame.inner_center());
    };
    if (is_outside) say_rotation();
    if (frame.has_scale()) scale(frame.scale, {});
    if (!is_outside) say_rotation();
}

void FrameSteps::erase(Step::Kind kind) {
    std::erase_if(steps_, [kind](const Step& step) { return step.kind == kind; });
}

FrameSteps::Made FrameSteps::frame() const {
    Made made{shift_, FrameFormFault::None};
    for (const Step& step : steps_) {
        const FrameFormFault fault = add(made.frame, step.frame);
        if (made.fault == FrameFormFault::None) made.fault = fault;
    }
    return made;
}

bool is_same(const ProgramFrame& a, const ProgramFrame& b) {
    constexpr double kRounding = 1e-9;  // mm, degrees, parts of a size
    const auto close = [](double x, double y) { return std::fabs(x - y) <= kRounding; };
    const auto are_close = [&](const std::array<double, 3>& x, const std::array<double, 3>& y) {
        return std::ranges::equal(x, y, close);
    };
    const bool turns_alike =
        close(a.angle_deg, b.angle_deg) &&
        (close(a.angle_deg, 0) || (a.plane == b.plane && are_close(a.center, b.center)));
    return turns_alike && are_close(a.shift, b.shift) && are_close(a.scale, b.scale) &&
           a.is_mirrored == b.is_mirrored;
}

}  // namespace kadr::control
