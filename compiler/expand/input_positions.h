// input_positions.h — increments behind a change of the frame, and axes whose coordinates the
// target must have in the text. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// An increment behind a change of the frame: some controls travel the change as well.
Done adapt_increments(Running& run, nc::Block& block, const sema::Plan& plan, std::uint32_t at);
/// An arc all of whose words are in `plan` and that names no end.
bool is_whole_circle(const Running& run, const sema::Plan& plan);
/// What names no axis as the first motion behind a rotation, a full circle or a cycle, gets a block
/// before it that does: to where the tool stands already.
Done write_positions(Running& run, SourceId source, std::uint32_t at, unsigned depth);
/// What stands under incremental dimensions for the program does so for the text again.
void return_to_increments(Running& run, nc::Block& block);

}  // namespace kadr::expand
