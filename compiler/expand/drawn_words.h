// drawn_words.h — angles, poles and polar coordinates in blocks become coordinates; chamfers and
// roundings are noted. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// Takes these words out of a block whose values are filled in; the modal state is that before its
/// motion.
Done take_drawn_words(Running& run, nc::Block& block, const sema::Plan& plan, std::uint32_t at);
/// No line at an angle waits for its end, which the block that follows does not give.
Done require_no_open_line(Running& run);

}  // namespace kadr::expand
