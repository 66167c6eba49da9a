// csv.h — tables for families of parts: a CSV file as an array of structs.
//
// The first row names the columns, with units where they are not the file's: `d [mm],depth [in]`.
// Used when the program is checked and, for names that only the running program knows, then.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// What a number without a unit means in a column, where that is not the unit of the file.
struct BareUnit {
    std::string_view column;
    double factor = 1;  // to mm, s, degrees, revolutions
};

/// Rows of a table, and where each of their cells stands.
struct PlacedTable {
    struct Place {
        std::uint32_t offset = 0;  // in the text, bytes
        std::uint32_t length = 0;  // bytes; 0: the file has no such cell
    };
    TableRows rows;
    std::vector<Place> places;  // shape (rows, columns of the schema)
};

/// Reads a text of this file, likewise, for those who check the cells further.
std::optional<PlacedTable> read_placed_table(const TableSchema& schema,
                                             std::span<const BareUnit> bare,
                                             const std::string& file, std::string_view text,
                                             DiagnosticSink& sink);

}  // namespace kadr::sema
