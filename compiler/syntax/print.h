// print.h — an Ast as text for people and tests.
#pragma once

#include <string>

#include "syntax/ast.h"

namespace kadr::syntax {

/// The tree as s-expressions, one declaration or statement a line, indented by depth:
///
///   (program part
///     (words G1 X10 (Y= (* 2 r))))
std::string dump(const Ast& ast);

/// One expression: `(+ a (* 2mm b))`.
std::string dump(const Ast& ast, ExprId id);

/// The unit as it is written behind a number: "mm/min"; empty for none.
std::string_view unit_text(Unit unit);

/// The operator as it is written: "+", "??", "contains".
std::string_view operator_text(Operator op);

}  // namespace kadr::syntax
