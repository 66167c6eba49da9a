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

namespace {

constexpr double kStraight = 1e-9;  // as in corner.cpp

/// The greatest acceleration along the path within a tick of an end of a profile, where it is this.
double acceleration_near(const Profile& profile, double at_end, double tick) {
    const double most = path_acceleration(profile);
    if (!profile.is_smooth || profile.has_varying_feed()) return most;
    return std::min(most, std::abs(at_end) + path_jerk(profile) * tick);
}

}  // namespace

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
    while (!has_ended && !lookahead.is_full()) {
        if (fresh == 0) fresh = preparer.next();
        if (fresh == 0) {
            while (waiting > 1) hand_on_oldest(0);
            if (waiting > 0) hand_on_waiting(0, Piece{});
            waiting = 0;
            gathered.finish();
            append_complete();
            lookahead.finish();
            has_ended = true;
            return;
        }
        --fresh;
        if (waiting > 0 && !axes.limits_jerk()) share_crowd();
        ++waiting;
        while (waiting > 1 && is_out_of_reach()) hand_on_oldest(fresh);
    }
}

/// Hands on the piece that waits longest; so many pieces are `fresh_ones`.
void Planner::State::hand_on_oldest(std::size_t fresh_ones) {
    --waiting;
    const std::size_t place = fresh_ones + waiting;
    hand_on_waiting(place, pieces.back(place - 1));
}

/// Without a limit of the jerk the setpoints of a tick may see several corners with the ramps of
/// all pieces between them: within a tick of a crowded one the ramps have what it leaves.
void Planner::State::share_crowd() {
    Piece& newest = pieces.back(fresh);
    double time = 0;  // at least, from the newest corner back
    for (std::size_t k = 1; k <= waiting && time < tick; ++k) {
        Piece& behind = pieces.back(fresh + k - 1);
        behind.ramp_before = std::min(behind.ramp_before, newest.crowd_ramp);
        Piece& before = pieces.back(fresh + k);
        time += before.length / before.speed;
        if (time < tick) newest.ramp = std::min(newest.ramp, before.crowd_ramp);
    }
}

/// Whether no corner that is still to come lies within a tick of the piece that waits longest.
bool Planner::State::is_out_of_reach() const {
    if (axes.limits_jerk()) return true;
    double time = 0;
    for (std::size_t k = 0; k + 1 < waiting && time < tick; ++k) {
        const Piece& piece = pieces.back(fresh + k);
        if (piece.entry_limit == 0) return true;  // it rests there
        time += piece.length / piece.speed;
    }
    return time >= tick;
}

/// The piece that waited for `next`, with what the corners at both its ends leave of its
/// acceleration and its jerk; so many pieces are `behind` it.
void Planner::State::hand_on_waiting(std::size_t behind, const Piece& next) {
    const double exit_limit = next.entry_limit;
    Piece& piece = pieces.back(behind);
    piece.jerk *= std::min(1.0, next.jerk_before / piece.jerk_share);
    piece.acceleration =
        std::min(piece.acceleration, piece.turning_acceleration * next.jerk_before);
    piece.is_cell = piece.is_cell && piece.ramp == 1 && next.ramp_before == 1;
    const double head = piece.corner_zone;
    const double tail = next.corner_zone_before;
    const double all = piece.acceleration;
    if (head == 0) piece.acceleration = std::min(piece.acceleration, piece.ramp * all);
    if (tail == 0) piece.acceleration = std::min(piece.acceleration, next.ramp_before * all);
    if (head == 0 && tail == 0) return hand_on(piece, exit_limit);

    // Beside a corner it has less on a short way alone: that is a piece of its own.
    const Piece whole = piece;
    const std::array<double, 4> bounds{0, head, whole.length - tail, whole.length};
    const std::array<double, 3> most{piece.ramp * all, all, next.ramp_before * all};
    bool is_first = true;
    for (std::size_t i = 0; i < most.size(); ++i) {
        if (bounds[i] == bounds[i + 1]) continue;
        Piece& part = is_first ? pieces.back(behind) : pieces.insert_behind(behind);
        part = part_of(whole, bounds[i], bounds[i + 1], axes);
        part.acceleration = std::min(whole.acceleration, most[i]);
        if (!is_first) part.issues = 0;
        is_first = false;
        hand_on(part, whole.speed);
    }
}

