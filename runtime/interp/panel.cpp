// panel.cpp — what the program takes from the operator's panel, and what it says of how fast its
// motions may be.
// source: SINUMERIK reference 2.3, 3.5; FANUC reference 3.2 (G63), 6.5 (#3004)
#include <cmath>
#include <string_view>

#include "base/diagnostics/iso.h"
#include "interp/executor.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of_all;
using path::Op;
using Write = ControlAccess::Write;

namespace {

// #3004, as a sum.
constexpr int kHold = 1;
constexpr int kOverride = 2;
constexpr int kExactStop = 4;

constexpr double kPercent = 0.01;

std::string_view name_of(Function function) {
    if (function == Function::AxisVelocity) return "velocity";
    return function == Function::AxisJerk ? "jerk" : "acceleration";
}

AxisValues& parts_of_axes(path::Dynamics& dynamics, Function function) {
    if (function == Function::AxisVelocity) return dynamics.velocity;
    return function == Function::AxisJerk ? dynamics.jerk : dynamics.acceleration;
}

}  // namespace

void Executor::set_dynamics(const Block& block, const Invocation& invocation) {
    const Function function = invocation.function;
    if (function == Function::FeedOverride || function == Function::RapidOverride)
        return set_override(block, invocation);
    constexpr double kLeast = 1;
    const double most = function == Function::AxisVelocity ? 100 : 200;
    constexpr std::size_t kAxis =
        parameter_of_all<"axis", Function::AxisVelocity, Function::AxisAcceleration,
                         Function::AxisJerk>();
    constexpr std::size_t kPart =
        parameter_of_all<"percent", Function::AxisVelocity, Function::AxisAcceleration,
                         Function::AxisJerk>();
    const double percent = block.argument(invocation, kPart);
    if (!(percent >= kLeast && percent <= most)) {
        reporter_.report(diag::DynamicsRange, block, function)
            .arg(percent)
            .arg(name_of(function))
            .arg(kLeast)
            .arg(most);
        return;
    }
    const std::int64_t number = std::llround(block.argument(invocation, kAxis));
    const std::size_t axis = number >= 1 ? static_cast<std::size_t>(number) - 1 : kAxes;
    if (axis >= kAxes || (axes_.present >> axis & 1) == 0) {
        reporter_.report(diag::AxisMissing, block, function)
            .arg(axis < kAxes ? kAxisNames[axis] : std::string_view("of this number"));
        return;
    }
    parts_of_axes(programmed_dynamics(), function)[axis] = percent * kPercent;
}

/// So much of F, or of the speed at rapid.
void Executor::set_override(const Block& block, const Invocation& invocation) {
    path::Dynamics& dynamics = programmed_dynamics();
    const bool is_feed = invocation.function == Function::FeedOverride;
    const double most = is_feed ? 200 : 100;
    constexpr std::size_t kPart =
        parameter_of_all<"percent", Function::FeedOverride, Function::RapidOverride>();
    const double percent = block.argument(invocation, kPart);
    if (!(percent >= 0 && percent <= most)) {
        reporter_.report(diag::OverrideRange, block, invocation.function).arg(percent).arg(most);
        return;
    }
    (is_feed ? dynamics.feed : dynamics.rapid) = percent * kPercent;
}

Write Executor::suppress_panel(double value) {
    constexpr double kAll = kHold + kOverride + kExactStop;
    if (!(value >= 0 && value <= kAll)) return Write::NoSuchEntry;
    const int bits = static_cast<int>(value);
    panel_.has_hold = (bits & kHold) == 0;
    panel_.has_override = (bits & kOverride) == 0;
    panel_.has_exact_stop = (bits & kExactStop) == 0;
    return Write::Done;
}

double Executor::suppressed_panel() const {
    return (panel_.has_hold ? 0 : kHold) + (panel_.has_override ? 0 : kOverride) +
           (panel_.has_exact_stop ? 0 : kExactStop);
}

/// Whether a motion ends at rest: by what is modal, or by a word of its block alone.
bool Executor::stops_exactly(bool once) const {
    return panel_.has_exact_stop && (modal_.has_exact_stop || once);
}

/// What of the panel and of the machine's limits acts on a command.
void Executor::put_panel(path::Command& command, const Block& block) const {
    const bool is_motion = path::is_motion(command.op);
    const bool is_feed = is_motion && command.op != Op::Rapid;
    const bool is_tap = is_feed && block.is_of_cycle() && block.context->taps;
    command.keeps_feed = is_tap || (is_feed && (modal_.taps || !panel_.has_override));
    command.ignores_hold = is_tap || (is_motion && (modal_.taps || !panel_.has_hold));
    command.dynamics = panel_.dynamics;
    // At rapid an axis has all its speed, whatever it has beside F.
    if (!command.dynamics.empty() && command.op == Op::Rapid)
        command.dynamics.front().speed = path::Dynamics().speed;
    if (panel_.has_feed_characteristic && !block.is_of_cycle()) put_feed_law(command);
}

}  // namespace kadr::interp
