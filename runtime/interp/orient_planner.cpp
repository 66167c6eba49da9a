// orient_planner.cpp — how the tool is oriented in a motion: the rotary positions at its end and
// the interpolation on the way.
//
// That is a cone, a great circle among them, or the axes in proportion; or the tool is led by the
// path, so that it waits until the path is known (lay_directions). Where the axes are on the way is
// motion's matter (motion/transformed.h).
#include "interp/orient_planner.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "base/diagnostics/machine.h"
#include "base/numbers.h"
#include "base/units.h"
#include "interp/channel.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/radius_compensation.h"
#include "interp/stages.h"
#include "interp/tool_motion.h"
#include "interp/transformation.h"
#include "machine/following.h"
#include "machine/orientation.h"
#include "path/linear.h"

namespace kadr::interp {

using machine::Chain;
using nc::Block;
using nc::Function;
using path::linear;
using path::Op;
using path::OrientKind;
using path::Vec3;

namespace {

/// Rounding of words and frames, as a tool's direction shows it, rad: no change of orientation.
constexpr double kSameDirection = 1e-12;
/// A tool that stands elsewhere than where its orientation begins by more goes there first, rad:
/// words have six digits and more.
constexpr double kSameStart = 1e-9;
/// Control points of directions that lie against each other make none, as a part of their length.
constexpr double kNoDirection = 1e-3;
/// Ends that are off a cone by more are not on it, rad; by less its axis is corrected.
constexpr double kOnCone = 0.1 * std::numbers::pi / 180;

/// How far the tool leaves a plane at most while the rotary axes run evenly, rad.
double angle_out_of(const Chain& chain, const Vec3& normal, const Vec3& from, const Vec3& to) {
    // Even a whole turn of R1 goes in steps of some degrees, between which the angle hardly
    // changes.
    constexpr int kSteps = 256;
    double most = 0;
    for (int i = 1; i < kSteps; ++i) {
        const double part = static_cast<double>(i) / kSteps;
        const Vec3 tool = machine::tool_vector(chain, from + part * (to - from));
        most = std::max(most, std::abs(normal.dot(tool)));
    }
    return std::asin(std::min(1.0, most));
}

std::string degrees(double angle) { return format_shortest(round_to(deg_from_rad(angle), 4)); }

std::string_view words_of(machine::CandidateFault fault) {
    using machine::CandidateFault;
    switch (fault) {
        case CandidateFault::NoSolution: return "does not exist";
        case CandidateFault::FirstOutside:
        case CandidateFault::SecondOutside:
        case CandidateFault::SpinOutside: return "is beyond a limit";
        case CandidateFault::OnlyLongTravel: return "is there by the longer path only";
        case CandidateFault::OtherConfiguration: return "is not on the path of the tool";
        case CandidateFault::LimitOnPath: return "is behind a limit on the way";
    }
    return "is not possible";
}

std::string words_of(const Chain& chain, const machine::PathRefusal& refusal) {
    std::string words;
    for (const machine::CandidateRefusal& refused : refusal.configurations) {
        if (refused.fault == machine::CandidateFault::NoSolution) continue;
        if (!words.empty()) words += "; ";
        words += kAxisNames[index(chain.joints[refused.joint].axis)];
        words += " at " + degrees(refused.value) + "° ";
        words += words_of(refused.fault);
    }
    return words;
}

/// The axis, turned by as little as possible so that both directions are on one cone about it.
Vec3 axis_between(const Vec3& axis, const Vec3& from, const Vec3& to) {
    const Vec3 delta = to - from;
    if (delta.norm() < kSameDirection) return axis;
    return (axis - axis.dot(delta) / delta.squaredNorm() * delta).normalized();
}

}  // namespace

OrientPlanner::OrientPlanner(Channel& channel, const OrientStart& start)
    : channel_(channel),
      start_(start),
      machine_(channel.state.machine),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      modal_(channel.state.motion.modal),
      frames_(channel.state.frame.frames),
      orienting_(channel.state.tool.orienting),
      comp_(channel.state.stage.comp),
      reported_(channel.state.reported) {}

Done OrientPlanner::lay_tool_words(const Block& block, const ToolWords& tool, Target& target) {
    if (tool.programs_direction() || tool.point.is_given() ||
        (block.given & channel_.transformation.joint_axes()) != 0)
        orienting_.lead_tilt_at_ends(false);
    const bool is_led = is_led_by_surface(tool) || tool.point.is_given() || tool.lead;
    const bool waits = spins_with_path(tool);
    if (is_led || waits) target.orientation.waiting = &tool;
    if (!is_led) {
        if (tool.programs_direction()) {
            if (!require_axes_for_direction(block)) return kFailed;
            const std::optional<Vec3> to = wanted_direction(block, tool);
            if (!to || !orient_to(block, tool, *to, target)) return kFailed;
        } else if (orienting_.has_length && !orient_by_axes(block, target)) {
            return kFailed;
        }
        if (!waits && !lay_spin(block, tool, target)) return kFailed;
        orienting_.point.reset();
    }
    return kDone;
}

/// Rotary axes are programmed where the tool is to go along a great circle: it must lead there.
Done OrientPlanner::orient_by_axes(const Block& block, Target& target) {
    if (start_.modes.interpolation != OrientInterpolation::Plane ||
        (block.given & channel_.transformation.joint_axes()) == 0)
        return kDone;
    const Chain& chain = machine_.kinematics->chain;
    constexpr double kSameJoint = 1e-6;  // rad
    const Vec3 wanted = channel_.transformation.joints_of(target.base);
    if ((wanted - channel_.transformation.joints_of(start_.base)).norm() < kSameJoint) return kDone;
    Target end{start_.here, start_.base, target.moved};
    if (!lay_orientation(block, machine::tool_vector(chain, wanted), end)) return kFailed;
    target.orientation = end.orientation;
    const Vec3 reached = channel_.transformation.joints_of(end.base);
    if ((reached - wanted).norm() < kSameJoint) return kDone;
    const std::size_t joint =
        std::abs(reached[0] - wanted[0]) > kSameJoint ? machine::kR1 : machine::kR2;
    reporter_.report(diag::OrientationNoWay, block)
        .arg(std::string(kAxisNames[index(chain.joints[joint].axis)]) + " comes to " +
             degrees(reached[static_cast<Eigen::Index>(joint)]) + "° on the great circle");
    return kFailed;
}

/// To a direction, by the interpolation that the program has chosen.
Done OrientPlanner::orient_to(const Block& block, const ToolWords& tool, const Vec3& to,
                              Target& target) {
    switch (start_.modes.interpolation) {
        case OrientInterpolation::ConeCw:
        case OrientInterpolation::ConeCcw:
        case OrientInterpolation::ConeOver:
        case OrientInterpolation::ConeOn: return lay_cone(block, tool, to, target);
        case OrientInterpolation::Plane:
        case OrientInterpolation::Axes:
        case OrientInterpolation::Surface:
        case OrientInterpolation::Point: break;
    }
    return lay_orientation(block, to, target, tool.angles.is_given() ? &tool : nullptr);
}

void OrientPlanner::report_no_solution(const Block& block, const machine::PathRefusal& refusal) {
    const Chain& chain = machine_.kinematics->chain;
    if (refusal.fault == machine::PathChoiceFault::Unreachable) {
        reporter_.report(diag::OrientationBeyond, block)
            .arg(chain.orients() ? "the direction is outside of the reach of its rotary axes"
                                 : "it has one rotary axis, which does not lead there");
    } else {
        reporter_.report(diag::OrientationNoWay, block).arg(words_of(chain, refusal));
    }
}

/// Along a great circle, or with the axes in proportion. With three rotary axes the block's angles
/// give its own rotation, too.
Done OrientPlanner::lay_orientation(const Block& block, const Vec3& to, Target& target,
                                    const ToolWords* angles) {
    const Chain& chain = machine_.kinematics->chain;
    const Vec3 joints = channel_.transformation.joints_of(start_.base);
    const Vec3 from = machine::tool_vector(chain, joints);
    const bool fixes_spin = angles != nullptr && chain.has(machine::kPsi);
    if ((to - from).norm() < kSameDirection && !fixes_spin) return kDone;
    machine::PathQuery query = query_to(to, angles);
    const bool is_plane = start_.modes.interpolation == OrientInterpolation::Plane ||
                          start_.modes.interpolation == OrientInterpolation::Surface;
    query.mode = is_plane ? machine::PathMode::Vector : machine::PathMode::Axis;
    const auto arc = machine::great_circle(from, to);
    if (is_plane && !arc) {
        reporter_.report(diag::OrientationOpposite, block);
        return kFailed;
    }
    const auto end = machine::choose_path(chain, query);
    if (!end) {
        report_no_solution(block, end.error());
        return kFailed;
    }
    channel_.tool_motion.put_joints(end->rotary, target);
    if (is_plane && end->mode == machine::PathMode::Axis)
        reporter_.report(diag::PlaneLeft, block)
            .arg(degrees(angle_out_of(chain, arc->axis, joints, end->rotary)));
    if (end->mode == machine::PathMode::Vector && arc->turn > kSameDirection) {
        target.orientation.orient_kind = OrientKind::Cone;
        target.orientation.axis = arc->axis;
        target.orientation.angle = arc->turn;
    }
    return kDone;
}

/// From where the rotary axes stand to a direction, with three rotary axes to what angles give.
machine::PathQuery OrientPlanner::query_to(const Vec3& to, const ToolWords* angles) const {
    const Chain& chain = machine_.kinematics->chain;
    machine::PathQuery query = machine::query_for(chain, to);
    if (angles != nullptr && chain.has(machine::kPsi)) {
        machine::Mat3 programmed = turn_into_base() * rotation_by_angles(angles->angles.vector());
        // What is mirrored of a tool is the axis from which its own angle counts.
        if (mirrors_words()) programmed.col(1) = programmed.col(2).cross(programmed.col(0));
        query.rotation = programmed * base_rotation().transpose();
        query.fixes_spin = true;
    }
    query.start = channel_.transformation.joints_of(start_.base);
    query.rule = machine_.kinematics->rule;
    query.pole_tolerance = machine_.kinematics->pole_tolerance;
    query.limits = channel_.tool_motion.joint_limits();
    return query;
}

/// The tool's base position as a rotation from Z: angles and own rotation count for a tool along Z.
machine::Mat3 OrientPlanner::base_rotation() const {
    return Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(),
                                              machine_.kinematics->chain.tool_direction)
        .toRotationMatrix();
}

