// keyword.h — the structural words of the language: where each one is a keyword.
//
// Most of them are ordinary names elsewhere (`dwell(time: 0.5s)`, `real error = 0;`), so that the
// language does not take good names away. The lexemes in other languages come from
// dialects/languages/*.xml and must name every row.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "syntax/token.h"

namespace kadr::syntax {

struct Keyword {
    enum class Context : std::uint8_t {
        Anywhere,   // never a name
        Statement,  // at the start of a statement or declaration, in front of one of `followers`
        Header,     // between `)` and `{` of a declaration
        Parameter,  // behind a parameter's name
        Infix,      // between two values
        Prefix,     // in front of a name
        Preserved,  // in the list behind `preserves`
        Type,       // the name of a built-in type; stays a name
        Operator,   // a word for an operator: `and`
    };
    std::string_view name;
    Token token;
    Context context;
    std::string_view followers;  // n name, t text, and `(` `{` `;` themselves
    bool is_required = true;     // every language file must give a lexeme
};

std::span<const Keyword> all_keywords();
const Keyword* find_keyword(std::string_view name);

}  // namespace kadr::syntax
