#include "interp/compensated_orientation.h"

#include <utility>

#include <Eigen/Geometry>

#include "base/units.h"
#include "machine/following.h"
#include "machine/kinematics.h"
#include "machine/orientation.h"
#include "path/curve_of.h"
#include "path/linear.h"

namespace kadr::interp {

using path::Command;
using path::linear;
using path::Op;
using path::OrientKind;
using path::Vec3;

namespace {

/// Directions that differ by the rounding of words and of rotary axes, rad.
constexpr double kSameTool = 1e-7;
/// Distances shorter than this are none: rounding of frames, mm.
constexpr double kNoDistance = 1e-9;

bool is_same(const Vec3& a, const Vec3& b) { return (a - b).norm() < kSameTool; }

/// The tool where a command begins and where it ends, by its own words.
struct ToolEnds {
    Vec3 first;
    Vec3 last;
};

ToolEnds ends_of(const path::Motion& motion, const path::Curve& curve, const Vec3& now) {
    if (motion.orient_kind == OrientKind::Cone) {
        const double angle = motion.orientation().angle;
        const Eigen::AngleAxisd back(-angle, motion.orientation().axis);
        return {angle == 0 ? motion.direction : back * motion.direction, motion.direction};
    }
    const double length = path::length(curve);
    const path::OrientLaw orientation =
        orient_law_of(motion, now, length > kNoDistance ? length : 1);
    return {path::direction_at(orientation, curve, 0),
            path::direction_at(orientation, curve, orientation.length)};
}

/// The motion changes the orientation along the great circle instead. False: there is none.
bool orient_straight(const Vec3& from, path::Motion& motion) {
    const auto arc = machine::great_circle(from, motion.direction);
    if (!arc) return false;
    motion.orient_kind = OrientKind::Cone;
    path::OrientDetails& details = motion.orient_details.made();
    details.axis = arc->axis;
    details.angle = arc->turn;
    return true;
}

/// The rotary axes where the tool ends on its path there. False: they cannot go.
bool lead_joints(const OrientationLimits& orientation_limits, const AxisValues& from,
                 const machine::DirectionFunction& direction, AxisValues& to) {
    const machine::Chain& chain = *orientation_limits.chain;
    const auto end =
        machine::follow(chain, {joints_at(chain, from), orientation_limits.limits}, direction);
    if (!end) return false;
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (!chain.has(k)) continue;
        to[index(chain.joints[k].axis)] = deg_from_rad(end->rotary[static_cast<Eigen::Index>(k)]);
    }
    return true;
}

/// The tip stands where the axes are while the orientation changes along the great circle.
bool put_standing_orientation(const OrientationLimits& orientation_limits, const Command& model,
                              const Vec3& to, AxisValues& axes, std::vector<Command>& settled) {
    const Vec3 from =
        machine::tool_vector(*orientation_limits.chain, joints_at(*orientation_limits.chain, axes));
    if (is_same(from, to)) return true;
    Command command = model;
    path::Motion& turn = command.motion();
    turn.become(turn.op() == Op::Rapid ? Op::Rapid : Op::Line);
    turn.exact_stop = false;
    turn.direction = to;
    turn.to = axes;
    if (!orient_straight(from, turn)) return false;
    const Eigen::AngleAxisd whole(turn.orientation().angle, turn.orientation().axis);
    const auto course = [&](double share) -> Vec3 {
        return Eigen::AngleAxisd(share * whole.angle(), whole.axis()) * from;
    };
    if (!lead_joints(orientation_limits, axes, course, turn.to)) return false;
    axes = turn.to;
    settled.push_back(std::move(command));
    return true;
}

/// Along an arc the orientation follows it: it goes there before, and to what is programmed behind.
bool put_led(const OrientationLimits& orientation_limits, AxisValues axes,
             const Command& programmed, const ToolEnds& ends, std::vector<Command>& settled) {
    const std::size_t before = settled.size();
    const auto put = [&] {
        if (!put_standing_orientation(orientation_limits, programmed, ends.first, axes, settled))
            return false;
        Command command = programmed;
        path::Motion& motion = command.motion();
        const path::Curve curve = path::curve_of(motion, linear(axes), linear(motion.to));
        const path::OrientLaw orientation = orient_law_of(motion, ends.first, path::length(curve));
        const auto course = [&](double share) {
            return path::direction_at(orientation, curve, share * orientation.length);
        };
        if (!lead_joints(orientation_limits, axes, course, motion.to)) return false;
        motion.direction = ends.last;
        axes = motion.to;
        settled.push_back(std::move(command));
        return put_standing_orientation(orientation_limits, programmed,
                                        programmed.motion().direction, axes, settled);
    };
    if (put()) return true;
    settled.resize(before);
    return false;
}

}  // namespace

Vec3 joints_at(const machine::Chain& chain, const AxisValues& axes) {
    Vec3 joints = Vec3::Zero();
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (chain.has(k))
            joints[static_cast<Eigen::Index>(k)] = rad_from_deg(axes[index(chain.joints[k].axis)]);
    }
    return joints;
}

path::OrientLaw orient_law_of(const path::Motion& motion, const Vec3& from_tool, double length) {
    const double share = 1 / length;
    const path::OrientDetails& whole = motion.orientation();
    path::OrientLaw orientation;
    orientation.kind = motion.orient_kind;
    orientation.length = length;
    orientation.start = orientation.kind == OrientKind::Cone ? from_tool : whole.from;
    orientation.axis =
        orientation.kind == OrientKind::Point ? Vec3(share * whole.axis) : whole.axis;
    orientation.rate = share * whole.angle;
    orientation.lead_tilt = whole.lead_tilt;
    orientation.outwards = whole.outwards;
    return orientation;
}

void shift_point(const CompensatedEnds& ends, path::Motion& motion) {
    if (motion.orient_kind != OrientKind::Point) return;
    const Vec3 before = ends.from_beside - ends.from;
    const Vec3 behind = ends.to_beside - ends.to;
    motion.orient_details->from += before;
    motion.orient_details->axis += behind - before;
}

bool put_oriented(const OrientationLimits& orientation_limits, const AxisValues& from,
                  Command command, std::vector<Command>& settled) {
    const bool is_led = orientation_limits.chain != nullptr && command.is_motion() &&
                        command.motion().orient_kind > OrientKind::Axes &&
                        !command.motion().contact;
    if (!is_led) {
        settled.push_back(std::move(command));
        return true;
    }
    path::Motion& motion = command.motion();
    const Vec3 now =
        machine::tool_vector(*orientation_limits.chain, joints_at(*orientation_limits.chain, from));
    const path::Curve curve = path::curve_of(motion, linear(from), linear(motion.to));
    const ToolEnds ends = ends_of(motion, curve, now);
    if (!is_same(ends.first, now) || !is_same(ends.last, motion.direction)) {
        if (motion.op() == Op::Arc && motion.orient_kind != OrientKind::Cone)
            return put_led(orientation_limits, from, command, ends, settled);
        if (!orient_straight(now, motion)) return false;
    }
    settled.push_back(std::move(command));
    return true;
}

}  // namespace kadr::interp