// ------------------------------------------------------------------------------ cones

/// The cone from where the tool stands to a direction; nothing if it was reported.
std::optional<machine::OrientationArc> OrientPlanner::cone_to(const Block& block,
                                                              const ToolWords& tool,
                                                              const Vec3& from, const Vec3& to) {
    using machine::ConeSense;
    const bool is_cw =
        (start_.modes.interpolation == OrientInterpolation::ConeCw) != mirrors_words();
    const ConeSense sense = is_cw ? ConeSense::Cw : ConeSense::Ccw;
    const auto refuse = [&](const DiagnosticRow& row) {
        reporter_.report(row, block);
        return std::nullopt;
    };
    Result<machine::OrientationArc, machine::OrientationFault> arc =
        machine::OrientationFault::EqualVectors;
    if (start_.modes.interpolation == OrientInterpolation::ConeOver) {
        if (!tool.between.is_given()) return refuse(diag::ConeBetweenMissing);
        const auto between = direction_in_base(block, tool.between.vector(), Function::ToolBetween);
        if (!between) return std::nullopt;
        arc = machine::cone_through(from, *between, to);
    } else if (start_.modes.interpolation == OrientInterpolation::ConeOn) {
        arc = machine::cone_tangential(from, orienting_.rate, to);
    } else if (tool.cone_axis.is_given()) {
        const auto axis = direction_in_base(block, tool.cone_axis.vector(), Function::ConeAxis);
        if (!axis) return std::nullopt;
        const double off = path::angle_between(*axis, from) - path::angle_between(*axis, to);
        if (std::abs(off) > kOnCone) {
            reporter_.report(diag::ConeBeside, block, Function::ConeAxis)
                .arg(degrees(path::angle_between(*axis, from)))
                .arg(degrees(path::angle_between(*axis, to)));
            return std::nullopt;
        }
        arc = machine::cone_about(from, to, axis_between(*axis, from, to), sense, kOnCone);
    } else if (tool.opening) {
        arc = machine::cone_of_opening(from, to, rad_from_deg(std::abs(*tool.opening)), sense);
        if (!arc && arc.error() == machine::OrientationFault::OpeningSmall) {
            reporter_.report(diag::ConeOpeningSmall, block, Function::ConeOpening)
                .arg(*tool.opening)
                .arg(degrees(path::angle_between(from, to)));
            return std::nullopt;
        }
    } else {
        return refuse(diag::ConeMissing);
    }
    if (arc) return *arc;
    return refuse(diag::ConeUndefined);
}

