// library_tools.h — what a program asks the tool library: `tool("MILL_10").d`, `tool("MILL_10");`.
//
// The library is there when a program is checked, so its values are constants with dimensions.
#pragma once

#include <span>
#include <string_view>

#include "sema/checking.h"

namespace kadr::sema {

/// Whether the expression is `tool(…)` of the language: nothing of the program is called so.
bool asks_library(Check& check, syntax::ExprId id);
/// The member `member` of the tool that `call` asks for. What is not given is reported if
/// `is_needed`; else the value has an optional type.
Value library_value(Check& check, syntax::ExprId member, syntax::ExprId call, bool is_needed);
/// The number of the tool that a block calls by this text constant; an error value: reported.
Value called_tool(Check& check, const Value& name, const SourceRange& range);
/// What can stand behind `tool("MILL_10").`
std::span<const std::string_view> library_members();

}  // namespace kadr::sema
