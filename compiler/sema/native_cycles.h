// native_cycles.h — cycles of the library that are the controls' own: called there, not written
// out.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// Whether a file belongs to the standard library.
bool is_library(const Check& check, std::uint32_t module);
/// The cycle of the controls that a function is the body of; nothing: it is none of theirs.
std::optional<nc::CycleId> native_cycle(const Check& check, const FunctionDecl& function);
/// From here on a control that has the cycle goes its own way; once in a body.
void emit_native_cycle(Check& check);
/// Whether a statement belongs to the contract of a cycle, which holds for a native one as well.
bool is_check(const Check& check, syntax::StmtId id);

}  // namespace kadr::sema
