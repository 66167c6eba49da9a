// contract.h — what a declaration tells who calls it: its parameters, what they mean, and what its
// `require`s ask of each of them.
//
// Read off the tree alone, as it is written: types and values are not known here (sema/), and a
// bound is the text of an expression.
#pragma once

#include <string>
#include <vector>

#include "base/source.h"
#include "syntax/ast.h"

namespace kadr::syntax {

/// One side of a range: `n <= 360` bounds n by `<=` and "360".
struct Bound {
    Operator op = Operator::None;  // Less, LessEqual, Greater or GreaterEqual
    std::string value;             // as it stands in the source
};

struct ParameterContract {
    std::string name;
    std::string type;     // as it stands in the source: `length?`
    std::string initial;  // the default, as it stands there; empty: none
    std::string meaning;  // of its line in the documentation; empty: it has none
    std::vector<Bound> bounds;
    TypeId type_id;
    bool is_optional = false;  // `?`: it may be left out without a default
    SourceRange range;         // of its name
};

struct Contract {
    std::string name;
    std::string heading;  // how it begins: `cycle drill`, `length twice`
    std::string ending;   // what stands between the parameters and the body: `preserves G90, G17`
    std::string about;    // the documentation without the lines of the parameters
    std::vector<ParameterContract> parameters;
    /// What else is required at its beginning, such as `2*edge < width`.
    std::vector<std::string> conditions;
};

/// Of a function, a cycle, a curve or a program. `text` is that of the tree's file. A line of the
/// documentation belongs to a parameter if it begins with its name and two blanks; several names
/// stand with commas. Only a `require` that every call comes to counts: one at the outermost level,
/// about parameters that nothing has changed before it.
Contract contract_of(const Ast& ast, DeclId id, std::string_view text);

/// `<` of Less …
std::string_view spelling(Operator comparison);

/// The bounds in one text: `> 0, <= 360`; empty: there are none.
std::string bounds_text(const ParameterContract& parameter);

/// The unit of a number without one, for a type as it is named in English: `mm` of a length in a
/// metric file; empty: the type has none.
std::string_view bare_unit(std::string_view type, bool is_inch);

/// Whether the file says `units inch;`.
bool is_inch(const Ast& ast);

}  // namespace kadr::syntax
