#include "motion/standing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "base/units.h"
#include "motion/transformed.h"
#include "path/curve_of.h"

namespace kadr::motion {

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

/// How far the tool's direction goes while the tip stands, rad.
double orient_angle(const path::Motion& motion, const Vec3& from) {
    if (motion.orient_kind != path::OrientKind::Cone)
        return path::angle_between(from, motion.direction);
    return std::abs(motion.orientation().angle) * motion.orientation().axis.cross(from).norm();
}

bool turns(std::size_t follower) { return is_rotary(static_cast<Axis>(follower + 3)); }

/// The path of the contact, of which corners have left a part. Where it stands, there is none.
path::Curve touched_path(const path::Motion& motion, const path::ContactMotion& touched) {
    const path::ContactKind kind = touched.contact.kind;
    if (kind == path::ContactKind::Pivot || kind == path::ContactKind::Corner)
        return path::Point{touched.from};
    const path::Curve whole = path::curve_of(motion, touched.from, touched.to);
    if (touched.begin == 0 && touched.end == 1) return whole;
    const double length = path::length(whole);
    return path::part(whole, touched.begin * length, touched.end * length);
}

/// While the contact stands, the path of the tip about it is the path.
double pivot_length(const path::Motion& motion, const path::Curve& touched) {
    if (!motion.contact || !std::holds_alternative<path::Point>(touched)) return 0;
    return path::tip_travel_about(motion.contact->contact, motion.direction);
}

}  // namespace

