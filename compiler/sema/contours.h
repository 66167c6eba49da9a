// contours.h — contours: blocks kept as a value, what can be asked of them and made of them.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

void contour_body(Check& check, const syntax::Decl& decl, Reg target);
void contour_variable(Check& check, syntax::DeclId id);
std::optional<Value> contour_property(Check& check, const Value& contour, const syntax::Expr& expr);
std::optional<Value> contour_function(Check& check, std::string_view name,
                                      const syntax::Expr& expr);

}  // namespace kadr::sema
