#include "expand/batch.h"

#include <algorithm>

#include "base/assert.h"

namespace kadr::expand {

void Batch::begin(std::span<nc::Block> out) {
    const std::size_t delivered = std::min(count_, origins_.size());
    origins_.erase(origins_.begin(), origins_.begin() + static_cast<std::ptrdiff_t>(delivered));
    out_ = out;
    count_ = 0;
    deliver_waiting();
}

void Batch::deliver_waiting() {
    if (!is_holding_) free_ = waiting_.size();
    for (; count_ < out_.size() && free_ > 0; --free_) {
        out_[count_++] = std::move(waiting_.front());
        waiting_.pop_front();
    }
}

void Batch::hold_last() {
    KADR_ASSERT(!is_holding_, "blocks are held already");
    if (waiting_.empty()) waiting_.push_back(std::move(out_[--count_]));
    is_holding_ = true;
    free_ = waiting_.size() - 1;
}

void Batch::insert_held(std::size_t i, nc::Block block) {
    if (has_origins()) {
        const std::size_t first = origins_.size() - held();
        const BlockOrigin origin = origins_[first];
        origins_.insert(origins_.begin() + static_cast<std::ptrdiff_t>(first + i), origin);
    }
    waiting_.insert(waiting_.begin() + static_cast<std::ptrdiff_t>(free_ + i), std::move(block));
}

void Batch::drop_held(std::size_t i) {
    if (has_origins()) origins_.erase(origins_.end() - static_cast<std::ptrdiff_t>(held() - i));
    waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(free_ + i));
}

void Batch::settle_first(std::size_t count) {
    free_ += count;
    is_holding_ = free_ < waiting_.size();
    deliver_waiting();
}

const BlockOrigin& Batch::origin(std::size_t i) const {
    KADR_ASSERT(i < origins_.size(), "a trace was asked for without ExpandOptions::trace");
    return origins_[i];
}

}  // namespace kadr::expand
