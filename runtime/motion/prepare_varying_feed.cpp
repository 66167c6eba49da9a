// prepare_varying_feed.cpp — motions whose feed changes along them.
//
// Where the axes can follow the feed, a piece has it as its own (varying_feed.h). Where they
// cannot, or the pulses of a laser change the speed meanwhile, it goes in steps: short pieces, each
// with the least feed on it, whose limits are those of any other piece.
#include <algorithm>
#include <cmath>

#include "motion/feed.h"
#include "motion/prepare_state.h"

namespace kadr::motion {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// From its least to its greatest feed a varying feed grows by this factor at most: what its ramps
/// may have goes by the greatest. A step grows by less.
constexpr double kCourse = 1.5;
constexpr double kStep = 1.02;
/// The feed does not change: rounding.
constexpr double kEven = 1 + 1e-9;
/// Of the acceleration and the jerk of a piece, what its feed may take; corners may take half of
/// them, and something has to be left to come up to the feed.
constexpr double kOfAcceleration = 0.25;
constexpr double kOfJerk = 0.2;
/// No piece passes in fewer ticks.
constexpr double kShortestTicks = 2;
constexpr double kNoJump = 1e-9;

}  // namespace

bool Preparer::State::has_law(const path::Command& command) const {
    return command.motion().dynamics && command.motion().dynamics->law.is_given();
}

/// Pieces of the motion follow, from this length of its path on.
void Preparer::State::begin_law(double from, double length) { lawful = {from, length}; }

/// The feed over the next piece, overrides included; nothing where F does not count for the axes
/// that move.
std::optional<path::FeedPolynomial> Preparer::State::law_on(const path::Command& command,
                                                            const Segment& segment,
                                                            double length) const {
    path::Motion unit = command.motion();
    unit.feed = 1;
    double scale = lawful.length / 60;  // of the inverse of a time
    if (unit.feed_mode != path::FeedMode::InverseTime) {
        const auto speed = path_feed(unit, segment, length, spindle, &axes);
        if (!speed || std::isinf(*speed)) return std::nullopt;
        scale = *speed;
    }
    scale *= feed_override(command);
    // From the part of the whole path to mm of this piece.
    const double begin = std::min(lawful.done / lawful.length, 1.0);
    const path::FeedPolynomial feed = path::feed_from(command.motion().dynamics->law.feed, begin);
    return path::feed_in_units(feed, scale, 1 / lawful.length);
}

void Preparer::State::emit_by_law(const path::Command& command, const Segment& segment,
                                  double length, const Emission& how) {
    path::Command share = command;
    share.motion().dynamics->law = {};
    follow_dynamics(share);
    if (!require_override(share)) return;
    Emission own = how;
    own.is_by_law = true;
    const auto feed = law_on(command, segment, length);
    lawful.done += length;
    const bool has_feed = feed && feed_override(share) > 0;
    if (!has_feed) return emit(share, segment, length, own);
    share.motion().feed_mode = path::FeedMode::PerMinute;
    emit_law_part(share, segment, *feed, {0, length}, own);
}

/// A part of a piece, or both its halves; `share` is the command with this feed.
void Preparer::State::emit_law_part(path::Command& share, const Segment& segment,
                                    const path::FeedPolynomial& feed, const PathPart& part,
                                    const Emission& how) {
    if (has_ended) return;
    const double length = part.to - part.from;
    const path::FeedRange range = path::feed_range(feed, part.from, part.to);
    const bool is_short = length < 2 * kShortestTicks * tick * range.most;
    // A curve around a corner stays one; and so does a tool whose orientation alone changes.
    const bool is_pivot =
        segment.is_transformed() && std::holds_alternative<path::Point>(segment.curve);
    const bool is_glide = std::holds_alternative<path::Glide>(segment.curve);
    const bool can_be_cut = !is_short && !is_pivot && !is_glide;
    const bool is_whole = part.from == 0 && part.to >= path::length(segment.curve);
    const Segment piece = is_whole ? segment : part_of(segment, part.from, part.to);
    Emission own = how;
    own.is_inside = how.is_inside || (part.from > 0 && segment.is_transformed());
    const auto emit_at = [&](double wanted) {
        // In the unit of F, and without the overrides, which act on it again.
        share.motion().feed = 1;
        const auto unit = path_feed(share.motion(), piece, length, spindle, &axes);
        share.motion().feed = wanted / (*unit * feed_override(share));
        emit(share, piece, length, own);
    };
    const double own_limit =
        machine.max_feed > 0 && !segment.is_rotary_only ? machine.max_feed : kInfinity;
    const PathLimits limits = axes.limits(piece, axes.start_rates(piece), range.most);
    const double most = std::min(limits.speed, own_limit);
    const bool is_even = range.most <= kEven * range.least;
    if (is_even || most <= range.least) return emit_at(range.least);
    if (!is_glide && range.most <= kCourse * range.least && most >= range.most / kEven) {
        if (const auto varying_feed =
                varying_feed_on(limits, path::feed_from(feed, part.from), length)) {
            own.varying_feed = &*varying_feed;
            return emit_at(range.most);
        }
    }
    if (!can_be_cut || range.most <= kStep * range.least) return emit_at(range.least);
    const double middle = (part.from + part.to) / 2;
    emit_law_part(share, segment, feed, {part.from, middle}, how);
    emit_law_part(share, segment, feed, {middle, part.to}, how);
}

/// The varying feed of a piece, if its axes have enough beside it.
std::optional<VaryingFeed> Preparer::State::varying_feed_on(const PathLimits& limits,
                                                            const path::FeedPolynomial& feed,
                                                            double length) const {
    if (has_pulses()) return std::nullopt;
    const VaryingFeed varying_feed = varying_feed_of(feed, length);
    if (varying_feed.acceleration > kOfAcceleration * limits.acceleration) return std::nullopt;
    if (varying_feed.jerk > kOfJerk * limits.jerk) return std::nullopt;
    return varying_feed;
}

/// The corner before a piece, or behind one, whose feed changes: its speed is the feed's, and the
/// acceleration changes by what both feeds differ in. At the speed v a feed f takes f'/f·v².
void Preparer::State::take_varying_feed(Piece& piece, const AxisRates& in) const {
    const VaryingFeed& varying_feed = piece.varying_feed;
    if (varying_feed.is_on()) piece.segment.feed = piece.length / varying_feed.time;
    const double entry = varying_feed.is_on() ? varying_feed.entry() : kInfinity;
    piece.entry_limit = std::min({piece.entry_limit, entry, last.exit_feed});
    if (!axes.limits_jerk() || piece.entry_limit == 0) return;
    const double slope = varying_feed.is_on() ? varying_feed.slope(0) / varying_feed.entry() : 0;
    const double speed = std::min({piece.entry_limit, piece.speed, last.speed});
    double taken = 0;  // in parts of what the jerk of an axis changes in a tick
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const double change = std::abs(in[i] * slope - last.rates[i] * last.feed_slope);
        taken = std::max(taken, change * speed * speed / (jerk_at_corner(i) * tick));
    }
    if (taken < kNoJump) return;
    if (taken > kMostJump) piece.entry_limit = speed * std::sqrt(kMostJump / taken);
    const double share = 1 - std::min(taken, kMostJump);
    piece.jerk_share *= share;
    piece.jerk_before *= share;
    piece.jerk *= share;
}

}  // namespace kadr::motion
