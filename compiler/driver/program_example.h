// program_example.h — examples of a control's own language: short programs that are executed.
#pragma once

#include <string>

#include "driver/session.h"

namespace kadr::driver {

/// What the program of an example comes to: `alarm 14012` if it stops at one, else the values of
/// the variables that `asked` names, as `asked` is written (`R1=2 R2=unset`).
std::string outcome_of(Session& session, const nc::Dialect& dialect, const std::string& text,
                       const std::string& asked);

}  // namespace kadr::driver
