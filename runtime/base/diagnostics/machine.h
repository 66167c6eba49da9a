// machine.h — the rows of machine.def, for those who report them: K6xxx: machine files (K60xx) and
// motion (K61xx).
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/machine.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
