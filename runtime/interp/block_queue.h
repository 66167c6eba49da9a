// block_queue.h — blocks of one stream, pulled in batches. Internal to interp.
#pragma once

#include <cstddef>
#include <vector>

#include "base/stream.h"
#include "nc/block.h"

namespace kadr::interp {

/// Blocks of one stream, pulled in batches.
class BlockQueue {
  public:
    BlockQueue(Stream<nc::Block>& blocks, std::size_t batch) : stream_(&blocks), blocks_(batch) {}
    /// The next block, nullptr at the end. Valid until the next call.
    const nc::Block* next() {
        if (next_ == count_) {
            count_ = stream_->pull(blocks_);
            next_ = 0;
            if (count_ == 0) return nullptr;
        }
        return &blocks_[next_++];
    }

  private:
    Stream<nc::Block>* stream_;
    std::vector<nc::Block> blocks_;
    std::size_t next_ = 0;
    std::size_t count_ = 0;
};

}  // namespace kadr::interp
