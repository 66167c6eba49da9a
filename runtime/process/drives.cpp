#include "process/drives.h"

#include <algorithm>
#include <cmath>

namespace kadr::process {

namespace {

/// Gain of the inner speed loop, A per rad/s.
double speed_gain(const machine::SpindleDrive& drive) {
    return drive.inertia / (2 * drive.time_constant * drive.torque_constant);
}

}  // namespace

double idle_torque(const machine::SpindleDrive& drive, double speed) {
    return drive.friction + drive.damping * speed;
}

SpindleState settled(const machine::SpindleDrive& drive, double speed, double load) {
    SpindleState state;
    state.speed = speed;
    state.current = (load + idle_torque(drive, speed)) / drive.torque_constant;
    state.reference = speed + state.current / speed_gain(drive);
    return state;
}

SpindleState advanced(const machine::SpindleDrive& drive, SpindleState state, double wanted,
                      double load, double step) {
    const double gain = speed_gain(drive);
    const double asked = gain * (state.reference - state.speed);
    const double given = std::clamp(asked, -drive.max_current, drive.max_current);
    // An integrator that goes on while the current is at its limit would run away.
    const double error = wanted - state.speed;
    if (given == asked || (asked > 0) != (error > 0)) {
        state.reference += step * error / (4 * drive.time_constant);
    }
    state.current += step * (given - state.current) / drive.time_constant;
    const double driving = drive.torque_constant * state.current;
    const double braking = load + idle_torque(drive, state.speed);
    // Friction holds a spindle that stands; it does not turn it backwards.
    if (state.speed > 0 || driving > braking) {
        state.speed = std::max(0.0, state.speed + step * (driving - braking) / drive.inertia);
    }
    return state;
}

AxisState advanced(const machine::FeedDrive& drive, AxisState state, const AxisState& command,
                   double step) {
    const double wanted =
        drive.gain * (command.position - state.position) + drive.feed_forward * command.velocity;
    state.velocity += step * (wanted - state.velocity) / drive.time_constant;
    state.position += step * state.velocity;
    return state;
}

double longest_step(const machine::Drives& drives) {
    // Explicit steps of first order: an eightieth of the fastest time constant keeps the peak of
    // the current true to a thousandth.
    constexpr double kFraction = 1.0 / 80;
    return kFraction * std::min({drives.spindle.time_constant, drives.feed.time_constant,
                                 1 / drives.feed.gain});
}

}  // namespace kadr::process
