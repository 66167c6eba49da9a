// idle_lines.h — lines in a row in which the cutter stays where it is beside a contour.
//
// Behind so many of them the control stops with an alarm, or cuts into inner corners, once the
// contour has begun. Optional blocks may be left out, so each level is counted with them and
// without.
//
// source       S 5.2 MD20250; F 4.3 No.19625
#pragma once

#include <array>

#include "write/messages.h"
#include "write/text_view.h"

namespace kadr::write {

class IdleLines {
  public:
    IdleLines(const Dialect& dialect, const TextView& text, BlockMessages& messages)
        : dialect_(dialect), text_(text), messages_(messages) {}

    /// Whether the lines of the next block count.
    bool counts() const {
        return text_.tables.rules.comp_empty_blocks >= 0 &&
               (now_.is_begun || text_.is_compensated());
    }
    /// written  lines of the block
    void count(const Block& block, std::uint32_t written);
    void forget() { now_ = {}; }

  private:
    static constexpr std::size_t kSkipLevels = 10;  // 0 to 9
    struct Now {
        bool is_begun = false;
        int moves = 0;   // in the plane, since the compensation began
        int level = -1;  // of skipping, if the compensation began in an optional block
        // In a row without a move: with all optional blocks, then without those of each level.
        std::array<int, 1 + kSkipLevels> lines{};
    };

    const Dialect& dialect_;
    const TextView& text_;
    BlockMessages& messages_;
    Now now_;
};

}  // namespace kadr::write
