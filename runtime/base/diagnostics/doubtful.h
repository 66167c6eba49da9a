// doubtful.h — the rows of doubtful.def, for those who report them: what a control executes without
// a word, and nobody can have meant (K590x).
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/doubtful.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
