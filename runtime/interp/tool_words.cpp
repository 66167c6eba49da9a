// tool_words.cpp — what the words of a block program for the tool: which of them belong together,
// and the direction that they mean.
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "base/diagnostics/iso.h"
#include "base/diagnostics/orienting.h"
#include "base/numbers.h"
#include "base/units.h"
#include "interp/channel.h"
#include "interp/orient_planner.h"
#include "interp/tool_motion.h"
#include "interp/transformation.h"
#include "machine/orientation.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::parameter_of;
using nc::parameter_of_all;
using path::Vec3;

namespace {

/// A lead or a tilt inclines the tool out of the surface by less than this, deg.
constexpr double kMostLeadTilt = 90;
/// … and a cone opens by no more, deg; a sign means another form of the same.
constexpr double kMostOpening = 180;

constexpr std::size_t kSpinAt = parameter_of<Function::ToolSpin>("at");

/// A count that a form of the dialect has; what is none is beyond all of them.
std::size_t small_count(const Block& block, const nc::Invocation& invocation,
                        std::size_t parameter) {
    constexpr double kMost = 9;
    const double value = block.argument(invocation, parameter);
    return static_cast<std::size_t>(value >= 0 && value < kMost ? value : kMost);
}

}  // namespace

ToolMotion::ToolMotion(Channel& channel)
    : channel_(channel),
      machine_(channel.state.machine),
      reporter_(channel.state.reporter),
      rules_(channel.state.rules),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      orienting_(channel.state.tool.orienting),
      virtual_(channel.state.tool.virtual_axes),
      comp_(channel.state.stage.comp),
      spline_(channel.state.cycle.spline),
      reported_(channel.state.reported),
      axes_(channel.state.axes) {}

void ToolMotion::take_orientation(const Block& block, const nc::Invocation& invocation,
                                  Actions& actions) {
    const bool is_of_cutter =
        invocation.function == Function::SurfaceNormal && comp_.takes_surface_normals();
    if (!orienting_.is_on && !is_of_cutter) {
        reporter_.report(diag::OrientationAlone, block, invocation.function)
            .arg(reporter_.word_of(block, invocation.function));
        return;
    }
    ToolWords& tool = actions.tool;
    const auto component = [&](ToolWords::Triple& triple) {
        constexpr std::size_t kComponent =
            parameter_of_all<"component", Function::ToolVector, Function::ToolAngle,
                             Function::ConeAxis, Function::ToolBetween>();
        constexpr std::size_t kValue =
            parameter_of_all<"value", Function::ToolVector, Function::ToolAngle, Function::ConeAxis,
                             Function::ToolBetween, Function::ToolPoint>();
        static_assert(kComponent == parameter_of<Function::ToolPoint>("axis"));
        const std::size_t part = small_count(block, invocation, kComponent);
        if (part < 3) triple.set(part, block.argument(invocation, kValue));
    };
    switch (invocation.function) {
        case Function::ToolVector:
            component(tool.vector);
            if (orienting_.lead != 0 && !tool.lead) tool.lead = orienting_.lead;
            return;
        case Function::ToolAngle: return component(tool.angles);
        case Function::ConeAxis: return component(tool.cone_axis);
        case Function::ToolBetween: return component(tool.between);
        case Function::ToolPoint: return component(tool.point);
        case Function::SurfaceNormal: {
            constexpr std::size_t kAt = parameter_of<Function::SurfaceNormal>("at");
            constexpr std::size_t kComponent = parameter_of<Function::SurfaceNormal>("component");
            constexpr std::size_t kValue = parameter_of<Function::SurfaceNormal>("value");
            const std::size_t end = small_count(block, invocation, kAt);
            const std::size_t part = small_count(block, invocation, kComponent);
            if (end < 2 && part < 3)
                tool.normals[end].set(part, block.argument(invocation, kValue));
            return;
        }
        case Function::ConeOpening: return take_opening(block, invocation, tool);
        case Function::ToolLead:
            tool.lead = block.argument(invocation, parameter_of<Function::ToolLead>("angle"));
            return;
        case Function::ToolSpin: {
            constexpr std::size_t kAngle = parameter_of<Function::ToolSpin>("angle");
            constexpr std::size_t kBy = parameter_of<Function::ToolSpin>("by");
            if (invocation.has(kAngle)) tool.spin = block.argument(invocation, kAngle);
            if (invocation.has(kBy)) tool.spin_by = block.argument(invocation, kBy);
            if (invocation.has(kSpinAt)) tool.spin = block.argument(invocation, kSpinAt);
            return;
        }
        case Function::SurfaceLead:
        case Function::SurfaceTilt: return take_lead_tilt(block, invocation, tool);
        default: return;
    }
}

