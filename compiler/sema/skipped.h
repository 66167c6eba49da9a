// skipped.h — text in a block that the control would pass over.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

void check_passed_text(Check& check, const Plan& plan, std::span<const syntax::Word> words);

}  // namespace kadr::sema
