// blocks.h — NC blocks in the source: words become a plan with values to fill in.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// A word as it stands in messages: `X10`, `X=`, `X+=`.
std::string word_text(const Check& check, const syntax::Word& word);
/// What the words of a block mean to the control of the file's input dialect; nothing, with
/// messages, if they mean no block.
std::optional<nc::BlockPlan> plan_words(Check& check, std::span<const syntax::Word> words);
/// What to write for the cycle of another control, `G83` or `CYCLE81`; empty: it is none.
std::string hint_of_cycle(Check& check, std::string_view word);
/// Reports inches in a file of millimetres, and the other way round.
void check_units_function(Check& check, nc::Function function, const SourceRange& range);
/// Whether a literal is written with a point or an exponent.
bool has_point(const Check& check, const syntax::Word& word);
/// A value for a parameter or a slot whose unit in the block is fixed: mm, degrees, s, rpm.
Filling fill_value(Check& check, const Value& value, nc::Dimension dimension,
                   const SourceRange& range, std::string_view what, Reg reg);
/// Across a part measures only X: any other word with a diameter means half of it or is a mistake.
Done require_no_diameter(Check& check, const Value& value, const SourceRange& range,
                         std::string_view what);
/// Emits a block: its plan, values in the registers from `first`, coordinates of the point behind
/// its words from `point` (0: none).
void emit_plan(Check& check, Plan plan, Reg first, unsigned point, const SourceRange& range);
/// Plans words, fills their values and emits the block or the cycle that they are. `customs` are
/// added to those that the plan has (see `custom` in code.h).
void emit_words(Check& check, std::span<const syntax::Word> words, const BehindWords& behind,
                const SourceRange& range, std::int8_t skip_level = -1, std::uint32_t customs = 0);
/// A statement of words: an NC block.
void words_statement(Check& check, const syntax::Stmt& stmt);

}  // namespace kadr::sema
