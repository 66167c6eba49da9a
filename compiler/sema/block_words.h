// block_words.h — the words of a block, and what the control of the file's input dialect means by
// them.
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

}  // namespace kadr::sema
