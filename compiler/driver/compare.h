// compare.h — `kadr compare`: whether two programs, or one for two controls, make the same motions.
#pragma once

#include "driver/options.h"
#include "driver/session.h"

namespace kadr::driver {

/// Executes both on the machine of the session and writes how far they agree to standard output.
/// Done: they move alike within the tolerance; Failed: they do not, or one has errors.
Status compare(Session& session, const CompareJob& job);

}  // namespace kadr::driver
