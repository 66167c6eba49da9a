// run.h — `kadr run`: execute a source and write what was asked for.
#pragma once

#include "driver/options.h"
#include "driver/session.h"

namespace kadr::driver {

/// Executes a Kadr program or ISO-7bit text on the machine and writes the outputs of the job; the
/// text summary goes to standard output if nothing else was asked for. After an error no output is
/// touched; after an alarm each holds what came before it and says so.
Status run(Session& session, const RunJob& job);

}  // namespace kadr::driver
