// picture.h — grey pictures for the dots of a laser: PGM files as rows of brightness.
//
// Used when the program is checked and, for names that only the running program knows, then.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostic.h"
#include "base/file_access.h"
#include "sema/code.h"

namespace kadr::sema {

/// Reads a PGM file, P2 (text) or P5 (bytes; two, the higher one first, where white is more than
/// 255), with comments in its head. Every mistake is reported, with line and column in text and
/// with row, column and byte among bytes; nothing is returned then. `path` is relative to `folder`;
/// `location` is where it is named; `access` tells what may be read, null: nothing. Source: Netpbm,
/// "PGM Format Specification".
std::optional<Picture> read_picture(const std::string& folder, const std::string& path,
                                    const SourceRange& location, FileAccess* access,
                                    DiagnosticSink& sink);

}  // namespace kadr::sema
