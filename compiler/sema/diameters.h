// diameters.h — which functions of a program work with diameters.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// Marks the functions of the code in which X is a diameter; once all bodies are emitted.
void mark_diameters(Check& check);

}  // namespace kadr::sema
