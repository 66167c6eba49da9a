// call_map.h — which calls led to which line of the ISO-7bit text.
//
// Like the LineMap it covers the lines between the writer and who executes them; older ones are
// forgotten, so that memory does not grow with the program.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>

#include "expand/expander.h"

namespace kadr::driver {

class CallMap {
  public:
    /// Lines first to last (from 1) come from this block. Lines are added in their order.
    void add(std::uint32_t first, std::uint32_t last, const expand::BlockOrigin& trace) {
        entries_.push_back({first, last, trace});
        while (entries_.front().last + kLines < last) entries_.pop_front();
    }

    const expand::BlockOrigin* find(std::uint32_t line) const {
        const auto behind = std::upper_bound(
            entries_.begin(), entries_.end(), line,
            [](std::uint32_t wanted, const Entry& entry) { return wanted < entry.first; });
        if (behind == entries_.begin()) return nullptr;
        const Entry& entry = *(behind - 1);
        return line <= entry.last ? &entry.trace : nullptr;
    }

  private:
    // More than a piece of text has: who looks on executes the lines one by one.
    static constexpr std::uint32_t kLines = 1u << 14;

    struct Entry {
        std::uint32_t first = 0;
        std::uint32_t last = 0;
        expand::BlockOrigin trace;
    };
    std::deque<Entry> entries_;
};

}  // namespace kadr::driver
