// skipped.h — blocks that the operator may leave out: what cannot stand in one.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// Reports a function in a block that may be left out, if what stands behind the block depends on
/// it: a frame, a tool.
void check_passed_text(Check& check, const Plan& plan, std::span<const syntax::Word> words);

}  // namespace kadr::sema
