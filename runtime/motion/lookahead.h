// lookahead.h — which speed every junction between stretches of path gets.
//
// Knows lengths, accelerations and speed limits; no geometry and no axes. The speeds are the
// greatest with which the path can be run and stopped at the end of what is known: a backward pass
// from rest, a forward pass from the speed reached (reference motion §2.5). Under a limit of the
// jerk the acceleration vanishes at the junctions, and the speed that a stretch allows at its other
// end is the monotone one of smooth_profile.h: for this too a new stretch can only raise speeds.
// Where the path is bent and its axes are at their limits, it comes in cells (bent_cell.h).
//
// Streaming: stretches are appended at one end and taken at the other. The backward pass runs once
// for a thirty-second of the window and stops at the first junction that it does not change, so a
// piece costs a bounded number of steps at any depth.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "motion/bent_cell.h"
#include "motion/stretch.h"

namespace kadr::motion {

struct JunctionSpeeds {
    double entry = 0;
    double exit = 0;
};

class LookAhead {
  public:
    /// `depth` ≥ 1: so many pieces are known at least, those of the current stretch included, when
    /// its exit speed is fixed. Up to `depth`/32 more are known, and what a stretch holds.
    explicit LookAhead(std::size_t depth);

    bool is_empty() const { return count_ == 0; }
    /// Enough is known: nothing need be appended before a stretch is taken.
    bool is_full() const { return pieces_ >= capacity_; }

    /// Grows if the stretches that were complete at once do not fit.
    void append(const Stretch& stretch);
    /// A cell of bent path (bent_cell.h), by itself; of its Stretch, `entry_limit` counts.
    void append(const BentCell& cell, double entry_limit);
    /// No more stretches come; the path ends at rest after the last one.
    void finish() { is_finished_ = true; }

    /// The oldest stretch can be taken: enough is known.
    bool is_ready() const { return takeable_ > 0 || is_full() || (is_finished_ && count_ > 0); }
    /// Speeds of the oldest stretch, which is then forgotten. Only if `is_ready`.
    JunctionSpeeds take();

    /// Under other overrides the same path has other speeds. Stretches that are appended later are
    /// under them as well; cells do not know overrides.
    void set_overrides(const Overrides& overrides);
    /// The speed at which the oldest stretch is entered.
    double reached() const { return std::sqrt(reached_); }
    /// The speed that is allowed behind the oldest stretch. Only if `is_ready`.
    double exit_limit();
    /// What was taken last was left at another speed than planned.
    void depart(double speed) { reached_ = speed * speed; }
    /// What is left of the stretch that was taken last, to be entered at this speed.
    void put_back(const Stretch& stretch, double entry);
    /// Forgets the oldest stretch.
    void drop();

  private:
    // All speeds are squared: without a limit of the jerk the passes need no root.
    struct Node {
        double gain = 0;      // 2·acceleration·length
        double limit = 0;     // of the entry junction
        double backward = 0;  // entry speed from which the rest of the window can be braked
        double speed = 0;     // limit inside
        double length = 0;
        double acceleration = 0;
        double jerk = 0;
        std::size_t pieces = 0;
        bool is_cell = false;
        double corner = 0;  // limit of the entry junction whatever the overrides
        OverriddenSpeed most;
        bool has_varying_feed = false;
        double entry_feed = 0;  // squared as well
        double exit_feed = 0;

        /// The speeds allowed inside at its ends, under overrides.
        double entry_speed(const Overrides& overrides) const;
        double exit_speed(const Overrides& overrides) const;
        /// The speed allowed at one end by that at the other.
        double reach(double other) const;
        double entry_by(double after) const;
        double exit_by(double before) const;
    };
    Node& node(std::size_t i) { return nodes_[(first_ + i) & mask_]; }
    const Node& node(std::size_t i) const { return nodes_[(first_ + i) & mask_]; }
    double entry_of(std::size_t i, double after) const;
    double exit_of_oldest(double limit) const;
    Node node_of(const Stretch& stretch) const;
    void plan_backward();
    void plan_if_needed();
    std::size_t takeable() const;
    void grow();

    std::vector<Node> nodes_;      // a ring
    std::vector<BentCell> cells_;  // of the nodes that are cells; empty until the first one
    std::size_t mask_;
    std::size_t capacity_;
    std::size_t chunk_;  // how many pieces one backward pass serves
    std::size_t first_ = 0;
    std::size_t count_ = 0;
    std::size_t pieces_ = 0;    // of all nodes
    std::size_t planned_ = 0;   // nodes whose `backward` holds
    std::size_t takeable_ = 0;  // nodes that may go before the next backward pass
    Node last_;                 // appended last
    double last_speed_ = 0;     // squared, inside of it at its end
    double reached_ = 0;        // squared, entry speed of the oldest stretch
    Overrides overrides_;
    bool is_finished_ = false;
};

}  // namespace kadr::motion