Done OrientPlanner::lay_cone(const Block& block, const ToolWords& tool, const Vec3& to,
                             Target& target) {
    const Vec3 from = machine::tool_vector(machine_.kinematics->chain,
                                           channel_.transformation.joints_of(start_.base));
    const auto arc = cone_to(block, tool, from, to);
    if (!arc) return kFailed;
    target.orientation.orient_kind = OrientKind::Cone;
    target.orientation.axis = arc->axis;
    target.orientation.angle = arc->turn;
    return follow_directions(block, {OrientKind::Cone, 1, from, arc->axis, arc->turn, {}},
                             path::Point{}, target);
}

/// The rotary positions at the end of an orientation path.
Done OrientPlanner::follow_directions(const Block& block, const path::OrientLaw& orientation,
                                      const path::Curve& curve, Target& target) {
    const Chain& chain = machine_.kinematics->chain;
    const machine::FollowQuery query{channel_.transformation.joints_of(start_.base),
                                     channel_.tool_motion.joint_limits()};
    const auto end = machine::follow(chain, query, [&](double fraction) {
        return path::direction_at(orientation, curve, fraction * orientation.length);
    });
    if (!end) {
        report_no_solution(block, end.error());
        return kFailed;
    }
    channel_.tool_motion.put_joints(end->rotary, target);
    return kDone;
}

