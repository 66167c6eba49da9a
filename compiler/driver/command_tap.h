// command_tap.h — looks at commands on their way to the planner.
//
// The planner reads in batches; when it stops at an alarm, commands behind the alarm have been read
// already. So a batch is looked at only when the next one is asked for, and the last one at the
// end.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "base/stream.h"
#include "path/command.h"

namespace kadr::driver {

class CommandTap final : public Stream<path::Command> {
  public:
    using Look = std::function<void(const path::Command&)>;

    /// `commands` outlives the tap. `batch`: no more are read ahead; 0: as many as are asked for.
    CommandTap(Stream<path::Command>& commands, Look look, std::size_t batch = 0)
        : commands_(commands), look_(std::move(look)), most_(batch) {}

    std::size_t pull(std::span<path::Command> out) override {
        pass_until(passed_ + waiting_);
        waiting_ = commands_.pull(most_ == 0 ? out : out.first(std::min(most_, out.size())));
        if (batch_.size() < waiting_) batch_.resize(waiting_);
        std::copy_n(out.begin(), waiting_, batch_.begin());
        return waiting_;
    }

    /// Looks at the rest, up to the `end`-th command of the run.
    void pass_until(std::uint64_t end) {
        const std::uint64_t rest =
            end > passed_ ? std::min<std::uint64_t>(end - passed_, waiting_) : 0;
        for (std::uint64_t i = 0; i < rest; ++i) look_(batch_[i]);
        passed_ += rest;
        waiting_ = 0;
    }

  private:
    Stream<path::Command>& commands_;
    Look look_;
    std::size_t most_;
    std::vector<path::Command> batch_;
    std::size_t waiting_ = 0;
    std::uint64_t passed_ = 0;
};

}  // namespace kadr::driver
