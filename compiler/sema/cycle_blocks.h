// cycle_blocks.h — cycles as the control of the input dialect has them, `G83 …` and `CYCLE81(…)`.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

void load_cycles(Check& check, std::uint32_t module);
void emit_cycle(Check& check, SourceCycle cycle, Reg first, const SourceRange& range);
void emit_run_cycle(Check& check, const SourceRange& range);
/// Takes the cycle out of a block; its fillings become those of the cycle.
std::optional<SourceCycle> take_cycle(Check& check, Plan& plan, const nc::BlockPlan& planned,
                                      std::span<const syntax::Word> words);
const syntax::Word* repeats_of(const Check& check, std::span<const syntax::Word> words);
void repeat_places(Check& check, const syntax::Stmt& stmt, const syntax::Word& times);
Value cycle_call(Check& check, const syntax::Expr& expr, SourceCycle::Kind kind);
bool is_modal_call(const Check& check, std::span<const syntax::Word> words);
void modal_call(Check& check, const syntax::Stmt& stmt);

}  // namespace kadr::sema
