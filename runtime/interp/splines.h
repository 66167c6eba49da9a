// splines.h — splines and polynomials: blocks are collected and become spans.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Splines and polynomials: blocks are collected and become spans.
class Splines {
  public:
    explicit Splines(Channel& channel);
    Splines(const Splines&) = delete;
    Splines& operator=(const Splines&) = delete;

    /// Whether a block belongs to the spline that runs. By knots, the function programmed again
    /// begins another one.
    bool continues_spline(const nc::Block& block) const;
    /// SD, 1 to 3.
    void set_spline_degree(const nc::Block& block, const nc::Invocation& invocation);
    /// A block under the spline function: a control point, a knot or both.
    void spline(const nc::Block& block, const ToolWords& tool);
    /// `kind` as the function names it; what it may be is the dialect's matter.
    void choose_spline_end(const nc::Block& block, const nc::Invocation& invocation);
    /// Whether a block belongs to the spline that runs: a position, with nothing beside it that
    /// ends the spline. The function may stand there again.
    bool continues_through(const nc::Block& block);
    /// Whether a block orients the tool at the point where it is: no point of a spline, as
    /// a point cannot stand twice, but not to be left out either. It is run by itself.
    bool only_turns(const nc::Block& block);
    /// A block with a position under such a function.
    void go_through(const nc::Block& block, nc::SlotMask targets, const ToolWords& tool);
    /// What is open ends: where the tool is cannot be known inside of a spline. `next` is the block
    /// that ends it, if it is one.
    void finish_open_spline(const nc::Block* next = nullptr);
    /// POLY: spans of its own, until the end of the block.
    void polynomial(const nc::Block& block, const ToolWords& tool, bool exact_stop);
    bool is_in_spline() const { return spline_ || through_; }

  private:
    Done start_spline(const nc::Block& block, bool by_knots);
    Done add_control_point(const nc::Block& block, nc::SlotMask targets, const ToolWords& tool);
    void move_along_spline();
    void finish_spline();
    void put_span(const path::SplineSpan& span, const ControlPointBlock& control_point,
                  AxisMask moved, bool exact_stop);
    void report_spline(const nc::Block& block, path::NurbsFault fault);
    Done start_through(const nc::Block& block);
    void move_through();
    void finish_through(const nc::Block* next);
    std::optional<path::Vec3> direction_into(const nc::Block& next);
    bool leaves_spline_open(const nc::Block& block, const nc::Invocation& invocation) const;
    ControlPointBlock control_point_block(const nc::Block& block, const AxisValues& to);
    path::Command span_as_programmed(const nc::Block& block);
    void as_programmed(path::Command& command) const;
    void put_commands_before(std::uint32_t number);

    Channel& channel_;
    const nc::Dialect& dialect_;
    const std::int64_t& work_offset_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    const Modal& modal_;
    Position& position_;
    const control::Frames& frames_;
    const Tool& tool_;
    const PositionWords& position_words_;
    const Orienting& orienting_;
    std::optional<SplineRun>& spline_;
    std::optional<ThroughRun>& through_;
    SplineCommands& spline_commands_;
    bool& puts_span_;
    const ProgrammedDynamics& dynamics_;
    SplineEnds spline_ends_;
    nc::Block spline_end_{};  // location of its latest block
    int spline_degree_ = 3;
};

}  // namespace kadr::interp
