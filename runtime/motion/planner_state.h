// planner_state.h — what the planner knows between two segments. Internal to motion.
//
// Its functions are in chapters: planner.cpp (the path of the pieces through the look-ahead),
// planner_operated.cpp (an operator changes overrides meanwhile).
#pragma once

#include <deque>

#include "base/done.h"
#include "motion/axis_table.h"
#include "motion/long_ramp.h"
#include "motion/loss_trace.h"
#include "motion/pipeline.h"
#include "motion/plc_handshake.h"
#include "motion/prepare.h"
#include "motion/reaction.h"
#include "motion/run_record.h"
#include "motion/running_stretch.h"
#include "motion/spindle_angle.h"
#include "motion/stretch_window.h"
#include "motion/waiting_pieces.h"

namespace kadr::motion {

struct Planner::State {
    State(Stream<path::Command>& commands, const machine::Machine& machine,
          const PlannerOptions& options_in, DiagnosticSink& sink_in)
        : options(prepared_for(options_in)),
          axes(machine),
          sink(sink_in),
          max_feed(machine.max_feed),
          panel(options_in.events, {options_in.feed_override, options_in.rapid_override}),
          preparer(commands, machine, axes, options, sink_in, pieces),
          waiting(pieces, axes, machine.tick),
          window(options.lookahead, {axes.limits_jerk(), panel.is_used()}),
          tick(machine.tick),
          plc(machine, options.plc),
          losses(machine, axes, options_in.report_loss),
          record(axes, machine.tick) {
        window.set_overrides(panel.acting());
        record.set_travel(preparer.travel());
    }
    /// For the highest overrides of the run.
    static PlannerOptions prepared_for(const PlannerOptions& options);

    bool next(Segment& segment);
    bool end();
    void fill();
    void hand_on_oldest();
    void hand_on(const Piece& piece, double exit_limit);
    void begin_stretch();
    PlannedStretch take_stretch();
    bool joins_stretches() const;
    static bool is_over_at_once(const Piece& piece);
    void plan(Piece& piece, bool is_last);
    void note_delivered(const Piece& piece);

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
    PieceRing pieces;  // between preparation and delivery
    Preparer preparer;
    WaitingPieces waiting;             // … and not in the look-ahead yet
    StretchWindow window;              // in the look-ahead
    std::deque<PlannedStretch> taken;  // behind it, that may be joined to one
    RunningStretch current;            // its pieces are being delivered
    double tick;                       // s, of the machine
    PlcHandshake plc;
    LossTrace losses;
    SpindleAngle spindle_angle;
    RunRecord record;
    bool has_ended = false;  // no further command comes

    /// What is remembered of the motion for events to come.
    struct Operated {
        PathMoment start;           // in it the oldest stretch begins, in the unit of its stretch;
                                    // its speed the look-ahead has
        std::uint32_t line = 0;     // of the block that was begun last
        bool went_through = false;  // the motion delivered last: a hold does not act on it
        bool stands_for_ever = false;  // nothing will let the motion go on
    };
    Operated operated;
};

}  // namespace kadr::motion
