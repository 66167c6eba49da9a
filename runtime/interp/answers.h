// answers.h — what a program and an operator ask of the control, and what a program sets.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// What a program and an operator ask of the control, and what a program sets.
class Answers {
  public:
    explicit Answers(Channel& channel);
    Answers(const Answers&) = delete;
    Answers& operator=(const Answers&) = delete;

    /// The modal state behind the latest block, for people.
    std::vector<StateItem> state() const;
    /// The same and positions, as numbers.
    Snapshot snapshot() const;
    /// Nothing: the control does not have it.
    std::optional<double> quantity(nc::SystemQuantity quantity, std::int64_t first,
                                   std::int64_t second);
    /// acts_at_once  or with the next word that calls it
    ControlAccess::Write set_quantity(nc::SystemQuantity quantity, std::int64_t first,
                                      std::int64_t second, double value, bool acts_at_once);
    /// Whether the axis of this number is counted in mm.
    bool is_length(std::int64_t axis) const;
    /// A name; nothing: there is none of this number.
    std::optional<std::string> text(nc::SystemQuantity quantity, std::int64_t index);
    /// Likewise.
    ControlAccess::Write set_text(nc::SystemQuantity quantity, std::int64_t index,
                                  std::string_view text);
    /// By which programs count axes, from 1.
    std::optional<std::int64_t> axis_number(Axis axis) const;
    /// By which a word of the axis is larger than its travel: 2 where X is a diameter.
    double word_factor(std::int64_t axis) const;
    /// A count of the machine's axes from 1, or a name: −1 X, −2 Y …
    std::optional<Axis> axis_of(std::int64_t index) const;
    /// mm or degrees; nothing: it is no position.
    std::optional<double> position_of(nc::SystemQuantity quantity, Axis axis) const;
    /// The clock takes notice of the commands that came out since it was last asked.
    void count_time();
    /// How long the program has run, s: what waits for its corner has been executed by then. A
    /// corner may make it a little shorter than it was taken for; time never goes back for that.
    double run_time();
    /// Whether the cutter is led beside the contour, or comes to it.
    bool is_compensated() const;

  private:
    double position_within(const control::ControlFrame& frame, Axis axis) const;
    double mirrored_axes() const;
    std::optional<double> clock(nc::SystemQuantity quantity);
    std::optional<double> calendar(nc::SystemQuantity quantity);
    std::optional<double> tool_datum(std::int64_t number) const;
    double timer(std::int64_t number);
    void set_timer(std::int64_t number, double value);
    ControlAccess::Write set_edge_speed(double value);

    Channel& channel_;
    const nc::Dialect& dialect_;
    const machine::Machine& machine_;
    const std::vector<control::ControlFrame>& work_offsets_;
    const std::int64_t& work_offset_;
    ToolOffsets& tool_offsets_;
    ToolNames& tool_names_;
    const InterpreterOptions& options_;
    const nc::Rules& rules_;
    const CommandOutput& output_;
    ProgramClocks& clocks_;
    const Probe& probe_;
    const Modal& modal_;
    const Position& position_;
    const control::Frames& frames_;
    const ProgrammedSpindle& spindle_;
    const std::vector<ProgrammedSpindle>& other_spindles_;
    Tool& tool_;
    const ExtraTool& extra_;
    const RadiusCompState& comp_;
    const SmoothApproach& smooth_approach_;
    const std::optional<Approached>& approached_;
    const path::CoolantMode& coolant_;
    ProgrammedDynamics& dynamics_;
    const AxisData& axes_;
    const AxisValues& length_shift_;
    const AxisValues& preset_;
    const ModalCycles& modal_cycles_;
};

}  // namespace kadr::interp
