// summary.h — what a run amounts to, for a person and for a program.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "driver/work_times.h"
#include "machine/machine.h"
#include "motion/pipeline.h"
#include "process/scanner.h"

namespace kadr::driver {

struct RunFigures {
    std::string source;   // "bracket.kadr"
    std::string dialect;  // title
    std::uint64_t blocks = 0;
    std::uint64_t commands = 0;
    std::uint64_t setpoints = 0;               // 0: nobody asked for them
    std::optional<std::uint64_t> pulses;       // of a pulsed laser
    std::optional<process::ScanFigures> scan;  // of a scanner
    std::size_t errors = 0;
    std::size_t alarms = 0;
    std::size_t warnings = 0;
    std::string alarm;  // the first one; empty: none
    motion::Totals totals;
    std::vector<ToolShare> tools;
    std::vector<CycleShare> cycles;      // the longest first
    std::vector<LocationShare> longest;  // statements, the longest first
};

/// A table with units, times as hours, minutes and seconds; ends with a line end.
std::string summary_text(const RunFigures& figures, const machine::Machine& machine);

/// One JSON object and a line end; s, mm, deg, mm/s and so on as DESIGN §11 names them. What is
/// infinite (the jerk of a profile that has none) is null.
std::string summary_json(const RunFigures& figures, const machine::Machine& machine);

/// `1 h 02 min 03 s`, `4 min 05 s`, `3.27 s`.
std::string duration_text(double seconds);

}  // namespace kadr::driver
