#include "motion/lookahead.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/assert.h"

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
    KADR_ASSERT(!is_full() && !is_finished_, "the look-ahead has no room");
    Node& fresh = node(count_++);
    fresh.gain = 2 * stretch.acceleration * stretch.length;
    fresh.speed = stretch.speed * stretch.speed;
    fresh.limit = std::min({stretch.entry_limit * stretch.entry_limit, last_speed_, fresh.speed});
    last_speed_ = fresh.speed;
}

void LookAhead::plan_backward() {
    double after = 0;  // the path ends at rest behind what is known
    for (std::size_t i = count_; i-- > 0;) {
        Node& current = node(i);
        const double entry = std::min(current.limit, after + current.gain);
        // Everything before depends on this speed alone: unchanged here, unchanged there.
        if (i < planned_ && entry == current.backward) break;
        current.backward = entry;
        after = entry;
    }
    planned_ = count_;
}

JunctionSpeeds LookAhead::take() {
    KADR_ASSERT(is_ready(), "the look-ahead does not know enough yet");
    if (takeable_ == 0) {
        plan_backward();
        takeable_ = is_finished_ ? count_ : chunk_;
    }
    const Node& oldest = node(0);
    const double exit_limit = count_ > 1 ? node(1).backward : 0.0;
    const double exit = std::min(exit_limit, reached_ + oldest.gain);
    const JunctionSpeeds speeds{std::sqrt(reached_), std::sqrt(exit)};
    reached_ = exit;
    first_ = (first_ + 1) & mask_;
    --count_;
    --planned_;
    --takeable_;
    return speeds;
}

}  // namespace kadr::motion
