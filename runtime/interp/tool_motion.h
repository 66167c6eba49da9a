// tool_motion.h — how the tool turns in a motion: the words of a block that orient it, and the
// rotary axes for them.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// How the tool turns in a motion: the words of a block that orient it, and the rotary axes for
/// them.
class ToolMotion {
  public:
    explicit ToolMotion(Channel& channel);
    ToolMotion(const ToolMotion&) = delete;
    ToolMotion& operator=(const ToolMotion&) = delete;

    /// A word of the block that says how the tool stands; it counts with the block's motion.
    void take_orientation(const nc::Block& block, const nc::Invocation& invocation,
                          Actions& actions);
    /// Whether the tool is led by a surface in every block.
    bool keeps_lead_tilt_to_surface() const;
    /// A direction that words say, in the base system; nothing if it was reported.
    std::optional<path::Vec3> direction_in_base(const nc::Block& block,
                                                const path::Vec3& programmed, nc::Function word);
    /// What the block says of the tool, as rotary positions at its end and a way there.
    Done orient(const nc::Block& block, const Actions& actions, Target& target);
    /// What the end of the motion says of the tool, for its command and the blocks behind it.
    void settle_orientation(Target& target);
    /// What waited for the path of the block: along it the tool is led, or its end says how it
    /// stands.
    Done lay_directions(const nc::Block& block, const path::Curve& curve, Target& target);
    /// The surface normals at start and end of the block, in the base system: nothing said is +Z,
    /// one that is not said at the start goes on from the block before. S 7.3.
    std::optional<std::array<path::Vec3, 2>> normals_of(const nc::Block& block,
                                                        const ToolWords& tool);
    /// The rotary axes of the transformation go to places of their own. S 7.4 ORIRESET.
    void reset_orientation(const nc::Block& block, const nc::Invocation& invocation);
    /// rad.
    machine::JointLimits joint_limits() const;
    /// The rotary axes of the target stand there, rad.
    void put_joints(const path::Vec3& joints, Target& target) const;
    /// plan  of the motion; null: the tool stays as it stands
    void put_orientation(path::Motion& motion, const OrientPlan* plan);
    /// Whether a motion of this kind goes from point to point.
    bool goes_straight(path::Op op) const;
    /// … the motion of a block.
    bool goes_straight(const nc::Block& block, const Actions& actions) const;
    /// What has a path of its own has no place where axes go from point to point. S 14144.
    Done require_point_to_point_motion(const nc::Block& block, const Actions& actions);
    /// Which position of the rotary axes the block wants: `STAT` from here on, `TU` here. S 7.4.
    void choose_axes(const nc::Block& block, const nc::Invocation& invocation, ToolWords& tool);
    /// The tool may turn as it is said beside a spline or a polynomial.
    Done require_orientation_along(const nc::Block& block, const ToolWords& tool);
    /// What a pole of a B-spline says of the tool: a direction, or the one of the pole before it.
    /// Nothing where no transformation turns the tool.
    Done orient_control_point(const nc::Block& block, const ToolWords& tool,
                              ControlPointBlock& control_point);
    /// How the tool turns along a span, and where the rotary axes stand at its end: in `to` and in
    /// the position, of which X, Y and Z are behind blocks that have been read meanwhile.
    ///
    /// at  whose place messages show
    Done orient_along(const nc::Block& at, const ControlPointBlock& control_point,
                      const path::Curve& span, AxisValues& to, OrientPlan& orientation);
    /// What a block says of the tool, shared out to the pieces of its polynomial by their lengths:
    /// the directions in which they end.
    Done share_orientation(const nc::Block& block, const ToolWords& tool,
                           const std::vector<double>& shares,
                           const std::vector<ControlPointBlock*>& pieces);

  private:
    Done require_axes_for_direction(const nc::Block& block);
    void take_lead_tilt(const nc::Block& block, const nc::Invocation& invocation, ToolWords& tool);
    void take_opening(const nc::Block& block, const nc::Invocation& invocation, ToolWords& tool);
    Done require_one_orientation(const nc::Block& block, const ToolWords& tool);
    Done require_no_idle_words(const nc::Block& block, const ToolWords& tool);
    bool is_led_by_surface(const ToolWords& tool) const;
    machine::Mat3 rotation_by_angles(const path::Vec3& angles_deg) const;
    machine::Mat3 turn_into_base() const;
    bool mirrors_words() const;
    std::optional<path::Vec3> wanted_direction(const nc::Block& block, const ToolWords& tool);
    Done lay_tool_words(const nc::Block& block, const ToolWords& tool, Target& target);
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
    bool surface_leads_end() const;
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
    Done lay_point_to_point(const nc::Block& block, const ToolWords& tool, Target& target);
    Done stand_along(const nc::Block& block, const ToolWords& tool, const path::Vec3& to,
                     Target& target);
    Done turn_by_signs(const nc::Block& block, const ToolWords& tool, Target& target);
    Done lay_span_orientation(const nc::Block& at, const ControlPointBlock& control_point,
                              const path::Curve& span, Target& target);

    Channel& channel_;
    const machine::Machine& machine_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    const Modal& modal_;
    Position& position_;
    const control::Frames& frames_;
    Orienting& orienting_;
    const Virtual& virtual_;
    const RadiusCompState& comp_;
    const std::optional<SplineRun>& spline_;
    ReportedInRun& reported_;
    const AxisData& axes_;
    path::Vec3 direction_ = path::Vec3::UnitZ();  // of the tool behind the latest motion
};

}  // namespace kadr::interp
