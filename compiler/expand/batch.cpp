#include "expand/batch.h"

#include <algorithm>

#include "base/assert.h"

namespace kadr::expand {

void Batch::begin(std::span<nc::Block> out) {
    const std::size_t delivered = std::min(count_, origins_.size());
    origins_.erase(origins_.begin(), origins_.begin() + static_cast<std::ptrdiff_t>(delivered));
    out_ = out;
    count_ = 0;
    while (count_ < out_.size() && !waiting_.empty()) {
        out_[count_++] = std::move(waiting_.front());
        waiting_.pop_front();
    }
}

const BlockOrigin& Batch::origin(std::size_t i) const {
    KADR_ASSERT(i < origins_.size(), "a trace was asked for without ExpandOptions::trace");
    return origins_[i];
}

}  // namespace kadr::expand
