// steps.h — the lines of a control's program that are executed, one by one, for a trace.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "driver/execution.h"
#include "driver/trace.h"

namespace kadr::driver {

/// What the execution knows of a control between two lines.
TraceState state_of(Execution& execution);

class Steps {
  public:
    /// Is shown every block, and the state behind it; block 0 is what the program found.
    using Look = std::function<void(const TraceStep&, const TraceState&)>;

    /// `look` may be empty.
    void show_to(Look look) { look_ = std::move(look); }
    void follow(Execution& execution) { execution_ = &execution; }
    /// Gets the variables that are set.
    std::vector<macro::VariableChange>* changes() { return &changes_; }

    /// The line before is executed, this one is next.
    const TraceStep& begin(const macro::WatchedLine& line);
    /// The line is executed; one on which nothing was, a comment or a label, is none for a trace.
    void end();
    /// The line is not going to be executed.
    void drop() { step_.reset(); }

  private:
    void show_beginning();
    void find_statement(TraceStep& step) const;

    Look look_;
    Execution* execution_ = nullptr;
    std::optional<TraceStep> step_;  // that is executed
    std::vector<macro::VariableChange> changes_;
    std::uint64_t traced_ = 0;
    std::uint64_t blocks_before_ = 0;
    std::uint64_t statements_before_ = 0;
    bool has_begun_ = false;
};

}  // namespace kadr::driver
