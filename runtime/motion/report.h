// report.h — messages of the motion at their location.
//
// The motion knows a command's line and source as numbers. What stands there, and which calls have
// led to it, knows who gave the commands.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/axes.h"
#include "base/diagnostic.h"
#include "path/command.h"

namespace kadr::motion {

/// What a message is about.
struct CommandLocation {
    std::uint32_t line = 0;    // Command::line
    SourceId source;           // Command::source
    std::optional<Axis> axis;  // whose word shows it best, if the line has one
};

struct ShownLocation {
    TextLocation line;
    std::vector<TextLocation> calls;  // that have led to the line, the nearest first
};

using LocateCommand = std::function<ShownLocation(const CommandLocation&)>;

/// Begins a message. `locate_command` may be empty: then there is nothing but the line's number.
DiagnosticBuilder report(DiagnosticSink& sink, const DiagnosticRow& row,
                         const CommandLocation& location, const LocateCommand& locate_command);
/// The same about a command.
DiagnosticBuilder report(DiagnosticSink& sink, const DiagnosticRow& row,
                         const path::Command& command, const LocateCommand& locate_command);

}  // namespace kadr::motion
