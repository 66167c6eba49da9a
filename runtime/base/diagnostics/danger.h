// danger.h — the rows of danger.def, for those who report them: what is legal and spoils a spindle.
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/danger.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
