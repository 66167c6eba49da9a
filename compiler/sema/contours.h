// contours.h — contours: blocks kept as a value, what can be asked of them and made of them.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// The statements of a contour; their blocks are kept in register `target`.
void contour_body(Check& check, const syntax::Decl& decl, Reg target);
/// A contour that is declared in a function.
void contour_variable(Check& check, syntax::DeclId id);
/// `c.length` and the like; nothing: a contour has no such member.
std::optional<Value> contour_property(Check& check, const Value& contour, const syntax::Expr& expr);
/// `offset(c, 3mm)`, `follow(c)` and the like; nothing: the name is none of them, or no contour is
/// given.
std::optional<Value> contour_function(Check& check, std::string_view name,
                                      const syntax::Expr& expr);

}  // namespace kadr::sema
