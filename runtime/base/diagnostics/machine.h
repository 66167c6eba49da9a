// machine.h — the rows of machine.def: machine files (K60xx) and motion (K61xx).
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/machine.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
