// variables.h — the control's variables at the end of a run, as JSON.
#pragma once

#include <span>
#include <string>

#include "macro/program.h"

namespace kadr::driver {

/// One object, a member for each variable that the program has set, by its own name: `"R1": 2.5`.
std::string variables_json(std::span<const macro::ControlVariable> variables);

}  // namespace kadr::driver
