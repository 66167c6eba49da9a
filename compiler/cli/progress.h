// progress.h — one line on the terminal that shows how far a long run has come.
#pragma once

#include <chrono>

#include "driver/session.h"

namespace kadr::cli {

class ProgressLine {
  public:
    explicit ProgressLine(bool is_terminal) : is_terminal_(is_terminal) {}

    /// Shows the figures, ten times a second at most and only after the first second.
    void show(const driver::Progress& progress);
    /// Takes the line away, before something else is printed.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    bool is_terminal_;
    bool is_shown_ = false;
    Clock::time_point next_ = Clock::now() + std::chrono::seconds(1);
};

}  // namespace kadr::cli
