// setpoint_columns.h — which numbers a setpoint of a machine has, and which of them are put out.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "machine/machine.h"

namespace kadr::machine {

/// Whether setpoints carry pulses: of the laser at the axes, or of the scanner's.
bool has_pulses(const Machine& machine);

/// `t,<machine axes…>,tip_x,tip_y,tip_z,tool_i,tool_j,tool_k,feed,iso`, and of a laser `pulse` or
/// `power`.
std::vector<std::string> setpoint_columns(const Machine& machine);

/// The columns that a word means: itself, or `axes`, `tip` and `tool` those that belong together.
/// Empty: there is none.
std::vector<std::size_t> columns_of_word(std::string_view word, const Machine& machine);

/// Those that the machine file asks for, in its order; all if it does not ask.
std::vector<std::size_t> chosen_columns(const Machine& machine);

}  // namespace kadr::machine