// ------------------------------------------------------------------------------ led by the path

Done OrientPlanner::lay_directions(const Block& block, const path::Curve& curve, Target& target) {
    const ToolWords& tool = *std::exchange(target.orientation.waiting, nullptr);
    if (tool.point.is_given()) {
        if (!lead_by_point(block, tool, curve, target)) return kFailed;
    } else if (tool.lead) {
        if (!apply_lead_tilt_at_end(block, tool, curve, target)) return kFailed;
    } else if (is_led_by_surface(tool)) {
        if (!lead_by_surface(block, tool, curve, target)) return kFailed;
    }
    if (!lay_spin(block, tool, target, &curve)) return kFailed;
    channel_.tool_motion.settle_orientation(target);
    return kDone;
}

/// The direction that the block programs, inclined towards the direction of travel at its end.
/// F 4.7 Q.
Done OrientPlanner::apply_lead_tilt_at_end(const Block& block, const ToolWords& tool,
                                           const path::Curve& curve, Target& target) {
    const std::optional<Vec3> normal = wanted_direction(block, tool);
    if (!normal) return kFailed;
    const path::LeadTiltAngles lead_tilt{rad_from_deg(*tool.lead), 0, path::TiltAbout::Tangent};
    const std::optional<Vec3> to = direction_on_surface(
        block, *normal, path::evaluate(curve, path::length(curve)).tangent, lead_tilt);
    if (!to) return kFailed;
    return orient_to(block, tool, *to, target);
}

/// The tool as it is inclined on a surface; nothing if it was reported.
std::optional<Vec3> OrientPlanner::direction_on_surface(const Block& block, const Vec3& normal,
                                                        const Vec3& tangent,
                                                        const path::LeadTiltAngles& lead_tilt) {
    if (lead_tilt.lead == 0 && lead_tilt.tilt == 0) return normal;
    if (tangent.isZero(0)) {
        reporter_.report(diag::LeanWithoutTravel, block);
        return std::nullopt;
    }
    if (!require_small_rise(block, path::rise_of(normal, tangent))) return std::nullopt;
    return path::leant(normal, tangent, lead_tilt);
}

