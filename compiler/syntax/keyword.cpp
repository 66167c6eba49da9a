#include "syntax/keyword.h"

namespace kadr::syntax {

namespace {

using Place = Keyword::Place;

constexpr Keyword kKeywords[] = {
    {"if", Token::If, Place::Anywhere, ""},
    {"else", Token::Else, Place::Anywhere, ""},
    {"while", Token::While, Place::Anywhere, ""},
    {"do", Token::Do, Place::Anywhere, ""},
    {"for", Token::For, Place::Anywhere, ""},
    {"switch", Token::Switch, Place::Anywhere, ""},
    {"case", Token::Case, Place::Anywhere, ""},
    {"default", Token::Default, Place::Anywhere, ""},
    {"break", Token::Break, Place::Anywhere, ""},
    {"continue", Token::Continue, Place::Anywhere, ""},
    {"return", Token::Return, Place::Anywhere, ""},
    {"struct", Token::Struct, Place::Anywhere, ""},
    {"enum", Token::Enum, Place::Anywhere, ""},
    {"import", Token::Import, Place::Anywhere, ""},
    {"const", Token::Const, Place::Anywhere, ""},
    {"auto", Token::Auto, Place::Anywhere, ""},
    {"with", Token::With, Place::Anywhere, ""},
    {"true", Token::True, Place::Anywhere, ""},
    {"false", Token::False, Place::Anywhere, ""},

    {"cycle", Token::Cycle, Place::Statement, "n"},
    {"program", Token::Program, Place::Statement, "n"},
    {"contour", Token::Contour, Place::Statement, "n"},
    {"curve", Token::Curve, Place::Statement, "n"},
    {"test", Token::Test, Place::Statement, "t"},
    {"property", Token::Property, Place::Statement, "t"},
    {"language", Token::Language, Place::Statement, "n;"},
    {"dialect", Token::Dialect, Place::Statement, "nt;"},
    {"units", Token::Units, Place::Statement, "n;"},
    {"note", Token::Note, Place::Statement, "nt(;"},
    {"comment", Token::Note, Place::Statement, "t(", false},  // the same
    {"raw", Token::Raw, Place::Statement, "nt({;"},
    {"require", Token::Require, Place::Statement, "("},
    {"assert", Token::Assert, Place::Statement, "("},
    {"error", Token::ErrorWord, Place::Statement, "("},
    {"warn", Token::Warn, Place::Statement, "("},
    {"expect", Token::Expect, Place::Statement, "("},
    {"assume", Token::Assume, Place::Statement, "("},
    {"close", Token::Close, Place::Statement, ";"},

    {"over", Token::Over, Place::Header, ""},
    {"preserves", Token::Preserves, Place::Header, ""},
    {"frames", Token::Frames, Place::Preserved, ""},
    {"in", Token::In, Place::Parameter, ""},
    {"contains", Token::Contains, Place::Infix, ""},
    {"given", Token::Given, Place::Prefix, ""},

    {"bool", Token::TypeName, Place::Type, ""},
    {"int", Token::TypeName, Place::Type, ""},
    {"real", Token::TypeName, Place::Type, ""},
    {"string", Token::TypeName, Place::Type, ""},
    {"length", Token::TypeName, Place::Type, ""},
    {"diameter", Token::TypeName, Place::Type, ""},
    {"angle", Token::TypeName, Place::Type, ""},
    {"time", Token::TypeName, Place::Type, ""},
    {"feed", Token::TypeName, Place::Type, ""},
    {"speed", Token::TypeName, Place::Type, ""},
    {"point", Token::TypeName, Place::Type, ""},
    {"vector", Token::TypeName, Place::Type, ""},
    {"void", Token::TypeName, Place::Type, ""},

    {"and", Token::AndAnd, Place::Operator, "", false},
    {"or", Token::OrOr, Place::Operator, "", false},
    {"not", Token::Not, Place::Operator, "", false},
    {"{", Token::OpenBrace, Place::Operator, "", false},
    {"}", Token::CloseBrace, Place::Operator, "", false},
};

}  // namespace

std::span<const Keyword> all_keywords() { return kKeywords; }

const Keyword* find_keyword(std::string_view name) {
    for (const Keyword& keyword : kKeywords) {
        if (keyword.name == name) return &keyword;
    }
    return nullptr;
}

bool is_keyword(std::string_view word) { return find_keyword(word) != nullptr; }

}  // namespace kadr::syntax
