// pipeline_data.h — what a machine file gives for the path from a command to a setpoint.
//
// Which module serves which command, how far each of the three stages (translate ahead,
// interpolate, output) may run ahead of the next one, and what is put out. Data only. None of the
// stages' numbers changes a result: they set how much is done in one go and may wait.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/source.h"
#include "path/command.h"

namespace kadr::machine {

/// Modules that every program has: what they serve is only counted, or is the scanner's.
inline constexpr std::string_view kNoModule = "none";
inline constexpr std::string_view kScannerModule = "scanner";

/// A command that a module serves other than the axes.
struct ModuleRow {
    path::Op command = path::Op::Dwell;
    std::string module;  // one of the two above, or one that is registered
    SourceRange range;   // where the file names the module
};

/// What one stage does in one go, and how many goes may wait for the next stage.
struct PipelineStage {
    double period = 0;      // s of motion; 0: the batch alone sets when it is handed on
    std::size_t batch = 0;  // pieces or setpoints at most, > 0
    std::size_t queue = 4;  // > 0; of the output none, it is the last
};

struct SetpointOutput {
    std::string file;                  // with {program} for the source's name; empty: none
    std::vector<std::string> columns;  // names, `axes` for all axes …; empty: all
};

struct Pipeline {
    std::size_t ahead = 1024;  // pieces of path that the look-ahead knows
    std::vector<ModuleRow> modules;
    PipelineStage translate{0, 64, 4};      // pieces; half a kilobyte each
    PipelineStage interpolate{0, 1024, 4};  // setpoints
    PipelineStage output{0, 1024, 1};       // setpoints
    SetpointOutput setpoints;
};

}  // namespace kadr::machine
