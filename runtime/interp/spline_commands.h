// spline_commands.h — what blocks program beside the points of a spline that is still open.
//
// Their spans are executed later, when further points have come. What a block switches acts from
// its own span on, and a command that it gives stands in front of that span.
#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

#include "path/command.h"

namespace kadr::interp {

class SplineCommands {
  public:
    /// The number of no block: everything stands before it.
    static constexpr std::uint32_t kBehindAll = std::numeric_limits<std::uint32_t>::max();

    /// The spline begins. `span`: a span as the modal state makes it, without its shape.
    void begin(path::Command span) {
        waiting_.clear();
        blocks_ = 0;
        span_ = std::move(span);
    }
    /// A command behind the spans of all blocks until now.
    path::Command& next() { return waiting_.emplace_back(Waiting{blocks_ + 1, false, {}}).command; }
    /// Spans are like this one from the next block on.
    void change(path::Command span) { waiting_.push_back({blocks_ + 1, true, std::move(span)}); }
    /// Another block with a point; returns its number, from 1.
    std::uint32_t count() { return ++blocks_; }

    /// The next command in front of the span of a block; nothing: all have been taken.
    std::optional<path::Command> take_before(std::uint32_t block) {
        while (!waiting_.empty() && waiting_.front().block <= block && waiting_.front().is_span) {
            span_ = std::move(waiting_.front().command);
            waiting_.pop_front();
        }
        if (waiting_.empty() || waiting_.front().block > block) return std::nullopt;
        path::Command command = std::move(waiting_.front().command);
        waiting_.pop_front();
        return command;
    }
    /// A span of the block of which everything before was taken.
    const path::Command& span() const { return span_; }

  private:
    struct Waiting {
        std::uint32_t block;  // in front of whose span
        bool is_span;         // … which is like this one from there on
        path::Command command;
    };
    std::uint32_t blocks_ = 0;
    path::Command span_;
    std::deque<Waiting> waiting_;
};

}  // namespace kadr::interp
