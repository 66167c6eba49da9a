// tool_table.h — a tool library from a CSV file, read as tables of programs are (csv.h).
//
// Columns: number, name, kind, d, r, length, flutes, tip_angle, pitch, holder, and cutting data,
// material, vc, fz, f. A row with neither number nor name is further cutting data of the tool
// above it.
#pragma once

#include <optional>

#include "base/diagnostic.h"
#include "machine/tool_library.h"

namespace kadr::sema {

/// Every mistake is reported with row and column; nothing is returned then. A number without a
/// unit is in mm, degrees, mm/rev, and of `vc` in m/min.
std::optional<machine::ToolLibrary> read_tool_table(FileId file, const Sources& sources,
                                                    DiagnosticSink& sink);

}  // namespace kadr::sema
