// tool_orientation.cpp — the orientation of the tool from motion to motion: the plan of a block
// (orient_planner.h), what its end means to the blocks behind it, and what its command has of it.
#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/channel.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/orient_planner.h"
#include "interp/radius_compensation.h"
#include "interp/stages.h"
#include "interp/tool_motion.h"
#include "interp/transformation.h"
#include "machine/kinematics.h"

namespace kadr::interp {

using machine::Chain;
using nc::Block;
using nc::Function;
using path::Op;
using path::OrientKind;
using path::Vec3;

OrientPlanner ToolMotion::planner() const {
    return {channel_, {position_.here(), position_.base(), orienting_, modal_.feed, false}};
}

Done ToolMotion::orient(const Block& block, const Actions& actions, Target& target) {
    // Every axis may move, whatever the block names.
    target.carried = static_cast<AxisMask>(kLinearXYZ & ~target.moved);
    target.moved =
        static_cast<AxisMask>(target.moved | kLinearXYZ | channel_.transformation.joint_axes());
    target.orientation = {};
    const ToolWords& tool = actions.tool;
    channel_.transformation.check_offset_programmed(block);
    OrientPlanner plan = planner();
    if (!plan.require_one_orientation(block, tool) || !plan.require_no_idle_words(block, tool))
        return kFailed;
    if (orienting_.takes_vectors && is_arc(modal_.motion)) {
        reporter_.report(diag::TcpArc, block, modal_.motion);
        return kFailed;
    }
    if (!channel_.compensation.require_no_peripheral_arc(block)) return kFailed;
    const Done is_laid = goes_straight(block, actions)
                             ? plan.lay_point_to_point(block, tool, target)
                             : plan.lay_tool_words(block, tool, target);
    if (!is_laid) return kFailed;
    settle_orientation(target);
    return kDone;
}

Done ToolMotion::lay_directions(const Block& block, const path::Curve& curve, Target& target) {
    return planner().lay_directions(block, curve, target);
}

std::optional<std::array<Vec3, 2>> ToolMotion::normals_of(const Block& block,
                                                          const ToolWords& tool) const {
    return planner().normals_of(block, tool);
}

/// What the block's end gives for the tool, for the command and for the blocks behind it.
void ToolMotion::settle_orientation(Target& target) {
    const Chain& chain = machine_.kinematics->chain;
    OrientPlan& orientation = target.orientation;
    orientation.direction =
        machine::tool_vector(chain, channel_.transformation.joints_of(target.base));
    orientation.is_made = true;
    direction_ = orientation.direction;
    if (orientation.orient_kind == OrientKind::Cone)
        orienting_.rate = orientation.axis.cross(orientation.direction) * orientation.angle;
}

machine::JointLimits ToolMotion::joint_limits() const {
    machine::JointLimits limits;
    const Chain& chain = machine_.kinematics->chain;
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (!chain.has(k)) continue;
        const std::size_t i = index(chain.joints[k].axis);
        limits[k] = {rad_from_deg(axes_.lower[i]), rad_from_deg(axes_.upper[i])};
    }
    return limits;
}

void ToolMotion::put_joints(const Vec3& joints, Target& target) const {
    const Chain& chain = machine_.kinematics->chain;
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (!chain.has(k)) continue;
        const std::size_t i = index(chain.joints[k].axis);
        target.base[i] = deg_from_rad(joints[static_cast<Eigen::Index>(k)]);
        target.here[i] = target.base[i] - frames_.shift_values()[i];
    }
}

void ToolMotion::reset_orientation(const Block& block, const nc::Invocation& invocation) {
    if (!orienting_.is_on) {
        reporter_.report(diag::OrientationAlone, block, invocation.function)
            .arg(reporter_.word_of(block, invocation.function));
        return;
    }
    const Chain& chain = machine_.kinematics->chain;
    Target target{position_.here(), position_.base(),
                  static_cast<AxisMask>(kLinearXYZ | channel_.transformation.joint_axes()),
                  kLinearXYZ};
    Vec3 joints = Vec3::Zero();
    constexpr std::size_t kFirst = nc::parameter_of<Function::OrientReset>("first");
    std::size_t axes = 0;
    const auto [first, second] = channel_.transformation.joints_in_order();
    for (const std::size_t k : {first, second, machine::kPsi}) {
        if (!chain.has(k)) continue;
        joints[static_cast<Eigen::Index>(k)] =
            rad_from_deg(block.argument(invocation, kFirst + axes++));
    }
    if (invocation.given >> (kFirst + axes) != 0) {
        reporter_.report(diag::ResetTooMany, block, invocation.function).arg(axes);
        return;
    }
    put_joints(joints, target);
    if (!channel_.checks.require_within_machine(block, target.base,
                                                channel_.transformation.joint_axes()))
        return;
    settle_orientation(target);
    channel_.motions.line(block, target, modal_.motion == Function::Rapid ? Op::Rapid : Op::Line,
                          false);
}

/// A motion under the transformation: the orientation that waits, or the axes as programmed.
void ToolMotion::put_orientation(path::Motion& motion, const OrientPlan* plan) {
    if (virtual_.axes.is_on()) {
        motion.orient_plainly(OrientKind::Axes);
        motion.virtual_system = virtual_.axes;
        return;
    }
    motion.virtual_system.reset();
    OrientPlan standing;
    standing.direction = direction_;
    const OrientPlan& orientation = plan != nullptr && plan->is_made ? *plan : standing;
    motion.direction = orientation.direction;
    if (goes_straight(motion.op())) return motion.orient_plainly(OrientKind::Straight);
    if (orientation.orient_kind <= OrientKind::Axes)
        return motion.orient_plainly(orientation.orient_kind);
    motion.orient_kind = orientation.orient_kind;
    motion.orient_details = path::OrientDetails{orientation.from, orientation.axis,
                                                orientation.angle, 0, orientation.lead_tilt};
}

}  // namespace kadr::interp
