// blocks.h — NC blocks in the source: words become a plan with values to fill in.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

std::string word_text(const Check& check, const syntax::Word& word);
std::optional<nc::BlockPlan> plan_words(Check& check, std::span<const syntax::Word> words);
/// What to write for the cycle of another control, `G83` or `CYCLE81`; empty: it is none.
std::string hint_of_cycle(Check& check, std::string_view word);
void check_units_function(Check& check, nc::Function function, const SourceRange& range);
bool has_point(const Check& check, const syntax::Word& word);
/// A value for a parameter or a slot whose unit in the block is fixed: mm, degrees, s, rpm.
Filling fill_value(Check& check, const Value& value, nc::Dimension dimension,
                   const SourceRange& range, std::string_view what, Reg reg);
/// Across a part measures only X: any other word with a diameter means half of it or is a mistake.
Done require_no_diameter(Check& check, const Value& value, const SourceRange& range,
                         std::string_view what);
void emit_plan(Check& check, Plan plan, Reg first, unsigned point, const SourceRange& range);
void emit_words(Check& check, std::span<const syntax::Word> words, const BehindWords& behind,
                const SourceRange& range, std::int8_t skip_level = -1, std::uint32_t customs = 0);
void words_statement(Check& check, const syntax::Stmt& stmt);

}  // namespace kadr::sema
