// blocks.h — blocks: plans filled with values; texts. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// The instruction that made the value of a word; its location is the word, not the whole block.
std::uint32_t word_of(const Running& run, const sema::Filling& filling, std::uint32_t at);
/// A block may be made: the limit is not reached, and it is no point of a curve.
Done require_room(Running& run, std::uint32_t at);
/// A block to fill: of the batch while there is room, else one that waits for the next batch.
nc::Block& next_block(Running& run, SourceId source);
/// Takes back the block that was made last: it could not be finished.
void drop_block(Running& run, const nc::Block& block);
/// Keeps how the block that was made last came to be.
void keep_trace(Running& run, std::uint32_t at, unsigned depth, SourceId source);
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
/// Puts F into the block, in the units of the feed mode that acts.
///
/// value        mm/s or mm/rev, as the form of the filling is
Done fill_feed(Running& run, nc::Block& block, const sema::Filling& filling, double value,
               std::uint32_t at);
/// `state.feed` and `state.speed` as registers have them; NaN: nobody knows.
double state_value(const Running& run, sema::StateValue which);
/// 3, 4, 5 as in M3, M4, M5; kNotGivenInteger: nobody knows.
std::int64_t spindle_code(const Running& run);
/// Executes EmitText: lines of raw text, or of a comment.
Done emit_text(Running& run, const Instruction& instruction, const Slot* registers,
               std::uint32_t at);

}  // namespace kadr::expand