/// `exit_limit`: of the corner behind it.
void Planner::State::hand_on(const Piece& piece, double exit_limit) {
    if (piece.is_cell) {
        lookahead.append(piece.cell, piece.entry_limit);
        return;
    }
    Stretch stretch{piece.length, piece.speed, piece.acceleration, piece.entry_limit};
    stretch.feed_asked = piece.feed_asked;
    stretch.rapid_asked = piece.rapid_asked;
    stretch.can_be_held = piece.can_be_held;
    stretch.follows_spindle = piece.follows_spindle;
    if (piece.course.is_on()) {
        const FeedCourse& course = piece.course;
        const RateLimits rate = rate_limits(course, piece.acceleration, piece.jerk);
        stretch.length = course.time;
        stretch.speed = 1;
        // The course is that of the highest override.
        if (std::isfinite(piece.feed_asked)) stretch.feed_asked = piece.programmed / course.most;
        stretch.acceleration = rate.acceleration;
        stretch.entry_feed = course.entry();
        stretch.exit_feed = course.exit();
        stretch.entry_limit = std::min(1.0, piece.entry_limit / course.entry());
        if (axes.limits_jerk()) {
            stretch.jerk = rate.jerk;
            exit_limit = std::min(1.0, exit_limit / course.exit());
            gathered.add(stretch, exit_limit);
            append_complete();
            return;
        }
    }
    if (!axes.limits_jerk()) {
        lookahead.append(stretch);
        if (panel.is_used()) stretches.push_back(stretch);
        return;
    }
    stretch.jerk = piece.jerk;
    stretch.entry_acceleration = piece.entry_acceleration;
    gathered.add(stretch, exit_limit);
    append_complete();
}

void Planner::State::append_complete() {
    for (const Stretch& stretch : gathered.complete()) {
        lookahead.append(stretch);
        stretches.push_back(stretch);
    }
    gathered.clear();
}

/// Speeds along the path in the unit of a stretch; at most its own, but for rounding.
JunctionSpeeds own_speeds(const Stretch& stretch, const JunctionSpeeds& speeds) {
    if (!stretch.has_varying_feed()) return speeds;
    return {std::min(stretch.speed, speeds.entry / stretch.entry_feed),
            std::min(stretch.speed, speeds.exit / stretch.exit_feed)};
}

/// The oldest stretch of the look-ahead with its speeds, and the profile that it has by itself.
PlannedStretch Planner::State::take_stretch() {
    PlannedStretch next;
    next.speeds = lookahead.take();
    next.limits.pieces = 1;
    if (!axes.limits_jerk()) return next;
    next.limits = stretches.front();
    stretches.pop_front();
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
        if (!lookahead.is_ready()) fill();
        if (!lookahead.is_ready()) break;
        taken.push_back(take_stretch());
    }
    current = taken.front().limits;
    speeds = taken.front().speeds;
    LongRamp ramp{1, taken.front().profile};
    const bool has_profile = axes.limits_jerk() && std::isfinite(current.jerk);
    if (has_profile && joins_stretches()) ramp = long_ramp(taken, pieces, axes).value_or(ramp);
    if (has_profile) cut = ProfileCut(ramp.profile);
    left = 0;
    for (std::size_t i = 0; i < ramp.stretches; ++i) {
        left += taken.front().limits.pieces;
        taken.pop_front();
    }
}

/// Nothing is left.
bool Planner::State::end() {
    losses.finish();
    totals.commands = preparer.commands();
    record_travel();
    return false;
}

