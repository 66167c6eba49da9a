// load.h — a dialect's XML file → DialectTables, inheritance worked in.
#pragma once

#include <memory>
#include <string>

#include "base/done.h"
#include "base/xml.h"
#include "nc/dialect_on_machine.h"
#include "nc/tables.h"

namespace kadr::nc {

/// What a dialect file may hold, and where; mirrors dialect.xsd.
const XmlShape& dialect_shape();

/// Reads the elements of one file, which has the shape of a dialect, into tables that may hold what
/// it extends already. Mistakes are reported; not done if there was one.
///
/// kind  of the machines whose defaults act
Done apply_dialect(const XmlElement& root, DialectTables& tables, MachineKind kind,
                   const Files& files, DiagnosticSink& sink);

/// Checks the whole and makes the indexes. Not done if there was a mistake.
Done finish_tables(DialectTables& tables, DiagnosticSink& sink);

}  // namespace kadr::nc
