// rotated_command.h — positions and motions in a system that is rotated against the base system, as
// a tilted working plane is.
#pragma once

#include "path/command.h"
#include "path/frame.h"
#include "path/linear.h"

namespace kadr::interp {

inline void turn(const path::Mat3& by, AxisValues& values) {
    path::set_linear(values, by * path::linear(values));
}

/// All that a motion has of positions and directions; of a parametric curve's shape nothing.
inline void turn(const path::Mat3& by, path::Motion& motion) {
    turn(by, motion.to);
    motion.direction = by * motion.direction;
    if (motion.orient_details) {
        for (path::Vec3* of_turn : {&motion.orient_details->from, &motion.orient_details->axis})
            *of_turn = by * *of_turn;
    }
    const auto turn_circle = [&](auto& circle) {
        circle.center = by * circle.center;
        circle.normal = by * circle.normal;
    };
    switch (motion.op()) {
        case path::Op::Arc: return turn_circle(motion.arc());
        case path::Op::Involute: return turn_circle(motion.involute());
        case path::Op::Spline:
            for (path::Vec3& inner : motion.spline().inner) inner = by * inner;
            return;
        default: return;
    }
}

}  // namespace kadr::interp
