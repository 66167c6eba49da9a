// curves.h — curves: the blocks that are fitted to them. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

enum class CurveProgress : std::uint8_t { Failed, BatchFull, Done };

/// Executes FollowCurve: further blocks of the curve, as many as the batch has room for.
CurveProgress follow_curve(Running& run, const Instruction& instruction, std::uint32_t at);

}  // namespace kadr::expand
