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

    std::vector<StateItem> state() const;
    Snapshot snapshot() const;
    std::optional<double> quantity(nc::Quantity quantity, std::int64_t first, std::int64_t second);
    ControlAccess::Write set_quantity(nc::Quantity quantity, std::int64_t first,
                                      std::int64_t second, double value, bool acts_at_once);
    bool is_length(std::int64_t axis) const;
    std::optional<std::string> text(nc::Quantity quantity, std::int64_t index);
    ControlAccess::Write set_text(nc::Quantity quantity, std::int64_t index, std::string_view text);
    std::optional<std::int64_t> axis_number(Axis axis) const;
    double word_factor(std::int64_t axis) const;
    std::optional<Axis> axis_of(std::int64_t index) const;
    std::optional<double> place_of(nc::Quantity quantity, Axis axis) const;
    void count_time();
    double run_time();
    bool is_compensated() const;

  private:
    double place_within(const control::ControlFrame& frame, Axis axis) const;
    double mirrored_axes() const;
    std::optional<double> clock(nc::Quantity quantity);
    std::optional<double> calendar(nc::Quantity quantity);
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
    const Output& output_;
    ProgramClocks& clocks_;
    const Probe& probe_;
    const Modal& modal_;
    const Position& position_;
    const control::Frames& frames_;
    const Spindle& spindle_;
    const std::vector<Spindle>& other_spindles_;
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
