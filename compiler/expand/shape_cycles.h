// shape_cycles.h — cycles of the control along a shape whose numbered blocks stand in the program.
// For the room expand only.
#pragma once

#include "expand/native_cycles.h"

namespace kadr::expand {

/// Executes NativeCycle of a cycle that takes its shape from the program (nc::CycleInfo): the call,
/// and behind it the blocks of the contour `shape`, numbered; a cycle that only finishes names the
/// blocks that a former one has written.
///
/// Moves: the control has no such cycle, or something acts under which it would do other work than
/// the library: an unknown state, a frame that does more than shift, compensation, inverse time, or
/// a text whose blocks are counted, where numbers of its own could be given twice.
CycleOutcome emit_shape_cycle(Running& run, nc::CycleId cycle, const Slot* registers);

}  // namespace kadr::expand
