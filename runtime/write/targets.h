// targets.h — the words of a block's axes and of its arc: which stand in the text, and with which
// numbers.
#pragma once

#include <array>

#include "write/messages.h"
#include "write/text_state.h"

namespace kadr::write {

struct Targets {
    SlotMask written = 0;                 // that get a word
    std::array<double, kSlots> number{};  // what stands there, in the text's units
    SlotMask wrapped_absolute = 0;        // AC()
    SlotMask wrapped_incremental = 0;     // IC()
    SlotMask by_letter = 0;               // that are written with the letter of distances
    double feed_factor = 1;               // of F
    bool needs_incremental = false;       // all words are distances from positions unknown
};

/// The words of the axes; the text's position goes there with them.
void place_targets(TextState& state, BlockMessages& messages, const Block& block, Targets& targets);

/// Words of axes that stay where they are need not be written, as long as one moves.
void drop_unchanged(const TextView& text, const Block& block, const WrittenPosition& start,
                    Targets& targets);

/// The axes of a straight block shall be as fast as the program means it, where program and control
/// count different ones: X, Y and Z, or all of them, of which a degree is a unit of length.
void place_axes_feed(const TextView& text, BlockMessages& messages, const Block& block,
                     const WrittenPosition& start, Targets& targets);

}  // namespace kadr::write
