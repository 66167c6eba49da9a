// page.h — the rows of page.def, for those who report them: K631x: the page that plays a machine.
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/page.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
