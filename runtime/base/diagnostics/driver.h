// driver.h — the rows of driver.def, for those who report them: K9xxx: the command line and files.
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/driver.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
