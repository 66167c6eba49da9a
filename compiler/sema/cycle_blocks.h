// cycle_blocks.h — cycles as the control of the input dialect has them, `G83 …` and `CYCLE81(…)`.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// Loads the files of the library whose cycles are blocks of a file; they are no imports of it.
void load_cycles(Check& check, std::uint32_t module);
/// Emits a cycle with its arguments in the registers from `first`, and its execution.
void emit_cycle(Check& check, SourceCycle cycle, Reg first, const SourceRange& range);
/// Emits the execution of the cycle that is modal, if one is.
void emit_run_cycle(Check& check, const SourceRange& range);
/// Takes the cycle out of a block; its fillings become those of the cycle.
std::optional<SourceCycle> take_cycle(Check& check, Plan& plan, const nc::BlockPlan& planned,
                                      std::span<const syntax::Word> words);
/// `K5` in a block that calls a cycle or can be a position of one; null: no word repeats.
const syntax::Word* repeats_of(const Check& check, std::span<const syntax::Word> words);
/// The block, then its position in the plane again and again.
void repeat_places(Check& check, const syntax::Stmt& stmt, const syntax::Word& times);
/// `CYCLE81(50,2,,-10)`.
Value cycle_call(Check& check, const syntax::Expr& expr, SourceCycle::Kind kind);
/// Whether the words hold `MCALL`, as the control calls it.
bool is_modal_call(const Check& check, std::span<const syntax::Word> words);
/// `MCALL CYCLE81(…);` and `MCALL;`.
void modal_call(Check& check, const syntax::Stmt& stmt);

}  // namespace kadr::sema
