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

    void set_area_limit(const nc::Block& block, const nc::Invocation& invocation);
    Done require_no_move_before_tap(const nc::Block& block, nc::SlotMask targets);
    Done require_feed(const nc::Block& block, std::string_view what);
    Done require_probe_feed(const nc::Block& block);
    void check_rapid(const nc::Block& block, const Target& target);
    void check_tool(const nc::Block& block);
    void check_units(const nc::Block& block, nc::Function function);
    Done require_within_limits(const nc::Block& block, const AxisValues& base, AxisMask moved);
    Done require_within_machine(const nc::Block& block, const AxisValues& base, AxisMask moved);
    Done require_arc_within_limits(const nc::Block& block, const path::Arc& arc,
                                   const Target& target);
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
    const Spindle& spindle_;
    const Tool& tool_;
    WorkArea& area_;
    const RadiusCompState& comp_;
    const bool& is_scanning_;
    Units& units_;
    const bool& taps_rigidly_;
    ReportedInRun& told_;
    const Dangers& dangers_;
    const AxisData& axes_;
    const AxisValues& length_shift_;
    const std::optional<ContourRun>& contour_;
};

}  // namespace kadr::interp
