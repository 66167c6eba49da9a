// stages.h — where commands go: through the stages that are on, in their one order.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Where commands go: through the stages that are on, in their one order.
class Stages {
  public:
    explicit Stages(Channel& channel);
    Stages(const Stages&) = delete;
    Stages& operator=(const Stages&) = delete;

    /// Whether commands pass through something that keeps them back; nearly never.
    bool has_stages() const;
    /// What a block has put goes through the corners and the compensation; what is settled goes
    /// out.
    void settle(const nc::Block& block);
    /// is_last  nothing of the block comes behind it
    void settle_stages(const nc::Block& block, const AxisValues& here, bool is_last);
    /// Where a command goes that no corner waits for.
    path::Command& behind_corners();
    /// A command in its slot, with what the modal state has of it.
    ///
    /// orientation  of the tool in a motion; null: it stays as it stands
    path::Command& put(path::Op op, const nc::Block& block,
                       const OrientPlan* orientation = nullptr);
    /// … of a motion where nothing waits, nothing compensates and nothing orients the tool.
    path::Motion& put_straight_out(path::Op op, const nc::Block& block);
    /// Every command that waits, the nearest to the output first.
    template <typename Visit>
    void visit_waiting(Visit visit) const {
        for (const path::Command& command : output_.waiting()) visit(command);
        compensation_.look_at_waiting(visit);
        comp_3d_.look_at_waiting(visit);
        smooth_approach_.look_at_waiting(visit);
        corners_.look_at_waiting(visit);
    }
    /// What the modal state has of a command; one that was something else before forgets it.
    void fill_in(path::Command& command, const nc::Block& block,
                 const OrientPlan* orientation = nullptr);
    /// A block for messages, at the location of a command. Where that is the call of the cycle that
    /// runs, it is one of the cycle's.
    nc::Block block_at(SourceId source, std::uint32_t line) const;
    /// As block_at, into a block that there is.
    void locate(nc::Block& at, SourceId source, std::uint32_t line) const;

  private:
    void fill_in_head(path::Command& command, const nc::Block& block);
    void fill_in_modal(path::Motion& motion, const nc::Block& block);

    Channel& channel_;
    Reporter& reporter_;
    CommandOutput& output_;
    const std::uint64_t& block_count_;
    const Modal& modal_;
    const Position& position_;
    const path::Contact& surface_;
    Corners& corners_;
    const RadiusCompState& comp_;
    SmoothApproach& smooth_approach_;
    Compensation& compensation_;
    Compensation3d& comp_3d_;
    SplineCommands& spline_commands_;
    const bool& puts_span_;
    const ProgrammedDynamics& dynamics_;
    Dangers& dangers_;
    CycleRun& cycle_;
    const Callers& callers_;
    std::optional<ShapeRun>& shape_;
    std::optional<ContourRun>& contour_;
};

}  // namespace kadr::interp
