// virtual_axes.h — coordinates of a workpiece that a rotary axis turns, and where the real axes
// are.
//
// A path on the end of a turned part, on its cylinder or across an inclined axis is programmed in
// the coordinates of a machine that had one more linear axis. Here stands what both have to do with
// each other; no limits and no time (motion/), no words (interp/).
//
//   Polar     x + i·y = center + side·radius·e^{iφ}: X goes along the radius, C turns by φ
//   Cylinder  what lies around the cylinder, at its radius, is the angle of the rotary axis
//   Inclined  the axis X stands at an angle to the normal of Z; Z makes up for it
//
// source  geometry; F 3.6, S 7.1
#pragma once

#include <cstdint>

#include "base/axes.h"
#include "path/vec3.h"

namespace kadr::path {

enum class VirtualKind : std::uint8_t { None, Polar, Cylinder, Inclined };

/// Nearer to the centre of polar coordinates the angle of the rotary axis has no meaning, mm.
inline constexpr double kPoleRadius = 1e-6;

struct VirtualAxes {
    VirtualKind kind = VirtualKind::None;
    Axis rotary = Axis::C;  // Polar: C. Cylinder: C along Z, A along X, B along Y
    std::int8_t side = 1;   // Polar: of the centre on which the tool stands along X, 1 or -1
    std::int8_t sign = 1;   // Polar: -1 if the rotary axis turns the tool clockwise about Z
    double size = 0;        // Cylinder: radius, mm, > 0; Inclined: angle, rad, |angle| < π/2
    double zero = 0;        // where the rotary axis stands at the angle 0, rad
    double center_x = 0;    // Polar: of the rotary axis, mm
    double center_y = 0;    // Polar: likewise; Cylinder: the coordinate around at the angle 0
    double standing = 0;    // Polar, Cylinder: where the tip stands along the real axis, mm

    bool is_on() const { return kind != VirtualKind::None; }
    /// Whether a rotary axis follows the path.
    bool turns() const { return kind == VirtualKind::Polar || kind == VirtualKind::Cylinder; }
    /// The coordinate that no linear axis of the machine moves; of an inclined axis there is none.
    Axis virtual_axis() const {
        return kind == VirtualKind::Cylinder && rotary == Axis::B ? Axis::X : Axis::Y;
    }
    friend bool operator==(const VirtualAxes&, const VirtualAxes&) = default;
};

/// Where the rotary axis stands, rad, for a tip in the virtual coordinates: of all turns the one
/// nearest to `near`, and `near` itself in the centre of polar coordinates.
double rotary_at(const VirtualAxes& axes, const Vec3& tip, double near);

/// … of a direction away from the polar centre.
double rotary_towards(const VirtualAxes& axes, const Vec3& out, double near);

/// Distance from the polar centre, mm.
double radius_at(const VirtualAxes& axes, const Vec3& tip);

/// Where X, Y, Z of the machine hold the tip.
Vec3 real_position(const VirtualAxes& axes, const Vec3& tip);

/// The other way round, for the rotary axis at `rotary`, rad.
Vec3 virtual_position(const VirtualAxes& axes, const Vec3& real, double rotary);

/// Whether the point is the polar centre.
bool is_at_pole(const VirtualAxes& axes, const Vec3& tip);

}  // namespace kadr::path
