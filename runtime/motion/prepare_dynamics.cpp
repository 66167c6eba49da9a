// prepare_dynamics.cpp — how fast motions may be as programmed: the axes have so much
// of their limits, F and rapid traverse so much of their speed.
//
// At a corner between two motions the axes keep what both of them leave.
#include <algorithm>

#include "base/diagnostics/machine.h"
#include "motion/prepare_state.h"

namespace kadr::motion {

/// The limits are those of the command from here on.
void Preparer::State::follow_dynamics(const path::Command& command) {
    if (is_plain && !command.motion().dynamics) return;  // nearly always
    static const path::Dynamics kPlain;
    const path::Dynamics& wanted = !command.motion().dynamics ? kPlain : *command.motion().dynamics;
    if (wanted == dynamics) return;
    dynamics = wanted;
    is_plain = !command.motion().dynamics;
    axes = machine_axes.under(dynamics);
    set_jumps();
}

/// By how much an axis may change its velocity at the corner behind the last piece.
void Preparer::State::set_jumps() {
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const double given = options.velocity_jump[i];
        const double part = acceleration_at_corner(i) / machine_axes.acceleration(i);
        const double usual = machine_axes.acceleration(i) * tick;
        jump[i] = given > 0 ? given : part * machine.axes[i].corner_jump.value_or(usual);
    }
}

double Preparer::State::acceleration_at_corner(std::size_t axis) const {
    const double part = last.dynamics.acceleration[index(machine.axes[axis].axis)];
    return std::min(axes.acceleration(axis), machine_axes.acceleration(axis) * part);
}

double Preparer::State::jerk_at_corner(std::size_t axis) const {
    const double part = last.dynamics.jerk[index(machine.axes[axis].axis)];
    return std::min(axes.jerk(axis), machine_axes.jerk(axis) * part);
}

/// By how much an axis may change its velocity in the tick of a corner, in parts of what its
/// acceleration is enough for: more than 1 where the machine's file lets its velocity jump so.
double Preparer::State::most_at_corner(std::size_t axis) const {
    return std::max(1.0, jump[axis] / (acceleration_at_corner(axis) * tick));
}

/// The jerk of which a part goes into a jump of the acceleration where the curvature changes: in a
/// tick it makes of the acceleration what the machine's file allows.
double Preparer::State::jerk_of_bend(std::size_t axis) const {
    const double jerk = jerk_at_corner(axis);
    const std::optional<double>& given = machine.axes[axis].curvature_jump;
    return given ? *given / tick * (jerk / machine_axes.jerk(axis)) : jerk;
}

/// What F is multiplied with by the program.
double Preparer::State::programmed_override(const path::Command& command) const {
    const bool is_free = command.motion().keeps_feed || command.op() == path::Op::Thread;
    return is_free || !command.motion().dynamics ? 1 : command.motion().dynamics->feed;
}

/// … and by the operator at the start of the run.
double Preparer::State::feed_override(const path::Command& command) const {
    const bool is_free = command.motion().keeps_feed || command.op() == path::Op::Thread;
    return is_free ? 1 : options.feed_override * programmed_override(command);
}

/// The program may take all speed from a motion.
Done Preparer::State::require_override(const path::Command& command) {
    const bool is_rapid = command.op() == path::Op::Rapid;
    if ((is_rapid ? dynamics.rapid : programmed_override(command)) > 0) return kDone;
    report(sink, diag::StandsForEver, command, options.locate_command)
        .arg("an override of 0 % in the program")
        .fix(is_rapid ? "`OVRRAP=100`, or `OVRA` of the axis above 0" : "`OVR=100`");
    has_alarmed = has_ended = true;
    return kFailed;
}

}  // namespace kadr::motion
