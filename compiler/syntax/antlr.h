// antlr.h — the door to ANTLR; lex.cpp, complain.cpp, parse.cpp and tree*.cpp go through it.
#pragma once

// The generated files bring ANTLR with them: antlr/antlr4-runtime.h tells which parts.
#include "KadrLexer.h"
#include "KadrParser.h"
#include "syntax/lexeme.h"

namespace kadr::syntax {

using generated::KadrLexer;
using generated::KadrParser;

/// The token kind that ANTLR's number stands for.
inline Token token_of(std::size_t type) {
    return type == antlr4::Token::EOF ? Token::EndOfFile : static_cast<Token>(type);
}

}  // namespace kadr::syntax
