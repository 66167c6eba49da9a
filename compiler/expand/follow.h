// follow.h — the blocks along a contour. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// Executes FollowStart: where `follow` begins, leads included.
Done follow_start(Running& run, const Instruction& instruction, Slot* registers, std::uint32_t at);
/// Executes FollowContour: the blocks along a contour, from where the tool is.
Done follow_contour(Running& run, const Instruction& instruction, const Slot* registers,
                    std::uint32_t at);
/// A line or an arc as a block in the present plane, in coordinates.
Done emit_element(Running& run, const path::Element& element, const FollowedBlock& next,
                  std::uint32_t at);
/// What every block that follows has behind its coordinates: the feed, checks, the modal state.
Done finish_followed(Running& run, nc::Block& block, const FollowedBlock& next, std::uint32_t at);

}  // namespace kadr::expand
