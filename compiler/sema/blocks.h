// blocks.h — NC blocks in the source: words become a plan with values to fill in.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

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
