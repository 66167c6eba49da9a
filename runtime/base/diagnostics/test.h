// test.h — the rows of test.def, for those who report them: K7xxx: tests and properties.
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/test.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
