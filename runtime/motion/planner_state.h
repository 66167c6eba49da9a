// planner_state.h — what the planner knows between two segments. Internal to motion.
//
// Its functions are told in chapters: planner.cpp (the way of the pieces through the look-ahead,
// what a run amounts to), planner_operated.cpp (an operator changes overrides meanwhile).
#pragma once

#include <deque>
#include <optional>

#include "base/done.h"
#include "motion/axis_table.h"
#include "motion/long_ramp.h"
#include "motion/lookahead.h"
#include "motion/loss_trace.h"
#include "motion/pipeline.h"
#include "motion/prepare.h"
#include "motion/profile_cut.h"
#include "motion/reaction.h"
#include "motion/spindle_angle.h"
#include "motion/stretch.h"

namespace kadr::motion {

JunctionSpeeds own_speeds(const Stretch& stretch, const JunctionSpeeds& speeds);

struct Planner::State {
    State(Stream<path::Command>& commands, const machine::Machine& machine,
          const PlannerOptions& options_in, DiagnosticSink& sink_in)
        : options(prepared_for(options_in)),
          axes(machine),
          sink(sink_in),
          max_feed(machine.max_feed),
          panel(options_in.events, {options_in.feed_override, options_in.rapid_override}),
          preparer(commands, machine, axes, options, sink_in, pieces),
          gathered(std::max<std::size_t>(options.lookahead, 1)),
          lookahead(options.lookahead),
          tick(machine.tick),
          machine_plc(machine),
          plc(options.plc != nullptr ? *options.plc : machine_plc),
          losses(machine, axes, options_in.report_loss) {
        lookahead.set_overrides(panel.acting());
        record_travel();
    }
    /// For the highest overrides of the run.
    static PlannerOptions prepared_for(const PlannerOptions& options);

    bool next(Segment& segment);
    bool end();
    void fill();
    void hand_on_oldest(std::size_t fresh_ones);
    void share_crowd();
    bool is_out_of_reach() const;
    void hand_on_waiting(std::size_t behind, const Piece& next);
    void hand_on(const Piece& piece, double exit_limit);
    void append_complete();
    void begin_stretch();
    PlannedStretch take_stretch();
    bool joins_stretches() const;
    void issue(Piece& piece);
    static bool is_over_at_once(const Piece& piece);
    void plan(Piece& piece, bool is_last);
    void plan_varying_feed(Piece& piece, bool is_last);
    void record(const Piece& piece);
    void record_corner(const Piece& piece);
    void record_jerk(const Piece& piece, double along);
    void record_travel();

    // With an operator; in planner_operated.cpp.
    bool next_operated(Segment& segment);
    void note_block(const Piece& piece);
    void obey_until(double time);
    void deliver(Segment& segment);
    bool must_wait();
    bool goes_through();
    Done wait(Segment& segment);
    void begin_operated();
    void split_current(double length, double exit_speed);
    void interrupt(const PathMoment& moment);
    bool run_for(double passed, Segment& segment);
    bool stand_for(Segment& segment);

    PlannerOptions options;
    AxisTable axes;
    DiagnosticSink& sink;
    double max_feed;
    OperatorPanel panel;
    PieceRing pieces;       // between preparation and delivery
    std::size_t fresh = 0;  // so many of them are not in the look-ahead yet
    Preparer preparer;
    StretchBuilder gathered;
    LookAhead lookahead;
    std::deque<Stretch> stretches;     // in the look-ahead
    Stretch current;                   // its pieces are being delivered
    std::deque<PlannedStretch> taken;  // behind it, that may be joined to one
    JunctionSpeeds speeds;
    ProfileCut cut;        // of its profile, if its jerk is limited
    std::size_t left = 0;  // so many of its pieces
    double tick;           // s, of the machine
    MachinePlc machine_plc;
    Plc& plc;
    LossTrace losses;
    SpindleAngle spindle_angle;
    double acknowledged = 0;       // s, all that was issued so far
    PathMoment start;              // in it the oldest stretch begins, in the unit of its stretch;
                                   // its speed the look-ahead has
    std::optional<Profile> given;  // of the current stretch, if its jerk is not limited
    bool rest_follows = false;     // of the current stretch: it is the oldest one
    std::uint32_t line = 0;        // of the block that was begun last
    bool went_through = false;     // the motion delivered last: a hold does not act on it
    bool is_stuck = false;         // nothing will let the motion go on
    bool has_ended = false;
    std::size_t waiting = 0;  // so many pieces before the fresh ones, for corners behind them

    Totals totals;
    AxisRates last_rates{};  // of the piece delivered last, at its end
    AxisTable::Loads last_loads;
    AxisRates last_bends{};
    double last_along = 0;  // its acceleration along the path
    double last_near = 0;   // … within a tick of its end
    double last_jerk = 0;   // its jerk along the path
};

}  // namespace kadr::motion
