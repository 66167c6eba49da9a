// spline_orientation.cpp — tool orientation along splines and polynomials.
//
// Blocks of a spline are read before their spans are known: what they program for the tool waits
// with them. Along a span the orientation changes as along any other path, in proportion to its
// length. A control point of a B-spline is no point of the path; the directions beside the control
// points are control points themselves, and at the end of every span the tool has the direction of
// their spline.
#include <bit>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "interp/channel.h"
#include "interp/motion_checks.h"
#include "interp/orient_planner.h"
#include "interp/radius_compensation.h"
#include "interp/splines.h"
#include "interp/tool_motion.h"
#include "interp/transformation.h"
#include "machine/chain.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using path::Vec3;

Done ToolMotion::require_orientation_along(const Block& block, const ToolWords& tool) {
    if (!orienting_.is_on && !tool.is_any()) return kDone;
    const bool is_alone =
        orienting_.is_on && !orienting_.has_length && !channel_.compensation.is_any_comp_on();
    // What is modal would act on the spans that wait, too.
    bool is_refused =
        tool.is_any() && (!is_alone || (tool.changes_lead_tilt && channel_.splines.is_in_spline()));
    if (modal_.motion == Function::Spline) {
        const OrientInterpolation interpolation = orienting_.interpolation;
        const bool is_free = interpolation == OrientInterpolation::Plane ||
                             interpolation == OrientInterpolation::Axes;
        const bool spins =
            tool.spin || tool.spin_by ||
            (tool.angles.is_given() && machine_.kinematics->chain.has(machine::kPsi));
        is_refused |= planner().is_led_by_surface(tool) || (tool.is_any() && !is_free) || spins;
    }
    if (is_refused) {
        reporter_.report(diag::IsoNotSupported, block)
            .arg("this interpolation of the orientation beside a spline");
        return kFailed;
    }
    if (!orienting_.is_on) return kDone;
    channel_.transformation.check_offset_programmed(block);
    if (!planner().require_one_orientation(block, tool)) return kFailed;
    return planner().require_no_idle_words(block, tool);
}

Done ToolMotion::orient_control_point(const Block& block, const ToolWords& tool,
                                      ControlPointBlock& control_point) {
    if (!orienting_.is_on) return kDone;
    if (tool.programs_direction()) {
        if (!planner().require_axes_for_direction(block)) return kFailed;
        const std::optional<Vec3> programmed = planner().wanted_direction(block, tool);
        if (!programmed) return kFailed;
        control_point.direction = *programmed;
        return kDone;
    }
    const Vec3 joints = channel_.transformation.joints_of(position_.base());
    control_point.direction =
        spline_->direction().value_or(machine::tool_vector(machine_.kinematics->chain, joints));
    return kDone;
}

Done ToolMotion::orient_along(const Block& at, const ControlPointBlock& control_point,
                              const path::Curve& span, AxisValues& to, OrientPlan& orientation) {
    const AxisValues from = path::with_linear(position_.base(), path::start(span));
    OrientPlanner plan(
        channel_, {frames_.from_base(from), from, control_point.modes, control_point.feed, true});
    Target target{frames_.from_base(from), from,
                  static_cast<AxisMask>(kLinearXYZ | channel_.transformation.joint_axes()),
                  kLinearXYZ};
    for (std::size_t i = 0; i < 3; ++i)
        target.base[i] = path::end(span)[static_cast<Eigen::Index>(i)];
    target.here = frames_.from_base(target.base);
    if (!plan.lay_span_orientation(at, control_point, span, target) ||
        !channel_.checks.require_within_limits(at, target.base,
                                               channel_.transformation.joint_axes()))
        return kFailed;
    orientation = target.orientation;
    for (AxisMask rest = channel_.transformation.joint_axes(); rest != 0;
         rest = static_cast<AxisMask>(rest & (rest - 1))) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        to[i] = target.base[i];
        position_.arrive_on(i, target.here[i], target.base[i]);
    }
    return kDone;
}

Done ToolMotion::share_orientation(const Block& block, const ToolWords& tool,
                                   const std::vector<double>& shares,
                                   const std::vector<ControlPointBlock*>& pieces) {
    if (!orienting_.is_on) return kDone;
    const bool is_led = planner().is_led_by_surface(tool);
    if (pieces.size() == 1 || (!tool.is_any() && !is_led)) {
        if (tool.is_any() || is_led) pieces.back()->tool = tool;
        return kDone;
    }
    const bool is_plane = orienting_.interpolation == OrientInterpolation::Plane &&
                          tool.programs_direction() && !is_led && !tool.spin && !tool.spin_by;
    if (!is_plane) {
        reporter_.report(diag::IsoNotSupported, block)
            .arg(
                "this interpolation of the orientation beside a polynomial with such a "
                "denominator");
        return kFailed;
    }
    if (!planner().require_axes_for_direction(block)) return kFailed;
    const std::optional<Vec3> to = planner().wanted_direction(block, tool);
    if (!to) return kFailed;
    const Vec3 from = machine::tool_vector(machine_.kinematics->chain,
                                           channel_.transformation.joints_of(position_.base()));
    const auto arc = machine::great_circle(from, *to);
    if (!arc) {
        reporter_.report(diag::OrientationOpposite, block);
        return kFailed;
    }
    double reached = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        reached += shares[i];
        const bool is_last = i + 1 == pieces.size();
        pieces[i]->direction =
            is_last ? *to : Vec3(Eigen::AngleAxisd(reached * arc->turn, arc->axis) * from);
    }
    return kDone;
}

}  // namespace kadr::interp
