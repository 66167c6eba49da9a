// declarations.h — files and what they declare: imports, types, functions, global variables.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// The units of a function: its own, else those of its file.
Units units_of(const Check& check, const FunctionDecl& function);

std::uint32_t load_module(Check& check, const syntax::Ast& ast, const nc::Dialect& dialect);
DeclaredSymbol described(const Check& check, std::uint32_t module, syntax::DeclId id,
                         DeclaredSymbol::Kind kind);
void declare_names(Check& check, std::uint32_t module);
Type resolve_type(Check& check, syntax::TypeId id);
void define_types(Check& check, std::uint32_t module);
void define_signature(Check& check, std::uint32_t function);
void check_global(Check& check, std::uint32_t global, bool on_demand);
void check_function(Check& check, std::uint32_t function);
ParameterInfo describe_parameter(Check& check, const ParameterDecl& parameter);
void export_enums(Check& check);

}  // namespace kadr::sema
