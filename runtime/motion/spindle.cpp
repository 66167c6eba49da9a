#include "motion/spindle.h"

#include <algorithm>
#include <numbers>

namespace kadr::motion {

double CommandedSpindle::speed_at(double radius) const {
    if (!is_turning) return 0;
    // On the axis itself every spindle without limit would run away; a micrometre bounds it.
    constexpr double kLeastRadius = 1e-3;
    double turns = speed;
    if (holds_cutting_speed) {
        turns = cutting_speed / (2 * std::numbers::pi * std::max(std::abs(radius), kLeastRadius));
        turns = std::max(turns, least);
        if (limit > 0) turns = std::min(turns, limit);
    }
    return machine_limit > 0 ? std::min(turns, machine_limit) : turns;
}

}  // namespace kadr::motion
