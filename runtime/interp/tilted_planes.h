// tilted_planes.h — tilted working planes, and the rotary axes that stand to them.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Tilted working planes, and the rotary axes that stand to them.
class TiltedPlanes {
  public:
    explicit TiltedPlanes(Channel& channel);
    TiltedPlanes(const TiltedPlanes&) = delete;
    TiltedPlanes& operator=(const TiltedPlanes&) = delete;

    /// A tilted plane by angles; the rotary axes go to it where the function asks for it.
    void tilt(const nc::Block& block, const nc::Invocation& invocation);
    /// Planes by points or vectors stand in several blocks, one behind the other.
    void set_plane_by_blocks(const nc::Block& block, const nc::Invocation& invocation);
    /// The plane square to the tool as it stands; frames lie on the turned tables first.
    void tilt_along_tool(const nc::Block& block, const nc::Invocation& invocation);
    /// The rotary axes stay.
    void end_tilted_plane(const nc::Block& block);
    /// A rotation about an axis in space, G68 with I, J, K.
    void rotate_about_axis(const nc::Block& block, const nc::Invocation& invocation);
    /// The rotary axes turn until the tool is along Z of the plane.
    void align(const nc::Block& block, const nc::Invocation& invocation);
    /// Frames lie on the tables as these joints have turned them, and the tool as the heads have;
    /// no axis moves. Under a transformation both are so anyway.
    void carry(const nc::Block& block, const path::Vec3& joints);
    /// The tables and the tool are taken as they stand without a plane.
    void drop_carry(const nc::Block& block);
    /// A rotary axis that the plane does not follow takes the tool out of it. F 4.8.
    void check_carried(const nc::Block& block);
    /// A plane that takes several blocks gets them one behind the other.
    Done require_block_of_open_plane(const nc::Block& block);
    /// CYCLE800.
    void swivel(const nc::Block& block, const nc::Invocation& invocation);
    /// One axis of the programmed system comes to lie along the tool, the others turn no more than
    /// they have to.
    void frame_along_tool(const nc::Block& block, const nc::Invocation& invocation);
    /// PAROT, PAROTOF.
    void follow_tables(const nc::Block& block, bool is_wanted);

  private:
    std::optional<path::Frame> plane_by_angles(const nc::Block& block,
                                               const nc::Invocation& invocation);
    std::optional<path::Frame> plane_by_blocks(const nc::Block& block, const OpenPlane& programmed);
    std::optional<path::Vec3> origin_of_plane(const nc::Block& block,
                                              const nc::Invocation& invocation, std::size_t first);
    Done require_place_for_plane(const nc::Block& block, const nc::Invocation& invocation,
                                 bool is_added);
    void set_plane(const path::Frame& plane, bool is_added);
    Done end_rotations_3d(const nc::Block& block);
    Done require_nested_length(const nc::Block& block, nc::Function function);
    Done require_rotary_axes(const nc::Block& block, nc::Function function);
    std::optional<path::Vec3> joints_for_plane(const nc::Block& block, nc::Function function,
                                               int sense);
    void turn_joints(const nc::Block& block, const path::Vec3& joints, path::Op op);
    void turn_about_tip(const nc::Block& block, const path::Vec3& joints, path::Op op,
                        double above);
    void hold_tip(const nc::Block& block, const path::Vec3& joints, path::Op op);
    void stand_at(const nc::Block& block, const AxisValues& axes, bool tool_turns);
    std::optional<path::Mat3> swivel_rotation(const nc::Block& block,
                                              const nc::Invocation& invocation);
    path::Vec3 direct_joints(const nc::Block& block, const nc::Invocation& invocation) const;
    Done retract_before_swivel(const nc::Block& block, const nc::Invocation& invocation);
    Done retract_along_tool(const nc::Block& block, std::optional<double> by);
    void end_swivel(const nc::Block& block);

    Channel& channel_;
    const machine::Machine& machine_;
    Reporter& reporter_;
    const Modal& modal_;
    Position& position_;
    control::Frames& frames_;
    const Tool& tool_;
    const ActiveCarrier& carrier_;
    const Orienting& orienting_;
    Tilting& tilted_plane_;
    const RadiusCompState& comp_;
    ReportedInRun& reported_;
    const AxisData& axes_;
    const AxisValues& length_shift_;
};

}  // namespace kadr::interp
