// calls.h — calls: functions and cycles of the program, functions of the vocabulary, methods.
// tables.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// A call: of a function or cycle, of the language, the vocabulary, a method, a word of the
/// control.
Value call(Check& check, syntax::ExprId id, Reg hint);
/// The arguments of a call by their parameters, positional ones first; not valid: not given.
/// Nothing, with messages, if they do not fit. `required` (bit i: parameter i) is for the hint
/// alone.
std::optional<std::vector<syntax::ExprId>> bind_arguments(Check& check, const syntax::Expr& expr,
                                                          std::string_view name,
                                                          std::span<const std::string_view> names,
                                                          const SourceRange& declared,
                                                          std::uint32_t required = 0);
/// Puts an argument where the called function finds it, from register `first` on; or a reference to
/// it.
void pass_argument(Check& check, const ParameterDecl& parameter, syntax::ExprId argument,
                   Reg first);
/// The parameters that a call names, as uses of them.
void note_arguments(Check& check, const FunctionDecl& function, const syntax::Expr& expr);
/// `mirror(x: true)`: the axis is named, at 0; nothing: `false`, it is not named.
std::optional<Value> named_axis(Check& check, const nc::FunctionInfo& info,
                                const nc::Parameter& parameter, const Value& value,
                                const SourceRange& range);
/// `shift(x: 10mm)`: a block of one function.
Value call_vocabulary(Check& check, const nc::FunctionInfo& info, const syntax::Expr& expr);
/// `list.count` and the like; nothing if it is a member of a struct.
std::optional<Value> property_value(Check& check, const Lvalue& whole, const syntax::Expr& expr);
/// `table<hole>("f.csv")`: the rows of a file; `image<…>(…)`: the dots of a picture.
Value table(Check& check, const syntax::Expr& expr);

}  // namespace kadr::sema
