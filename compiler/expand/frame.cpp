#include "expand/frame.h"

#include "sema/arithmetic.h"

namespace kadr::expand {

namespace {

struct PlaneAxes {
    std::size_t first;
    std::size_t second;
};

PlaneAxes axes_of(nc::Function plane) {
    switch (plane) {
        case nc::Function::PlaneZx: return {2, 0};
        case nc::Function::PlaneYz: return {1, 2};
        default: return {0, 1};
    }
}

std::array<double, 3> rotated(std::array<double, 3> v, double angle_deg, nc::Function plane) {
    if (angle_deg == 0) return v;
    const PlaneAxes axes = axes_of(plane);
    const double c = sema::cos_deg(angle_deg);
    const double s = sema::sin_deg(angle_deg);
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

}  // namespace

bool ProgramFrame::is_identity() const {
    return shift == std::array<double, 3>{} && angle_deg == 0 && !has_mirror();
}

void ProgramFrame::add_shift(const std::array<double, 3>& by, const std::array<bool, 3>& given) {
    const std::array<double, 3> outer = rotated(mirrored(by, is_mirrored), angle_deg, plane);
    for (std::size_t i = 0; i < 3; ++i) {
        shift[i] += outer[i];
        is_shifted[i] = is_shifted[i] || given[i] || outer[i] != 0;
    }
}

bool ProgramFrame::add_rotation(double by_deg, nc::Function in_plane) {
    if (angle_deg != 0 && plane != in_plane) return false;
    plane = in_plane;
    angle_deg = std::fmod(angle_deg + (turns_sense() ? -by_deg : by_deg), 360.0);
    return true;
}

/// A mirror of one axis of the plane turns the sense of what follows.
bool ProgramFrame::turns_sense() const {
    const PlaneAxes axes = axes_of(plane);
    return is_mirrored[axes.first] != is_mirrored[axes.second];
}

double ProgramFrame::angle_behind_mirrors_deg() const {
    return turns_sense() ? -angle_deg : angle_deg;
}

bool ProgramFrame::add_mirror(const std::array<bool, 3>& axes) {
    for (std::size_t i = 0; i < 3; ++i) is_mirrored[i] = is_mirrored[i] != axes[i];
    return true;
}

KnownPoint change_frame(const KnownPoint& point, const ProgramFrame& from, const ProgramFrame& to) {
    if (from == to) return point;
    KnownPoint result = point;
    std::array<double, 3> outer =
        rotated(mirrored(point.value, from.is_mirrored), from.angle_deg, from.plane);
    for (std::size_t i = 0; i < 3; ++i) outer[i] += from.shift[i] - to.shift[i];
    result.value = mirrored(rotated(outer, -to.angle_deg, to.plane), to.is_mirrored);
    // A rotation mixes two axes: one of them alone says nothing.
    const auto mix = [&](const ProgramFrame& frame) {
        if (frame.angle_deg == 0) return;
        const PlaneAxes axes = axes_of(frame.plane);
        const bool both = result.is_known[axes.first] && result.is_known[axes.second];
        result.is_known[axes.first] = result.is_known[axes.second] = both;
    };
    if (from.angle_deg != to.angle_deg || from.plane != to.plane || from.shift != to.shift) {
        mix(from);
        mix(to);
    }
    return result;
}

}  // namespace kadr::expand
