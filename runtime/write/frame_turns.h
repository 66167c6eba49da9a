// frame_turns.h — what the rounded angle of a frame costs: it grows with the distance of the tool
// from the frame's centre.
#pragma once

#include "write/messages.h"
#include "write/text_view.h"

namespace kadr::write {

/// Reports, once for each frame, where its rounded angle takes the tool beside its position by more
/// than the text's own rounding does. A rotation turns its plane, a tilted plane all of space.
void check_turn(const TextView& text, BlockMessages& messages, const Block& block);

}  // namespace kadr::write
