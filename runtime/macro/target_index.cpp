#include "macro/target_index.h"

#include <algorithm>

namespace kadr::macro {

/// Where a look through the lines from a position on stops, which is at the end of its program.
std::uint64_t TargetIndex::end_of_scan(const LinePosition& from, const LinePosition& begin) const {
    bool is_behind_head = !(from == begin);
    auto bound = std::ranges::lower_bound(bounds_, from.offset, {},
                                          [](const Bound& each) { return each.line.offset; });
    for (; bound != bounds_.end(); ++bound) {
        // The mark at the head of a file looks like the one at its end.
        const bool is_end = bound->is_end && bound->line.line > begin.line;
        if (is_end || (!bound->is_end && is_behind_head)) return bound->line.offset;
        if (!bound->is_end) is_behind_head = true;
    }
    return ~std::uint64_t{0};
}

const TargetIndex::Hit* TargetIndex::find(const LineTarget& target, Direction direction,
                                          const ProgramLine& from,
                                          const LinePosition& begin) const {
    const auto known = hits_.find(target);
    if (known == hits_.end()) return nullptr;
    const std::vector<Hit>& hits = known->second;
    const auto first_from = [&](std::uint64_t offset) {
        return std::ranges::lower_bound(hits, offset, {},
                                        [](const Hit& hit) { return hit.line.offset; });
    };
    if (direction != Direction::Backward) {
        const auto hit = first_from(from.next.offset);
        if (hit != hits.end() && hit->line.offset < end_of_scan(from.next, begin)) return &*hit;
    }
    if (direction == Direction::Forward) return nullptr;
    const std::uint64_t limit = std::min(end_of_scan(begin, begin), from.line.offset + 1);
    auto hit = first_from(direction == Direction::Backward ? limit : begin.offset);
    if (direction == Direction::Backward) {
        if (hit == hits.begin()) return nullptr;
        --hit;
        return hit->line.offset < begin.offset ? nullptr : &*hit;
    }
    return hit != hits.end() && hit->line.offset < limit ? &*hit : nullptr;
}

}  // namespace kadr::macro
