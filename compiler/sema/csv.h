// csv.h — tables for families of parts: a CSV file as an array of structs.
//
// The first row names the columns, with units where they are not the file's: `d [mm],depth [in]`.
// Used when the program is checked and, for names that only the running program knows, then.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/diagnostic.h"
#include "base/file_access.h"
#include "sema/code.h"

namespace kadr::sema {

/// Reads a CSV file row by row. Every mistake is reported with file, row and column; nothing is
/// returned then. `path` is relative to the folder of the file that names it; `location` is where.
/// `access` tells what may be read; null: nothing.
std::optional<TableRows> read_table(const TableSchema& schema, std::span<const EnumNames> enums,
                                    const std::string& path, const SourceRange& location,
                                    FileAccess* access, DiagnosticSink& sink);

}  // namespace kadr::sema
