// orient_planner.h — plans how the tool is oriented in one motion: what the words of a block, or of
// a span that was read before, make of it.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// What the orientation of a motion begins with. Of a block that is executed: where the tool stands
/// and what is in force; of a span, whose blocks were read before: where the span begins, with what
/// was in force then.
struct OrientStart {
    AxisValues here{};  // in the programmed system
    AxisValues base{};  // in the base system
    OrientModes modes;
    double feed = 0;  // of a motion that orients the tool first, unit of the feed mode
    bool is_of_span = false;
};

/// Plans the orientation of the tool in one motion: where the rotary axes stand at its end, and how
/// they come there. The plan is `Target::orientation`.
class OrientPlanner {
  public:
    OrientPlanner(Channel& channel, const OrientStart& start);

    // ---------------------------------------------------------------- what the words say
    /// No words stand side by side that exclude each other.
    Done require_one_orientation(const nc::Block& block, const ToolWords& tool);
    /// For a direction of the tool some controls want two rotary axes. A 2.4.
    Done require_axes_for_direction(const nc::Block& block);
    /// Words that the interpolation in force has no use for: nothing may be lost silently.
    Done require_no_idle_words(const nc::Block& block, const ToolWords& tool);
    /// Whether a surface gives the orientation in this block: along it, or at its end.
    bool is_led_by_surface(const ToolWords& tool) const;
    /// Whether surface words of a block give the orientation at its end. Where a cutter is
    /// compensated on the surface they are of the surface alone; a cone, or the second point of the
    /// tool, leads the tool itself.
    bool surface_leads_end() const;
    /// The direction that the block's words give, in the base system; nothing if it was reported.
    std::optional<path::Vec3> wanted_direction(const nc::Block& block, const ToolWords& tool);
    /// The surface normals at start and end of the block, in the base system: where none is given
    /// it is +Z, one that is not given at the start goes on from the block before. S 7.3.
    std::optional<std::array<path::Vec3, 2>> normals_of(const nc::Block& block,
                                                        const ToolWords& tool);

    // ---------------------------------------------------------------- the plan
    /// By what a block gives; what depends on the block's path waits for it.
    Done lay_tool_words(const nc::Block& block, const ToolWords& tool, Target& target);
    /// What waited for the path of the block: along it the tool is led, or its end gives the
    /// orientation.
    Done lay_directions(const nc::Block& block, const path::Curve& curve, Target& target);
    /// Where the axes stand for the tool that the block gives. What leads a tool along a path leads
    /// none here.
    Done lay_point_to_point(const nc::Block& block, const ToolWords& tool, Target& target);
    /// By what the blocks of a span have given.
    Done lay_span_orientation(const nc::Block& at, const ControlPointBlock& control_point,
                              const path::Curve& span, Target& target);

  private:
    std::optional<path::Vec3> direction_in_base(const nc::Block& block,
                                                const path::Vec3& programmed, nc::Function word);
    machine::Mat3 rotation_by_angles(const path::Vec3& angles_deg) const;
    machine::Mat3 turn_into_base() const;
    bool mirrors_words() const;
    Done orient_by_axes(const nc::Block& block, Target& target);
    Done orient_to(const nc::Block& block, const ToolWords& tool, const path::Vec3& to,
                   Target& target);
    Done lay_orientation(const nc::Block& block, const path::Vec3& to, Target& target,
                         const ToolWords* angles = nullptr);
    Done lay_cone(const nc::Block& block, const ToolWords& tool, const path::Vec3& to,
                  Target& target);
    std::optional<machine::OrientationArc> cone_to(const nc::Block& block, const ToolWords& tool,
                                                   const path::Vec3& from, const path::Vec3& to);
    Done follow_directions(const nc::Block& block, const path::OrientLaw& orientation,
                           const path::Curve& curve, Target& target);
    Done apply_lead_tilt_at_end(const nc::Block& block, const ToolWords& tool,
                                const path::Curve& curve, Target& target);
    std::optional<path::Vec3> direction_on_surface(const nc::Block& block, const path::Vec3& normal,
                                                   const path::Vec3& tangent,
                                                   const path::LeadTiltAngles& lead_tilt);
    Done require_small_rise(const nc::Block& block, double rise);
    Done require_small_rise_along(const nc::Block& block, const path::OrientLaw& surface,
                                  const path::Curve& curve);
    Done lead_by_surface(const nc::Block& block, const ToolWords& tool, const path::Curve& curve,
                         Target& target);
    Done lead_by_point(const nc::Block& block, const ToolWords& tool, const path::Curve& curve,
                       Target& target);
    Done orient_first(const nc::Block& block, const path::Vec3& to);
    bool spins_with_path(const ToolWords& tool) const;
    std::optional<path::Vec3> spin_reference(const path::Vec3& tool, const OrientPlan& orientation,
                                             const path::Curve* curve) const;
    Done lay_spin(const nc::Block& block, const ToolWords& tool, Target& target,
                  const path::Curve* curve = nullptr);
    machine::Mat3 base_rotation() const;
    void report_no_solution(const nc::Block& block, const machine::PathRefusal& refusal);
    machine::PathQuery query_to(const path::Vec3& to, const ToolWords* angles) const;
    machine::JointLimits signed_limits(const ToolWords& tool) const;
    Done stand_along(const nc::Block& block, const ToolWords& tool, const path::Vec3& to,
                     Target& target);
    Done turn_by_signs(const nc::Block& block, const ToolWords& tool, Target& target);

    Channel& channel_;
    OrientStart start_;
    const machine::Machine& machine_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    const Modal& modal_;
    const control::Frames& frames_;
    Orienting& orienting_;
    const RadiusCompState& comp_;
    ReportedInRun& reported_;
};

}  // namespace kadr::interp
