#include "motion/axis_check.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostics/machine.h"
#include "base/numbers.h"
#include "base/units.h"
#include "motion/standing.h"

namespace kadr::motion {

namespace {

// Limits are checked to a millionth of a millimetre (or rad): a hundredth of what encoders resolve.
constexpr double kLimitTolerance = 1e-6;

std::string shown(const machine::MachineAxis& axis, double position) {
    const double value = axis.is_rotary ? deg_from_rad(position) : position;
    return format_shortest(round_to(value, 4)) + (axis.is_rotary ? " deg" : " mm");
}

}  // namespace

AxisCheck::AxisCheck(const machine::Machine& machine, const AxisTable& axes,
                     const PlannerOptions& options, DiagnosticSink& sink)
    : machine_(machine), axes_(axes), options_(options), sink_(sink) {
    for (std::size_t i = 0; i < kAxes; ++i) {
        const auto axis = static_cast<Axis>(i);
        const std::size_t slot = axes.slot(axis);
        if (slot == axes.size()) {
            missing_.push_back(axis);
            missing_mask_ |= bit(axis);
        } else {
            travel_.lower[slot] = travel_.upper[slot] = machine.axes[slot].home;
        }
    }
}

AxisCheck::Answer AxisCheck::check(const path::Command& command, const Segment& piece,
                                   double length) {
    if (!require_all_axes(command, piece, length)) return Answer::Impossible;
    reached_ = axes_.travel(piece, length);
    return require_limits(command, reached_) ? Answer::Possible : Answer::Beyond;
}

Done AxisCheck::require_all_axes(const path::Command& command, const Segment& piece,
                                 double length) {
    // Linear axes and followers may move, nothing else does.
    auto missing = static_cast<AxisMask>(missing_mask_ & (kLinearXYZ | piece.followers));
    // What has no axis of its own there is the matter of a rotary one.
    if (piece.virtual_axes.turns())
        missing = static_cast<AxisMask>(missing & ~bit(piece.virtual_axes.virtual_axis()));
    if (missing == 0) return kDone;
    const path::Box box = path::bounds(piece.curve);  // an arc may come back to where it began
    bool has_all = true;
    for (const Axis axis : missing_) {
        if ((missing & bit(axis)) == 0) continue;
        const std::size_t i = index(axis);
        const auto k = static_cast<Eigen::Index>(i);
        const double distance =
            i < 3 ? box.upper[k] - box.lower[k] : std::abs(piece.follower_rate[i - 3]) * length;
        if (distance <= kStill) continue;
        has_all = false;
        if (!reported_.first_time_missing(i)) continue;
        report(sink_, diag::AxisNotOnMachine, {command.line, command.source, axis},
               options_.locate_command)
            .arg(kAxisNames[i])
            .arg(machine_.name);
    }
    return Done(has_all);
}

Done AxisCheck::require_limits(const path::Command& command, const AxisTable::Travel& reached) {
    bool keeps_all = true;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const machine::MachineAxis& axis = machine_.axes[i];
        const bool above = reached.upper[i] > axis.upper + kLimitTolerance;
        const bool below = reached.lower[i] < axis.lower - kLimitTolerance;
        if (!above && !below) {
            reported_.forget_outside(i);
            continue;
        }
        keeps_all = false;
        if (!reported_.first_time_outside(i)) continue;
        report(sink_, diag::AxisBeyondLimit, {command.line, command.source, axis.axis},
               options_.locate_command)
            .arg(axis.name)
            .arg(shown(axis, above ? reached.upper[i] : reached.lower[i]))
            .arg(shown(axis, above ? axis.upper : axis.lower));
    }
    return Done(keeps_all);
}

void AxisCheck::widen_travel() {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        travel_.lower[i] = std::min(travel_.lower[i], reached_.lower[i]);
        travel_.upper[i] = std::max(travel_.upper[i], reached_.upper[i]);
    }
}

}  // namespace kadr::motion