bool Planner::State::next(Segment& segment) {
    if (panel.is_used()) return next_operated(segment);
    while (true) {
        if (left == 0) {
            if (!lookahead.is_ready()) fill();
            if (!lookahead.is_ready() && taken.empty()) return end();
            begin_stretch();
        }
        --left;
        Piece& piece = pieces.front();
        if (panel.waits_for_block()) note_block(piece);
        plan(piece, left == 0);
        const bool is_over = is_over_at_once(piece);
        if (!is_over) {
            record(piece);
            segment = piece.segment;
        }
        pieces.pop_front();
        if (!is_over) return true;
    }
}

/// The piece begins, and with it its M functions.
void Planner::State::issue(Piece& piece) {
    std::deque<IssuedFunction>& issued = preparer.issued();
    for (; piece.issues > 0; --piece.issues) {
        IssuedFunction function = issued.front();
        issued.pop_front();
        function.time = totals.time;
        acknowledged = std::max({acknowledged, totals.time, plc.acknowledged(function)});
    }
    if (piece.awaits) piece.segment.duration = std::max(0.0, acknowledged - totals.time);
}

/// What is waited for has come already.
bool Planner::State::is_over_at_once(const Piece& piece) {
    return (piece.awaits || piece.awaits_mark) && !(piece.segment.duration > 0);
}

/// `is_last`: of its stretch.
void Planner::State::plan(Piece& piece, bool is_last) {
    Segment& segment = piece.segment;
    segment.start_time = totals.time;
    if (piece.issues > 0 || piece.awaits) issue(piece);
    if (piece.awaits_mark) {
        const double speed = segment.spindle.speed_at(path::start(segment.curve)[0]);
        segment.duration = speed > 0 ? spindle_angle.time_to(piece.mark, speed) : 0;
    }
    if (!is_motion(segment.kind)) return;
    if (piece.is_cell) {
        segment.profile = profile_over(piece.cell, speeds.entry, speeds.exit);
    } else if (given) {
        segment.profile = piece.course.is_on() ? over_varying_feed(*given, piece.course) : *given;
    } else if (piece.course.is_on()) {
        plan_varying_feed(piece, is_last);
    } else if (std::isinf(current.jerk)) {
        auto profile = trapezoid(piece.length, speeds.entry, speeds.exit,
                                 {piece.speed, piece.acceleration, piece.acceleration});
        KADR_ASSERT(profile.has_value(),
                    "the look-ahead promised a change of speed that does not fit");
        segment.profile = *profile;
        // What setpoints show of an acceleration that begins at once.
        if (piece.is_geared) segment.profile.jerk = piece.acceleration / tick;
    } else {
        segment.profile = cut.next(piece.length, is_last);
    }
    segment.duration = segment.profile.duration();
}

/// Over the time of its feed, as others over their length.
void Planner::State::plan_varying_feed(Piece& piece, bool is_last) {
    const FeedCourse& course = piece.course;
    if (std::isfinite(current.jerk)) {
        piece.segment.profile = over_varying_feed(cut.next(course.time, is_last), course);
        return;
    }
    const double most = rate_limits(course, piece.acceleration, piece.jerk).acceleration;
    const auto rate = trapezoid(course.time, std::min(1.0, speeds.entry / course.entry()),
                                std::min(1.0, speeds.exit / course.exit()), {1, most, most});
    KADR_ASSERT(rate.has_value(), "the look-ahead promised a change of speed that does not fit");
    piece.segment.profile = over_varying_feed(*rate, course);
}

