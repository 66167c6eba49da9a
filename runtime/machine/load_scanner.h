// load_scanner.h — the element <scanner> of a machine file, with the table of its field.
#pragma once

#include <optional>

#include "base/diagnostic.h"
#include "base/source.h"
#include "base/xml.h"
#include "machine/scanner_data.h"

namespace kadr::machine {

/// Every mistake is reported with its location, those of the table in the table's file, which lies
/// beside the machine file or below its folder. Values that are wrong are replaced: the caller
/// counts what was reported.
Scanner read_scanner(const XmlElement& element, Sources& sources, DiagnosticSink& sink);

/// The table of a field: the header `x [mm],y [mm],dx [mm],dy [mm]`, then a row for every crossing
/// of the grid, in any order. Lines that begin with `#` and empty ones are passed over.
///
/// returns  nothing if anything was reported
std::optional<FieldGrid> read_field_grid(FileId file, const Sources& sources, DiagnosticSink& sink);

}  // namespace kadr::machine
