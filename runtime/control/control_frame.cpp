#include "control/control_frame.h"

#include <cmath>

#include <Eigen/Geometry>

#include "base/assert.h"
#include "base/units.h"

namespace kadr::control {

using nc::FramePart;
using path::Frame;
using path::Mat3;
using path::Vec3;

namespace {

/// Directions that a frame has worked on count as square to each other within this.
constexpr double kSquare = 1e-9;

Vec3 linear_of(const AxisValues& values) { return {values[0], values[1], values[2]}; }

bool is_of_space(Axis axis) { return index(axis) < 3; }

Eigen::Index row(Axis axis) { return static_cast<Eigen::Index>(index(axis)); }

path::AxisAngles angles_rad(const Vec3& degrees) {
    return {rad_from_deg(degrees.x()), rad_from_deg(degrees.y()), rad_from_deg(degrees.z())};
}

Vec3 degrees_of(const Mat3& rotation) {
    const path::AxisAngles angles = path::rpy_of(rotation);
    return {deg_from_rad(angles.x), deg_from_rad(angles.y), deg_from_rad(angles.z)};
}

/// `values` taken through the linear part of a frame, axes besides X, Y, Z as they are.
AxisValues through(const Mat3& linear, const AxisValues& values) {
    AxisValues out = values;
    const Vec3 turned = linear * linear_of(values);
    for (std::size_t i = 0; i < 3; ++i) out[i] = turned[static_cast<Eigen::Index>(i)];
    return out;
}

}  // namespace

Frame ControlFrame::whole() const { return {linear, linear_of(shift) + linear_of(fine)}; }

// ---------------------------------------------------------------- constants

ControlFrame plain_frame(const Frame& of) {
    ControlFrame frame;
    for (std::size_t i = 0; i < 3; ++i) frame.shift[i] = of.shift[static_cast<Eigen::Index>(i)];
    frame.linear = of.linear;
    return frame;
}

ControlFrame shift_frame(std::span<const AxisAndValue> shifts) {
    ControlFrame frame;
    for (const auto& [axis, value] : shifts) frame.shift[index(axis)] = value;
    return frame;
}

ControlFrame fine_frame(std::span<const AxisAndValue> shifts) {
    ControlFrame frame;
    for (const auto& [axis, value] : shifts) frame.fine[index(axis)] = value;
    return frame;
}

ControlFrame rotation_frame(std::span<const AxisAndValue> angles) {
    Vec3 degrees = Vec3::Zero();
    for (const auto& [axis, value] : angles)
        if (is_of_space(axis)) degrees[row(axis)] = value;
    ControlFrame frame;
    frame.linear = path::rotation_rpy(angles_rad(degrees)).linear;
    return frame;
}

ControlFrame solid_frame(std::span<const AxisAndValue> angles) {
    if (angles.size() < 2) return rotation_frame(angles);
    KADR_ASSERT(angles.size() == 2, "a plane is given by two angles");
    // Round X, Y, Z the first of the two axes is the one that the other follows: its new direction
    // is rotated about the other axis; the other line about the first.
    AxisAndValue first = angles[0];
    AxisAndValue second = angles[1];
    if ((index(first.axis) + 1) % 3 != index(second.axis)) std::swap(first, second);
    const Vec3 u = path::unit(first.axis);
    const Vec3 v = path::unit(second.axis);
    const Vec3 kept = Eigen::AngleAxisd(rad_from_deg(second.value), v) * u;
    const Vec3 other = Eigen::AngleAxisd(rad_from_deg(first.value), u) * v;
    const Vec3 normal = kept.cross(other).normalized();
    const auto third = static_cast<Eigen::Index>(3 - index(first.axis) - index(second.axis));
    ControlFrame frame;
    frame.linear.col(row(first.axis)) = kept;
    frame.linear.col(third) = normal;
    frame.linear.col(row(second.axis)) = normal.cross(kept);
    return frame;
}

ControlFrame scale_frame(std::span<const AxisAndValue> factors) {
    ControlFrame frame;
    for (const auto& [axis, value] : factors)
        if (is_of_space(axis)) frame.linear(row(axis), row(axis)) = value;
    return frame;
}

ControlFrame mirror_frame(AxisMask axes) {
    ControlFrame frame;
    frame.mirrored = static_cast<AxisMask>(axes & kLinearXYZ);
    frame.linear = path::mirroring(frame.mirrored).linear;
    return frame;
}

// ---------------------------------------------------------------- chains

ControlFrame chain(const ControlFrame& outer, const ControlFrame& inner) {
    ControlFrame frame;
    const AxisValues shift = through(outer.linear, inner.shift);
    const AxisValues fine = through(outer.linear, inner.fine);
    for (std::size_t i = 0; i < kAxes; ++i) {
        frame.shift[i] = outer.shift[i] + shift[i];
        frame.fine[i] = outer.fine[i] + fine[i];
    }
    frame.linear = outer.linear * inner.linear;
    frame.mirrored = static_cast<AxisMask>(outer.mirrored ^ inner.mirrored);
    return frame;
}

ControlFrame inverse(const ControlFrame& frame) {
    ControlFrame back;
    back.linear = frame.linear.inverse();
    back.mirrored = frame.mirrored;
    const AxisValues shift = through(back.linear, frame.shift);
    const AxisValues fine = through(back.linear, frame.fine);
    for (std::size_t i = 0; i < kAxes; ++i) {
        back.shift[i] = 0 - shift[i];
        back.fine[i] = 0 - fine[i];
    }
    return back;
}

// ---------------------------------------------------------------- components

Mat3 FrameParts::linear() const {
    return rotation * scale.asDiagonal() * path::mirroring(mirrored).linear;
}

std::optional<FrameParts> parts_of(const ControlFrame& frame) {
    FrameParts parts;
    parts.mirrored = frame.mirrored;
    const Mat3 turned = frame.linear * path::mirroring(frame.mirrored).linear;
    for (Eigen::Index i = 0; i < 3; ++i) {
        parts.scale[i] = turned.col(i).norm();
        if (parts.scale[i] == 0) return std::nullopt;
        parts.rotation.col(i) = turned.col(i) / parts.scale[i];
    }
    // A negative factor turns the sense of the axes: it stays with X.
    if (parts.rotation.determinant() < 0) {
        parts.scale[0] = -parts.scale[0];
        parts.rotation.col(0) = -parts.rotation.col(0);
    }
    const Mat3 square = parts.rotation.transpose() * parts.rotation;
    if (!square.isIdentity(kSquare)) return std::nullopt;
    return parts;
}

std::optional<double> part_of(const ControlFrame& frame, FramePart part, Axis axis) {
    if (part == FramePart::Shift) return frame.shift[index(axis)];
    if (part == FramePart::Fine) return frame.fine[index(axis)];
    if (!is_of_space(axis)) return part == FramePart::Scale ? 1.0 : 0.0;
    if (part == FramePart::Mirror) return (frame.mirrored & bit(axis)) != 0 ? 1.0 : 0.0;
    const std::optional<FrameParts> parts = parts_of(frame);
    if (!parts) return std::nullopt;
    return part == FramePart::Scale ? parts->scale[row(axis)]
                                    : degrees_of(parts->rotation)[row(axis)];
}

bool set_part(ControlFrame& frame, FramePart part, Axis axis, double value) {
    if (part == FramePart::Shift || part == FramePart::Fine) {
        (part == FramePart::Shift ? frame.shift : frame.fine)[index(axis)] = value;
        return true;
    }
    if (!is_of_space(axis)) return false;
    std::optional<FrameParts> parts = parts_of(frame);
    if (!parts) return false;
    if (part == FramePart::Rotation) {
        Vec3 degrees = degrees_of(parts->rotation);
        degrees[row(axis)] = value;
        parts->rotation = path::rotation_rpy(angles_rad(degrees)).linear;
    } else if (part == FramePart::Scale) {
        if (value == 0) return false;
        parts->scale[row(axis)] = value;
    } else {
        const AxisMask others = static_cast<AxisMask>(parts->mirrored & ~bit(axis));
        parts->mirrored = value != 0 ? static_cast<AxisMask>(others | bit(axis)) : others;
    }
    frame.linear = parts->linear();
    frame.mirrored = parts->mirrored;
    return true;
}

}  // namespace kadr::control
