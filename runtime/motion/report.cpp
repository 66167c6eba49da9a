#include "motion/report.h"

#include <utility>

namespace kadr::motion {

DiagnosticBuilder report(DiagnosticSink& sink, const DiagnosticRow& row,
                         const CommandLocation& place, const LocateCommand& place_of) {
    ShownLocation shown;
    if (place_of) shown = place_of(place);
    else shown.line.line = place.line;
    DiagnosticBuilder builder = sink.report(row, std::move(shown.line));
    for (TextLocation& call : shown.calls) builder.note(std::move(call), "called here");
    return builder;
}

DiagnosticBuilder report(DiagnosticSink& sink, const DiagnosticRow& row,
                         const path::Command& command, const LocateCommand& place_of) {
    return report(sink, row, CommandLocation{command.line, command.source, {}}, place_of);
}

}  // namespace kadr::motion
