#include "expand/budget.h"

#include <algorithm>
#include <utility>

namespace kadr::expand {

Budget::Budget(const RunLimits& limits, const std::atomic<bool>* stop)
    : stop_(stop),
      seconds_(limits.seconds),
      turns_to_come_(std::max<std::uint64_t>(limits.loop_turns, 1)),
      blocks_(limits.blocks) {}

std::uint64_t Budget::take_slice() {
    constexpr std::uint64_t kSlice = 1u << 16;  // passes between two looks at `stop` and the clock
    if (look_for_end()) return 0;
    const std::uint64_t turns = std::min(turns_to_come_, kSlice);
    turns_to_come_ -= turns;
    return turns;
}

void Budget::look_early() {
    if (stop_ != nullptr && stop_->load(std::memory_order_relaxed))
        turns_to_come_ += std::exchange(turns_, 1) - 1;
}

bool Budget::look_for_end() {
    was_stopped_ = stop_ != nullptr && stop_->load(std::memory_order_relaxed);
    is_late_ =
        seconds_ > 0 && std::chrono::duration<double>(Clock::now() - began_).count() > seconds_;
    return was_stopped_ || is_late_;
}

}  // namespace kadr::expand
