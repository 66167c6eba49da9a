// control_frame.h — a frame as the control's language holds it: shifts, rotation, scale, mirror.
//
// p_outer = (shift + fine) + rotation · scale · mirror · p. What a program assigns, chains and
// reads by component; where it acts is the matter of frames.h.
#pragma once

#include <optional>
#include <span>

#include "nc/language.h"
#include "path/frame.h"

namespace kadr::control {

struct ControlFrame {
    AxisValues shift{};  // mm, deg; of all axes
    AxisValues fine{};   // added to it
    path::Mat3 linear = path::Mat3::Identity();
    AxisMask mirrored = 0;  // axes whose sign `linear` has changed

    /// What acts on the linear axes X, Y, Z.
    path::Frame whole() const;
    bool is_shift() const { return linear == path::Mat3::Identity(); }
};

/// An axis and a value, as the functions of frames take them.
struct AxisAndValue {
    Axis axis = Axis::X;
    double value = 0;
};

/// A frame of space alone, with nothing of it as a fine part or a mirror.
ControlFrame plain_frame(const path::Frame& frame);
ControlFrame shift_frame(std::span<const AxisAndValue> shifts);  // mm, deg
ControlFrame fine_frame(std::span<const AxisAndValue> shifts);
/// Roll, pitch and yaw, deg, whatever their order: about Z, the new Y, the new X.
ControlFrame rotation_frame(std::span<const AxisAndValue> angles);
/// A plane by the angles, deg, of its lines with two coordinate planes: of X and Y the new X stays
/// in the old Z-X plane, and so on round; one angle is a rotation about its axis. Two at most.
ControlFrame solid_frame(std::span<const AxisAndValue> angles);
/// Factors, none of them 0.
ControlFrame scale_frame(std::span<const AxisAndValue> factors);
ControlFrame mirror_frame(AxisMask axes);

/// The right one acts on a point first.
ControlFrame chain(const ControlFrame& outer, const ControlFrame& inner);
/// The inverse.
ControlFrame inverse(const ControlFrame& frame);

/// Rotation, scale and mirror of a frame that has no shear.
struct FrameParts {
    path::Mat3 rotation = path::Mat3::Identity();
    path::Vec3 scale = path::Vec3::Ones();
    AxisMask mirrored = 0;

    path::Mat3 linear() const;
};
/// Nothing: a rotation behind unequal factors has made a shear.
std::optional<FrameParts> parts_of(const ControlFrame& frame);

/// One component: mm or deg; the angle of roll, pitch, yaw, deg; a factor; 1 if it is mirrored.
/// Nothing: the axis has none, or parts_of has none.
std::optional<double> part_of(const ControlFrame& frame, nc::FramePart part, Axis axis);
/// Sets it. False: as above, or a factor of 0.
bool set_part(ControlFrame& frame, nc::FramePart part, Axis axis, double value);

}  // namespace kadr::control
