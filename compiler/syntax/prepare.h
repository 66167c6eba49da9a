// prepare.h — text → the tokens that the parser and the formatter read.
#pragma once

#include <optional>
#include <vector>

#include "syntax/ast.h"
#include "syntax/limits.h"
#include "syntax/retype.h"

namespace kadr::syntax {

/// Lexes, merges words and retypes. Mistakes are reported; nothing is returned if there is nothing
/// sensible to go on with.
std::optional<Prepared> prepare(const SourceFile& file, const KeywordTable& keywords,
                                const nc::Dialect& dialect, const LimitedSink& limit,
                                std::vector<Comment>& comments);

}  // namespace kadr::syntax
