// callers.h — where the next block comes from. Internal to interp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "base/stream.h"
#include "interp/block_queue.h"
#include "nc/block.h"

namespace kadr::interp {

/// The program, and on top of it what it has called: positions of a pattern, the blocks of a cycle.
class Callers {
  public:
    enum class Kind : std::uint8_t { Program, Pattern, Cycle };

    /// batch  blocks that are read at once
    Callers(Stream<nc::Block>& program, std::size_t batch) {
        stack_.push_back({Kind::Program, nullptr, BlockQueue(program, batch), false});
    }

    /// Whose turn it is: the latest one that does not wait.
    Kind kind() const { return stack_[turn()].kind; }
    /// Its next block; null: it has no more. Valid until the next call.
    const nc::Block* next() { return stack_[turn()].blocks.next(); }
    /// Whether one of this kind has begun, and has not ended.
    bool runs(Kind kind) const {
        for (const Source& source : stack_)
            if (source.kind == kind) return true;
        return false;
    }

    /// From here on its blocks come.
    ///
    /// context  of all of them; null: they are as the stream has them
    void call(Kind kind, std::unique_ptr<Stream<nc::Block>> stream, std::size_t batch,
              const nc::BlockContext* context = nullptr) {
        Stream<nc::Block>& blocks = *stream;
        stack_.push_back({kind, std::move(stream), BlockQueue(blocks, batch, context), false});
    }
    /// The latest one of this kind is through.
    void leave(Kind kind) { stack_.erase(stack_.begin() + latest(kind)); }

    /// The latest pattern waits while the program runs that it calls at a position …
    void hold_pattern() { stack_[at(latest(Kind::Pattern))].waits = true; }
    /// … and goes on behind it.
    void release_pattern() { stack_[at(latest(Kind::Pattern))].waits = false; }
    bool is_pattern_held() const {
        return runs(Kind::Pattern) && stack_[at(latest(Kind::Pattern))].waits;
    }

  private:
    struct Source {
        Kind kind;
        std::unique_ptr<Stream<nc::Block>> stream;  // null: somebody else's
        BlockQueue blocks;
        bool waits;
    };

    static std::size_t at(std::ptrdiff_t index) { return static_cast<std::size_t>(index); }
    std::size_t turn() const {
        std::size_t i = stack_.size() - 1;
        while (stack_[i].waits) --i;
        return i;
    }
    std::ptrdiff_t latest(Kind kind) const {
        std::size_t i = stack_.size();
        while (i > 0 && stack_[i - 1].kind != kind) --i;
        KADR_ASSERT(i > 0, "nothing of this kind was called");
        return static_cast<std::ptrdiff_t>(i) - 1;
    }

    std::vector<Source> stack_;
};

}  // namespace kadr::interp
