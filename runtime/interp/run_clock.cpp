#include "interp/run_clock.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/units.h"
#include "interp/compensated_orientation.h"
#include "machine/kinematics.h"
#include "path/arc.h"
#include "path/linear.h"

namespace kadr::interp {

using path::FeedMode;
using path::linear;
using path::Op;
using path::Vec3;

/// The axes stand, and their position gets the coordinates of the next motion.
void RunClock::follow_virtual(const path::VirtualAxes& axes) {
    if (axes == axes_) return;
    const double rotary = rad_from_deg(at_[index(axes.rotary)]);
    const Vec3 point =
        path::virtual_position(axes, path::real_position(axes_, linear(at_)), rotary);
    for (std::size_t i = 0; i < 3; ++i) at_[i] = point[static_cast<Eigen::Index>(i)];
    axes_ = axes;
}

void RunClock::move(const path::Motion& motion, const AxisValues& to) {
    const double time = time_of(motion, to);
    seconds_ += time;
    if (motion.op() != Op::Rapid) cutting_seconds_ += time;
    at_ = to;
}

void RunClock::add(const path::Command& command) {
    if (command.is_motion()) {
        const path::Motion& motion = command.motion();
        follow_virtual(motion.virtual_axes());
        if (!motion.machine_coordinates) return move(motion, motion.to);
        AxisValues to = motion.to;
        for (std::size_t i = 0; i < kAxes; ++i) to[i] -= length_[i];
        return move(motion, to);
    }
    switch (command.op()) {
        case Op::Dwell: {
            const double speed = speed_at(at_[0]);
            seconds_ += command.dwell().time;
            if (command.dwell().revolutions > 0 && speed > 0)
                seconds_ += command.dwell().revolutions / speed * 60;
            return;
        }
        case Op::Spindle:
            spindle_ = command.spindle().speed;
            has_cutting_speed_ = command.spindle().has_cutting_speed;
            most_speed_ = machine_.max_speed_of(command.spindle().number);
            [[fallthrough]];
        case Op::OtherSpindle:
            if (command.spindle().mode == path::SpindleMode::Orient)
                seconds_ += machine_.orient_time_of(command.spindle().number);
            return;
        case Op::SpeedLimit:
            limit_ = command.speed_limit().most;
            least_ = command.speed_limit().least;
            return;
        case Op::Function: {
            const machine::MachineFunction* known = machine_.find_function(command.function().code);
            const bool waits = command.function().step == path::FunctionStep::Both;
            if (waits && known != nullptr) seconds_ += known->takes;
            return;
        }
        case Op::Tool: seconds_ += machine_.tool_change_time; return;
        case Op::ToolLength: {
            // The machine stays where it is: the tip of the other tool is elsewhere.
            for (std::size_t i = 0; i < kAxes; ++i) at_[i] += length_[i];
            length_ = {};
            length_[index(path::axes_of(command.tool_length().plane).normal)] =
                command.tool_length().length;
            for (std::size_t i = 0; i < 3; ++i) {
                length_[i] += command.tool_length().aside[static_cast<Eigen::Index>(i)];
                at_[i] -= length_[i];
            }
            return;
        }
        default: return;
    }
}

double RunClock::time_of(const path::Motion& motion, const AxisValues& to) const {
    const bool is_straight = motion.orient_kind == path::OrientKind::Straight;
    if (motion.op() == Op::Rapid && is_straight)
        return rapid(machine_position(at_), machine_position(to));
    if (motion.op() == Op::Rapid) return rapid(at_, to);
    const double feed = motion.feed;
    if (!(feed > 0)) return 0;
    const bool is_by_turns =
        motion.op() == Op::Thread || motion.feed_mode == FeedMode::PerRevolution;
    if (!is_by_turns && motion.feed_mode == FeedMode::InverseTime) return 60 / feed;
    const double distance = distance_of(motion, to);
    // The pitch grows evenly with the revolutions, so the mean of both ends is that of the time.
    const double last = motion.op() != Op::Thread || motion.thread().pitch_change == 0
                            ? feed
                            : std::sqrt(feed * feed + 2 * motion.thread().pitch_change * distance);
    const double mm_min = is_by_turns ? (feed + last) / 2 * speed_at(to[0]) : feed;
    return mm_min > 0 ? distance / mm_min * 60 : 0;
}

/// Where the axes of the machine are for a position of the tip under its transformation.
AxisValues RunClock::machine_position(const AxisValues& at) const {
    const machine::Chain& chain = machine_.kinematics->chain;
    const machine::ChainPosition position{
        Vec3::Zero(), {at[6], at[7], at[8]}, joints_at(chain, at)};
    const Vec3 xyz = machine::inverse_linear(chain, linear(at), position, -linear(length_));
    AxisValues place = at;
    for (std::size_t i = 0; i < 3; ++i) place[i] = xyz[static_cast<Eigen::Index>(i)];
    return place;
}

double RunClock::rapid(const AxisValues& from, const AxisValues& to) const {
    double longest = 0;
    for (const machine::MachineAxis& axis : machine_.axes) {
        const std::size_t i = index(axis.axis);
        const double distance = std::abs(to[i] - from[i]);
        longest =
            std::max(longest, (axis.is_rotary ? rad_from_deg(distance) : distance) / axis.velocity);
    }
    return longest;
}

/// Of an arc along it, of a spline its chord, from point to point that of the axes; where no linear
/// axis moves the angle of the others.
double RunClock::distance_of(const path::Motion& motion, const AxisValues& to) const {
    const bool is_straight = motion.orient_kind == path::OrientKind::Straight;
    const Vec3 from = linear(is_straight ? machine_position(at_) : at_);
    const Vec3 end = linear(is_straight ? machine_position(to) : to);
    if (motion.op() == Op::Arc) {
        const path::ArcShape& arc = motion.arc();
        // Only the distance across the normal counts.
        const Vec3 out = from - arc.center;
        const double radius = (out - arc.normal * out.dot(arc.normal)).norm();
        return std::hypot(radius * arc.sweep, (end - from).dot(arc.normal));
    }
    const double distance = (end - from).norm();
    if (distance > 0) return distance;
    double turned = 0;
    for (std::size_t i = 3; i < kAxes; ++i) turned = std::hypot(turned, to[i] - at_[i]);
    return turned;
}

/// rpm; `x` is of the tip
double RunClock::speed_at(double x) const {
    if (!has_cutting_speed_) return spindle_;
    const double diameter = 2 * std::abs(x + length_[index(Axis::X)]);
    double most =
        most_speed_ > 0 ? rpm_from_speed(most_speed_) : std::numeric_limits<double>::infinity();
    if (limit_ > 0) most = std::min(most, limit_);
    return std::min(most, std::max(least_, 1000 * spindle_ / (std::numbers::pi * diameter)));
}

}  // namespace kadr::interp
