// statements.h — statements: variables, branches, contracts, messages.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

std::uint32_t statement_id(Check& check, const SourceRange& range);
Completion block(Check& check, syntax::List statements, const SourceRange& range);
Completion statement(Check& check, syntax::StmtId id);
void leave_function(Check& check, const SourceRange& range);

}  // namespace kadr::sema
