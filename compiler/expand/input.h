// input.h — blocks written in the manner of another control: the target shall do what that
// control would have done with them, or the program ends with a message. By subject: frames
// (input_frames.h), tools and lengths (input_tools.h), increments and coordinates that must be
// named (input_positions.h), work offsets and points of the machine (input_references.h). For the
// room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// Arguments are in the block; the modal state is that before it.
Done adapt(Running& run, nc::Block& block, const sema::Plan& plan, std::uint32_t at);
/// The words of a source mean this block in some planes only: one of them acts.
Done require_plane_of_source(Running& run, const sema::Plan& plan, std::uint32_t at);
/// The block may move, with the tool length and the feed that act.
Done check_move(Running& run, const nc::Block& block, std::uint32_t at);

}  // namespace kadr::expand
