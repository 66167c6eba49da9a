// format.h — a Kadr program in its canonical layout.
#pragma once

#include <optional>
#include <string>

#include "syntax/parse.h"

namespace kadr::syntax {

/// The text of a file as `kadr fmt` lays it out: four blanks a level, 100 columns, one statement a
/// line, `a*b + c`, comments behind statements aligned. Kept from the author: comments, texts,
/// empty lines between statements (one at most), NC blocks that share a line, rows of values in
/// braces, and `{ … }` in one line. The result means the same (the trees are equal) and is laid out
/// already (a second run changes nothing).
///
/// A file with a syntax error is reported like by `parse`; nothing is returned then.
std::optional<std::string> format(const Sources& sources, FileId file, const KeywordTable& keywords,
                                  const nc::Dialect& dialect, DiagnosticSink& sink);

}  // namespace kadr::syntax
