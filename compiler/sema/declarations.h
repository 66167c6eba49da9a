// declarations.h — files and the names that they declare.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// The units of a function: its own, else those of its file.
Units units_of(const Check& check, const FunctionDecl& function);
/// Takes a file and everything that it imports among those of the check; its number.
std::uint32_t load_module(Check& check, const syntax::Ast& ast, const nc::Dialect& dialect);
/// A declaration as it is recorded: its name, where it stands.
DeclaredSymbol described(const Check& check, std::uint32_t module, syntax::DeclId id,
                         DeclaredSymbol::Kind kind);
/// Declares the names at the top of a file.
void declare_names(Check& check, std::uint32_t module);

}  // namespace kadr::sema
