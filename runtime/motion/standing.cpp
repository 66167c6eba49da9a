#include "motion/standing.h"

#include <cmath>

#include "base/units.h"

namespace kadr::motion {

using path::Command;
using path::Op;
using path::Vec3;

namespace {

Vec3 tool_axis(path::Plane plane, const AxisTable& axes) {
    Axis axis = Axis::Z;
    switch (plane) {
        case path::Plane::Xy: axis = Axis::Z; break;
        case path::Plane::Zx: axis = Axis::Y; break;
        case path::Plane::Yz: axis = Axis::X; break;
    }
    // A lathe works in Z-X and has no Y: its lengths count along Z.
    if (axes.slot(axis) == axes.size()) axis = Axis::Z;
    return Vec3::Unit(static_cast<Eigen::Index>(index(axis)));
}

bool turns(std::size_t follower) { return is_rotary(static_cast<Axis>(follower + 3)); }

}  // namespace

Standing::Standing(const machine::Machine& machine) {
    for (const machine::MachineAxis& axis : machine.axes) {
        const std::size_t i = index(axis.axis);
        if (i < 3) {
            tip_[static_cast<Eigen::Index>(i)] = axis.home;
        } else {
            followers_[i - 3] = axis.home;
        }
        last_to_[i] = axis.is_rotary ? deg_from_rad(axis.home) : axis.home;
    }
}

Standing::Target Standing::target_of(const Command& command) const {
    Target target{tip_, followers_};
    for (std::size_t i = 0; i < kAxes; ++i) {
        // An axis that is not programmed and whose value did not change stands. Its value may be of
        // another kind than the position now: machine coordinates, or before a tool length.
        const bool is_moved = (command.moved & bit(static_cast<Axis>(i))) != 0;
        if (!is_moved && (command.machine_coordinates || command.to[i] == last_to_[i])) continue;
        if (i >= 3) {
            target.followers[i - 3] = turns(i - 3) ? rad_from_deg(command.to[i]) : command.to[i];
            continue;
        }
        const auto k = static_cast<Eigen::Index>(i);
        target.tip[k] =
            command.machine_coordinates ? command.to[i] - tool_length_ * tool_[k] : command.to[i];
    }
    return target;
}

double Standing::lay_path(const Command& command, const Target& target, Segment& segment) const {
    double length = 0;
    if (command.op == Op::Arc) {
        const path::Helix helix =
            path::make_helix(tip_, target.tip, command.center, command.normal, command.sweep);
        length = helix.length;
        segment.curve = helix;
    } else if (command.op == Op::Spline && command.spline.degree > 3) {
        const path::QuinticSpan quintic = path::make_quintic(tip_, target.tip, command.spline);
        length = quintic.length;
        segment.curve = quintic;
    } else if (command.op == Op::Involute) {
        const path::Involute involute = path::make_involute(tip_, target.tip, command.center,
                                                            command.normal, command.base_radius);
        length = involute.length;
        segment.curve = involute;
    } else if (command.op == Op::Spline) {
        const path::CubicSpan spline = path::make_spline(tip_, target.tip, command.spline);
        length = spline.length;
        segment.curve = spline;
    } else if ((target.tip - tip_).squaredNorm() > kStill * kStill) {
        const path::Line line = path::make_line(tip_, target.tip);
        length = line.length;
        segment.curve = line;
    }
    if (target.followers != followers_) lay_followers(target, length, segment);
    return length > kStill ? length : 0;
}

/// X Y Z make the path if they move, else U V W, else the rotary axes in degrees; the others follow
/// in proportion (reference motion §1.1).
void Standing::lay_followers(const Target& target, double& length, Segment& segment) const {
    double turn = 0;
    double parallel = 0;
    for (std::size_t i = 0; i < kFollowers; ++i) {
        const double way = target.followers[i] - followers_[i];
        (turns(i) ? turn : parallel) +=
            turns(i) ? deg_from_rad(way) * deg_from_rad(way) : way * way;
    }
    if (length <= kStill) length = std::sqrt(parallel);
    if (length <= kStill) {
        length = std::sqrt(turn);
        segment.turns_only = true;
    }
    if (length <= kStill) return;
    for (std::size_t i = 0; i < kFollowers; ++i) {
        const double way = target.followers[i] - followers_[i];
        if (way == 0) continue;
        segment.follower_rate[i] = way / length;
        segment.followers |= bit(static_cast<Axis>(i + 3));
    }
}

Segment Standing::still() const {
    Segment segment;
    segment.curve = path::Point{tip_};
    segment.tool = tool_;
    segment.tool_length = tool_length_;
    segment.follower_start = followers_;
    return segment;
}

void Standing::arrive(const Command& command, const Target& target) {
    tip_ = target.tip;
    followers_ = target.followers;
    last_to_ = command.to;
}

void Standing::set_tool_length(const Command& command, const AxisTable& axes) {
    const Vec3 carrier = tip_ + tool_length_ * tool_;
    tool_ = tool_axis(command.plane, axes);
    tool_length_ = command.length;
    if (!command.aside.isZero(0)) {  // of a lathe's tool: what carries it lies aside as well
        const Vec3 carried = command.length * tool_ + command.aside;
        tool_length_ = carried.norm();
        tool_ = carried / tool_length_;
    }
    tip_ = carrier - tool_length_ * tool_;
}

}  // namespace kadr::motion
