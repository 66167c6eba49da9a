#include "motion/spindle_angle.h"

#include <cmath>

namespace kadr::motion {

namespace {

/// Of a revolution: below it the rest of one is rounding.
constexpr double kSameAngle = 1e-9;

}  // namespace

void SpindleAngle::pass(const Segment& segment) {
    const CommandedSpindle& spindle = segment.spindle;
    if (!spindle.is_turning) return;
    const double begins = spindle.speed_at(path::start(segment.curve)[0]);
    const double ends = spindle.speed_at(path::end(segment.curve)[0]);
    turned_ += (begins + ends) / 2 * segment.duration;
    turned_ -= std::floor(turned_);
}

double SpindleAngle::time_to(double mark, double speed) const {
    double rest = mark - turned_;
    rest -= std::floor(rest);
    return rest < kSameAngle || rest > 1 - kSameAngle ? 0 : rest / speed;
}

}  // namespace kadr::motion
