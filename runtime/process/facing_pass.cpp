#include "process/facing_pass.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "process/drives.h"

namespace kadr::process {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// The interpolator: its velocity follows a target with a limited slope (rectangle), its position
/// is the integral (trapezoid).
AxisState interpolated(const FacingPass& pass, AxisState state, double target, double step) {
    const double slope = std::clamp((target - state.velocity) / pass.ramp_time, -pass.acceleration,
                                    pass.acceleration);
    const double before = state.velocity;
    state.velocity += slope * step;
    state.position += (before + state.velocity) / 2 * step;
    return state;
}

}  // namespace

double run_facing_pass(const machine::Drives& drives, const FacingPass& pass, double step,
                       const std::function<void(const FacingSample&)>& look) {
    const double start_speed = kTurn * pass.spindle.speed_at(pass.radius);
    const double start_load = drives.cutting_force * pass.radius / 1000;
    SpindleState spindle = settled(drives.spindle, start_speed, start_load);
    AxisState command;
    AxisState axis;
    bool is_cutting = true;
    double held = 0;  // rad/s, on the return
    for (std::int64_t i = 0;; ++i) {
        const double time = static_cast<double>(i) * step;
        const double radius = pass.radius - axis.position;
        look({time, radius, spindle.speed, spindle.current, axis.velocity, is_cutting});
        if (!is_cutting && axis.position <= 0) return time;
        if (is_cutting && radius < 0) {
            is_cutting = false;
            held = kTurn * pass.spindle.speed_at(radius);
        }
        const double asked_feed = pass.feed_per_revolution * spindle.speed / kTurn;
        const double target = is_cutting ? asked_feed : -pass.rapid;
        const double wanted = is_cutting ? kTurn * pass.spindle.speed_at(radius) : held;
        // The force follows the thickness of the chip, and that the real feed.
        const double chip =
            is_cutting && asked_feed > 0 ? std::clamp(axis.velocity / asked_feed, 0.0, 1.0) : 0;
        const double load = drives.cutting_force * std::abs(radius) / 1000 * chip;
        spindle = advanced(drives.spindle, spindle, wanted, load, step);
        command = interpolated(pass, command, target, step);
        axis = advanced(drives.feed, axis, command, step);
    }
}

}  // namespace kadr::process
