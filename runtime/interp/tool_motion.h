// tool_motion.h — tool orientation in a motion: the words of a block that orient it, and the
// rotary axes for them.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;
class OrientPlanner;

/// Tool orientation in a motion: the words of a block that orient it, and the rotary axes for
/// them.
class ToolMotion {
  public:
    explicit ToolMotion(Channel& channel);
    ToolMotion(const ToolMotion&) = delete;
    ToolMotion& operator=(const ToolMotion&) = delete;

    /// A word of the block that orients the tool; it counts with the block's motion.
    void take_orientation(const nc::Block& block, const nc::Invocation& invocation,
                          Actions& actions);
    /// What the block programs for the tool, as rotary positions at its end and a path there.
    Done orient(const nc::Block& block, const Actions& actions, Target& target);
    /// What the end of the motion gives for the tool, for its command and the blocks behind it.
    void settle_orientation(Target& target);
    /// What waited for the path of the block: along it the tool is led, or its end gives how it
    /// stands.
    Done lay_directions(const nc::Block& block, const path::Curve& curve, Target& target);
    /// The surface normals at start and end of the block, in the base system: none programmed is
    /// +Z, one that is not programmed at the start goes on from the block before. S 7.3.
    std::optional<std::array<path::Vec3, 2>> normals_of(const nc::Block& block,
                                                        const ToolWords& tool) const;
    /// The rotary axes of the transformation go to positions of their own. S 7.4 ORIRESET.
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
    /// What has a path of its own has no effect where axes go from point to point. S 14144.
    Done require_point_to_point_motion(const nc::Block& block, const Actions& actions);
    /// Which position of the rotary axes the block wants: `STAT` from here on, `TU` here. S 7.4.
    void choose_axes(const nc::Block& block, const nc::Invocation& invocation, ToolWords& tool);
    /// The tool may change its orientation as programmed beside a spline or a polynomial.
    Done require_orientation_along(const nc::Block& block, const ToolWords& tool);
    /// What a control point of a B-spline programs for the tool: a direction, or the one of the one
    /// before. Nothing where no transformation orients the tool.
    Done orient_control_point(const nc::Block& block, const ToolWords& tool,
                              ControlPointBlock& control_point);
    /// The tool orientation along a span, and where the rotary axes stand at its end: in `to` and
    /// in the position, of which X, Y and Z are behind blocks that have been read meanwhile.
    ///
    /// at  whose location messages show
    Done orient_along(const nc::Block& at, const ControlPointBlock& control_point,
                      const path::Curve& span, AxisValues& to, OrientPlan& orientation);
    /// What a block programs for the tool, shared out to the pieces of its polynomial by their
    /// lengths: the directions in which they end.
    Done share_orientation(const nc::Block& block, const ToolWords& tool,
                           const std::vector<double>& shares,
                           const std::vector<ControlPointBlock*>& pieces);

  private:
    /// Of a motion from where the tool stands, by what is in force.
    OrientPlanner planner() const;
    void take_lead_tilt(const nc::Block& block, const nc::Invocation& invocation, ToolWords& tool);
    void take_opening(const nc::Block& block, const nc::Invocation& invocation, ToolWords& tool);

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
