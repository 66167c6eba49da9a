// block_functions.h — the functions of a block: what each does at once, and what waits for the
// motion.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// The functions of a block: what each does at once, and what waits for the motion.
class BlockFunctions {
  public:
    explicit BlockFunctions(Channel& channel);
    BlockFunctions(const BlockFunctions&) = delete;
    BlockFunctions& operator=(const BlockFunctions&) = delete;

    /// M functions that take the machine time, at one side of the block's motion.
    enum class MotionMoment : std::uint8_t { Before, Behind };
    /// Every default is executed as if it stood in a block of its own. Nobody has written it: there
    /// is no location to report anything at. Units are the reader's matter.
    void power_on();
    /// What they do at once; what waits for the motion is the answer.
    Actions apply_functions(const nc::Block& block);
    /// Spindle, tool, coolant, data, in the control's order.
    void act_before_motion(const nc::Block& block, const Actions& actions);
    /// Stops, the end, what the rules put there.
    void act_after_motion(const nc::Block& block, const Actions& actions);
    /// Whether the function chooses another working plane.
    bool is_other_plane(nc::Function function) const;
    /// Whether the path stops until the machine has acknowledged a function of a block.
    bool is_awaited(const nc::Block& block, const nc::Invocation& invocation) const;
    nc::Changer changer() const { return is_lathe_ ? nc::Changer::Turret : nc::Changer::Magazine; }

  private:
    void write_data(const nc::Block& block, const nc::Invocation& invocation);
    void begin_with(nc::Function function);
    Done require_allowed(const nc::Block& block, nc::Function function);
    void apply(const nc::Block& block, const nc::Effect& effect, Actions& actions);
    void apply_own(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    void set_member(const nc::Block& block, const nc::Effect& effect, Actions& actions);
    void set_diameter(const nc::Block& block, nc::Function member);
    void switch_tcp(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    void dwell(const nc::Block& block, const nc::Invocation& invocation);
    void stop_spindle_and_coolant(const nc::Block& block, const Actions& actions);
    void set_coolant(const nc::Block& block, path::CoolantMode mode);
    void change_plane(const nc::Block& block, nc::Function plane);
    bool is_too_late(nc::Function function) const;
    void issue_functions(const nc::Block& block, const Actions& actions, MotionMoment side);
    bool has_changed(std::int64_t code, const Actions& actions) const;
    void pass_machine_function(const nc::Block& block, std::int64_t number);
    void write_parameter(const nc::Block& block, const nc::Invocation& invocation);
    void report_life_data(const nc::Block& block);

    Channel& channel_;
    const nc::Dialect& dialect_;
    const machine::Machine& machine_;
    const bool is_lathe_;
    const InterpreterOptions& options_;
    Reporter& reporter_;
    nc::Rules& rules_;
    Modal& modal_;
    Position& position_;
    control::Frames& frames_;
    ProgrammedSpindle& spindle_;
    const std::vector<ProgrammedSpindle>& other_spindles_;
    Tool& tool_;
    WorkArea& area_;
    PositionWords& position_words_;
    const Orienting& orienting_;
    const Tilting& tilted_plane_;
    bool& diameter_is_absolute_;
    const RadiusCompState& comp_;
    ApproachChoice& approach_choice_;
    const SmoothApproach& smooth_approach_;
    path::CoolantMode& coolant_;
    bool& is_scanning_;
    bool& taps_rigidly_;
    ProgrammedDynamics& dynamics_;
    ReportedInRun& reported_;
    AxisData& axes_;
    ModalCycles& modal_cycles_;
};

}  // namespace kadr::interp
