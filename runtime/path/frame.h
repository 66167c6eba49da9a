// frame.h — coordinate frames: shift, rotate, scale, mirror, one after the other.
//
// A frame maps a point of the inner (programmed) system to the outer one. Pure mathematics: which
// G-code makes which frame, and what deletes it, is the interpreter's matter (interp/frames.h).
#pragma once

#include <Eigen/Core>

#include "base/axes.h"
#include "base/result.h"
#include "path/command.h"

namespace kadr::path {

using Mat3 = Eigen::Matrix3d;

/// p_outer = linear · p + shift.
struct Frame {
    Mat3 linear = Mat3::Identity();
    Vec3 shift = Vec3::Zero();

    Vec3 operator()(const Vec3& point) const { return linear * point + shift; }
    /// A difference of two points, a vector from an arc to its centre: the shift does not act.
    Vec3 direction(const Vec3& vector) const { return linear * vector; }
};

/// The chain outer : inner. The right one acts on a point first, as additive frames
/// (ATRANS, AROT …) do in the system reached so far.
Frame operator*(const Frame& outer, const Frame& inner);

Frame translation(const Vec3& shift);

/// Whether the frame leaves every point where it is.
inline bool is_nothing(const Frame& frame) {
    return frame.linear == Mat3::Identity() && frame.shift == Vec3::Zero();
}

/// Angles about the axes X, Y, Z, rad.
struct AxisAngles {
    double x = 0;
    double y = 0;
    double z = 0;
};

/// Rotation by roll, pitch, yaw: about Z, then the new Y', then the new X''; R = Rz·Ry·Rx.
Frame rotation_rpy(const AxisAngles& angles);

/// Rotation by Euler angles: about Z, then the new X', then the new Z'' by the angle named `y`
/// (that is where the control's third word stands); R = Rz(z)·Rx(x)·Rz(y).
Frame rotation_euler(const AxisAngles& angles);

/// Rotation about the axis normal to the plane (Z, Y, X), counter-clockwise, rad.
Frame rotation_in_plane(Plane plane, double angle);

/// Factors along X, Y, Z.
Frame scaling(const Vec3& factors);

/// Changes the sign of the named linear axes.
Frame mirroring(AxisMask axes);

/// Unit vectors along the frame's axes: that of X, and of Y and Z what is square to those before.
Mat3 unit_axes(const Frame& frame);

enum class FrameFault { Singular };

/// The inverse. A frame that flattens space (a scale of zero) has none.
Result<Frame, FrameFault> inverse(const Frame& frame);

/// Roll, pitch, yaw of a pure rotation, rad: x and z in ±π, y in ±π/2. Where y is ±π/2, only the
/// sum of the other two is determined; x is 0 then.
AxisAngles rpy_of(const Mat3& rotation);

/// The three directions of a working plane: first and second axis, and the tool axis.
/// G17 X, Y, Z; G18 Z, X, Y; G19 Y, Z, X.
struct PlaneAxes {
    Axis first = Axis::X;
    Axis second = Axis::Y;
    Axis normal = Axis::Z;
};
constexpr PlaneAxes axes_of(Plane plane) {
    switch (plane) {
        case Plane::Xy: return {Axis::X, Axis::Y, Axis::Z};
        case Plane::Zx: return {Axis::Z, Axis::X, Axis::Y};
        case Plane::Yz: return {Axis::Y, Axis::Z, Axis::X};
    }
    return {};
}
/// Unit vector of a linear axis X, Y, Z.
inline Vec3 unit(Axis axis) { return Vec3::Unit(static_cast<Eigen::Index>(index(axis))); }

}  // namespace kadr::path
