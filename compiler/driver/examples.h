// examples.h — the examples of a dialect file, run as the manual has them.
#pragma once

#include "driver/session.h"

namespace kadr::driver {

/// Whether the Kadr files of the control's own cycles have those cycles, with their parameters.
void check_cycles(Session& session, const nc::Dialect& dialect);

/// Checks and runs the source of every example, in the language of the common core, and holds what
/// comes out against its text. Each one that is not true is reported at its attribute.
void check_examples(Session& session, const nc::Dialect& dialect);

}  // namespace kadr::driver
