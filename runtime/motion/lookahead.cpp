#include "motion/lookahead.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/assert.h"
#include "motion/smooth_profile.h"

namespace kadr::motion {

LookAhead::LookAhead(std::size_t depth) {
    depth = std::max<std::size_t>(depth, 1);
    // One pass costs at most the whole window, so a piece costs at most 33 steps.
    chunk_ = depth / 32 + 1;
    capacity_ = depth + chunk_ - 1;
    nodes_.resize(std::bit_ceil(capacity_));
    mask_ = nodes_.size() - 1;
}

void LookAhead::append(const Stretch& stretch) {
    KADR_ASSERT(!is_finished_, "the look-ahead has ended");
    if (count_ == nodes_.size()) grow();
    Node& fresh = node(count_++);
    fresh.length = stretch.length;
    fresh.acceleration = stretch.acceleration;
    fresh.jerk = stretch.jerk;
    fresh.pieces = stretch.pieces;
    fresh.gain = 2 * stretch.acceleration * stretch.length;
    fresh.speed = stretch.speed * stretch.speed;
    fresh.limit = std::min({stretch.entry_limit * stretch.entry_limit, last_speed_, fresh.speed});
    last_speed_ = fresh.speed;
    pieces_ += stretch.pieces;
}

void LookAhead::grow() {
    std::vector<Node> larger(2 * nodes_.size());
    for (std::size_t i = 0; i < count_; ++i) larger[i] = node(i);
    nodes_ = std::move(larger);
    mask_ = nodes_.size() - 1;
    first_ = 0;
}

double LookAhead::Node::reach(double other) const {
    if (std::isinf(jerk)) return other + gain;
    const double reached = steady_reach(std::sqrt(other), length, {acceleration, jerk});
    return reached * reached;
}

void LookAhead::plan_backward() {
    double after = 0;  // the path ends at rest behind what is known
    for (std::size_t i = count_; i-- > 0;) {
        Node& current = node(i);
        const double entry = std::min(current.limit, current.reach(after));
        // Everything before depends on this speed alone: unchanged here, unchanged there.
        if (i < planned_ && entry == current.backward) break;
        current.backward = entry;
        after = entry;
    }
    planned_ = count_;
}

/// How many stretches may go before the next backward pass: as long as a window of `depth` pieces
/// is known from the current one on.
std::size_t LookAhead::takeable() const {
    if (is_finished_) return count_;
    const std::size_t depth = capacity_ + 1 - chunk_;
    std::size_t known = pieces_;
    std::size_t taken = 0;
    while (taken < count_ && known >= depth) known -= node(taken++).pieces;
    return std::max<std::size_t>(taken, 1);
}

JunctionSpeeds LookAhead::take() {
    KADR_ASSERT(is_ready(), "the look-ahead does not know enough yet");
    if (takeable_ == 0) {
        plan_backward();
        takeable_ = takeable();
    }
    const Node& oldest = node(0);
    const double exit_limit = count_ > 1 ? node(1).backward : 0.0;
    const double exit = std::min(exit_limit, oldest.reach(reached_));
    const JunctionSpeeds speeds{std::sqrt(reached_), std::sqrt(exit)};
    reached_ = exit;
    first_ = (first_ + 1) & mask_;
    --count_;
    pieces_ -= oldest.pieces;
    --planned_;
    --takeable_;
    return speeds;
}

}  // namespace kadr::motion
