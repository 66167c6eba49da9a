// program_clocks.h — the clocks that a program can ask and set. Internal to interp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "interp/run_clock.h"

namespace kadr::interp {

struct ProgramClocks {
    explicit ProgramClocks(const machine::Machine& machine) : run(machine) {}

    /// A clock of the program's own, s: what it shows, or what is added to the running time.
    struct Timer {
        double value = 0;
        bool runs = false;
    };

    RunClock run;
    std::size_t timed = 0;  // commands of this batch that the clock knows
    double latest = 0;      // that the program has been given, s
    double cutting = 0;     // … of it at feed
    std::map<std::int64_t, Timer> timers;
    double milliseconds_from = 0;  // what the program has set, without the time since
    double hours_from = 0;
};

}  // namespace kadr::interp
