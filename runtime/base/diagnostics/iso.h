// iso.h — the rows of iso.def, for those who report them: K5xxx: ISO-7bit text, read and executed.
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/iso.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
