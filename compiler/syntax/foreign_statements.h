// foreign_statements.h — statements as controls and other languages write them.
//
// Where such a statement can be no statement of Kadr, whatever the names in it mean, it is reported
// once, before the parser sees it: `FOR (int i = 0; …)` becomes the loop that is meant,
// `IF [#1 EQ 5] GOTO 10` and `ENDWHILE` are left out. All else is the parser's matter.
#pragma once

#include <vector>

#include "syntax/lexeme.h"
#include "syntax/parse.h"

namespace kadr::syntax {

/// The lexemes with such statements mended. `lexemes` come from merge_words and end with EndOfFile.
std::vector<Lexeme> mend_statements(const SourceFile& file, std::vector<Lexeme> lexemes,
                                    const KeywordTable& keywords);

}  // namespace kadr::syntax
