// block_fillings.h — values that a block gets when the program runs: in which unit, out of which
// register.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// A value for a parameter or a slot whose unit in the block is fixed: mm, degrees, s, rpm.
Filling fill_value(Check& check, const Value& value, nc::Dimension dimension,
                   const SourceRange& range, std::string_view what, Reg reg);
/// Across a part measures only X: any other word with a diameter means half of it or is a mistake.
Done require_no_diameter(Check& check, const Value& value, const SourceRange& range,
                         std::string_view what);
/// The value of a word for its hole in the plan, in the register `reg`.
Filling fill_word(Check& check, const syntax::Word& word, const nc::Hole& hole, Reg reg);

}  // namespace kadr::sema
