// preserves.h — `preserves`: what a cycle promises to leave as it was.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// The members of modal groups that the declaration promises to preserve, and so needs.
std::vector<nc::Function> preserved_members(Check& check, const syntax::Decl& decl);
/// Reports ways through a body on which a promise of `preserves` is broken.
void check_preserves(Check& check, const FunctionDecl& function, const syntax::Decl& decl);

}  // namespace kadr::sema
