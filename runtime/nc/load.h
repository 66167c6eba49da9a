// load.h — a dialect's XML file → DialectTables, inheritance worked in.
#pragma once

#include <memory>
#include <string>

#include "nc/tables.h"
#include "nc/xml.h"

namespace kadr::nc {

/// Whether the elements and attributes of a file are those that a dialect may have; others are
/// reported. `root` is a <dialect>.
bool check_shape(const XmlElement& root, DiagnosticSink& sink);

/// Reads the elements of one file into tables that may hold what it extends already. Mistakes are
/// reported; false if there was one.
bool apply_dialect(const XmlElement& root, DialectTables& tables, DiagnosticSink& sink);

/// Checks the whole and makes the indexes. False if there was a mistake.
bool finish_tables(DialectTables& tables, DiagnosticSink& sink);

}  // namespace kadr::nc
