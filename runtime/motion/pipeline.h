// pipeline.h — Command → Segment → Setpoint, and what a run amounts to.
//
// plan: commands become segments, the look-ahead gives every junction its speed; sample: each
// segment is walked along its profile at the machine's tick.
//
//     Planner planner(commands, machine, options, sink);   // Stream<Segment>
//     Sampler sampler(planner, machine, tick);              // Stream<Setpoint>
//
// What an operator does meanwhile (PlannerOptions::events) acts from its time on: the path speed
// goes over to what is allowed then within the limits of the axes, a held program stands on its
// path. The path is the same. The plan has the highest override of the run in reserve, as the
// look-ahead of a control has; lower ones lower its speeds.
//
// Pull the Planner for times and drawings, the Sampler for setpoints; planner.totals() is complete
// when either has come to its end.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "base/stream.h"
#include "machine/machine.h"
#include "motion/operator_panel.h"
#include "motion/plc.h"
#include "motion/report.h"
#include "motion/segment.h"
#include "motion/speed_loss.h"
#include "path/command.h"

namespace kadr::motion {

/// One sample of the motion. Canonical units: s, mm, rad, mm/s.
struct Setpoint {
    double time = 0;
    std::array<double, kAxes> axis{};  // in the order of Machine::axes
    path::Vec3 tip = path::Vec3::Zero();
    path::Vec3 tool = path::Vec3::UnitZ();  // unit vector from tip to holder
    double feed = 0;                        // path speed at this instant
    double programmed_feed = 0;  // path speed asked for; 0 at rapid and with the spindle standing
    double nominal_feed = 0;     // the same at an override of 100 %
    std::uint32_t pulses = 0;    // of the laser since the setpoint before
    std::uint32_t line = 0;      // of the ISO-7bit text
    SourceId source;
};

/// What a run amounts to; filled while the motion is planned, complete at the end of the stream.
struct Totals {
    std::uint64_t commands = 0;
    std::uint64_t segments = 0;              // pieces of motion
    double time = 0;                         // s, everything
    double cutting_time = 0;                 // s at feed
    double rapid_time = 0;                   // s
    double dwell_time = 0;                   // s, dwells and spindle orientation
    double tool_change_time = 0;             // s
    double hold_time = 0;                    // s, held by the operator, or at an override of 0
    double wait_time = 0;                    // s, for the machine to acknowledge M functions
    double external_time = 0;                // s in which a module beside the axes works
    double length = 0;                       // mm, of the tip, all motion
    double cutting_length = 0;               // mm
    std::array<double, kAxes> travel_min{};  // per machine axis, mm or rad; start included
    std::array<double, kAxes> travel_max{};
    std::array<double, kAxes> max_velocity{};      // mm/s or rad/s
    std::array<double, kAxes> max_acceleration{};  // from tick to tick: ramps, arcs, corners
    std::array<double, kAxes> max_jerk{};          // infinite under trapezoidal profiles
};

/// How fast a corner may be taken.
enum class CornerRule : std::uint8_t {
    AxisJump,           // no axis changes its velocity from tick to tick by more than its limit
    JunctionDeviation,  // as if an arc missed the corner by `junction_deviation`
};

struct PlannerOptions {
    double feed_override = 1;   // > 0; multiplies the feed, never a limit
    double rapid_override = 1;  // > 0
    /// What the operator does meanwhile, from these overrides on; with any of it they may be 0.
    std::vector<OperatorEvent> events;
    bool hold_stops_dwell = true;  // the rest of a dwell passes after cycle start
    /// The block number of a line of the ISO-7bit text, -1 none; may be empty.
    std::function<std::int32_t(std::uint32_t line)> number_of;
    /// Gets what keeps every piece below what it asks for, and what that costs; empty: nobody asks.
    std::function<void(const SpeedLoss&)> report_loss;
    /// Who acknowledges M functions; null: the machine's file tells when.
    Plc* plc = nullptr;
    std::size_t lookahead = 1024;  // pieces known ahead at least, the current one included
    CornerRule corner_rule = CornerRule::AxisJump;
    double junction_deviation = 0.01;  // mm
    std::array<double, kAxes>
        velocity_jump{};  // per machine axis, mm/s or rad/s, beside full ramps; 0: the machine's
    bool stop_at_alarm = true;     // false: report and go on with a sensible value
    LocateCommand locate_command;  // for messages; may be empty
};

/// Plans commands into segments with look-ahead. Memory is bounded by the look-ahead, whatever the
/// program's length.
class Planner final : public Stream<Segment> {
  public:
    /// All references outlive the planner.
    Planner(Stream<path::Command>& commands, const machine::Machine& machine,
            const PlannerOptions& options, DiagnosticSink& sink);
    ~Planner() override;

    std::size_t pull(std::span<Segment> out) override;

    /// Of the segments that were delivered; complete at the end of the stream.
    const Totals& totals() const;
    /// An alarm of the motion was reported. With stop_at_alarm the stream ended before the command
    /// that caused it.
    bool alarmed() const;
    /// What the operator would have done at blocks that were not begun.
    const std::vector<OperatorEvent>& events_ahead() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Walks segments at a fixed tick. The setpoints stand at 0, tick, 2·tick …; a tick that crosses a
/// boundary of pieces is filled from the next piece, and the last one stands at the first tick at
/// or after the end, in the end position.
class Sampler final : public Stream<Setpoint> {
  public:
    /// `tick` in s; 0: the machine's. What is planned does not depend on it. References outlive the
    /// sampler.
    Sampler(Stream<Segment>& segments, const machine::Machine& machine, double tick = 0);
    ~Sampler() override;

    std::size_t pull(std::span<Setpoint> out) override;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kadr::motion
