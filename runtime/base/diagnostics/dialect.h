// dialect.h — the rows of dialect.def: dialect files, words of blocks in a source, writing.
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/dialect.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
