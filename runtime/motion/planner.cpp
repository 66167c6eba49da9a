// How commands become segments with their profiles.
//
// prepare.h turns every command into pieces of path, each with limits along the path that keep
// every axis within its velocity, acceleration and jerk whatever the profile does below them, and
// every corner with a speed. Then there are two ways:
//
// Without a limit of the jerk every piece is a stretch of its own: the look-ahead gives its ends
// their speeds, and a trapezoid connects them. Bent pieces that bring an axis near its acceleration
// come in cells (bent_cell.h), with the limits of every axis at both ends instead of fixed shares.
//
// With one, stretch.h gathers pieces to stretches with one set of limits. The look-ahead gives the
// ends of the stretches their speeds; there the acceleration vanishes. A profile of seven phases
// connects them, and profile_cut.h shares it out among the pieces, so phases run across blocks. No
// limit can be passed: a profile keeps those of its stretch, and these are the least of its
// pieces'. Where the bend changes all along the path, long_ramp.h joins stretches again behind the
// look-ahead, if one ramp over them keeps the limits of every piece. Every speed at a junction can
// be braked to rest within what is known. What the gathering costs against the best plan is time
// alone.
#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "motion/planner_state.h"
#include "motion/smooth_profile.h"

namespace kadr::motion {

PlannerOptions Planner::State::prepared_for(const PlannerOptions& options) {
    PlannerOptions highest = options;
    const OperatorPanel panel(options.events, {options.feed_override, options.rapid_override});
    if (panel.is_used()) {
        highest.feed_override = panel.highest().feed;
        highest.rapid_override = panel.highest().rapid;
    } else {
        highest.events.clear();
    }
    return highest;
}

void Planner::State::fill() {
    while (!has_ended && !window.is_full()) {
        if (!waiting.has_fresh()) waiting.add_fresh(preparer.next());
        if (!waiting.has_fresh()) {
            while (!waiting.is_empty()) hand_on_oldest();
            window.finish();
            has_ended = true;
            return;
        }
        waiting.take_fresh();
        while (waiting.is_oldest_settled()) hand_on_oldest();
    }
}

/// Hands on the piece that waits longest.
void Planner::State::hand_on_oldest() {
    const WaitingPieces::Settled settled = waiting.settle_oldest();
    for (std::size_t i = settled.parts; i > 0; --i)
        hand_on(pieces.back(settled.behind + i - 1), settled.exit_limit);
}

/// `exit_limit`: of the corner behind it.
void Planner::State::hand_on(const Piece& piece, double exit_limit) {
    if (piece.is_cell) {
        window.append(piece.cell, piece.entry_limit);
        return;
    }
    Stretch stretch{piece.length, piece.speed, piece.acceleration, piece.entry_limit};
    stretch.feed_asked = piece.feed_asked;
    stretch.rapid_asked = piece.rapid_asked;
    stretch.can_be_held = piece.can_be_held;
    stretch.follows_spindle = piece.follows_spindle;
    const bool limits_jerk = axes.limits_jerk();
    if (piece.varying_feed.is_on()) {
        const VaryingFeed& varying_feed = piece.varying_feed;
        const RateLimits rate = rate_limits(varying_feed, piece.acceleration, piece.jerk);
        stretch.length = varying_feed.time;
        stretch.speed = 1;
        // The varying feed is that of the highest override.
        if (std::isfinite(piece.feed_asked))
            stretch.feed_asked = piece.programmed / varying_feed.most;
        stretch.acceleration = rate.acceleration;
        if (limits_jerk) stretch.jerk = rate.jerk;
        stretch.entry_feed = varying_feed.entry();
        stretch.exit_feed = varying_feed.exit();
        stretch.entry_limit = std::min(1.0, piece.entry_limit / varying_feed.entry());
        exit_limit = std::min(1.0, exit_limit / varying_feed.exit());
    } else if (limits_jerk) {
        stretch.jerk = piece.jerk;
        stretch.entry_acceleration = piece.entry_acceleration;
    }
    window.append(stretch, exit_limit);
}

/// The oldest stretch of the look-ahead with its speeds, and the profile that it has by itself.
PlannedStretch Planner::State::take_stretch() {
    PlannedStretch next;
    if (axes.limits_jerk()) next.limits = window.oldest();
    next.speeds = window.take();
    const Stretch& limits = next.limits;
    if (std::isinf(limits.jerk)) return next;
    const JunctionSpeeds ends = own_speeds(limits, next.speeds);
    const auto whole =
        seven_phases(limits.length, ends.entry, ends.exit,
                     {limits.speed, limits.acceleration, limits.acceleration, limits.jerk});
    KADR_ASSERT(whole.has_value(), "the look-ahead promised a smooth ramp that does not fit");
    next.profile = *whole;
    return next;
}

/// An operator may change the speeds of what comes; then every stretch goes by itself.
bool Planner::State::joins_stretches() const { return axes.limits_jerk() && !panel.is_used(); }

/// The next stretch, or several that one ramp runs over.
void Planner::State::begin_stretch() {
    if (taken.empty()) taken.push_back(take_stretch());
    while (joins_stretches() && taken.size() < kMostJoined &&
           std::isfinite(taken.back().limits.jerk)) {
        if (!window.is_ready()) fill();
        if (!window.is_ready()) break;
        taken.push_back(take_stretch());
    }
    current.limits = taken.front().limits;
    current.speeds = taken.front().speeds;
    LongRamp ramp{1, taken.front().profile};
    const bool has_profile = axes.limits_jerk() && current.has_limited_jerk();
    if (has_profile && joins_stretches()) ramp = long_ramp(taken, pieces, axes).value_or(ramp);
    if (has_profile) current.cut = ProfileCut(ramp.profile);
    current.left = 0;
    for (std::size_t i = 0; i < ramp.stretches; ++i) {
        current.left += taken.front().limits.pieces;
        taken.pop_front();
    }
}

/// Nothing is left.
bool Planner::State::end() {
    losses.finish();
    record.set_commands(preparer.commands());
    record.set_travel(preparer.travel());
    return false;
}

bool Planner::State::next(Segment& segment) {
    if (panel.is_used()) return next_operated(segment);
    while (true) {
        if (current.left == 0) {
            if (!window.is_ready()) fill();
            if (!window.is_ready() && taken.empty()) return end();
            begin_stretch();
        }
        --current.left;
        Piece& piece = pieces.front();
        if (panel.waits_for_block()) note_block(piece);
        plan(piece, current.left == 0);
        const bool is_over = is_over_at_once(piece);
        if (!is_over) {
            note_delivered(piece);
            segment = piece.segment;
        }
        pieces.pop_front();
        if (!is_over) return true;
    }
}

/// What is waited for has come already.
bool Planner::State::is_over_at_once(const Piece& piece) {
    return (piece.awaits || piece.awaits_mark) && !(piece.segment.duration > 0);
}

/// `is_last`: of its stretch.
void Planner::State::plan(Piece& piece, bool is_last) {
    Segment& segment = piece.segment;
    segment.start_time = record.time();
    if (piece.issues > 0 || piece.awaits) plc.begin(piece, preparer.issued(), record.time());
    if (piece.awaits_mark) {
        const double speed = segment.spindle.speed_at(path::start(segment.curve)[0]);
        segment.duration = speed > 0 ? spindle_angle.time_to(piece.mark, speed) : 0;
    }
    if (!is_motion(segment.kind)) return;
    current.plan(piece, is_last, tick);
    segment.duration = segment.profile.duration();
}

void Planner::State::note_delivered(const Piece& piece) {
    losses.add(piece, panel.is_held() ? 0 : panel.dials().feed);
    record.add(piece);
    spindle_angle.pass(piece.segment);
}

Planner::Planner(Stream<path::Command>& commands, const machine::Machine& machine,
                 const PlannerOptions& options, DiagnosticSink& sink)
    : state_(std::make_unique<State>(commands, machine, options, sink)) {}
Planner::~Planner() = default;

std::size_t Planner::pull(std::span<Segment> out) {
    std::size_t written = 0;
    while (written < out.size() && state_->next(out[written])) ++written;
    return written;
}

const Totals& Planner::totals() const { return state_->record.totals(); }
bool Planner::alarmed() const { return state_->preparer.alarmed(); }
const std::vector<OperatorEvent>& Planner::events_ahead() const { return state_->panel.ahead(); }

}  // namespace kadr::motion