/// The direction of travel goes out of the surface by no more than the control takes, rad. S 7.4.
Done OrientPlanner::require_small_rise(const Block& block, double rise) {
    if (std::abs(rise) <= rad_from_deg(rules_.surface_rise)) return kDone;
    reporter_.report(diag::SurfaceAcross, block).arg(degrees(std::abs(rise)));
    return kFailed;
}

/// … anywhere on the path along which the surface leads the tool.
Done OrientPlanner::require_small_rise_along(const Block& block, const path::OrientLaw& surface,
                                             const path::Curve& curve) {
    // At the ends of the parts; between them the rise of a full circle differs by a tenth of a
    // degree.
    constexpr int kParts = 64;
    double rise = 0;
    for (int i = 1; i < kParts; ++i) {
        const double distance = surface.length * i / kParts;
        const Vec3 normal =
            Eigen::AngleAxisd(surface.rate * distance, surface.axis) * surface.start;
        const double here = path::rise_of(normal, path::evaluate(curve, distance).tangent);
        if (std::abs(here) > std::abs(rise)) rise = here;
    }
    return require_small_rise(block, rise);
}

std::optional<std::array<Vec3, 2>> OrientPlanner::normals_of(const Block& block,
                                                             const ToolWords& tool) {
    const auto said = [&](std::size_t i) {
        const Vec3 normal = tool.normals[i].vector();
        const bool is_none = comp_.takes_surface_normals() && normal.isZero(0);
        if (!is_none) return direction_in_base(block, normal, Function::SurfaceNormal);
        reporter_.report(diag::CompFaceNormal, block, Function::SurfaceNormal)
            .arg("all its components are zero");
        return std::optional<Vec3>();
    };
    const bool has_start = tool.normals[0].is_given();
    const bool has_end = tool.normals[1].is_given();
    const std::optional<Vec3> unsaid = turn_into_base() * Vec3::UnitZ();
    if (!has_start && !has_end) return std::array{*unsaid, *unsaid};
    const auto start = has_start ? said(0) : orienting_.normal ? orienting_.normal : unsaid;
    if (!start) return std::nullopt;
    const auto end = has_end ? said(1) : start;
    if (!end) return std::nullopt;
    return std::array{*start, *end};
}

Done OrientPlanner::lead_by_surface(const Block& block, const ToolWords& tool,
                                    const path::Curve& curve, Target& target) {
    const auto normals = normals_of(block, tool);
    if (!normals) return kFailed;
    path::LeadTiltAngles lead_tilt = orienting_.lead_tilt;
    if (mirrors_words()) lead_tilt.tilt = -lead_tilt.tilt;
    lead_tilt.about = rules_.tilt_about_normal ? path::TiltAbout::Normal : path::TiltAbout::Tangent;
    const double length = path::length(curve);
    const bool is_still_leant =
        length == 0 && !start_.modes.keeps_lead_tilt_to_surface() && !tool.programs_surface();
    if (is_still_leant) return kDone;
    // Where the tip stands there is no path to be led by, and where the control only looks at the
    // block's end it is not.
    const bool is_led = length > 0 && start_.modes.keeps_lead_tilt_to_surface();
    const auto start = is_led ? direction_on_surface(block, (*normals)[0],
                                                     path::evaluate(curve, 0).tangent, lead_tilt)
                              : normals->front();
    if (!start) return kFailed;
    const auto end = direction_on_surface(block, (*normals)[1],
                                          path::evaluate(curve, length).tangent, lead_tilt);
    if (!end) return kFailed;
    orienting_.normal = (*normals)[1];
    if (!is_led) return orient_to(block, tool, *end, target);
    const auto arc = machine::great_circle((*normals)[0], (*normals)[1]);
    if (!arc) {
        reporter_.report(diag::OrientationOpposite, block);
        return kFailed;
    }
    const path::OrientLaw surface{OrientKind::Surface, length,   (*normals)[0], arc->axis,
                                  arc->turn / length,  lead_tilt};
    const bool is_inclined = lead_tilt.lead != 0 || lead_tilt.tilt != 0;
    if (is_inclined && !require_small_rise_along(block, surface, curve)) return kFailed;
    if (!orient_first(block, *start)) return kFailed;
    target.orientation.orient_kind = OrientKind::Surface;
    target.orientation.from = (*normals)[0];
    target.orientation.axis = arc->axis;
    target.orientation.angle = arc->turn;
    target.orientation.lead_tilt = lead_tilt;
    return follow_directions(block, surface, curve, target);
}

