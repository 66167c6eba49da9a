// stretch.h — pieces of path gathered into stretches that one smooth profile passes.
//
// A smooth ramp begins and ends without acceleration. Were that so at every junction of short
// blocks, they would crawl; so neighbours are gathered, as long as one set of limits suits them,
// and the acceleration vanishes between stretches only. A stretch has the least of its pieces'
// limits, inner corners included: whatever is gathered, no limit is passed. What is gathered only
// decides what it costs:
//
// * Across a corner only if it is so slight that it leaves at least half of the acceleration that a
//   ramp at this speed reaches.
// * Pieces of a straight line at one feed are always joined: cutting a line costs no time.
// * Others are joined while running at the least of their speeds costs less than a tenth of the
//   time that a ramp to this speed takes, and not if both are long enough to have their own ramps.
// * A feed that follows the spindle is never lowered to that of a neighbour.
// * A stretch from which a part can be split, so that both parts are longer than the ramps up to
//   its speed and down from it, is split: the speed between them is reached, and memory bounded.
//
// Limits of lengths and speeds only; no geometry, no axes and no junction speeds (lookahead.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "motion/operator_panel.h"

namespace kadr::motion {

/// A limit of the speed, and what of it changes with the overrides.
struct OverriddenSpeed {
    double speed = 0;  // at the highest overrides of the run
    /// What the program asks for at 100 %, if an override may change it while it runs; infinite if
    /// nothing is a feed, or nothing rapid.
    double feed_asked = std::numeric_limits<double>::infinity();
    double rapid_asked = std::numeric_limits<double>::infinity();
    bool can_be_held = false;

    /// Whether the same switches act on both.
    bool is_operated_as(const OverriddenSpeed& other) const {
        return can_be_held == other.can_be_held && is_overridden() == other.is_overridden();
    }
    bool is_overridden() const { return std::isfinite(std::min(feed_asked, rapid_asked)); }
    /// 0 where the motion stands.
    double speed_at(const Overrides& overrides) const {
        if (can_be_held && overrides.is_held) return 0;
        double most = speed;
        if (std::isfinite(feed_asked)) most = std::min(most, overrides.feed * feed_asked);
        if (std::isfinite(rapid_asked)) most = std::min(most, overrides.rapid * rapid_asked);
        return most;
    }
};

/// What the look-ahead knows of one piece, or of several that run under one set of limits.
struct Stretch {
    double length = 0;        // ≥ 0
    double speed = 0;         // limit inside, > 0
    double acceleration = 0;  // > 0, along the path, the same for braking
    double entry_limit = 0;   // of the junction before it; the speeds of both sides count anyway
    double jerk = std::numeric_limits<double>::infinity();  // > 0, along the path
    /// With so much acceleration along the path the junction before it may be passed: what the
    /// acceleration of an axis changes by there is what its jerk allows in a tick. 0: none at all.
    double entry_acceleration = std::numeric_limits<double>::infinity();
    std::size_t pieces = 1;
    OverriddenSpeed most() const { return {speed, feed_asked, rapid_asked, can_be_held}; }
    double feed_asked = std::numeric_limits<double>::infinity();  // as of an OverriddenSpeed
    double rapid_asked = std::numeric_limits<double>::infinity();
    bool can_be_held = false;
    /// Feeds at its ends where it changes along it: length and limits are of its rate then
    /// (varying_feed.h), s and 1/s.
    double entry_feed = 0;
    double exit_feed = 0;
    bool has_varying_feed() const { return entry_feed > 0; }
    /// Path speed for a speed of 1 in its own unit, at its ends.
    double entry_scale() const { return has_varying_feed() ? entry_feed : 1; }
    double exit_scale() const { return has_varying_feed() ? exit_feed : 1; }
    bool follows_spindle = false;  // its speed is the spindle's: another one would be another feed
};

class StretchBuilder {
  public:
    /// `most` ≥ 1: pieces in a stretch.
    explicit StretchBuilder(std::size_t most) : most_(most) {}

    /// The next piece, and the limit of the corner behind it.
    void add(const Stretch& piece, double exit_limit);
    /// No more pieces come.
    void finish();

    /// Stretches that are complete, in order, since the last call of `clear`.
    const std::vector<Stretch>& complete() const { return complete_; }
    void clear() { complete_.clear(); }

  private:
    struct Part {
        Stretch limits;
        double time = 0;  // s, of the piece by itself, without ramps
    };
    /// A stretch that still grows.
    struct Open {
        Stretch limits;
        double time = 0;  // s, of its pieces by themselves
    };
    bool joins(const Part& part) const;
    void join(const Part& part);
    void split(std::size_t count);
    void split_if_long();
    void close();

    std::size_t most_;
    std::vector<Part> parts_;  // of the open stretch
    Open open_;
    double ramps_ = 0;       // length of its ramps up and down
    std::size_t cut_ = 0;    // so many of its pieces can be split off, 0: not yet
    double cut_length_ = 0;  // of these pieces
    std::vector<Stretch> complete_;
};

}  // namespace kadr::motion
