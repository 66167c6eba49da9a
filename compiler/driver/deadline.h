// deadline.h — when a command has to end before it is through: `--max-time`, or nobody wants its
// answer any more.
#pragma once

#include <atomic>
#include <chrono>

namespace kadr::driver {

class Deadline {
  public:
    /// Counts from now. `seconds` 0: as long as it takes. `cancelled` is set from outside, by any
    /// thread; null: by nobody.
    Deadline(double seconds, const std::atomic<bool>* cancelled)
        : seconds_(seconds), cancelled_(cancelled), start_(Clock::now()) {}

    double seconds() const { return seconds_; }
    bool is_cancelled() const {
        return cancelled_ != nullptr && cancelled_->load(std::memory_order_relaxed);
    }
    bool is_time_over() const {
        return seconds_ > 0 &&
               std::chrono::duration<double>(Clock::now() - start_).count() > seconds_;
    }
    bool is_over() const { return is_cancelled() || is_time_over(); }

  private:
    using Clock = std::chrono::steady_clock;

    double seconds_;
    const std::atomic<bool>* cancelled_;
    Clock::time_point start_;
};

}  // namespace kadr::driver
