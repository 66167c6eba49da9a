#include "motion/standing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "motion/transformed.h"

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
    if (machine.kinematics) chain_ = &machine.kinematics->chain;
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

/// Where X, Y and Z of the machine stand.
Vec3 Standing::carrier() const {
    if (!is_transformed_) return tip_ + held_;
    const machine::ChainPosition position{Vec3::Zero(),
                                          {followers_[3], followers_[4], followers_[5]},
                                          joints_of(*chain_, followers_)};
    return machine::inverse_linear(*chain_, tip_, position, -held_);
}

void Standing::put_carrier(const Vec3& carrier) {
    if (!is_transformed_) {
        tip_ = carrier - held_;
        return;
    }
    LogicalAxes axes{carrier[0], carrier[1], carrier[2]};
    std::ranges::copy(followers_, axes.begin() + 3);
    tip_ = tip_at(*chain_, axes, held_);
}

bool Standing::follow_transformation(const Command& command) {
    const bool is_wanted = command.turning != path::Turning::None;
    if (is_wanted == is_transformed_ || chain_ == nullptr) return false;
    const Vec3 stays = carrier();
    is_transformed_ = is_wanted;
    put_carrier(stays);
    // What the command says of the other axes is of the new system.
    last_to_.fill(std::numeric_limits<double>::quiet_NaN());
    return true;
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
        target.tip[k] = command.machine_coordinates ? command.to[i] - held_[k] : command.to[i];
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
    } else if (command.op == Op::Parametric) {
        const path::Parametric curve =
            path::make_parametric(tip_, target.tip, command.curve.front());
        length = curve.length;
        segment.curve = curve;
    } else if ((target.tip - tip_).squaredNorm() > kStill * kStill) {
        const path::Line line = path::make_line(tip_, target.tip);
        length = line.length;
        segment.curve = line;
    }
    if (target.followers != followers_) lay_followers(target, length, segment);
    if (segment.is_transformed()) lay_turn(command, length, segment);
    return length > kStill ? length : 0;
}

/// On a cone R1 and R2 follow the tool; where only it turns, its angle is the path.
void Standing::lay_turn(const Command& command, double& length, Segment& segment) const {
    Turn& turn = segment.turn;
    turn.kind = command.turning;
    if (turn.kind == path::Turning::Cone) {
        const bool stands = std::holds_alternative<path::Point>(segment.curve);
        const bool is_parallel = (segment.followers & ~kRotaryABC) != 0;
        if (stands && !is_parallel) {
            length = deg_from_rad(std::abs(command.turn_angle));
            segment.turns_only = true;
        }
        for (const std::size_t joint : {machine::kR1, machine::kR2}) {
            if (!chain_->has(joint)) continue;
            const Axis axis = chain_->joints[joint].axis;
            segment.follower_rate[index(axis) - 3] = 0;
            segment.followers |= bit(axis);
        }
        turn.direction = machine::tool_vector(*chain_, joints_of(*chain_, followers_));
        turn.axis = command.turn_axis;
        if (length > kStill) turn.rate = command.turn_angle / length;
    }
    turn.length = length;
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
    segment.carrier = held_;
    segment.follower_start = followers_;
    if (is_transformed_) segment.turn.kind = path::Turning::Axes;
    return segment;
}

void Standing::arrive(const Command& command, const Target& target) {
    tip_ = target.tip;
    followers_ = target.followers;
    last_to_ = command.to;
}

void Standing::set_tool_length(const Command& command, const AxisTable& axes) {
    const Vec3 stays = carrier();
    tool_ = tool_axis(command.plane, axes);
    held_ = command.length * tool_ + command.aside;
    if (command.is_swivelled) {
        tool_ = command.direction;
    } else if (!command.aside.isZero(0)) {  // a lathe's tool: what carries it lies aside as well
        tool_ = held_.normalized();
    }
    put_carrier(stays);
    // What was said of axes that all have another length now is of no use: a head has turned.
    if ((command.moved & kLinearXYZ) == kLinearXYZ)
        last_to_.fill(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace kadr::motion
