// retype.h — what each token is by its position: keyword or name, type or value, block or value.
#pragma once

#include <optional>
#include <vector>

#include "syntax/lexeme.h"
#include "syntax/parse.h"

namespace kadr::syntax {

struct Prepared {
    std::vector<Lexeme> lexemes;     // well nested, ends with EndOfFile
    bool has_broken_blocks = false;  // a `}` was missing or too many
};

/// Retypes the tokens for the parser and mends brackets that do not match. Nothing is returned if
/// the nesting is too deep.
std::optional<Prepared> retype(const SourceFile& file, std::vector<Lexeme> lexemes,
                               const KeywordTable& keywords);

}  // namespace kadr::syntax
