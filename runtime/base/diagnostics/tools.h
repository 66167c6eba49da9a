// tools.h — the rows of tools.def, for those who report them: tool libraries (K670x), and what
// programs ask them (K271x).
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/tools.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
