// control_machines.h — the machines on which the programs of tests/control run.
#pragma once

#include <string>

#include "machine/machine.h"

namespace kadr::interp {

/// The machine that a program names: `lathe`, `driven`, `five-axis`, `edges`, `spindles` or one of
/// runtime/machines; without a name a mill, on the control of a lathe as one. Work offset 2 is X10
/// Y20 Z30, and the first tool has no length, so that the places of the programs are those of the
/// axes.
machine::Machine machine_named(const std::string& name, bool control_is_of_lathe);

}  // namespace kadr::interp
