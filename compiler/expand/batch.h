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
/// do, the batch is full. Blocks that another one behind them may still change are held; they wait
/// at the end.
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

    /// From the block that was made last on, blocks are held.
    void hold_last();
    bool is_holding() const { return is_holding_; }
    std::size_t held() const { return is_holding_ ? waiting_.size() - free_ : 0; }
    /// One of them; 0 is the first.
    nc::Block& held(std::size_t i) { return waiting_[free_ + i]; }
    const nc::Block& held(std::size_t i) const { return waiting_[free_ + i]; }
    /// A block between them, whose origin is that of the first.
    void insert_held(std::size_t i, nc::Block block);
    void drop_held(std::size_t i);
    /// The first of them are as they are to be.
    void settle_first(std::size_t count);
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
    void deliver_waiting();
    bool has_origins() const { return origins_.size() == count_ + waiting_.size(); }

    std::span<nc::Block> out_;
    std::size_t count_ = 0;
    std::deque<nc::Block> waiting_;
    bool is_holding_ = false;
    std::size_t free_ = 0;             // while it holds: of those that wait, so many are not held
    std::deque<BlockOrigin> origins_;  // of the batch and of what waits
};

}  // namespace kadr::expand
