// line_map.h — which statement made which line of the ISO-7bit text.
//
// Covers the lines that are in flight between the writer and the planner; older ones are forgotten,
// so that memory does not grow with the program.
#pragma once

#include <array>
#include <cstdint>

#include "base/source.h"

namespace kadr::driver {

class LineMap {
  public:
    /// Lines first to last (from 1) come from this statement.
    void add(std::uint32_t first, std::uint32_t last, SourceId source) {
        for (std::uint32_t line = first; line <= last; ++line) {
            entries_[line % kLines] = {line, source};
        }
    }

    /// The statement behind a line; invalid if there is none or it was forgotten.
    SourceId find(std::uint32_t line) const {
        const Entry& entry = entries_[line % kLines];
        return entry.line == line ? entry.source : SourceId{};
    }

  private:
    // More than the reader, the compensation and the look-ahead together hold back.
    static constexpr std::uint32_t kLines = 1u << 14;

    struct Entry {
        std::uint32_t line = 0;
        SourceId source;
    };
    std::array<Entry, kLines> entries_{};
};

}  // namespace kadr::driver
