// globals.h — variables of files: their types and values, each found out once.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// `on_demand`: its value is needed before its turn has come.
void check_global(Check& check, std::uint32_t global, bool on_demand);

}  // namespace kadr::sema
