// type_declarations.h — types: as they are written, and as files declare them.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// A type as it is written; kError, with a message, if there is none such.
Type resolve_type(Check& check, syntax::TypeId id);
/// Members of structs and values of enums of a file, once all names are declared.
void define_types(Check& check, std::uint32_t module);
/// Names of the members of enums for the code.
void export_enums(Check& check);

}  // namespace kadr::sema
