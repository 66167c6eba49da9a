// piece.h — what is known of a piece of path before it has its speeds.
#pragma once

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "motion/axis_table.h"
#include "motion/bent_cell.h"
#include "motion/segment.h"
#include "motion/stretch.h"

namespace kadr::motion {

/// A segment before it has its speeds: `segment.profile`, `start_time` and, for motion, `duration`
/// are still open.
struct Piece {
    Segment segment;
    double length = 0;        // of the path, mm (deg); 0 for a standstill
    double speed = 0;         // limit inside the piece
    double acceleration = 0;  // along the path
    double jerk = std::numeric_limits<double>::infinity();  // along the path
    double entry_limit = 0;        // of the corner before it; 0: the path comes to rest there
    bool rests_at_corner = false;  // … as that is quicker than to pass it
    double entry_acceleration = std::numeric_limits<double>::infinity();  // as of a Stretch
    /// Jerk of ramps that end at the corner before it without acceleration: within a tick of it
    /// they have no more acceleration than it leaves. 0: it was reckoned with all that they have.
    double smooth_corner_jerk = 0;
    /// Part of the acceleration of this piece, and of the one before it, that the corner between
    /// them leaves …
    double ramp = 1;
    double ramp_before = 1;
    /// … to all pieces within a tick of it, if other corners are so near
    double crowd_ramp = 1;
    /// … on so much of their paths beside the corner, mm (deg); 0: on all of them.
    double corner_zone = 0;
    double corner_zone_before = 0;
    double jerk_share = 1;  // the same of the jerk, where the curvature jumps
    double jerk_before = 1;
    double turning_acceleration = std::numeric_limits<double>::infinity();  // see PathLimits
    double feed_asked = std::numeric_limits<double>::infinity();  // as of an OverriddenSpeed
    double rapid_asked = std::numeric_limits<double>::infinity();
    bool can_be_held = false;
    std::size_t issues = 0;        // so many M functions are issued where it begins
    bool awaits = false;           // stands until all that was issued is acknowledged
    bool awaits_mark = false;      // stands until the spindle is at `mark`
    double mark = 0;               // of a revolution
    double programmed = 0;         // feed at 100 %, of the tool; rapid: what the axes can
    bool is_cell = false;          // planned as `cell` instead
    bool is_geared = false;        // to the spindle: its acceleration begins and ends at once
    bool follows_spindle = false;  // as of a Stretch
    bool has_dynamics = false;     // the program chooses how much of their limits the axes have
    BentCell cell;
    VaryingFeed varying_feed;  // is_on: the feed changes along it
    /// As a Stretch counts it: mm (deg), or s of its varying feed.
    double extent() const { return varying_feed.is_on() ? varying_feed.time : length; }
    AxisRates rates{};  // dq/ds at its start
    AxisTable::Loads loads;
};

/// A part of a piece between two lengths of its path; in itself it has no corner.
Piece part_of(const Piece& whole, double from, double to, const AxisTable& axes);
/// The same between two of its extents.
Piece part_between(const Piece& whole, double from, double to, const AxisTable& axes);

/// Pieces between preparation and delivery: a ring that grows to the length of the look-ahead.
class PieceRing {
  public:
    /// Holds what it was used for before.
    Piece& push_back() {
        if (count_ == pieces_.size()) grow();
        return pieces_[(first_ + count_++) & (pieces_.size() - 1)];
    }
    /// The i-th from the end.
    Piece& back(std::size_t i) { return pieces_[(first_ + count_ - 1 - i) & (pieces_.size() - 1)]; }
    const Piece& back(std::size_t i) const {
        return pieces_[(first_ + count_ - 1 - i) & (pieces_.size() - 1)];
    }
    /// Behind the i-th from the end, whose index and those behind it move up: the fresh one is
    /// then the i-th from the end.
    Piece& insert_behind(std::size_t i) {
        push_back();
        for (std::size_t k = 0; k < i; ++k) std::swap(back(k), back(k + 1));
        return back(i);
    }
    Piece& front() { return pieces_[first_]; }
    /// The i-th from the beginning.
    Piece& at(std::size_t i) { return pieces_[(first_ + i) & (pieces_.size() - 1)]; }
    /// In front of the i-th from the beginning, which is then the next. Those before it are moved.
    Piece& insert(std::size_t i) {
        if (count_ == pieces_.size()) grow();
        first_ = (first_ + pieces_.size() - 1) & (pieces_.size() - 1);
        ++count_;
        for (std::size_t k = 0; k < i; ++k) at(k) = at(k + 1);
        return at(i);
    }
    std::size_t size() const { return count_; }
    void pop_front() {
        first_ = (first_ + 1) & (pieces_.size() - 1);
        --count_;
    }

  private:
    void grow() {
        std::vector<Piece> larger(2 * pieces_.size());
        for (std::size_t i = 0; i < count_; ++i) {
            larger[i] = pieces_[(first_ + i) & (pieces_.size() - 1)];
        }
        pieces_ = std::move(larger);
        first_ = 0;
    }

    std::vector<Piece> pieces_ = std::vector<Piece>(64);  // a power of two
    std::size_t first_ = 0;
    std::size_t count_ = 0;
};

}  // namespace kadr::motion
