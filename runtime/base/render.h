// render.h — a diagnostic as a person or a program reads it.
#pragma once

#include <string>

#include "base/diagnostic.h"

namespace kadr {

struct RenderOptions {
    bool color = false;
};

/// `file:line:column: error[K0123]: text`, the source line with a caret, notes and fixes; ends
/// with a line end. Long lines are shown around the caret.
std::string render_text(const Diagnostic& diagnostic, const Sources& sources,
                        const RenderOptions& options = {});

/// One JSON object without a line end: file, line, column, end_line, end_column, severity, code,
/// message, notes, fixes; for an alarm also `alarm` and `alarm_text`. A fix that replaces text has
/// its location and `replacement`, one in words `text` alone.
std::string render_json(const Diagnostic& diagnostic, const Sources& sources);

}  // namespace kadr
