// expand.h — the rows of expand.def: K3xxx, what happens while a program is evaluated.
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/expand.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
