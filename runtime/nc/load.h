// load.h — a dialect's XML file → DialectTables, inheritance worked in.
#pragma once

#include <memory>
#include <string>

#include "base/xml.h"
#include "nc/dialect_on_machine.h"
#include "nc/tables.h"

namespace kadr::nc {

/// What a dialect file may hold, and where; mirrors dialect.xsd.
const XmlShape& dialect_shape();

/// Reads the elements of one file, which has the shape of a dialect, into tables that may hold what
/// it extends already. Mistakes are reported; false if there was one.
///
/// kind  of the machines whose defaults act
bool apply_dialect(const XmlElement& root, DialectTables& tables, MachineKind kind,
                   DiagnosticSink& sink);

/// Checks the whole and makes the indexes. False if there was a mistake.
bool finish_tables(DialectTables& tables, DiagnosticSink& sink);

}  // namespace kadr::nc