AxesPosition::AxesPosition(const machine::Machine& machine) {
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

/// Where X, Y and Z of the machine stand there.
Vec3 AxesPosition::carrier_at(const MotionEnd& target) const {
    const auto& [tip, followers] = target;
    if (virtual_.is_on()) return path::real_position(virtual_, tip) + held_;
    if (!is_transformed_) return tip + held_;
    const machine::ChainPosition position{
        Vec3::Zero(), {followers[3], followers[4], followers[5]}, joints_of(*chain_, followers)};
    return machine::inverse_linear(*chain_, tip, position, -held_);
}

void AxesPosition::put_carrier(const Vec3& carrier) {
    const Vec3 carried = carrier - held_;
    if (virtual_.is_on()) {
        tip_ = path::virtual_position(virtual_, carried, virtual_angle());
        return;
    }
    if (!is_transformed_) {
        tip_ = carried;
        return;
    }
    LogicalAxes axes{carrier[0], carrier[1], carrier[2]};
    std::ranges::copy(followers_, axes.begin() + 3);
    tip_ = tip_at(*chain_, axes, held_);
}

double AxesPosition::virtual_angle() const {
    return virtual_.turns() ? followers_[index(virtual_.rotary) - 3] : 0;
}

bool AxesPosition::follow_transformation(const path::Motion& motion) {
    const bool is_wanted = motion.orient_kind != path::OrientKind::None;
    const bool is_other = is_wanted != is_transformed_ || motion.virtual_axes() != virtual_;
    if (!is_other || (chain_ == nullptr && is_wanted && !motion.virtual_axes().is_on()))
        return false;
    const Vec3 stays = carrier();
    is_transformed_ = is_wanted;
    virtual_ = motion.virtual_axes();
    put_carrier(stays);
    // What the command gives for the other axes is of the new system.
    last_to_.fill(std::numeric_limits<double>::quiet_NaN());
    return true;
}

AxesPosition::MotionEnd AxesPosition::target_of(const path::Motion& motion) const {
    MotionEnd target{tip_, followers_};
    for (std::size_t i = 0; i < kAxes; ++i) {
        // An axis that is not programmed and whose value did not change stands. Its value may be of
        // another kind than the position now: machine coordinates, or before a tool length.
        const bool is_moved = (motion.moved & bit(static_cast<Axis>(i))) != 0;
        if (!is_moved && (motion.machine_coordinates || motion.to[i] == last_to_[i])) continue;
        if (i >= 3) {
            target.followers[i - 3] = turns(i - 3) ? rad_from_deg(motion.to[i]) : motion.to[i];
            continue;
        }
        const auto k = static_cast<Eigen::Index>(i);
        target.tip[k] = motion.machine_coordinates ? motion.to[i] - held_[k] : motion.to[i];
    }
    return target;
}

double AxesPosition::lay_path(const path::Motion& motion, const MotionEnd& target,
                              Segment& segment) const {
    if (motion.orient_kind == path::OrientKind::Straight) lay_straight(target, segment);
    else if (!motion.contact) segment.curve = path::curve_of(motion, tip_, target.tip);
    else segment.curve = touched_path(motion, *motion.contact);
    double length = std::max(path::length(segment.curve), pivot_length(motion, segment.curve));
    if (target.followers != followers_) lay_followers(target, length, segment);
    if (segment.is_transformed()) lay_orientation(motion, length, segment);
    return length > kStill ? length : 0;
}

/// From point to point every axis goes evenly, as if no transformation acted.
void AxesPosition::lay_straight(const MotionEnd& target, Segment& segment) const {
    const Vec3 from = carrier() - held_;
    const Vec3 to = carrier_at(target) - held_;
    segment.orientation.kind = path::OrientKind::Straight;
    if ((to - from).norm() > kStill) segment.curve = path::make_line(from, to);
    else segment.curve = path::Point{from};
}

/// A rotary axis of virtual coordinates follows the path. Where the tool's path is given R1 and R2
/// follow it; where only the orientation changes, its angle is the path.
void AxesPosition::lay_orientation(const path::Motion& motion, double& length,
                                   Segment& segment) const {
    path::OrientLaw& orientation = segment.orientation;
    orientation.kind = motion.orient_kind;
    if (virtual_.turns()) {
        segment.follower_rate[index(virtual_.rotary) - 3] = 0;
        segment.followers |= bit(virtual_.rotary);
    }
    if (gives_direction(orientation)) {
        const Vec3 from = machine::tool_vector(*chain_, joints_of(*chain_, followers_));
        const bool stands = std::holds_alternative<path::Point>(segment.curve);
        const bool is_parallel = (segment.followers & ~kRotaryABC) != 0;
        if (stands && !is_parallel && pivot_length(motion, segment.curve) <= kStill) {
            const double before = length;
            length = deg_from_rad(orient_angle(motion, from));
            segment.is_rotary_only = true;
            if (length > kStill)
                for (double& rate : segment.follower_rate) rate *= before / length;
        }
        for (const std::size_t joint : {machine::kR1, machine::kR2}) {
            if (!chain_->has(joint)) continue;
            const Axis axis = chain_->joints[joint].axis;
            segment.follower_rate[index(axis) - 3] = 0;
            segment.followers |= bit(axis);
        }
        const double share = length > kStill ? 1 / length : 0;
        const bool is_point = orientation.kind == path::OrientKind::Point;
        orientation.start =
            orientation.kind == path::OrientKind::Cone ? from : motion.orientation().from;
        orientation.axis =
            is_point ? Vec3(share * motion.orientation().axis) : motion.orientation().axis;
        orientation.rate = share * motion.orientation().angle;
        orientation.lead_tilt = motion.orientation().lead_tilt;
        orientation.outwards = motion.orientation().outwards;
    }
    orientation.length = length;
    if (motion.contact) segment.contact = motion.contact->contact;
}

/// X Y Z make the path if they move, else U V W, else the rotary axes in degrees; the others follow
/// in proportion (reference motion §1.1).
void AxesPosition::lay_followers(const MotionEnd& target, double& length, Segment& segment) const {
    double turn = 0;
    double parallel = 0;
    for (std::size_t i = 0; i < kFollowers; ++i) {
        const double distance = target.followers[i] - followers_[i];
        (turns(i) ? turn : parallel) +=
            turns(i) ? deg_from_rad(distance) * deg_from_rad(distance) : distance * distance;
    }
    if (length <= kStill) length = std::sqrt(parallel);
    if (length <= kStill) {
        length = std::sqrt(turn);
        segment.is_rotary_only = true;
    }
    if (length <= kStill) return;
    for (std::size_t i = 0; i < kFollowers; ++i) {
        const double distance = target.followers[i] - followers_[i];
        if (distance == 0) continue;
        segment.follower_rate[i] = distance / length;
        segment.followers |= bit(static_cast<Axis>(i + 3));
    }
}

Segment AxesPosition::still() const {
    Segment segment;
    segment.curve = path::Point{tip_};
    segment.tool = tool_;
    segment.carrier = held_;
    segment.follower_start = followers_;
    if (is_transformed_) segment.orientation.kind = path::OrientKind::Axes;
    segment.virtual_axes = virtual_;
    return segment;
}

void AxesPosition::arrive(const path::Motion& motion, const MotionEnd& target) {
    tip_ = target.tip;
    followers_ = target.followers;
    last_to_ = motion.to;
}

void AxesPosition::set_tool_length(const path::ToolLength& length, const AxisTable& axes) {
    const Vec3 stays = carrier();
    tool_ = tool_axis(length.plane, axes);
    held_ = length.length * tool_ + length.aside;
    if (length.is_swivelled) {
        tool_ = length.direction;
    } else if (!length.aside.isZero(0)) {  // a lathe's tool: what carries it lies aside as well
        tool_ = held_.normalized();
    }
    put_carrier(stays);
    // What was programmed of axes that all have another length now is of no use: a head has turned.
    if ((length.changed & kLinearXYZ) == kLinearXYZ)
        last_to_.fill(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace kadr::motion
