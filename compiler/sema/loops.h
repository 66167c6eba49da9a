// loops.h — loops, and the ways out of them.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// `break`, `continue`; reported outside of a loop.
void jump_out(Check& check, bool is_break, const SourceRange& range);
/// The loops by their kinds.
Completion while_statement(Check& check, const syntax::Stmt& stmt);
Completion do_statement(Check& check, const syntax::Stmt& stmt);
Completion for_statement(Check& check, const syntax::Stmt& stmt);
Completion for_each(Check& check, const syntax::Stmt& stmt);

}  // namespace kadr::sema
