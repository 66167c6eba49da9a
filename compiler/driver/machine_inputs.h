// machine_inputs.h — what the machine gives a program before it begins, from where people write it:
// the machine file, files of variables, the command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/session.h"
#include "machine/described_machine.h"
#include "macro/program.h"

namespace kadr::driver {

/// `<data>` of the machine file, then the files of `--variables-in`, then `--set`: what comes later
/// wins. Nothing: a file cannot be read, which is reported.
std::optional<std::vector<macro::ProgramInputs>> machine_inputs(Session& session);

/// What the machine's axes are called as an index.
nc::MachineAxisNames axis_names(const machine::Machine& machine, const machine::MachineData& data);

/// A file of variables as lines of the control's language, each at its location: JSON as
/// `--variables` writes it, or what the control puts out itself (F: `#500=12.5`, `#500 12.5
/// (NAME)`, `G10 L2 …` between `%`; S: an INI file with `CHANDATA(1)`). Nothing: it is JSON of
/// another kind; `fault` is where.
std::optional<std::string> lines_of_variables(std::string_view text, std::size_t& fault);

}  // namespace kadr::driver
