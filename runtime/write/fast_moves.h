// fast_moves.h — the fast path of a straight move in absolute coordinates, perhaps with a feed,
// modal words repeated or not.
//
// Nearly all blocks of a program are such, and formatting their numbers is what expansion costs.
// Whatever is unusual about a block, or about one of its numbers, sends it the long path before
// anything is written.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "write/lines.h"
#include "write/words.h"

namespace kadr::write {

struct FastAxis {
    Slot slot = Slot::X;
    char letter = 'X';
    bool is_length = true;
    bool has_point = false;         // of whole numbers, too
    std::array<int, 2> decimals{};  // metric, inch
    std::uint64_t most = 0;         // greatest number in increments
};

/// What the fast path can write on a control.
struct FastPlan {
    std::vector<FastAxis> axes;  // in the order of their words
    SlotMask slots = 0;
    std::string rapid, line;  // codes

    /// Code of a straight motion; empty if it is no code by itself.
    const std::string& code(Function motion) const {
        return motion == Function::Rapid ? rapid : line;
    }
};
FastPlan fast_plan(const TextView& text);

class FastMoves {
  public:
    /// repeats  whether modal words are repeated
    FastMoves(TextState& state, Lines& lines, Words& words, bool repeats)
        : state_(state),
          text_(state.view()),
          modal_(state.modal()),
          tables_(text_.tables),
          lines_(lines),
          words_(words),
          repeats_(repeats),
          plan_(fast_plan(text_)) {}

    /// Whether the block was such a move, and stands in the text.
    bool write(const Block& block, std::string& out);

  private:
    bool is_fast(const Block& block) const;

    TextState& state_;
    const TextView& text_;
    const WriterModal& modal_;
    const DialectTables& tables_;
    Lines& lines_;
    Words& words_;
    const bool repeats_;
    const FastPlan plan_;
};

}  // namespace kadr::write
