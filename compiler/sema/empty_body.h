// empty_body.h — a semicolon that ends a loop or a condition before its body.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// `while (…);`: warns of it.
void warn_of_empty_body(Check& check, const syntax::Stmt& stmt);

}  // namespace kadr::sema