void Planner::State::record(const Piece& piece) {
    const Segment& segment = piece.segment;
    losses.add(piece, panel.is_held() ? 0 : panel.dials().feed);
    totals.time += segment.duration;
    spindle_angle.pass(segment);
    switch (segment.kind) {
        case SegmentKind::Rapid: totals.rapid_time += segment.duration; break;
        case SegmentKind::Feed: totals.cutting_time += segment.duration; break;
        case SegmentKind::Dwell:
        case SegmentKind::Orient: totals.dwell_time += segment.duration; break;
        case SegmentKind::ToolChange: totals.tool_change_time += segment.duration; break;
        case SegmentKind::Hold: totals.hold_time += segment.duration; break;
        case SegmentKind::Wait: totals.wait_time += segment.duration; break;
        case SegmentKind::External:
        case SegmentKind::Jump:
        case SegmentKind::Mark: totals.external_time += segment.duration; break;
    }
    if (!is_motion(segment.kind)) return;
    ++totals.segments;
    const double length = path::arc_length(segment.curve);
    totals.length += length;
    if (segment.kind == SegmentKind::Feed) totals.cutting_length += length;
    AxisTable::Peaks peaks = axes.peaks(segment, piece.loads);
    if (piece.is_cell) axes.measure_cell(segment, piece.cell, peaks);
    for (std::size_t i = 0; i < axes.size(); ++i) {
        totals.max_velocity[i] = std::max(totals.max_velocity[i], peaks.velocity[i]);
        totals.max_acceleration[i] = std::max(totals.max_acceleration[i], peaks.acceleration[i]);
        totals.max_jerk[i] = std::max(totals.max_jerk[i], peaks.jerk[i]);
    }
    record_corner(piece);
}

/// What setpoints show at a corner: the jump of the velocity and the ramps beside it.
void Planner::State::record_corner(const Piece& piece) {
    const Segment& segment = piece.segment;
    const double speed = segment.profile.entry_speed;
    const double along = path_acceleration(segment.profile);
    const bool is_straight =
        std::holds_alternative<path::Line>(segment.curve) && !segment.is_transformed();
    const double near =
        acceleration_near(segment.profile, segment.profile.entry_acceleration, tick);
    if (axes.limits_jerk()) record_jerk(piece, along);
    if (speed > 0) {
        for (std::size_t i = 0; i < axes.size(); ++i) {
            const double change = std::abs(piece.rates[i] - last_rates[i]);
            if (change < kStraight) continue;
            const double jump = change * speed / tick;
            const double reached = corner_acceleration(last_loads.at(i, speed, last_near),
                                                       piece.loads.at(i, speed, near), jump);
            totals.max_acceleration[i] = std::max(totals.max_acceleration[i], reached);
        }
    }
    last_rates = is_straight ? piece.rates : axes.end_rates(segment);
    last_loads = piece.loads;
    last_along = along;
    const double end = state_at(segment.profile, segment.profile.duration()).acceleration;
    last_near = acceleration_near(segment.profile, end, tick);
}

/// The same of the jerk.
void Planner::State::record_jerk(const Piece& piece, double along) {
    const Segment& segment = piece.segment;
    const double speed = segment.profile.entry_speed;
    const double jerk = path_jerk(segment.profile);
    const bool is_straight =
        std::holds_alternative<path::Line>(segment.curve) && !segment.is_transformed();
    const AxisRates bends = is_straight ? AxisRates{} : axes.start_bends(segment);
    for (std::size_t i = 0; speed > 0 && i < axes.size(); ++i) {
        const double jump = std::abs(piece.rates[i] - last_rates[i]) * speed / tick;
        const double bend = std::abs(bends[i] - last_bends[i]) * speed * speed;
        if (jump == 0 && bend == 0) continue;
        const double beside = std::max(last_loads.jerk_at(i, {speed, last_along, last_jerk}),
                                       piece.loads.jerk_at(i, {speed, along, jerk}));
        totals.max_jerk[i] =
            std::max(totals.max_jerk[i], (jump + kJumpBell * bend) / tick + beside);
    }
    last_bends = is_straight ? AxisRates{} : axes.end_bends(segment);
    last_jerk = jerk;
}

void Planner::State::record_travel() {
    totals.travel_min = preparer.travel().lower;
    totals.travel_max = preparer.travel().upper;
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

const Totals& Planner::totals() const { return state_->totals; }
bool Planner::alarmed() const { return state_->preparer.alarmed(); }
const std::vector<OperatorEvent>& Planner::events_ahead() const { return state_->panel.ahead(); }

}  // namespace kadr::motion
