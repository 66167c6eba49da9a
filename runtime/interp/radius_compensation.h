// radius_compensation.h — cutter radius compensation: what blocks choose of it, given to the stages
// that make it.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Cutter radius compensation: what blocks choose of it, given to the stages that make it.
class RadiusCompensation {
  public:
    explicit RadiusCompensation(Channel& channel);
    RadiusCompensation(const RadiusCompensation&) = delete;
    RadiusCompensation& operator=(const RadiusCompensation&) = delete;

    /// Another member of one of its groups. Roughing works along the programmed shape and takes no
    /// choice; where the shape is followed, it is compensated.
    void choose(const nc::Block& block, nc::Function member, Actions& actions);
    /// CompCornerPointed, CompOpenEnd, CompAllowance, CompDepth; likewise.
    void choose_by_words(const nc::Block& block, const nc::Invocation& invocation,
                         Actions& actions);
    /// CompFeed.
    void choose_feed(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    /// It does not act any more, and no path ends it.
    void leave() { comp_.side = CompSide::Off; }
    /// Whether cutter radius compensation must have ended before the function.
    bool needs_comp_off(const nc::Block& block, nc::Function function) const;
    /// The choices of a block count together, whatever their order in it.
    void act_on_comp(const nc::Block& block, const Actions& actions);
    /// At its position among the commands: behind a corner that is not known yet.
    void send_comp(const CompChange& change);
    /// The function needs a compensation in the plane, or none.
    Done require_comp_in_plane(const nc::Block& block, nc::Function function);
    /// How the plane lies in which the cutter is compensated: that of the base system, or that of
    /// the program, if frames have tilted it; there left and right are the program's. A carrier
    /// that turns the tool's direction turns its plane, and that has to be the program's.
    path::Mat3 comp_lie() const;
    /// How the plane of the program lies, if frames have tilted it.
    path::Mat3 plane_lie() const;
    /// What reaches the stage: behind the corners that wait.
    void change_comp(const CompChange& change);
    /// What a block has put goes through the compensation; what is settled of it goes out.
    ///
    /// here     where the tool is behind the block, not compensated
    /// is_last  no block waits behind it
    void settle_comp(const nc::Block& block, const AxisValues& here, bool is_last = true);
    /// The contour ends on its normal here; what waits goes out.
    void flush_comp();
    /// The compensation ends where the cutter is, without a motion.
    void stop_comp();
    /// An arc about the corner at which the cutter is, in a block of its own.
    void round_comp_corner(const nc::Block& block, const nc::Invocation& invocation);
    /// The direction that the centre's words give beside the code that ends the compensation.
    std::optional<path::Vec2> leave_direction(const nc::Block& block) const;
    /// With the tool, the plane and the frame that act now.
    CompChange comp_change(const nc::Block& block, CompChange::Kind kind);
    /// How the surface lies along the block, for the cutter on it.
    Done lay_surface(const nc::Block& block, const ToolWords& tool);
    /// F 4.4: with a tool and a table that turn, lines and positioning only.
    Done require_no_peripheral_arc(const nc::Block& block);
    /// Where the settled blocks have led the cutter: beside the contour.
    AxisValues cutter_position() const {
        return comp_3d_.is_on() ? comp_3d_.position() : compensation_.position();
    }
    bool is_any_comp_on() const { return compensation_.is_on() || comp_3d_.is_on(); }

  private:
    void choose_pointed_corners(const nc::Block& block, const nc::Invocation& invocation);
    void choose_comp_side(const nc::Block& block, nc::Function function, Actions& actions);
    void begin_comp(const nc::Block& block, CompSide side);
    void change_comp_3d(const CompChange& change);
    bool is_in_space(CompChange::Kind kind) const;
    Comp3dSettings comp_3d_settings() const;
    path::Vec3 tool_direction() const;
    void take_comp(const std::optional<CompAlarm>& alarm);
    CompSettings comp_settings() const;
    std::optional<path::Vec2> direction_in_base(const path::Vec3& programmed) const;
    std::optional<std::int64_t> comp_offset() const;
    void take_comp_tool(const nc::Block& block, std::int64_t number, CompChange& change);
    void report_comp(const CompAlarm& alarm);
    std::optional<Cutter3d> mill_shape_now(const nc::Block& block);
    Done require_constant_tool(const nc::Block& block);
    Done require_tcp_for_peripheral_comp(const nc::Block& block, nc::Function function);

    Channel& channel_;
    const nc::Dialect& dialect_;
    const machine::Machine& machine_;
    const bool is_lathe_;
    const ToolOffsets& tool_offsets_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    CommandOutput& output_;
    const Modal& modal_;
    const Position& position_;
    const control::Frames& frames_;
    const Tool& tool_;
    const ExtraTool& extra_;
    Orienting& orienting_;
    const Tilting& tilted_plane_;
    path::Contact& surface_;
    Corners& corners_;
    RadiusCompState& comp_;
    Compensation& compensation_;
    Compensation3d& comp_3d_;
    ReportedInRun& reported_;
};

}  // namespace kadr::interp
