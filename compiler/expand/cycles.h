// cycles.h — cycles as the control of the input dialect has them. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// Whether a modal cycle is active, and the next block may be a position of it.
inline bool is_between_positions(const Running& run) {
    return run.cycle.is_active && !run.cycle.is_running && !run.recordings.is_open();
}
/// Reports what cannot stand while a cycle is modal.
Done refuse_beside_cycle(Running& run, std::string_view what, std::uint32_t at);
/// A block may stand where the next one may be a position of the modal cycle.
Done require_between_positions(Running& run, const sema::Plan& plan, const Instruction& instruction,
                               std::uint32_t at);
/// A block of a source that has cycles, with all its words: a position, or the end of the mode.
Done take_position(Running& run, nc::Block& block, const sema::Plan& plan, std::uint32_t at);
/// `Q2.` or `P100` beside a position: the stroke or the dwell from here on.
Done take_cycle_words(Running& run, const nc::Block& block, const nc::Invocation& invocation,
                      std::uint32_t at);
/// Executes SayCycle: a block of the source programs a cycle.
Done say_cycle(Running& run, const Instruction& instruction, const Slot* registers,
               std::uint32_t at);
/// Completes the arguments and calls the library's cycle.
Done call_cycle(Running& run, const Instruction& instruction, const Slot* registers,
                std::uint32_t at);
/// Executes LeaveCycle: behind the blocks of a cycle that the source called.
void leave_cycle(Running& run, const Instruction& instruction, std::uint32_t at);

}  // namespace kadr::expand
