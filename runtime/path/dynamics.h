// dynamics.h — what a program says of how fast its motions may be run: parts of what it asks for
// otherwise, and of what the machine allows.
//
// What they mean for a motion is motion/'s matter.
#pragma once

#include "base/axes.h"

namespace kadr::path {

/// Every part is ≥ 0, 1 where nothing is said; those of axes are > 0.
struct Dynamics {
    double feed = 1;   // of F
    double rapid = 1;  // of the speed at rapid
    AxisValues velocity;
    AxisValues acceleration;
    AxisValues jerk;

    Dynamics() {
        velocity.fill(1);
        acceleration.fill(1);
        jerk.fill(1);
    }
    friend bool operator==(const Dynamics&, const Dynamics&) = default;
};

}  // namespace kadr::path
