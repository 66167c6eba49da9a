// terminal.h — the prompt at a terminal (libedit: editing, history, completion) or in a pipe.
#pragma once

#include "driver/options.h"
#include "driver/shared_inputs.h"

namespace kadr::repl {

/// Reads lines until they end. At a terminal the status is Done; in a pipe an input that came to an
/// error makes it Failed, so that a script notices.
driver::Status converse(const driver::Options& options, driver::SharedInputs& inputs);

}  // namespace kadr::repl
