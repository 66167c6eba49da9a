// lex.h — text → tokens, with nothing decided yet: every word is an Identifier.
#pragma once

#include <string>
#include <vector>

#include "syntax/lexeme.h"
#include "syntax/limits.h"
#include "syntax/parse.h"

namespace kadr::syntax {

/// The text with blanks for every byte that is no text, so that offsets stay. Bytes that are not
/// UTF-8, NUL and control characters are reported; nothing is returned if there are many of them.
std::optional<std::string> clean_text(FileId file, std::string_view text, DiagnosticSink& sink);

/// The tokens of the whole file without comments, which go to `comments`. Texts are resolved and
/// taken apart at their braces, `raw { … }` is one token. Ends with EndOfFile. Returns nothing if
/// the file is too much to go on.
std::optional<std::vector<Lexeme>> lex(const SourceFile& file, const KeywordTable& keywords,
                                       const LimitedSink& limit, std::vector<Comment>& comments);

}  // namespace kadr::syntax
