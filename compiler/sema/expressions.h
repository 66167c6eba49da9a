// expressions.h — expressions by their kind: literals, names, `? :`.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// Checks an expression and emits it: a constant, or the registers that hold its value. `expected`
/// decides where the expression alone does not (braces, literals); `hint` is the register that
/// would be right for the result. A value of the type kError, with a message, if there is a
/// mistake.
Value expression(Check& check, syntax::ExprId id, Type expected = {}, Reg hint = kNoReg);
/// Records what an expression came to; of a literal only the type.
void note_value(Check& check, syntax::ExprId id, const Value& value);
/// The value of a local name; `checked`: it must be given, which is reported or checked when it
/// runs.
Value symbol_value(Check& check, std::int32_t index, const SourceRange& range, bool checked);
/// The value of a name: local, of a file, of the language (`pi`, `position`).
Value name_value(Check& check, syntax::ExprId id, Reg hint);
/// The type of an expression, found by a dry run: nothing is reported, recorded or emitted.
Type type_of(Check& check, syntax::ExprId id);
/// Whether an expression may change a variable: an assignment, `++`, a call.
bool writes(Check& check, syntax::ExprId id);

}  // namespace kadr::sema
