// Planning while an operator turns overrides, holds the feed and starts it again.
//
// Pieces are prepared for the highest override of the run. What is planned stays as it is until an
// event; there the piece that is being run is cut, the rest of its stretch goes back in front of
// the look-ahead, which gives every junction its speed under the new overrides, and the rest is
// begun in the state that the axes are in (reaction.h). Where the motion may not go on, the axes
// stand until an event lets them.
//
// What cannot be held is run to its end, all pieces of it that follow each other: a thread, a tap
// out of its hole again. A tool change or the motion of the spindle to an angle is finished, and
// the hold acts behind it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/assert.h"
#include "base/diagnostics/machine.h"
#include "motion/axis_check.h"
#include "motion/planner_state.h"
#include "motion/smooth_profile.h"

namespace kadr::motion {

namespace {

// Times that are closer, s, are the same; lengths, mm (deg), likewise: cutting off less would only
// be rounding.
constexpr double kSameTime = 1e-12;
constexpr double kSamePlace = 1e-9;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A thread, a tap, and what the program lets no hold interrupt.
bool goes_through_hold(const Piece& piece) {
    return is_motion(piece.segment.kind) && !piece.can_be_held;
}

}  // namespace

bool Planner::State::next_operated(Segment& segment) {
    while (!operated.stands_for_ever) {
        if (current.left == 0) {
            obey_until(record.time());
            if (!window.is_ready()) fill();
            if (!window.is_ready()) break;
            if (must_wait()) {
                if (!wait(segment)) break;
                return true;
            }
            begin_operated();
            continue;
        }
        Piece& piece = pieces.front();
        note_block(piece);
        plan(piece, current.left == 1);
        if (is_over_at_once(piece)) {
            operated.went_through |= piece.awaits_mark;
            --current.left;
            pieces.pop_front();
            continue;
        }
        panel.pass_idle_until(record.time() + piece.segment.duration - kSameTime);
        const double passed = std::max(0.0, panel.next_time() - record.time());
        if (passed >= piece.segment.duration - kSameTime) {
            deliver(segment);
            return true;
        }
        if (is_motion(piece.segment.kind) ? run_for(passed, segment) : stand_for(segment)) {
            return true;
        }
    }
    return end();
}

/// Informs the panel if a block begins with the piece.
void Planner::State::note_block(const Piece& piece) {
    if (piece.segment.line == operated.line) return;
    operated.line = piece.segment.line;
    const bool is_asked = options.number_of && panel.waits_for_block();
    panel.begin_block(operated.line, is_asked ? options.number_of(operated.line) : -1,
                      record.time());
}

/// Does what is due, and lets the look-ahead know.
void Planner::State::obey_until(double time) {
    if (panel.act_until(time + kSameTime)) window.set_overrides(panel.acting());
}

/// The segment of the oldest piece, as it is planned.
void Planner::State::deliver(Segment& segment) {
    --current.left;
    const Piece& piece = pieces.front();
    note_delivered(piece);
    // Between the spindle's mark and the thread that begins there nothing may pass.
    if (is_motion(piece.segment.kind)) operated.went_through = goes_through_hold(piece);
    else if (piece.awaits_mark) operated.went_through = true;
    segment = piece.segment;
    if (std::isfinite(piece.feed_asked)) {
        const double dial = panel.dials().feed;
        const bool is_limited = max_feed > 0 && !segment.is_rotary_only;
        segment.feed = std::min(dial * piece.programmed, is_limited ? max_feed : kInfinity);
        segment.feed_per_revolution *= dial / options.feed_override;
        if (piece.varying_feed.is_on())
            segment.feed = piece.length / piece.varying_feed.time * dial / options.feed_override;
    }
    if (std::isfinite(piece.rapid_asked)) segment.feed = panel.dials().rapid * piece.programmed;
    pieces.pop_front();
}

// ------------------------------------------------------------------------------ standing

/// Whether the axes stand and may not go on.
bool Planner::State::must_wait() {
    if (window.reached() > 0) return false;
    const OverriddenSpeed most = window.oldest().most();
    if (!(most.speed_at(panel.acting()) > 0)) return true;
    return panel.is_held() && !most.can_be_held && !goes_through();
}

/// Behind a motion that cannot be held and in front of another one, with nothing between but
/// standstill.
bool Planner::State::goes_through() {
    if (!operated.went_through) return false;
    std::size_t next = 0;
    while (next + 1 < pieces.size() && !is_motion(pieces.at(next).segment.kind)) ++next;
    return goes_through_hold(pieces.at(next));
}

/// Stands until the next event; not done if there is none.
Done Planner::State::wait(Segment& segment) {
    const Segment& next = pieces.front().segment;
    operated.start.acceleration = 0;
    if (std::isinf(panel.next_time())) {
        const bool is_rapid = std::isfinite(pieces.front().rapid_asked);
        report(sink, diag::StandsForEver, CommandLocation{next.line, next.source, {}},
               options.locate_command)
            .arg(panel.is_held() ? "feed hold"
                 : is_rapid      ? "a rapid override of 0 %"
                                 : "a feed override of 0 %")
            .fix(panel.is_held() ? "let cycle start follow at a later time"
                                 : "let an override above 0 % follow at a later time");
        operated.stands_for_ever = true;
        return kFailed;
    }
    segment = part_of(next, 0, 0);
    segment.curve = path::Point{path::start(next.curve)};
    segment.kind = SegmentKind::Hold;
    segment.followers = 0;
    segment.follower_rate = {};
    segment.profile = {};
    segment.feed = segment.feed_per_revolution = 0;
    segment.ends_command = segment.has_pulse = segment.is_rotary_only = false;
    segment.start_time = record.time();
    segment.duration = panel.next_time() - record.time();
    record.add_hold(segment.duration);
    spindle_angle.pass(segment);
    return kDone;
}

// ------------------------------------------------------------------------------ stretches

void Planner::State::begin_operated() {
    current.limits = window.oldest();
    Stretch& limits = current.limits;
    const PathMoment at{window.reached() / limits.entry_scale(), operated.start.acceleration};
    operated.start.acceleration = 0;
    current.given.reset();
    current.rest_follows = false;
    Stretch now = limits;
    now.speed = limits.most().speed_at(panel.acting());
    const double exit_limit = window.exit_limit() / limits.exit_scale();
    const bool moves = limits.length > 0;
    const auto answer = moves ? reaction(at, now, exit_limit) : std::nullopt;
    current.speeds = window.take();
    current.left = limits.pieces;
    if (answer && answer->length < limits.length) {
        split_current(answer->length, answer->exit_speed);
    } else if (answer) {
        current.speeds.exit = answer->exit_speed * limits.exit_scale();
        window.depart(current.speeds.exit);
    }
    if (!moves) return;
    const ProfileLimits most{now.speed, now.acceleration, now.acceleration, now.jerk};
    const JunctionSpeeds ends = own_speeds(now, current.speeds);
    if (std::isinf(now.jerk)) {
        const auto sharp = trapezoid(now.length, ends.entry, ends.exit, most);
        KADR_ASSERT(answer || sharp.has_value(),
                    "the look-ahead promised a ramp that does not fit");
        current.given = answer ? *answer : *sharp;
        return;
    }
    const auto smooth = answer ? Result<Profile, ProfileFault>(*answer)
                               : seven_phases(now.length, ends.entry, ends.exit, most);
    KADR_ASSERT(smooth.has_value(), "the look-ahead promised a smooth ramp that does not fit");
    current.cut = ProfileCut(*smooth);
}

/// The current stretch ends behind this length, in a piece of its own and at this speed; the rest
/// follows.
void Planner::State::split_current(double length, double exit_speed) {
    Stretch& limits = current.limits;
    std::size_t count = 0;
    double to = length;  // from the start of the piece `count`
    while (count + 1 < limits.pieces && to > pieces.at(count).extent() - kSamePlace)
        to -= pieces.at(count++).extent();
    Stretch rest = limits;
    rest.entry_limit = limits.speed;
    rest.entry_acceleration = kInfinity;
    rest.length -= length;
    if (to > kSamePlace) {
        const Piece whole = pieces.at(count);
        pieces.insert(count) = part_between(whole, 0, to, axes);
        pieces.at(count + 1) = part_between(whole, to, whole.extent(), axes);
        ++count;
        ++rest.pieces;
    }
    rest.pieces -= count;
    if (rest.has_varying_feed())
        rest.entry_feed = limits.exit_feed = pieces.at(count).varying_feed.entry();
    current.speeds.exit = exit_speed * rest.entry_scale();
    window.put_back(rest, current.speeds.exit);
    limits.length = length;
    limits.pieces = current.left = count;
    // Where the acceleration vanishes between the two, the next event joins them again.
    current.rest_follows = current.has_limited_jerk();
}

/// The current stretch, as far as it is not delivered, is to be begun anew, in this state, which is
/// given in the stretch's own unit.
void Planner::State::interrupt(const PathMoment& moment) {
    Stretch rest = current.limits;
    rest.entry_limit = current.limits.speed;
    rest.entry_acceleration = kInfinity;
    rest.pieces = current.left;
    rest.length = 0;
    for (std::size_t i = 0; i < current.left; ++i) rest.length += pieces.at(i).extent();
    if (rest.has_varying_feed()) rest.entry_feed = pieces.front().varying_feed.entry();
    if (current.rest_follows) {
        const Stretch& following = window.oldest();
        rest.length += following.length;
        rest.exit_feed = following.exit_feed;
        rest.pieces += following.pieces;
        window.drop();
    }
    window.put_back(rest, moment.speed * rest.entry_scale());
    operated.start = moment;
    current.left = 0;
}

// ------------------------------------------------------------------------------ events

/// An event comes while the oldest piece is run, so much later than it begins. False if there is
/// nothing to be delivered before it.
bool Planner::State::run_for(double passed, Segment& segment) {
    Piece& piece = pieces.front();
    const double time = record.time() + passed;
    const Profile whole_profile = piece.segment.profile;
    const Profile profile =
        whole_profile.has_varying_feed() ? rate_of(whole_profile) : whole_profile;
    const ProfileState state = state_at(profile, passed);
    if (state.distance > piece.extent() - kSamePlace) {
        deliver(segment);
        return true;
    }
    const bool is_begun = state.distance > kSamePlace;
    const bool is_smooth = current.has_limited_jerk();
    PathMoment moment{profile.entry_speed, is_smooth ? profile.entry_acceleration : 0};
    if (is_begun) {
        moment = {state.speed, is_smooth ? state.acceleration : 0};
        const Piece whole = piece;
        pieces.insert(0) = part_between(whole, 0, state.distance, axes);
        pieces.at(1) = part_between(whole, state.distance, whole.extent(), axes);
        ++current.left;
        const VaryingFeed& varying_feed = pieces.front().varying_feed;
        Segment& head = pieces.front().segment;
        head.profile = head_of(profile, passed);
        if (varying_feed.is_on()) head.profile = over_varying_feed(head.profile, varying_feed);
        head.duration = passed;
        deliver(segment);
    }
    interrupt(moment);
    obey_until(time);
    return is_begun;
}

/// Events come while the axes stand. A hold stops a dwell, whose rest passes later; nothing else is
/// interrupted. False if there is nothing to be delivered before it.
bool Planner::State::stand_for(Segment& segment) {
    const double end = record.time() + pieces.front().segment.duration;
    const bool is_dwell = pieces.front().segment.kind == SegmentKind::Dwell;
    while (panel.next_time() < end - kSameTime) {
        const double passed = panel.next_time() - record.time();
        obey_until(panel.next_time());
        if (!is_dwell || !options.hold_stops_dwell || !panel.is_held() || goes_through()) continue;
        const bool is_begun = passed > kSameTime;
        if (is_begun) {
            const Piece whole = pieces.front();
            pieces.insert(0) = whole;
            pieces.at(0).segment.duration = passed;
            pieces.at(0).segment.ends_command = false;
            pieces.at(1).segment.duration -= passed;
            ++current.left;
            deliver(segment);
        }
        interrupt({0, 0});
        window.set_overrides(panel.acting());
        return is_begun;
    }
    deliver(segment);
    return true;
}

}  // namespace kadr::motion
