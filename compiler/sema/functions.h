// functions.h — functions: their parameters and results, and their bodies.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// The types of a function's parameters and result, and the registers of its parameters.
void define_signature(Check& check, std::uint32_t function);
/// Checks the body of a function and emits it.
void check_function(Check& check, std::uint32_t function);
/// A parameter as the outside needs it.
ParameterInfo describe_parameter(Check& check, const ParameterDecl& parameter);
/// Reports it if what was emitted needs more registers than there are.
void report_overflow(Check& check, std::string_view name, const SourceRange& range);

}  // namespace kadr::sema
