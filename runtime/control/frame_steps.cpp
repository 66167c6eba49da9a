#include "control/frame_steps.h"

#include <algorithm>
#include <cmath>

namespace kadr::control {

void FrameSteps::shift(const std::array<double, 3>& by, const std::array<bool, 3>& given) {
    steps_.clear();
    shift_add(by, given);
}

void FrameSteps::shift_add(const std::array<double, 3>& by, const std::array<bool, 3>& given) {
    steps_.push_back({Step::Kind::Shift, by, given, {}, 0, nc::Function::PlaneXy});
}

void FrameSteps::rotate(double angle_deg, nc::Function plane, const std::array<double, 3>& about) {
    steps_.push_back({Step::Kind::Rotation, about, {}, {}, angle_deg, plane});
}

void FrameSteps::rotate_scaled(double angle_deg, nc::Function plane,
                               const std::array<double, 3>& about) {
    const auto scale = std::ranges::find(steps_, Step::Kind::Scale, &Step::kind);
    if (scale == steps_.end()) return rotate(angle_deg, plane, about);
    FrameSteps inner;
    inner.steps_.assign(scale, steps_.end());
    const ProgramFrame frame = inner.frame().frame;
    KnownPoint point{about, {true, true, true}};
    point = change_frame(point, frame, {});
    steps_.insert(scale, {Step::Kind::Rotation, point.value, {}, {}, angle_deg, plane});
}

void FrameSteps::scale(const std::array<double, 3>& by, const std::array<double, 3>& about) {
    steps_.push_back({Step::Kind::Scale, about, {}, by, 0, nc::Function::PlaneXy});
}

void FrameSteps::mirror(const std::array<bool, 3>& axes) {
    steps_.push_back({Step::Kind::Mirror, {}, axes, {}, 0, nc::Function::PlaneXy});
}

void FrameSteps::mirror_off(std::uint32_t axes) {
    for (Step& step : steps_) {
        if (step.kind != Step::Kind::Mirror) continue;
        for (std::size_t i = 0; i < 3; ++i)
            if (axes == 0 || (axes >> i & 1u) != 0) step.axes[i] = false;
    }
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
    Made made;
    for (const Step& step : steps_) {
        switch (step.kind) {
            case Step::Kind::Shift: made.frame.add_shift(step.values, step.axes); break;
            case Step::Kind::Scale: made.frame.add_scale(step.factors, step.values); break;
            case Step::Kind::Mirror: made.frame.add_mirror(step.axes); break;
            case Step::Kind::Rotation: {
                const FrameFault fault =
                    made.frame.add_rotation(step.angle_deg, step.plane, step.values);
                if (made.fault == FrameFault::None) made.fault = fault;
                break;
            }
        }
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
