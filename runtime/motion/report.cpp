#include "motion/report.h"

#include <utility>

namespace kadr::motion {

DiagnosticBuilder report(DiagnosticSink& sink, const DiagnosticRow& row,
                         const CommandLocation& location, const LocateCommand& locate_command) {
    ShownLocation shown;
    if (locate_command) shown = locate_command(location);
    else shown.line.line = location.line;
    DiagnosticBuilder builder = sink.report(row, std::move(shown.line));
    for (TextLocation& call : shown.calls) builder.note(std::move(call), "called here");
    return builder;
}

DiagnosticBuilder report(DiagnosticSink& sink, const DiagnosticRow& row,
                         const path::Command& command, const LocateCommand& locate_command) {
    return report(sink, row, CommandLocation{command.line, command.source, {}}, locate_command);
}

}  // namespace kadr::motion
