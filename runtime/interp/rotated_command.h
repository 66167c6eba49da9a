// rotated_command.h — places and commands in a system that is turned against the base system, as a
// tilted working plane is.
#pragma once

#include "path/command.h"
#include "path/frame.h"
#include "path/linear.h"

namespace kadr::interp {

inline void turn(const path::Mat3& by, AxisValues& values) {
    path::set_linear(values, by * path::linear(values));
}

/// All that a command says of places and directions; of a curve's shape nothing.
inline void turn(const path::Mat3& by, path::Command& command) {
    turn(by, command.to);
    command.center = by * command.center;
    for (path::Vec3& inner : command.spline.inner) inner = by * inner;
    for (path::Vec3* direction :
         {&command.normal, &command.direction, &command.turn_from, &command.turn_axis})
        *direction = by * *direction;
}

}  // namespace kadr::interp