/// A second point of the tool's axis goes straight to the point that the block programs, S 7.4
/// ORICURVE. Where none was programmed before it starts as far from the tip as it will end.
Done OrientPlanner::lead_by_point(const Block& block, const ToolWords& tool,
                                  const path::Curve& curve, Target& target) {
    const Chain& chain = machine_.kinematics->chain;
    const Vec3 tip = path::start(curve);
    const Vec3 direction =
        machine::tool_vector(chain, channel_.transformation.joints_of(start_.base));
    AxisValues position{};
    const AxisValues before =
        orienting_.point ? frames_.from_base({(*orienting_.point)[0], (*orienting_.point)[1],
                                              (*orienting_.point)[2]})
                         : target.here;
    for (std::size_t i = 0; i < 3; ++i) {
        const bool is_given = (tool.point.parts >> i & 1u) != 0;
        position[i] = is_given ? tool.point.values[i] : before[i];
    }
    const Vec3 end = linear(frames_.to_base(position));
    const double reach = (end - path::end(curve)).norm();
    const Vec3 start = orienting_.point.value_or(tip + reach * direction);
    constexpr double kNoReach = 1e-6;  // mm
    if (reach < kNoReach || (start - tip).norm() < kNoReach) {
        reporter_.report(diag::PointAtTip, block, Function::ToolPoint);
        return kFailed;
    }
    if (!orient_first(block, (start - tip).normalized())) return kFailed;
    const bool stands = path::length(curve) == 0;
    const double length = stands ? 1 : path::length(curve);
    target.orientation.orient_kind = OrientKind::Point;
    target.orientation.from = start;
    target.orientation.axis = end - start;
    orienting_.point = end;
    return follow_directions(
        block, {OrientKind::Point, length, start, (end - start) / length, 0, {}}, curve, target);
}

/// Where the orientation begins with another direction than the tool has, the tool goes there
/// first, along a great circle, while the tip stands.
Done OrientPlanner::orient_first(const Block& block, const Vec3& to) {
    const Chain& chain = machine_.kinematics->chain;
    const Vec3 from = machine::tool_vector(chain, channel_.transformation.joints_of(start_.base));
    if (path::angle_between(from, to) < kSameStart) return kDone;
    Target here{start_.here, start_.base,
                static_cast<AxisMask>(kLinearXYZ | channel_.transformation.joint_axes()),
                kLinearXYZ};
    OrientPlanner on_great_circle = *this;
    on_great_circle.start_.modes.interpolation = OrientInterpolation::Plane;
    if (!on_great_circle.lay_orientation(block, to, here)) return kFailed;
    channel_.tool_motion.settle_orientation(here);
    path::Motion& motion =
        channel_.stages
            .put(modal_.motion == Function::Rapid ? Op::Rapid : Op::Line, block, &here.orientation)
            .motion();
    motion.to = here.base;
    motion.moved = here.moved;
    motion.feed = motion.op() == Op::Rapid ? 0 : start_.feed;
    start_.here = here.here;
    start_.base = here.base;
    // Of a span the tool is where blocks that have been read meanwhile lead.
    if (!start_.is_of_span) channel_.motions.arrive(here);
    return kDone;
}

// ------------------------------------------------------------------------------ about itself

/// Whether the tool's own angle counts from the direction of travel.
bool OrientPlanner::spins_with_path(const ToolWords& tool) const {
    return start_.modes.spin == SpinFrom::Path && (tool.spin || tool.spin_by);
}

