#include "machine/nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace kadr::machine {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// The value that differs by whole turns and is nearest.
double nearest_turn(double angle, double near) {
    return angle + kTurn * std::round((near - angle) / kTurn);
}

Vec3 nearest_turns(const Vec3& rotary, const Vec3& near) {
    Vec3 turned;
    for (Eigen::Index i = 0; i < 3; ++i) turned[i] = nearest_turn(rotary[i], near[i]);
    return turned;
}

}  // namespace

bool is_at_pole(const Chain& chain, const Vec3& direction) {
    if (!chain.orients()) return false;
    const double tilt = tilt_of(chain, direction);
    return std::min(tilt, std::numbers::pi - tilt) < kPoleWidth;
}

Vec3 joints_for(const Chain& chain, const Vec3& direction, const Vec3& near) {
    const auto solutions = solve(chain, direction);
    if (!solutions) return near;
    const bool from_pole = is_at_pole(chain, tool_vector(chain, near));
    const int configuration = configuration_of(chain, near);
    Vec3 best = near;
    double least = std::numeric_limits<double>::infinity();
    for (const Solution& found : *solutions) {
        const bool is_other = solutions->count > 1 && found.configuration != configuration;
        if (is_other && !from_pole && !found.is_pole) continue;
        const Vec3 rotary = found.is_pole ? at_pole(chain, found, near[0]).rotary : found.rotary;
        const Vec3 turned = nearest_turns(rotary, near);
        const double distance = (turned - near).head<2>().squaredNorm();
        if (distance >= least) continue;
        least = distance;
        best = turned;
    }
    best[2] = near[2];
    return best;
}

}  // namespace kadr::machine
