// syntax.h — the rows of syntax.def, for those who report them: K1xxx: the shape of a Kadr program.
// K10xx characters, numbers, texts; K11xx brackets
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/syntax.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
