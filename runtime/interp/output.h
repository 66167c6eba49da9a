// output.h — commands as they go out.
//
// Into the caller's batch while it has room; a block that makes more commands than fit leaves the
// rest in a queue for the next pull.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "path/command.h"

namespace kadr::interp {

class CommandOutput {
  public:
    /// Starts a batch; what the last one had no room for comes first.
    void open(std::span<path::Command> out) {
        out_ = out;
        written_ = std::min(queue_.size(), out.size());
        const auto end = queue_.begin() + static_cast<std::ptrdiff_t>(written_);
        std::move(queue_.begin(), end, out.begin());
        queue_.erase(queue_.begin(), end);
    }
    bool has_room() const { return written_ < out_.size(); }
    std::size_t written() const { return written_; }

    /// A command of this batch that is in the caller's room.
    const path::Command& at(std::size_t i) const { return out_[i]; }

    /// Commands that wait for the next batch.
    const std::vector<path::Command>& waiting() const { return queue_; }

    /// A command of this batch or one that waits, in order.
    path::Command& any(std::size_t i) { return i < written_ ? out_[i] : queue_[i - written_]; }
    /// Takes back this command and all behind it.
    void drop_from(std::size_t i) {
        if (i < written_) {
            written_ = i;
            queue_.clear();
        } else {
            queue_.resize(i - written_);
        }
    }

    /// The slot of the next command. Valid until the next call.
    path::Command& next() {
        if (written_ < out_.size()) return out_[written_++];
        return queue_.emplace_back();
    }

  private:
    std::span<path::Command> out_;
    std::size_t written_ = 0;
    std::vector<path::Command> queue_;
};

}  // namespace kadr::interp
