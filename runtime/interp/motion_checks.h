// motion_checks.h — what forbids a motion: limits of the axes, the work area, a missing feed.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// What forbids a motion: limits of the axes, the work area, a missing feed.
class MotionChecks {
  public:
    explicit MotionChecks(Channel& channel);
    MotionChecks(const MotionChecks&) = delete;
    MotionChecks& operator=(const MotionChecks&) = delete;

    /// G25, G26, G22: mm.
    void set_area_limit(const nc::Block& block, const nc::Invocation& invocation);
    /// Between the code that gears the spindle and the tapping cycle no axis moves.
    Done require_no_move_before_tap(const nc::Block& block, nc::SlotMask targets);
    /// what  is moved, for the message
    Done require_feed(const nc::Block& block, std::string_view what);
    /// Nothing is cut: the spindle may stand, and what is in it need not be a tool. A feed per
    /// revolution would wait for ever where it stands.
    Done require_probe_feed(const nc::Block& block);
    /// A rapid that dives below the workpiece zero of a mill while the spindle stands. On a lathe,
    /// and in another plane, Z is not the direction into the workpiece.
    void check_rapid(const nc::Block& block, const Target& target);
    /// A cut on a machine that changes tools, with whatever is in the spindle.
    void check_tool(const nc::Block& block);
    /// Another unit is warned of behind a motion, and refused where the control forbids it.
    void check_units(const nc::Block& block, nc::Function function);
    /// base  end of the motion, mm and degrees, without the tool's length
    Done require_within_limits(const nc::Block& block, const AxisValues& base, AxisMask moved);
    /// The axes alone, whatever the work area.
    Done require_within_machine(const nc::Block& block, const AxisValues& base, AxisMask moved);
    /// At its end and wherever it bulges.
    Done require_arc_within_limits(const nc::Block& block, const path::Arc& arc,
                                   const Target& target);
    /// mm, base system.
    Done require_box_within_limits(const nc::Block& block, const path::Box& box);

  private:
    Done require_within_area(const nc::Block& block, const AxisValues& base, AxisMask moved);
    void report_limit(const nc::Block& block, Axis axis, double at);

    Channel& channel_;
    const nc::Dialect& dialect_;
    const machine::Machine& machine_;
    const InterpreterOptions& options_;
    Reporter& reporter_;
    const nc::Rules& rules_;
    const Modal& modal_;
    const Position& position_;
    const control::Frames& frames_;
    const ProgrammedSpindle& spindle_;
    const Tool& tool_;
    WorkArea& area_;
    const RadiusCompState& comp_;
    const bool& is_scanning_;
    ProgrammedUnits& units_;
    const bool& taps_rigidly_;
    ReportedInRun& reported_;
    const Dangers& dangers_;
    const AxisData& axes_;
    const AxisValues& length_shift_;
    const std::optional<ContourRun>& contour_;
};

}  // namespace kadr::interp
