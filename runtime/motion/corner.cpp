#include "motion/corner.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kadr::motion {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Directions of coordinates with three decimals on blocks of some millimetres differ by 1e-4 and
// more where there is a corner; below 1e-9 rad it is the rounding of the subtraction.
constexpr double kStraight = 1e-9;

}  // namespace

double axis_jump_speed(std::span<const double> in, std::span<const double> out,
                       std::span<const double> jump) {
    double worst = 0;  // 1/speed
    for (std::size_t i = 0; i < in.size(); ++i) {
        const double change = std::abs(out[i] - in[i]);
        if (change > kStraight) worst = std::max(worst, change / jump[i]);
    }
    return worst > 0 ? 1 / worst : kInfinity;
}

double junction_deviation_speed(const path::Vec3& in, const path::Vec3& out, double deviation,
                                double acceleration) {
    // θ is the inner angle of the corner: π straight on, 0 turning back. A circle of radius r that
    // touches both legs misses the corner by r·(1/sin(θ/2) − 1); v² = acceleration·r.
    const double sin_half = std::sqrt(std::max(0.0, 0.5 * (1 + in.dot(out))));
    // 1 − sin(θ/2) ≈ (turn)²/8 for a small turn, so the same angle as above ends here squared.
    if (1 - sin_half < kStraight * kStraight / 8 + 1e-16) return kInfinity;
    return std::sqrt(acceleration * deviation * sin_half / (1 - sin_half));
}

}  // namespace kadr::motion
