// dialect.h — the rows of dialect.def, for those who report them: K4xxx: dialect files (K40xx),
// words of blocks in a source (K41xx), and blocks that
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/dialect.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
