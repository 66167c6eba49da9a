// lookahead.h — which speed every junction between pieces gets.
//
// Knows lengths, accelerations and speed limits; no geometry and no axes. The speeds are the
// greatest with which the path can be run and stopped at the end of what is known: a backward pass
// from rest, a forward pass from the speed reached (reference motion §2.5).
//
// Streaming: pieces are appended at one end and taken at the other. The backward pass runs once for
// a thirty-second of the window and stops at the first junction that it does not change, so a piece
// costs a bounded number of steps at any depth. For the jerk-limited profile, `reach` becomes the
// monotone envelope of §2.5; the passes stay.
#pragma once

#include <cstddef>
#include <vector>

namespace kadr::motion {

/// What the look-ahead knows of one piece.
struct Stretch {
    double length = 0;        // ≥ 0
    double speed = 0;         // limit inside the piece, > 0
    double acceleration = 0;  // > 0, along the path, the same for braking
    double entry_limit = 0;   // of the junction before it; the speeds of both pieces count anyway
};

struct JunctionSpeeds {
    double entry = 0;
    double exit = 0;
};

class LookAhead {
  public:
    /// `depth` ≥ 1: so many pieces are known at least, the current one included, when its exit
    /// speed is fixed. Up to `depth`/32 more are known.
    explicit LookAhead(std::size_t depth);

    bool is_empty() const { return count_ == 0; }
    /// No piece can be appended before one is taken.
    bool is_full() const { return count_ == capacity_; }

    void append(const Stretch& stretch);
    /// No more pieces come; the path ends at rest after the last one.
    void finish() { is_finished_ = true; }

    /// The oldest piece can be taken: enough is known.
    bool is_ready() const { return takeable_ > 0 || is_full() || (is_finished_ && count_ > 0); }
    /// Speeds of the oldest piece, which is then forgotten. Only if `is_ready`.
    JunctionSpeeds take();

  private:
    // All speeds are squared: the passes need no root.
    struct Node {
        double gain = 0;      // 2·acceleration·length
        double limit = 0;     // of the entry junction
        double backward = 0;  // entry speed from which the rest of the window can be braked
        double speed = 0;     // limit inside
    };
    Node& node(std::size_t i) { return nodes_[(first_ + i) & mask_]; }
    void plan_backward();

    std::vector<Node> nodes_;  // a ring
    std::size_t mask_;
    std::size_t capacity_;
    std::size_t chunk_;  // how many pieces one backward pass serves
    std::size_t first_ = 0;
    std::size_t count_ = 0;
    std::size_t planned_ = 0;   // nodes whose `backward` holds
    std::size_t takeable_ = 0;  // nodes that may go before the next backward pass
    double last_speed_ = 0;     // squared, of the last piece appended
    double reached_ = 0;        // squared, entry speed of the oldest piece
    bool is_finished_ = false;
};

}  // namespace kadr::motion
