// start.h — which program runs, and with which parameters. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// Registers for the globals and for a function that begins, and the state in which it does.
void prepare(Running& run, const sema::FunctionCode& function);
/// The register of a parameter's slot, of the function that is to begin.
Slot& argument_register(Running& run, std::size_t slot);
/// Begins with the globals; behind them the function runs.
///
/// given        bit i: parameter i has its value in the registers
/// return_to    instruction behind it; 0: the program ends there
void enter(Running& run, const sema::FunctionCode& function, std::uint32_t given,
           std::uint32_t return_to = 0);
/// Puts a value of the command line into a register, checked, with its unit.
Done set_parameter(Running& run, const sema::FunctionCode& function,
                   const sema::ParameterInfo& parameter, const std::string& text, Slot& slot);
/// See Expander::start.
Done start(Running& run, std::string_view program, const std::vector<sema::Define>& defines);
/// An argument of a cycle as a block has it (mm, degrees, s, rpm). False: it is no number.
bool set_number(const sema::ParameterInfo& parameter, double value, Slot& slot);
/// See Expander::start_cycle.
Done start_cycle(Running& run, std::string_view name, std::span<const double> arguments,
                 std::uint32_t given, const Expander::Surroundings& at);

}  // namespace kadr::expand
