#include "process/pulses.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kadr::process {

namespace {

// A billionth of a squared speed is rounding.
constexpr double kRounding = 1e-9;

/// Time of a leg that goes to a middle speed, keeps it, and goes to its end speed.
double time_over(const PulseLeg& leg, double entry, double exit, double middle) {
    const double a = leg.acceleration;
    const double ramps = std::abs(middle - entry) + std::abs(middle - exit);
    const double distances =
        (std::abs(middle * middle - entry * entry) + std::abs(middle * middle - exit * exit)) /
        (2 * a);
    const double rest = std::max(0.0, leg.length - distances);
    return ramps / a + (rest > 0 ? rest / middle : 0);
}

double fastest_middle(const PulseLeg& leg, double entry, double exit) {
    const double reachable =
        std::sqrt(leg.acceleration * leg.length + (entry * entry + exit * exit) / 2);
    return std::max({std::min(leg.speed, reachable), entry, exit});
}

/// Squared; negative if the leg can come to a stand on its way.
double slowest_middle(const PulseLeg& leg, double entry, double exit) {
    return (entry * entry + exit * exit) / 2 - leg.acceleration * leg.length;
}

}  // namespace

std::optional<Durations> durations(const PulseLeg& leg, double entry, double exit) {
    const double change = std::abs(entry * entry - exit * exit);
    const double reach = 2 * leg.acceleration * leg.length;
    const double fastest = std::max(entry, exit);
    if (change > reach * (1 + kRounding) + 1e-12 * fastest * fastest) return std::nullopt;
    Durations range;
    range.least = time_over(leg, entry, exit, fastest_middle(leg, entry, exit));
    const double slowest = slowest_middle(leg, entry, exit);
    if (slowest <= 0) {
        range.most = std::numeric_limits<double>::infinity();
    } else {
        const double middle = std::min(std::sqrt(slowest), std::min(entry, exit));
        range.most = (entry + exit - 2 * middle) / leg.acceleration;
    }
    range.most = std::max(range.most, range.least);
    return range;
}

motion::Profile profile_lasting(const PulseLeg& leg, double entry, double exit, double duration) {
    // The time falls while the middle speed grows.
    double slow = std::sqrt(std::max(0.0, slowest_middle(leg, entry, exit)));
    double fast = fastest_middle(leg, entry, exit);
    for (int i = 0; i < 100 && slow < fast; ++i) {
        const double middle = (slow + fast) / 2;
        if (middle <= slow || middle >= fast) break;
        if (time_over(leg, entry, exit, middle) > duration) slow = middle;
        else fast = middle;
    }
    const double middle = fast;
    const double a = leg.acceleration;
    motion::Profile profile;
    profile.length = leg.length;
    profile.entry_speed = entry;
    profile.peak_speed = middle;
    profile.exit_speed = exit;
    // A ramp down before the middle, or up behind it, has the opposite sign.
    profile.acceleration = middle >= entry ? a : -a;
    profile.deceleration = middle >= exit ? a : -a;
    profile.accelerating = std::abs(middle - entry) / a;
    profile.braking = std::abs(middle - exit) / a;
    profile.cruising = std::max(0.0, duration - profile.accelerating - profile.braking);
    return profile;
}

}  // namespace kadr::process
