// statements.h — statements: variables, branches, contracts, messages.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// A new SourceId for what stands at a range.
std::uint32_t statement_id(Check& check, const SourceRange& range);
/// The statements of a scope that ends with the range.
Completion block(Check& check, syntax::List statements, const SourceRange& range);
/// Checks a statement and emits it.
Completion statement(Check& check, syntax::StmtId id);
/// Sets back what `with` has set around, and checks `preserves`, before a return.
void leave_function(Check& check, const SourceRange& range);

}  // namespace kadr::sema
