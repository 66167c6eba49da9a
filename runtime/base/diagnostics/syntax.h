// syntax.h — the rows of syntax.def: K1xxx, the shape of a Kadr program.
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/syntax.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
