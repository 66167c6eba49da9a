// xml.h — the rows of xml.def: K91xx, what is wrong with an XML file as a file.
#pragma once

#include "base/diagnostic.h"

namespace kadr::diag {
#define KADR_DIAGNOSTIC(name, code, severity, message, explanation, wrong, right) \
    extern const DiagnosticRow name;
#include "base/diagnostics/xml.def"
#undef KADR_DIAGNOSTIC
}  // namespace kadr::diag
