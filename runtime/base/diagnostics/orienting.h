// orienting.h — the rows of orienting.def, for those who report them: tools that are inclined under
// the machine's transformation (K584x), and motions from point to point (K5693 and on).
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/orienting.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
