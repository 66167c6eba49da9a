// point_to_point.h — the least time of a motion from rest to rest under limits of velocity,
// acceleration and jerk, in closed form, and random motions to hold the planner against it.
//
// Knows nothing of the planner: what stands here is what its times are compared with, by a test and
// by bench_point_to_point.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>

#include "motion/pipeline.h"

namespace kadr::bench {

/// Limits along one coordinate, all > 0 and finite.
struct ThirdOrder {
    double velocity = 0;      // mm/s
    double acceleration = 0;  // mm/s²
    double jerk = 0;          // mm/s³
};

/// The least time, s, for a distance ≥ 0, mm. The jerk is always at its limit or the acceleration
/// or the speed is; which of them are reached tells the four cases.
///
/// source       reference motion §2.3, both ramps alike
inline double least_time(double distance, const ThirdOrder& limits) {
    const double v = limits.velocity;
    const double a = limits.acceleration;
    const double j = limits.jerk;
    if (v * j < a * a) {  // the speed is reached before the acceleration is
        const double whole = 2 * v * std::sqrt(v / j);
        if (distance >= whole) return distance / v + 2 * std::sqrt(v / j);
        return 4 * std::cbrt(distance / (2 * j));
    }
    if (distance >= v * (v / a + a / j)) return distance / v + v / a + a / j;
    if (distance <= 2 * a * a * a / (j * j)) return 4 * std::cbrt(distance / (2 * j));
    const double rise = a * a / j;
    const double peak = (std::sqrt(rise * rise + 4 * a * distance) - rise) / 2;
    return 2 * (peak / a + a / j);
}

/// A motion of three axes by `way`, each with its own limits.
struct Transfer {
    std::array<double, 3> delta{};  // mm, either sign
    std::array<ThirdOrder, 3> axes;

    double length() const { return std::hypot(delta[0], delta[1], delta[2]); }
};

/// The least time on the straight line: what each axis allows of the path, all the way.
inline double least_time_straight(const Transfer& transfer) {
    const double length = transfer.length();
    ThirdOrder path{1e300, 1e300, 1e300};
    for (std::size_t i = 0; i < 3; ++i) {
        const double share = std::abs(transfer.delta[i]) / length;
        if (share == 0) continue;
        const ThirdOrder& axis = transfer.axes[i];
        path.velocity = std::min(path.velocity, axis.velocity / share);
        path.acceleration = std::min(path.acceleration, axis.acceleration / share);
        path.jerk = std::min(path.jerk, axis.jerk / share);
    }
    return least_time(length, path);
}

/// The least time if the way between does not matter: all axes arrive with the slowest one.
inline double least_time_free(const Transfer& transfer) {
    double time = 0;
    for (std::size_t i = 0; i < 3; ++i)
        time = std::max(time, least_time(std::abs(transfer.delta[i]), transfer.axes[i]));
    return time;
}

/// Random transfers of machine tools: 1 µm to 2 m, 5 to 120 m/min, 0.5 to 20 m/s², 5 to 1000 m/s³.
class Transfers {
  public:
    explicit Transfers(std::uint32_t seed) : random_(seed) {}

    Transfer next(std::size_t axes) {
        Transfer transfer;
        for (std::size_t i = 0; i < 3; ++i) {
            transfer.axes[i] = {between(80, 2000), between(500, 20'000), between(5000, 1e6)};
            if (i >= axes) continue;
            const double sign = random_() % 2 == 0 ? 1 : -1;
            transfer.delta[i] = sign * between(1e-3, 2000);
        }
        return transfer;
    }

  private:
    /// Evenly over the powers.
    double between(double low, double high) {
        const double share = static_cast<double>(random_()) * 0x1p-32;
        return low * std::pow(high / low, share);
    }
    std::mt19937 random_;
};

/// A machine with the limits of the transfer, standing at zero.
inline machine::Machine machine_for(const Transfer& transfer) {
    machine::Machine machine;
    machine.name = "transfer";
    for (std::size_t i = 0; i < 3; ++i) {
        machine::MachineAxis axis;
        axis.name = std::string(kAxisNames[i]);
        axis.axis = static_cast<Axis>(i);
        axis.lower = -1e9;
        axis.upper = 1e9;
        axis.velocity = transfer.axes[i].velocity;
        axis.acceleration = transfer.axes[i].acceleration;
        axis.jerk = transfer.axes[i].jerk;
        machine.axes.push_back(std::move(axis));
    }
    return machine;
}

}  // namespace kadr::bench