void ToolMotion::take_opening(const Block& block, const nc::Invocation& invocation,
                              ToolWords& tool) {
    const double opening = block.argument(invocation, parameter_of<Function::ConeOpening>("angle"));
    if (std::abs(opening) <= kMostOpening) {
        tool.opening = opening;
    } else {
        reporter_.report(diag::ConeOpeningRange, block, invocation.function).arg(opening);
    }
}

void ToolMotion::take_lead_tilt(const Block& block, const nc::Invocation& invocation,
                                ToolWords& tool) {
    const bool is_lead = invocation.function == Function::SurfaceLead;
    const double angle = block.argument(
        invocation, parameter_of_all<"angle", Function::SurfaceLead, Function::SurfaceTilt>());
    if (!(std::abs(angle) < kMostLeadTilt)) {
        reporter_
            .report(is_lead ? diag::LeadTooLarge : diag::TiltTooLarge, block, invocation.function)
            .arg(angle);
        return;
    }
    (is_lead ? orienting_.lead_tilt.lead : orienting_.lead_tilt.tilt) = rad_from_deg(angle);
    tool.changes_lead_tilt = true;
    if (planner().surface_leads_end()) orienting_.lead_tilt_at_ends(true);
}

// ------------------------------------------------------------------------------ what they mean

Done OrientPlanner::require_one_orientation(const Block& block, const ToolWords& tool) {
    const bool has_axes = (block.given & channel_.transformation.joint_axes()) != 0;
    const bool has_vector = tool.vector.is_given();
    const bool has_angles = tool.angles.is_given();
    const bool leads = start_.modes.keeps_lead_tilt_to_surface() || surface_leads_end() ||
                       !comp_.takes_surface_normals();
    const bool has_surface = leads && tool.programs_surface();
    const bool is_on_surface = start_.modes.keeps_lead_tilt_to_surface() ||
                               (surface_leads_end() && tool.programs_surface());
    const DiagnosticRow* row = has_vector && has_angles  ? &diag::OrientVectorAngles
                               : has_vector && has_axes  ? &diag::OrientVectorAxes
                               : has_angles && has_axes  ? &diag::OrientAnglesAxes
                               : has_surface && has_axes ? &diag::OrientSurfaceAxes
                               : (has_vector || has_angles) && is_on_surface
                                   ? &diag::OrientOnSurface
                                   : nullptr;
    if (row == nullptr) return kDone;
    reporter_.report(*row, block, has_vector ? Function::ToolVector : Function::ToolAngle);
    return kFailed;
}

Done OrientPlanner::require_axes_for_direction(const Block& block) {
    const machine::Chain& chain = machine_.kinematics->chain;
    const bool has_both = chain.has(machine::kR1) && chain.has(machine::kR2);
    if (has_both || !rules_.direction_needs_two_axes) return kDone;
    reporter_.report(diag::OrientationBeyond, block).arg("it has one rotary axis");
    return kFailed;
}

bool OrientPlanner::is_led_by_surface(const ToolWords& tool) const {
    if (start_.modes.keeps_lead_tilt_to_surface()) return true;
    return surface_leads_end() && (orienting_.has_lead_tilt || tool.programs_surface());
}

bool OrientPlanner::surface_leads_end() const {
    const OrientInterpolation interpolation = start_.modes.interpolation;
    const bool is_free =
        interpolation == OrientInterpolation::Plane || interpolation == OrientInterpolation::Axes;
    return rules_.surface_words_at_end && is_free && !comp_.takes_surface_normals();
}

