// contours.h — what a contour answers, and what is made of it. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// Executes ContourValue: what a contour answers, or another one that is made of it.
Done contour_value(Running& run, const Instruction& instruction, Slot* registers, std::uint32_t at);

}  // namespace kadr::expand
