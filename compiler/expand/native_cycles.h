// native_cycles.h — cycles of the library that the control has itself. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

enum class CycleOutcome : std::uint8_t {
    Moves,   // the control has no such cycle: its body is executed
    Block,   // a block stands for it
    Failed,  // reported
};

/// Reports a cycle under cutter radius compensation, where it is called.
void compensated_cycle(Running& run, const sema::FunctionCode& cycle);
/// Executes NativeCycle: the call as a block of the control's own cycle, if it has one that fits.
CycleOutcome emit_cycle(Running& run, nc::CycleId cycle, const Slot* registers);

}  // namespace kadr::expand
