// compensation_3d_parts.h — what both files of Compensation3d work with; nobody else.
#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include "interp/compensation_3d.h"
#include "path/linear.h"

namespace kadr::interp {

// Sine of the change of direction below which a corner is none.
inline constexpr double kSmooth = 1e-7;
// Distances shorter than this are none: rounding of frames, mm.
inline constexpr double kStill = 1e-9;

inline bool is_same_position(const AxisValues& a, const AxisValues& b) {
    for (std::size_t i = 0; i < kAxes; ++i) {
        if (std::abs(a[i] - b[i]) > path::kSamePoint) return false;
    }
    return true;
}

/// A command that is to be another one in the same block.
inline path::Command like(const path::Command& model, path::Op op) {
    path::Command command = model;
    path::Motion& motion = command.motion();
    motion.become(op);
    motion.exact_stop = false;
    motion.contact.reset();
    if (motion.orient_kind != path::OrientKind::None) motion.orient_plainly(path::OrientKind::Axes);
    return command;
}

/// Where one side ends and the next one begins.
struct Compensation3d::Corner {
    path::Vec3 point;
    path::Vec3 first;  // tangents
    path::Vec3 second;
    path::Vec3 tool;    // at the end of the first side …
    path::Vec3 behind;  // … and at the start of the second
    double turn = 0;    // of the tangents, rad, seen from the holder: positive to the left

    bool is_smooth() const { return first.dot(second) > 0 && first.cross(second).norm() < kSmooth; }
    path::Vec3 axis() const {
        const path::Vec3 across = first.cross(second);
        return across.norm() > kSmooth ? path::Vec3(across.normalized()) : tool;
    }
};

}  // namespace kadr::interp
