// test.h — `kadr test`: runs the tests and properties that stand in Kadr programs.
#pragma once

#include "driver/options.h"
#include "driver/session.h"

namespace kadr::driver {

/// Runs each test for each control, without a dialect in the options for the three that ship, and
/// writes one line a test to the output of the job. Failed if something does not hold; what that is
/// goes to the messages, once if it is the same for all controls.
Status test(Session& session, const TestJob& job);

}  // namespace kadr::driver
