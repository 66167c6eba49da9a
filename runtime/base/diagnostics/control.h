// control.h — the rows of control.def, for those who report them: K54xx and K550x: the controls'
// own parametric languages.
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/control.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
