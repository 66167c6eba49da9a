// block_checks.h — what is wrong with the words of a block that has a plan, and what else its
// control would do with it.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// Reports inches in a file of millimetres, and the other way round.
void check_units_function(Check& check, nc::Function function, const SourceRange& range);
/// Whether a literal is written with a point or an exponent.
bool has_point(const Check& check, const syntax::Word& word);
/// `M97 P1` in a source of a FANUC: beside a code of another kind P is no word of the modal cycle.
Done check_cycle_words(Check& check, const nc::BlockPlan& plan,
                       std::span<const syntax::Word> words);
/// Units among the words that are not those of the file.
void check_units_words(Check& check, const nc::BlockPlan& plan,
                       std::span<const syntax::Word> words);
/// Numbers without a point, where the control of the source counts them in increments.
Done check_points(Check& check, const nc::BlockPlan& plan, std::span<const syntax::Word> words);
/// Whole numbers that the planner has put into the block itself: `T1.5` is no tool.
void check_counts(Check& check, const nc::BlockPlan& plan, std::span<const syntax::Word> words);
/// What the control of the source does with the block where controls differ; bits of `custom`.
std::uint32_t customs_of(const Check& check, const Plan& plan, std::span<const syntax::Word> words);

}  // namespace kadr::sema
