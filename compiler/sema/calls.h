// calls.h — calls: functions and cycles of the program, functions of the vocabulary, methods.
// tables.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

Value call(Check& check, syntax::ExprId id, Reg hint);
std::optional<std::vector<syntax::ExprId>> bind_arguments(Check& check, const syntax::Expr& expr,
                                                          std::string_view name,
                                                          std::span<const std::string_view> names,
                                                          const SourceRange& declared,
                                                          std::uint32_t required = 0);
void pass_argument(Check& check, const ParameterDecl& parameter, syntax::ExprId argument,
                   Reg first);
void note_arguments(Check& check, const FunctionDecl& function, const syntax::Expr& expr);
std::optional<Value> named_axis(Check& check, const nc::FunctionInfo& info,
                                const nc::Parameter& parameter, const Value& value,
                                const SourceRange& range);
Value call_vocabulary(Check& check, const nc::FunctionInfo& info, const syntax::Expr& expr);
/// `list.count` and the like; nothing if it is a member of a struct.
std::optional<Value> property_value(Check& check, const Lvalue& whole, const syntax::Expr& expr);
Value table(Check& check, const syntax::Expr& expr);

}  // namespace kadr::sema
