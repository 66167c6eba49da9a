// deadline.h — `--max-time`: how long a command may compute.
#pragma once

#include <chrono>

namespace kadr::driver {

class Deadline {
  public:
    /// Counts from now. `seconds` 0: never over.
    explicit Deadline(double seconds) : seconds_(seconds), start_(Clock::now()) {}

    double seconds() const { return seconds_; }
    bool is_over() const {
        return seconds_ > 0 &&
               std::chrono::duration<double>(Clock::now() - start_).count() > seconds_;
    }

  private:
    using Clock = std::chrono::steady_clock;

    double seconds_;
    Clock::time_point start_;
};

}  // namespace kadr::driver
