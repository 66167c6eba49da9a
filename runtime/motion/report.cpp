#include "motion/report.h"

#include <utility>

namespace kadr::motion {

DiagnosticBuilder report(DiagnosticSink& sink, const DiagnosticRow& row, const AskedPlace& place,
                         const PlaceOf& place_of) {
    ShownPlace shown;
    if (place_of) shown = place_of(place);
    else shown.line.line = place.line;
    DiagnosticBuilder builder = sink.report(row, std::move(shown.line));
    for (LinePlace& call : shown.calls) builder.note(std::move(call), "called here");
    return builder;
}

DiagnosticBuilder report(DiagnosticSink& sink, const DiagnosticRow& row,
                         const path::Command& command, const PlaceOf& place_of) {
    return report(sink, row, AskedPlace{command.line, command.source, {}}, place_of);
}

}  // namespace kadr::motion
