// parser_position.h — where a mistake of a source stands.
#pragma once

#include "syntax/complain.h"

namespace kadr::syntax {

/// Where the parser stands and what it could go on with.
struct Complaints::ParserPosition {
    std::size_t index;
    const Lexeme& offending;
    const Lexeme& previous;
    antlr4::misc::IntervalSet expected;
    std::size_t rule;  // innermost
    Token head;        // first token of the statement or declaration around
    std::size_t head_index;
    bool is_new_line;

    bool expects(Token token) const {
        return expected.contains(token == Token::EndOfFile ? antlr4::Token::EOF
                                                           : static_cast<std::size_t>(token));
    }
    /// Whether nothing but this token can go on.
    bool expects_only(Token token) const { return expects(token) && expected.size() == 1; }
};

}  // namespace kadr::syntax
