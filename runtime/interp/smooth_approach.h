// smooth_approach.h — a smooth approach waits for its contour: commands in, and out again behind
// the path to the contour, once the contour's direction is known.
//
// Here is what the program has asked for and what of that is known by now; the moves that it
// becomes are made by the executor (approach_moves.cpp).
#pragma once

#include <optional>
#include <vector>

#include "base/diagnostic.h"
#include "interp/state.h"
#include "path/approach_path.h"
#include "path/command.h"
#include "path/contour.h"
#include "path/frame.h"

namespace kadr::interp {

/// What the words of a block program of a smooth approach or retraction. Lengths mm.
struct ApproachMove {
    path::ApproachShape shape = path::ApproachShape::Line;
    double radius = 0;                // DISR
    double clearance = 0;             // above the level of the contour
    std::optional<double> level;      // … or as a coordinate in the base system
    std::optional<double> slow_feed;  // of the slow infeed
    ApproachChoice choice;
    path::Command fast;  // as the block before moves: op, feed, source
    path::Command slow;  // as this block moves
};

class SmoothApproach {
  public:
    bool is_active() const { return is_active_; }
    /// Whether the next line gives where the contour begins.
    bool needs_point() const { return is_active_ && !has_point_; }

    /// `from` is where the tool is, `to` where the block takes it; both in the base system.
    ///
    /// has_place, has_level  whether the block gives the point in the plane, and along its normal
    void begin(const ApproachMove& move, path::Plane plane, const AxisValues& from,
               const AxisValues& to, bool has_point, bool has_level);

    /// Where the executor puts a command while an approach waits.
    path::Command& next() { return fresh_.emplace_back(); }
    /// Takes what a block has put. A row: what is wrong with it. When the contour has begun, the
    /// approach is not active any more, and `waiting()` begins behind it.
    const DiagnosticRow* end_block(int empty_blocks);

    const ApproachMove& move() const { return move_; }
    const AxisValues& from() const { return from_; }
    /// Where the contour begins, and its direction there.
    const AxisValues& position() const { return to_; }
    const path::Vec2& direction() const { return direction_; }
    /// Commands behind the approach. The caller clears them.
    std::vector<path::Command>& waiting() { return held_; }
    template <typename See>
    void look_at_waiting(See see) const {
        for (const auto* commands : {&held_, &fresh_})
            for (const path::Command& command : *commands) see(command);
    }

  private:
    const DiagnosticRow* take(path::Command& command);
    const DiagnosticRow* take_point(const path::Motion& motion);
    path::Vec2 in_plane(const AxisValues& values) const;

    bool is_active_ = false;
    bool has_point_ = false;
    bool has_level_ = false;
    ApproachMove move_;
    path::PlaneAxes axes_;
    AxisValues from_{};
    AxisValues to_{};
    path::Vec2 direction_ = path::Vec2::Zero();
    int empty_blocks_ = 0;
    std::vector<path::Command> fresh_;
    std::vector<path::Command> held_;
};

}  // namespace kadr::interp
