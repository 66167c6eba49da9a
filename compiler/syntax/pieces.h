// pieces.h — a source as the formatter sees it: its tokens as they are spelled, and its comments,
// in one list.
#pragma once

#include <string>
#include <vector>

#include "base/allow.h"
#include "syntax/lexeme.h"

namespace kadr::syntax {

/// A token, or a comment, that the formatter moves as a whole.
struct LayoutPiece {
    Token token = Token::EndOfFile;  // LineComment and BlockComment, too
    std::string text;                // as it is written; words and numbers without inner blanks
    bool starts_line = false;        // in the source
    bool follows_blank = false;      // an empty line stands in front of it

    bool is_comment() const { return token == Token::LineComment || token == Token::BlockComment; }
    /// Whether it silences warnings of a line, or means to: `// kadr: allow K2501`.
    bool is_allowance() const {
        return token == Token::LineComment && allowed_codes(text.substr(2)).is_one;
    }
};

/// The pieces of a file without mistakes. A text with `{…}` inside is one piece, as it stands: what
/// is written into a text is its author's matter. Ends with EndOfFile.
std::vector<LayoutPiece> pieces_of(const SourceFile& file, const std::vector<Lexeme>& lexemes,
                                   const std::vector<Comment>& comments);

}  // namespace kadr::syntax
