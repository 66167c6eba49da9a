// token_kinds.h — what kinds of tokens there are for those who report what is wrong with them.
#pragma once

#include "syntax/lexeme.h"

namespace kadr::syntax {

inline bool is_word(Token token) {
    return token == Token::LiteralWord || token == Token::BareWord || token == Token::Address;
}

inline bool opens(Token token) {
    return token == Token::OpenParen || token == Token::OpenBracket || token == Token::OpenBrace ||
           token == Token::OpenValue;
}

inline bool closes(Token token) {
    return token == Token::CloseParen || token == Token::CloseBracket || token == Token::CloseBrace;
}

/// Words that can only begin a declaration of a file.
inline bool begins_declaration(Token token) {
    switch (token) {
        case Token::Cycle:
        case Token::Program:
        case Token::Curve:
        case Token::Test:
        case Token::Property:
        case Token::Struct:
        case Token::Enum:
        case Token::Import:
        case Token::Include:
        case Token::Language:
        case Token::Dialect: return true;
        default: return false;
    }
}

/// Words that only begin a statement.
inline bool begins_statement(Token token) {
    switch (token) {
        case Token::If:
        case Token::While:
        case Token::Do:
        case Token::For:
        case Token::Switch:
        case Token::Break:
        case Token::Continue:
        case Token::Return:
        case Token::With:
        case Token::Const:
        case Token::Auto:
        case Token::TypeName:
        case Token::Note:
        case Token::Raw:
        case Token::Require:
        case Token::Assert:
        case Token::ErrorWord:
        case Token::Warn:
        case Token::Expect:
        case Token::Assume:
        case Token::Close: return true;
        default: return begins_declaration(token);
    }
}

inline bool is_keyword(Token token) { return token >= Token::If && token <= Token::Contains; }

/// Whether the value of a word ends in front of this token.
inline bool ends_value(Token token) {
    return token == Token::Semicolon || token == Token::EndOfFile || is_word(token) ||
           token == Token::CloseBrace;
}

/// Whether a value can end with this token.
inline bool may_end_value(Token token) {
    switch (token) {
        case Token::Identifier:
        case Token::Number:
        case Token::Text:
        case Token::TextClose:
        case Token::CloseParen:
        case Token::CloseBracket:
        case Token::CloseBrace:
        case Token::True:
        case Token::False:
        case Token::LiteralWord:
        case Token::PlusPlus:
        case Token::MinusMinus: return true;
        default: return false;
    }
}

}  // namespace kadr::syntax
