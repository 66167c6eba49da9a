#include "control/program_frame.h"

#include <cmath>

#include "base/degrees.h"

namespace kadr::control {

namespace {

struct RotationAxes {
    std::size_t first;
    std::size_t second;
};

RotationAxes axes_of(nc::Function plane) {
    switch (plane) {
        case nc::Function::PlaneZx: return {2, 0};
        case nc::Function::PlaneYz: return {1, 2};
        default: return {0, 1};
    }
}

std::array<double, 3> rotated(std::array<double, 3> v, double angle_deg, nc::Function plane) {
    if (angle_deg == 0) return v;
    const RotationAxes axes = axes_of(plane);
    const double c = cos_deg(angle_deg);
    const double s = sin_deg(angle_deg);
    const double a = v[axes.first];
    const double b = v[axes.second];
    v[axes.first] = c * a - s * b;
    v[axes.second] = s * a + c * b;
    return v;
}

std::array<double, 3> mirrored(std::array<double, 3> v, const std::array<bool, 3>& axes) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (axes[i]) v[i] = -v[i];
    }
    return v;
}

std::array<double, 3> scaled(std::array<double, 3> v, const std::array<double, 3>& by) {
    for (std::size_t i = 0; i < 3; ++i) v[i] *= by[i];
    return v;
}

std::array<double, 3> sum(std::array<double, 3> a, const std::array<double, 3>& b) {
    for (std::size_t i = 0; i < 3; ++i) a[i] += b[i];
    return a;
}

std::array<double, 3> difference(std::array<double, 3> a, const std::array<double, 3>& b) {
    for (std::size_t i = 0; i < 3; ++i) a[i] -= b[i];
    return a;
}

}  // namespace

bool ProgramFrame::is_identity() const { return shift == std::array<double, 3>{} && is_shift(); }

AxisMask ProgramFrame::plane_mask() const {
    const RotationAxes axes = axes_of(plane);
    return static_cast<AxisMask>(1u << axes.first | 1u << axes.second);
}

bool ProgramFrame::is_stretched(nc::Function in_plane) const {
    const RotationAxes axes = axes_of(in_plane);
    return scale[axes.first] != scale[axes.second];
}

std::array<double, 3> ProgramFrame::inner_center() const {
    std::array<double, 3> inner = mirrored(center, is_mirrored);
    // Beside an unequal scale the rotation is written outside of it.
    if (is_stretched(plane)) return inner;
    for (std::size_t i = 0; i < 3; ++i) inner[i] /= scale[i];
    return inner;
}

double ProgramFrame::inner_angle_deg() const {
    const RotationAxes axes = axes_of(plane);
    return is_mirrored[axes.first] != is_mirrored[axes.second] ? -angle_deg : angle_deg;
}

void ProgramFrame::move_shift(const std::array<double, 3>& by) {
    for (std::size_t i = 0; i < 3; ++i) {
        shift[i] += by[i];
        is_shifted[i] = is_shifted[i] || by[i] != 0;
    }
}

void ProgramFrame::add_shift(const std::array<double, 3>& by, const std::array<bool, 3>& given) {
    move_shift(rotated(scaled(mirrored(by, is_mirrored), scale), angle_deg, plane));
    for (std::size_t i = 0; i < 3; ++i) is_shifted[i] = is_shifted[i] || given[i];
}

FrameFormFault ProgramFrame::add_rotation(double by_deg, nc::Function in_plane,
                                          const std::array<double, 3>& about) {
    if (angle_deg != 0 && plane != in_plane) return FrameFormFault::Planes;
    if (is_stretched(in_plane)) return FrameFormFault::Stretched;
    // The new center c turns with the old rotation R about C: it lies at C + R(c − C), and there it
    // stays: shift' + c = shift + C + R(c − C).
    std::array<double, 3> next = scaled(mirrored(about, is_mirrored), scale);
    const RotationAxes axes = axes_of(in_plane);
    for (std::size_t i = 0; i < 3; ++i) {
        if (i != axes.first && i != axes.second) next[i] = 0;
    }
    const std::array<double, 3> point =
        sum(center, rotated(difference(next, center), angle_deg, plane));
    move_shift(difference(point, next));
    plane = in_plane;
    // A mirror of one axis of the plane turns the sense of what follows.
    const bool turns = is_mirrored[axes.first] != is_mirrored[axes.second];
    angle_deg = std::fmod(angle_deg + (turns ? -by_deg : by_deg), 360.0);
    center = angle_deg == 0 ? std::array<double, 3>{} : next;
    return FrameFormFault::None;
}

void ProgramFrame::add_scale(const std::array<double, 3>& by, const std::array<double, 3>& about) {
    const std::array<double, 3> point = scaled(mirrored(about, is_mirrored), scale);
    move_shift(rotated(difference(point, scaled(point, by)), angle_deg, plane));
    scale = scaled(scale, by);
}

void ProgramFrame::add_mirror(const std::array<bool, 3>& axes) {
    for (std::size_t i = 0; i < 3; ++i) is_mirrored[i] = is_mirrored[i] != axes[i];
}

void ProgramFrame::remove_mirror(std::uint32_t axes) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (axes == 0 || (axes >> i & 1u) != 0) is_mirrored[i] = false;
    }
}

bool ProgramFrame::differs(const ProgramFrame& other, std::size_t axis) const {
    if (shift[axis] != other.shift[axis] || scale[axis] != other.scale[axis] ||
        is_mirrored[axis] != other.is_mirrored[axis])
        return true;
    const auto turns = [axis](const ProgramFrame& frame) {
        const RotationAxes axes = axes_of(frame.plane);
        return frame.angle_deg != 0 && (axis == axes.first || axis == axes.second);
    };
    return !(*this == other) && (turns(*this) || turns(other));
}

KnownPoint change_frame(const KnownPoint& point, const ProgramFrame& from, const ProgramFrame& to) {
    if (from == to) return point;
    KnownPoint result = point;
    const std::array<double, 3> inner =
        difference(scaled(mirrored(point.value, from.is_mirrored), from.scale), from.center);
    const std::array<double, 3> outer =
        sum(sum(rotated(inner, from.angle_deg, from.plane), from.center),
            difference(from.shift, to.shift));
    result.value = sum(rotated(difference(outer, to.center), -to.angle_deg, to.plane), to.center);
    for (std::size_t i = 0; i < 3; ++i) result.value[i] /= to.scale[i];
    result.value = mirrored(result.value, to.is_mirrored);
    // A rotation mixes two axes: one of them alone tells nothing.
    const auto mix = [&](const ProgramFrame& frame) {
        if (frame.angle_deg == 0) return;
        const RotationAxes axes = axes_of(frame.plane);
        const bool both = result.is_known[axes.first] && result.is_known[axes.second];
        result.is_known[axes.first] = result.is_known[axes.second] = both;
    };
    if (from.angle_deg != to.angle_deg || from.plane != to.plane || from.shift != to.shift ||
        from.center != to.center) {
        mix(from);
        mix(to);
    }
    return result;
}

}  // namespace kadr::control