Done OrientPlanner::require_no_idle_words(const Block& block, const ToolWords& tool) {
    const OrientInterpolation interpolation = start_.modes.interpolation;
    const bool is_about_axis = interpolation == OrientInterpolation::ConeCw ||
                               interpolation == OrientInterpolation::ConeCcw;
    const bool takes_surface = interpolation == OrientInterpolation::Surface ||
                               surface_leads_end() || comp_.takes_surface_normals();
    const nc::Invocation* const spin = block.find(Function::ToolSpin);
    if (spin != nullptr && spin->has(kSpinAt) && start_.modes.spin == SpinFrom::Path) {
        reporter_.report(diag::SpinAgainstPath, block, Function::ToolSpin)
            .arg(reporter_.word_of(block, Function::ToolSpin));
        return kFailed;
    }
    if (tool.lead.has_value() && !tool.vector.is_given()) {
        reporter_.report(diag::OrientLeadAlone, block, Function::ToolLead)
            .arg(reporter_.word_of(block, Function::ToolLead));
        return kFailed;
    }
    const struct {
        bool is_idle;
        Function word;
    } checks[] = {
        {tool.cone_axis.is_given() && !is_about_axis, Function::ConeAxis},
        {tool.opening.has_value() && !is_about_axis, Function::ConeOpening},
        {tool.between.is_given() && interpolation != OrientInterpolation::ConeOver,
         Function::ToolBetween},
        {tool.point.is_given() && interpolation != OrientInterpolation::Point, Function::ToolPoint},
        {tool.normals[0].is_given() && !takes_surface, Function::SurfaceNormal},
        {tool.normals[1].is_given() && !takes_surface, Function::SurfaceNormal},
        {tool.changes_lead_tilt && tool.programs_direction(),
         block.find(Function::SurfaceLead) != nullptr ? Function::SurfaceLead
                                                      : Function::SurfaceTilt},
        {tool.programs_direction() && tool.point.is_given(), Function::ToolVector},
    };
    for (const auto& check : checks) {
        if (!check.is_idle) continue;
        reporter_.report(diag::OrientWordIdle, block, check.word)
            .arg(reporter_.word_of(block, check.word))
            .arg(reporter_.spelling_of(function_of(interpolation)));
        return kFailed;
    }
    if (is_on_cone(interpolation) && !tool.programs_direction() && tool.is_any() && !tool.spin &&
        !tool.spin_by) {
        reporter_.report(diag::ConeEndMissing, block);
        return kFailed;
    }
    return kDone;
}

/// The rotation that the block's angles give, in the system in which they are programmed.
machine::Mat3 OrientPlanner::rotation_by_angles(const Vec3& angles_deg) const {
    const Vec3 angles = angles_deg * (std::numbers::pi / 180);
    switch (start_.modes.angles) {
        case ToolAngles::Rpy: return machine::rpy_zyx(angles);
        case ToolAngles::Xyz: return machine::rpy_xyz(angles);
        case ToolAngles::Zyz: return machine::euler_zyz(angles);
        case ToolAngles::Euler: break;
    }
    return machine::euler_zxz(angles);
}

/// How frames turn what is programmed for the tool into the base system. Scales stretch positions,
/// not directions. Under ORIMKS and its kin frames do nothing but where the table lies.
machine::Mat3 OrientPlanner::turn_into_base() const {
    machine::Mat3 rotation = machine::Mat3::Identity();
    if (start_.modes.is_in_base || frames_.is_shift()) return rotation;
    for (Eigen::Index i = 0; i < 3; ++i)
        rotation.col(i) = frames_.total().direction(Vec3::Unit(i)).normalized();
    return rotation;
}

/// Whether frames mirror what is programmed for the tool: what goes by the right-hand rule about
/// something goes the other way round then.
bool OrientPlanner::mirrors_words() const { return turn_into_base().determinant() < 0; }

std::optional<Vec3> OrientPlanner::direction_in_base(const Block& block, const Vec3& programmed,
                                                     Function word) {
    const auto direction = machine::unit_of(Vec3(turn_into_base() * programmed));
    if (direction) return *direction;
    reporter_.report(diag::OrientationZero, block, word);
    return std::nullopt;
}

std::optional<Vec3> OrientPlanner::wanted_direction(const Block& block, const ToolWords& tool) {
    const Vec3 programmed = tool.angles.is_given()
                                ? Vec3(rotation_by_angles(tool.angles.vector()) * Vec3::UnitZ())
                                : tool.vector.vector();
    return direction_in_base(block, programmed, Function::ToolVector);
}

}  // namespace kadr::interp
