// used_functions.h — which functions of the vocabulary the blocks of a program may have.
#pragma once

#include "nc/vocabulary.h"
#include "sema/code.h"

namespace kadr::sema {

/// Of the function and of all that it may call, whether it comes there or not. Raw text counts for
/// nothing.
nc::FunctionSet used_functions(const Code& code, const FunctionCode& entry);

}  // namespace kadr::sema
