#include "syntax/keyword.h"

namespace kadr::syntax {

namespace {

using Context = Keyword::Context;

constexpr Keyword kKeywords[] = {
    {"if", Token::If, Context::Anywhere, ""},
    {"else", Token::Else, Context::Anywhere, ""},
    {"while", Token::While, Context::Anywhere, ""},
    {"do", Token::Do, Context::Anywhere, ""},
    {"for", Token::For, Context::Anywhere, ""},
    {"switch", Token::Switch, Context::Anywhere, ""},
    {"case", Token::Case, Context::Anywhere, ""},
    {"default", Token::Default, Context::Anywhere, ""},
    {"break", Token::Break, Context::Anywhere, ""},
    {"continue", Token::Continue, Context::Anywhere, ""},
    {"return", Token::Return, Context::Anywhere, ""},
    {"struct", Token::Struct, Context::Anywhere, ""},
    {"enum", Token::Enum, Context::Anywhere, ""},
    {"import", Token::Import, Context::Anywhere, ""},
    {"const", Token::Const, Context::Anywhere, ""},
    {"auto", Token::Auto, Context::Anywhere, ""},
    {"with", Token::With, Context::Anywhere, ""},
    {"true", Token::True, Context::Anywhere, ""},
    {"false", Token::False, Context::Anywhere, ""},

    {"cycle", Token::Cycle, Context::Statement, "n"},
    {"program", Token::Program, Context::Statement, "n"},
    {"contour", Token::Contour, Context::Statement, "n"},
    {"curve", Token::Curve, Context::Statement, "n"},
    {"test", Token::Test, Context::Statement, "t"},
    {"property", Token::Property, Context::Statement, "t"},
    {"language", Token::Language, Context::Statement, "n;"},
    {"dialect", Token::Dialect, Context::Statement, "nt;"},
    {"units", Token::Units, Context::Statement, "n;"},
    {"note", Token::Note, Context::Statement, "nt(;"},
    {"comment", Token::Note, Context::Statement, "t(", false},  // the same
    {"raw", Token::Raw, Context::Statement, "nt({;"},
    {"require", Token::Require, Context::Statement, "("},
    {"assert", Token::Assert, Context::Statement, "("},
    {"error", Token::ErrorWord, Context::Statement, "("},
    {"warn", Token::Warn, Context::Statement, "("},
    {"expect", Token::Expect, Context::Statement, "("},
    {"assume", Token::Assume, Context::Statement, "("},
    {"close", Token::Close, Context::Statement, ";"},

    {"over", Token::Over, Context::Header, ""},
    {"preserves", Token::Preserves, Context::Header, ""},
    {"frames", Token::Frames, Context::Preserved, ""},
    {"in", Token::In, Context::Parameter, ""},
    {"contains", Token::Contains, Context::Infix, ""},
    {"given", Token::Given, Context::Prefix, ""},

    {"bool", Token::TypeName, Context::Type, ""},
    {"int", Token::TypeName, Context::Type, ""},
    {"real", Token::TypeName, Context::Type, ""},
    {"string", Token::TypeName, Context::Type, ""},
    {"length", Token::TypeName, Context::Type, ""},
    {"diameter", Token::TypeName, Context::Type, ""},
    {"angle", Token::TypeName, Context::Type, ""},
    {"time", Token::TypeName, Context::Type, ""},
    {"feed", Token::TypeName, Context::Type, ""},
    {"speed", Token::TypeName, Context::Type, ""},
    {"point", Token::TypeName, Context::Type, ""},
    {"vector", Token::TypeName, Context::Type, ""},
    {"void", Token::TypeName, Context::Type, ""},

    {"and", Token::AndAnd, Context::Operator, "", false},
    {"or", Token::OrOr, Context::Operator, "", false},
    {"not", Token::Not, Context::Operator, "", false},
    {"{", Token::OpenBrace, Context::Operator, "", false},
    {"}", Token::CloseBrace, Context::Operator, "", false},
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
