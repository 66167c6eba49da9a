// batch.h — the blocks that a running program has made: those of the batch that is being filled,
// and those that wait for the next one. For the room expand only.
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <utility>

#include "expand/expander.h"
#include "nc/block.h"

namespace kadr::expand {

/// One instruction may make more blocks than the batch has room for: the others wait. While some
/// do, the batch is full.
class Batch {
  public:
    /// From here on blocks go into `out`, what waits first. Origins of the batch before are gone.
    void begin(std::span<nc::Block> out);
    /// A block to fill.
    nc::Block& add() {
        if (count_ < out_.size() && waiting_.empty()) return out_[count_++];
        return waiting_.emplace_back();
    }
    /// The block that was made last.
    nc::Block& last() { return waiting_.empty() ? out_[count_ - 1] : waiting_.back(); }
    void drop_last() {
        if (!waiting_.empty()) waiting_.pop_back();
        else --count_;
    }
    bool is_full() const { return count_ == out_.size(); }
    bool has_waiting() const { return !waiting_.empty(); }
    std::size_t count() const { return count_; }

    /// How the block that was made last came to be; one for each block, if they are kept at all.
    void add_origin(BlockOrigin origin) { origins_.push_back(std::move(origin)); }
    /// … as the one before it.
    void repeat_origin() { origins_.push_back(origins_.back()); }
    void drop_origin() { origins_.pop_back(); }
    /// Of block i of the batch.
    const BlockOrigin& origin(std::size_t i) const;

  private:
    std::span<nc::Block> out_;
    std::size_t count_ = 0;
    std::deque<nc::Block> waiting_;
    std::deque<BlockOrigin> origins_;  // of the batch and of what waits
};

}  // namespace kadr::expand