/// The direction across the tool from which its own angle counts; nothing if there is none.
std::optional<Vec3> OrientPlanner::spin_reference(const Vec3& tool, const OrientPlan& orientation,
                                                  const path::Curve* curve) const {
    Vec3 reference = Vec3::Zero();
    switch (start_.modes.spin) {
        case SpinFrom::Plane:
        case SpinFrom::Turn:
            if (orientation.orient_kind == OrientKind::Cone)
                reference = orientation.axis.cross(tool) * (orientation.angle < 0 ? -1 : 1);
            break;
        case SpinFrom::Path:
            if (curve != nullptr) reference = path::evaluate(*curve, path::length(*curve)).tangent;
            break;
        case SpinFrom::Fixed: {
            const machine::Mat3 back = turn_into_base().transpose();
            const Vec3 programmed = back * tool;
            const double away = std::hypot(programmed.x(), programmed.y());
            const double around =
                away < kSameStart ? 0 : std::atan2(programmed.y(), programmed.x());
            const double tilt = std::atan2(away, programmed.z());
            const machine::Mat3 turned =
                start_.modes.euler == ToolAngles::Zyz
                    ? machine::euler_zyz({around, tilt, 0})
                    : machine::euler_zxz(
                          {away < kSameStart ? 0 : around + std::numbers::pi / 2, tilt, 0});
            reference = back.transpose() * turned.col(0);
        }
    }
    reference -= reference.dot(tool) * tool;
    if (reference.norm() < kSameStart) return std::nullopt;
    return reference.normalized();
}

/// The angle about the tool that the block programs, as the end of the joint Ψ.
Done OrientPlanner::lay_spin(const Block& block, const ToolWords& tool, Target& target,
                             const path::Curve* curve) {
    if (!tool.spin && !tool.spin_by) return kDone;
    const Chain& chain = machine_.kinematics->chain;
    if (!chain.has(machine::kPsi)) {
        if (reported_.first_time(RunNotice::Spin))
            reporter_.report(diag::SpinWithoutAxis, block, Function::ToolSpin);
        return kDone;
    }
    Vec3 joints = channel_.transformation.joints_of(target.base);
    double& psi = joints[2];
    const double sign = chain.joints[machine::kPsi].sign;
    const double sense = mirrors_words() ? -1 : 1;
    if (tool.spin_by) {
        psi += sign * sense * rad_from_deg(*tool.spin_by);
    } else {
        const Vec3 direction = machine::tool_vector(chain, joints);
        const auto reference = spin_reference(direction, target.orientation, curve);
        if (!reference) {
            reporter_.report(diag::SpinUndefined, block, Function::ToolSpin);
            return kFailed;
        }
        // Where the tool's own X would be without Ψ, and where it is wanted.
        const Vec3 across =
            machine::rotation_of(chain, {joints[0], joints[1], 0}) * base_rotation().col(0);
        const Vec3 wanted =
            Eigen::AngleAxisd(sense * rad_from_deg(*tool.spin), direction) * *reference;
        const double angle =
            std::atan2(direction.dot(across.cross(wanted)), across.dot(wanted)) * sign;
        const double before = channel_.transformation.joints_of(start_.base)[2];
        psi = before + std::remainder(angle - before, 2 * std::numbers::pi);
    }
    const machine::AxisRange limits = channel_.tool_motion.joint_limits()[machine::kPsi];
    if (psi < limits.lower || psi > limits.upper) {
        machine::PathRefusal refusal;
        refusal.configurations[0] = {machine::CandidateFault::SpinOutside, machine::kPsi, psi,
                                     limits};
        report_no_solution(block, refusal);
        return kFailed;
    }
    channel_.tool_motion.put_joints(joints, target);
    return kDone;
}

// ------------------------------------------------------------------------------ spans

Done OrientPlanner::lay_span_orientation(const Block& at, const ControlPointBlock& control_point,
                                         const path::Curve& span, Target& target) {
    target.orientation = {};
    if (control_point.direction) {
        if (control_point.direction->norm() < kNoDirection) {
            reporter_.report(diag::OrientationOpposite, at);
            return kFailed;
        }
        if (!lay_orientation(at, control_point.direction->normalized(), target)) return kFailed;
        orienting_.lead_tilt_at_ends(false);
    } else {
        static const ToolWords kNone;
        if (!lay_tool_words(at, control_point.tool ? *control_point.tool : kNone, target))
            return kFailed;
        if (target.orientation.waiting != nullptr) return lay_directions(at, span, target);
    }
    channel_.tool_motion.settle_orientation(target);
    return kDone;
}

}  // namespace kadr::interp
