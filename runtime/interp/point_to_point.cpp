// point_to_point.cpp — motions from point to point under the machine's transformation.
//
// Where such a block ends is programmed as ever: the tip and the tool in the workpiece. On the path
// every axis of the machine goes straight (motion/standing.h), so nothing leads the tool there, and
// the block may ask for one of several positions of the rotary axes. S 7.4, alarms 14140 and 14144.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/diagnostics/iso.h"
#include "base/diagnostics/orienting.h"
#include "base/units.h"
#include "interp/channel.h"
#include "interp/orient_planner.h"
#include "interp/tool_motion.h"
#include "interp/transformation.h"
#include "nc/parameters.h"

namespace kadr::interp {

using machine::Chain;
using nc::Block;
using nc::Function;
using path::Op;
using path::Vec3;

namespace {

constexpr double kWhole = 360;  // deg
/// A position below 0 is so far below, rad: 0 itself is not negative.
constexpr double kBelowZero = 1e-8;

/// A rotary axis that goes farther either way has several positions of the same sign: there the
/// sign decides nothing, and the axis takes its nearest position.
bool is_told_by_sign(const machine::MachineAxis& axis) {
    constexpr double kSlack = 1e-9;  // rad
    const double whole = 2 * std::numbers::pi + kSlack;
    return axis.lower >= -whole && axis.upper <= whole;
}

}  // namespace

bool ToolMotion::goes_straight(Op op) const {
    if (!orienting_.is_on || orienting_.has_length) return false;
    switch (orienting_.point_to_point) {
        case PointToPoint::None: return false;
        case PointToPoint::All: return op == Op::Rapid || op == Op::Line;
        // Beside a contour the tip goes along its path at rapid, too.
        case PointToPoint::Rapids: return op == Op::Rapid && !comp_.is_on();
    }
    return false;
}

bool ToolMotion::goes_straight(const Block& block, const Actions& actions) const {
    const Function motion = block.motion != Function::None ? block.motion : modal_.motion;
    const bool is_rapid = actions.at_rapid || motion == Function::Rapid;
    return goes_straight(is_rapid ? Op::Rapid : Op::Line);
}

Done ToolMotion::require_point_to_point_motion(const Block& block, const Actions& actions) {
    const bool is_wanted = orienting_.point_to_point == PointToPoint::All ||
                           (orienting_.point_to_point == PointToPoint::Rapids &&
                            (actions.at_rapid || modal_.motion == Function::Rapid));
    if (is_wanted && virtual_.axes.is_on()) {
        reporter_.report(diag::IsoNotSupported, block)
            .arg("a motion from point to point under TRANSMIT, TRACYL or TRAANG");
        return kFailed;
    }
    if (orienting_.point_to_point != PointToPoint::All || !orienting_.is_on ||
        orienting_.has_length)
        return kDone;
    std::string why;
    if (actions.smooth_approach != nullptr)
        why = reporter_.word_of(block, actions.smooth_approach->function);
    else if (comp_.is_on()) why = reporter_.spelling_of(function_of(comp_.side));
    else if (actions.probes) why = reporter_.word_of(block, Function::Probe);
    else if (!actions.at_rapid && modal_.motion != Function::Rapid &&
             modal_.motion != Function::Line)
        why = reporter_.spelling_of(modal_.motion);
    else if (actions.taps) why = reporter_.word_of(block, Function::TapFloating);
    if (why.empty()) return kDone;
    reporter_.report(diag::PointMotion, block).arg(why);
    return kFailed;
}

void ToolMotion::choose_axes(const Block& block, const nc::Invocation& invocation,
                             ToolWords& tool) {
    const Function function = invocation.function;
    if (!channel_.transformation.is_transformed()) {
        reporter_.report(diag::AxisChoiceAlone, block, function)
            .arg(reporter_.word_of(block, function));
        return;
    }
    constexpr double kMost = 1 << 16;
    constexpr std::size_t kBits =
        nc::parameter_of_all<"bits", Function::AxisConfiguration, Function::AxisSigns>();
    const double value = block.argument(invocation, kBits);
    const bool is_whole = value >= 0 && value < kMost && value == std::trunc(value);
    const auto bits = static_cast<unsigned>(is_whole ? value : kMost);
    unsigned known = function == Function::AxisConfiguration ? 1 : 0;
    if (function == Function::AxisSigns) {
        for (std::size_t i = 0; i < machine_.axes.size(); ++i)
            if (machine_.axes[i].is_rotary) known |= 1u << i;
    }
    if ((bits & ~known) != 0) {
        reporter_.report(diag::AxisChoiceBit, block, function)
            .arg(value)
            .arg(reporter_.word_of(block, function));
        return;
    }
    if (function == Function::AxisConfiguration) {
        orienting_.configuration = static_cast<int>(bits) + 1;
        tool.programs_configuration = true;
    } else {
        tool.signs = bits;
    }
}

/// The limits of the joints, as the block's signs leave them.
machine::JointLimits OrientPlanner::signed_limits(const ToolWords& tool) const {
    machine::JointLimits limits = channel_.tool_motion.joint_limits();
    if (!tool.signs) return limits;
    const Chain& chain = machine_.kinematics->chain;
    for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
        const machine::MachineAxis& axis = machine_.axes[i];
        if (!is_told_by_sign(axis)) continue;
        for (std::size_t k = 0; k < machine::kJoints; ++k) {
            if (!chain.has(k) || chain.joints[k].axis != axis.axis) continue;
            const bool is_negative = (*tool.signs >> i & 1u) != 0;
            if (is_negative) limits[k].upper = std::min(limits[k].upper, -kBelowZero);
            else limits[k].lower = std::max(limits[k].lower, 0.0);
        }
    }
    return limits;
}

