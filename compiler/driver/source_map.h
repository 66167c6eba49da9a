// source_map.h — the source map: which statement, calls and loop passes made a line of the text.
#pragma once

#include <cstdint>
#include <string>

#include "base/json_writer.h"
#include "driver/session.h"
#include "expand/expander.h"

namespace kadr::driver {

/// Lines of ISO-7bit text that one block became, counted from 1.
struct LineSpan {
    std::uint32_t first = 0;
    std::uint32_t count = 1;
};

/// The member `"calls":[{"function":"f","file":"a.kadr","line":50,"column":3}]`, the outermost
/// first.
void put_calls(JsonWriter& json, const expand::BlockOrigin& trace, const Session& session);

/// Appends one object and a line end:
/// `{"iso":12,"lines":1,"file":"a.kadr","line":34,"column":5,"end_line":34,"end_column":20,
///   "calls":[{"function":"f","file":"a.kadr","line":50,"column":3}],"loops":[2]}`.
/// `calls` begins with the outermost; `loops` counts the passes of the loops around the statement,
/// the outermost first.
void append_map_entry(std::string& out, LineSpan lines, const expand::BlockOrigin& trace,
                      const Session& session);

}  // namespace kadr::driver
