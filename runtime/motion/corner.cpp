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

// The second difference of setpoints, divided by the tick T squared, is the acceleration averaged
// with a triangle of the width 2T. A jump J·T at a distance x·T from its middle counts J·(1 − x);
// with y = 1 − x the ramp R of the nearer side counts R·(1 − y²/2), that of the other side r·y²/2.
// J·y + R − (R − r)·y²/2 is greatest at y = J/(R − r), or at y = 1 if that is beyond.
double corner_acceleration(double before, double behind, double jump) {
    const double more = std::max(before, behind);
    const double difference = std::abs(before - behind);
    if (jump >= difference) return jump + (before + behind) / 2;
    return more + jump * jump / (2 * difference);
}

double jump_share(double before, double behind, bool is_alone, double most) {
    const double more = std::min(1.0, std::max(before, behind));
    // Corners nearer to each other share the triangle: their jumps add up to one of full weight.
    if (!is_alone) return most - more;
    const double difference = more - std::min({1.0, before, behind});
    const double at_middle = most - (more + more - difference) / 2;
    return at_middle >= difference ? at_middle : std::sqrt(2 * difference * (most - more));
}

double ramp_share(double before, double behind, double jump, double most) {
    if (corner_acceleration(before, behind, jump) <= most) return 1;
    if (jump >= most) return 0;
    // corner_acceleration of ρ·before and ρ·behind is `most`: linear in ρ while the jump exceeds
    // their difference, else a quadratic equation.
    const double difference = std::abs(before - behind);
    const double linear = 2 * (most - jump) / (before + behind);
    if (jump >= linear * difference) return std::min(1.0, linear);
    const double more = std::max(before, behind);
    const double root = std::max(0.0, most * most - 2 * more * jump * jump / difference);
    return std::min(1.0, (most + std::sqrt(root)) / (2 * more));
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
