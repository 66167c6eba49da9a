// blocks.h — blocks: plans filled with values; texts. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// A block may be made: the limit is not reached, and it is no point of a curve.
Done require_room(Running& run, std::uint32_t at);
/// A block to fill: of the batch while there is room, else one that waits for the next batch.
nc::Block& next_block(Running& run, SourceId source);
/// Takes back the block that was made last: it could not be finished.
void drop_block(Running& run, const nc::Block& block);
/// Keeps how the block that was made last came to be.
void keep_trace(Running& run, std::uint32_t at, unsigned depth, SourceId source);
/// … as if it had been made where the innermost function was called.
void keep_trace_of_caller(Running& run, std::uint32_t at, unsigned depth, SourceId source);
/// Executes Emit: the block of a plan, with its values in the registers, and all that the control
/// of the source would have done beside it.
///
/// at           the instruction
Done emit(Running& run, const Instruction& instruction, const Slot* registers, std::uint32_t at);
/// One block of the output, if the plan leaves one for this control; before it what is due.
Done emit_block(Running& run, const sema::Plan& plan, const Instruction& instruction,
                const Slot* registers, std::uint32_t at);
/// A block of the plan and what it does to the modal state; one that the operator may leave out
/// leaves known what is so either way.
Done fill_plan(Running& run, const sema::Plan& plan, const Instruction& instruction,
               const Slot* registers, std::uint32_t at);
/// Executes EmitText: lines of raw text, or of a comment.
Done emit_text(Running& run, const Instruction& instruction, const Slot* registers,
               std::uint32_t at);

}  // namespace kadr::expand