Done OrientPlanner::lay_point_to_point(const Block& block, const ToolWords& tool, Target& target) {
    const bool is_led = is_led_by_surface(tool) || tool.point.is_given() || spins_with_path(tool);
    if (is_led || tool.lead) {
        const Function word =
            tool.lead ? Function::ToolLead : function_of(start_.modes.interpolation);
        reporter_.report(diag::PointMotion, block)
            .arg(spins_with_path(tool) ? reporter_.spelling_of(function_of(start_.modes.spin))
                 : tool.lead           ? reporter_.word_of(block, word)
                                       : reporter_.spelling_of(word));
        return kFailed;
    }
    orienting_.point.reset();
    if (tool.programs_direction()) {
        if (!require_axes_for_direction(block)) return kFailed;
        const std::optional<Vec3> to = wanted_direction(block, tool);
        if (!to || !stand_along(block, tool, *to, target)) return kFailed;
    } else if ((block.given & channel_.transformation.joint_axes()) != 0) {
        if (!turn_by_signs(block, tool, target)) return kFailed;
    } else if (tool.signs || tool.programs_configuration) {
        const Vec3 stays = machine::tool_vector(machine_.kinematics->chain,
                                                channel_.transformation.joints_of(start_.base));
        if (!stand_along(block, tool, stays, target)) return kFailed;
    }
    return lay_spin(block, tool, target);
}

/// The rotary axes hold the tool along a direction, in the position that the block asks for, or the
/// nearest one.
Done OrientPlanner::stand_along(const Block& block, const ToolWords& tool, const Vec3& to,
                                Target& target) {
    const Chain& chain = machine_.kinematics->chain;
    machine::PathQuery query = query_to(to, tool.angles.is_given() ? &tool : nullptr);
    query.mode = machine::PathMode::Axis;
    const auto nearest = machine::choose_path(chain, query);
    if (!nearest) {
        report_no_solution(block, nearest.error());
        return kFailed;
    }
    query.configuration = orienting_.configuration;
    query.limits = signed_limits(tool);
    const auto end = machine::choose_path(chain, query);
    if (!end) {
        reporter_.report(diag::AxisChoiceMissing, block);
        return kFailed;
    }
    channel_.tool_motion.put_joints(end->rotary, target);
    return kDone;
}

/// Rotary axes that are programmed go to the turn that has the sign of the block.
Done OrientPlanner::turn_by_signs(const Block& block, const ToolWords& tool, Target& target) {
    if (!tool.signs) return kDone;
    const Chain& chain = machine_.kinematics->chain;
    const machine::JointLimits limits = signed_limits(tool);
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        if (!chain.has(k) || !block.has(nc::slot_of(chain.joints[k].axis))) continue;
        const std::size_t i = index(chain.joints[k].axis);
        double& parameter = target.base[i];
        const auto fits = [&](double at) {
            constexpr double kSlack = 1e-9;  // rad
            return rad_from_deg(at) >= limits[k].lower - kSlack &&
                   rad_from_deg(at) <= limits[k].upper + kSlack;
        };
        for (const double other : {parameter - kWhole, parameter + kWhole})
            if (!fits(parameter) && fits(other)) parameter = other;
        if (!fits(parameter)) {
            reporter_.report(diag::AxisChoiceMissing, block);
            return kFailed;
        }
        target.here[i] = parameter - frames_.shift_values()[i];
    }
    return kDone;
}

}  // namespace kadr::interp
