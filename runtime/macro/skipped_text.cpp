#include "macro/skipped_text.h"

#include <algorithm>

namespace kadr::macro {

namespace {

/// A text with more of them is made by a machine, and alike from part to part.
constexpr std::size_t kMostParts = 4096;

}  // namespace

void PassedText::add(const LinePosition& begin, std::uint64_t end) {
    if (begin.offset < end && parts_.size() < kMostParts) parts_.push_back({begin, end});
}

void PassedText::take_out(const LinePosition& begin, const LinePosition& next) {
    const auto is_behind = [](std::uint64_t offset, const Part& part) { return offset < part.end; };
    const auto found = std::upper_bound(parts_.begin(), parts_.end(), begin.offset, is_behind);
    if (found == parts_.end() || begin.offset < found->begin.offset) return;
    const Part before{found->begin, begin.offset};
    found->begin = next;
    if (found->begin.offset >= found->end) *found = before;
    else if (before.begin.offset < before.end) parts_.insert(found, before);
}

std::optional<PassedText::Part> PassedText::take_first() {
    while (first_ < parts_.size()) {
        const Part& part = parts_[first_++];
        if (part.begin.offset < part.end) return part;
    }
    return std::nullopt;
}

}  // namespace kadr::macro
