// sema.h — the rows of sema.def, for those who report them: K2xxx: names, types and dimensions.
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/sema.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
