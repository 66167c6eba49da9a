// control_memory.h — the rows of control_memory.def, for those who report them: K594x, what does
// not fit into the memory of a control.
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/control_memory.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
