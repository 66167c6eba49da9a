// stop_text.h — where a run stands, for people and as JSON.
#pragma once

#include <string>
#include <string_view>

#include "driver/debug/engine.h"

namespace kadr::driver {

/// "stopped before `N30`"
std::string reason_of(const Stop& stop, const Places& places);
/// Whether a report shows the next line of the text: the run stands in front of it, or the place
/// is one of its statement or of a call that leads to it.
bool shows_line(const Stop& stop, const DebugEngine& engine);

/// The head of a stop in front of a line: the line, and the statement that has made it.
std::string line_head(const Stop& stop, std::string_view reason, const Session& session);
/// The head of one in front of a statement, and the line that comes next if one is known.
std::string statement_head(const Stop& stop, std::string_view reason, const Session& session);
/// Where the tool stands, programmed and in the machine.
std::string position_lines(const TraceState& now);
std::string state_lines(const TraceState& now);
/// `length y = 1 mm`, one a line, those whose names begin so.
std::string variable_lines(const std::vector<Variable>& variables, std::string_view part);

/// All of it as one object.
std::string stop_json(const Stop& stop, std::string_view reason, DebugEngine& engine,
                      const Session& session);

}  // namespace kadr::driver
