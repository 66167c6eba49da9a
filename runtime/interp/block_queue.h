// block_queue.h — blocks of one stream, pulled in batches. Internal to interp.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/stream.h"
#include "nc/block.h"

namespace kadr::interp {

/// Blocks of one stream, pulled in batches.
class BlockQueue {
  public:
    /// context  of all of them: their line and source become those of its caller; null: they are
    ///          as the stream has them
    BlockQueue(Stream<nc::Block>& blocks, std::size_t batch,
               const nc::BlockContext* context = nullptr)
        : stream_(&blocks), blocks_(batch), context_(context) {}
    /// The next block, nullptr at the end. Valid until the next call.
    const nc::Block* next() {
        if (next_ == count_) {
            count_ = stream_->pull(blocks_);
            next_ = 0;
            if (count_ == 0) return nullptr;
            if (context_ != nullptr) say_context();
        }
        return &blocks_[next_++];
    }

  private:
    void say_context() {
        for (nc::Block& block : std::span(blocks_).first(count_)) {
            block.context = context_;
            block.line = context_->caller->line;
            block.source = context_->caller->source;
        }
    }

    Stream<nc::Block>* stream_;
    std::vector<nc::Block> blocks_;
    const nc::BlockContext* context_;
    std::size_t next_ = 0;
    std::size_t count_ = 0;
};

}  // namespace kadr::interp
