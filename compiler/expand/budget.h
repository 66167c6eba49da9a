// budget.h — what a running program may use up: passes of loops, blocks, time. For the room expand
// only.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

#include "expand/expander.h"

namespace kadr::expand {

class Budget {
  public:
    /// Time counts from here on. `stop` outlives the budget; null: nobody stops the program.
    Budget(const RunLimits& limits, const std::atomic<bool>* stop);

    /// Passes that are left of the present slice; who runs instructions counts them down.
    std::uint64_t turns() const { return turns_; }
    void keep_turns(std::uint64_t turns) { turns_ = turns; }
    /// The pass that used up a slice of them asks for the next one, to which it belongs: how many
    /// passes it has. 0: there is none, or somebody wants the evaluation to end.
    std::uint64_t take_slice();
    /// A slice can make blocks for seconds: who wants it to end is heard in the next pass.
    void look_early();
    /// Looks whether somebody wants the evaluation to end, and at the clock. True: it is to end.
    bool look_for_end();
    /// What the last look has found.
    bool was_stopped() const { return was_stopped_; }
    bool is_late() const { return is_late_; }

    /// One block more; false: there were as many as may be.
    bool take_block() {
        if (blocks_ == 0) return false;
        --blocks_;
        return true;
    }

  private:
    using Clock = std::chrono::steady_clock;

    const std::atomic<bool>* stop_;
    double seconds_;               // 0: no limit
    std::uint64_t turns_ = 1;      // of the present slice
    std::uint64_t turns_to_come_;  // of the slices behind it
    std::uint64_t blocks_;
    Clock::time_point began_ = Clock::now();
    bool was_stopped_ = false;  // from outside
    bool is_late_ = false;
};

}  // namespace kadr::expand
