// executor.h — block after block: its functions, its motion, and what is due behind them.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Block after block: its functions, its motion, and what is due behind them.
class Executor {
  public:
    explicit Executor(Channel& channel);
    Executor(const Executor&) = delete;
    Executor& operator=(const Executor&) = delete;

    enum class Plainly : std::uint8_t { NotPlain, Executed };
    /// The next commands; 0: the run has ended.
    std::size_t pull(std::span<path::Command> out);
    /// Whether it is a block of the control that the operator lets run.
    bool acts(const nc::Block& block) const;
    /// A block of whichever caller, if the operator lets it run.
    void execute(const nc::Block& block);
    /// The working plane with which the block's motion is meant.
    path::Plane plane_in(const nc::Block& block) const;
    /// The state of a control that has been switched on.
    void start();
    bool has_open_line() const { return open_line_.has_value(); }
    /// A program has asked or set something: what plain moves take for given may have changed.
    void look_again() { is_plain_.reset(); }

  private:
    void execute_next();
    void execute_of_cycle(const nc::Block* block);
    void run(const nc::Block& block);
    void run_functions(const nc::Block& block);
    void end_of_blocks();
    void end_where_stopped();
    Plainly move_plainly(const nc::Block& block);
    bool is_plain_block(const nc::Block& block) const;
    bool is_plain_state() const;
    void move_with_own_feed(const nc::Block& places, const Actions& actions);
    bool opens_line(const nc::Block& block);
    void close_line(const nc::Block& block);
    bool is_open_distance(const nc::Block& first, const nc::Block& second, nc::Slot slot) const;
    const nc::Block* with_positions(const nc::Block& block);

    Channel& channel_;
    const InterpreterOptions& options_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    CommandOutput& output_;
    ProgramClocks& clocks_;
    std::uint64_t& block_count_;
    Modal& modal_;
    Position& position_;
    const control::Frames& frames_;
    const ProgrammedSpindle& spindle_;
    const Tool& tool_;
    const WorkArea& area_;
    PositionWords& position_words_;
    const Tilting& tilted_plane_;
    const Virtual& virtual_;
    const SmoothApproach& smooth_approach_;
    const path::CoolantMode& coolant_;
    const bool& owes_speed_;
    const std::optional<SplineRun>& spline_;
    const std::optional<ThroughRun>& through_;
    const bool& taps_rigidly_;
    const AxisMask& unplaced_;
    ReportedInRun& reported_;
    const AxisData& axes_;
    const AxisValues& length_shift_;
    const ModalCycles& modal_cycles_;
    CycleRun& cycle_;
    std::optional<ShapeRun>& shape_;
    const std::optional<ContourRun>& contour_;
    Callers& callers_;
    std::optional<bool> is_plain_;        // is_plain_state; nothing: to be looked at again
    std::optional<nc::Block> open_line_;  // waits for the one that gives its end
};

}  // namespace kadr::interp
