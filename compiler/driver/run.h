// run.h — `kadr run`: execute a source and write what was asked for.
#pragma once

#include <functional>

#include "driver/options.h"
#include "driver/session.h"
#include "motion/segment.h"

namespace kadr::driver {

/// Executes a Kadr program or ISO-7bit text on the machine and writes the outputs of the job; the
/// text summary goes to standard output if nothing else was asked for. After an error no output is
/// touched; after an alarm each holds what came before it and notes it.
///
/// Setpoints are held against the programmed path (motion/path_check.h); one that is off is an
/// error of Kadr, and reported as one. `spoil` makes planned motion wrong, for tests of that.
Status run(Session& session, const RunJob& job,
           const std::function<void(motion::Segment&)>& spoil = {});

}  // namespace kadr::driver
