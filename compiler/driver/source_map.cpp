#include "driver/source_map.h"

#include "base/render.h"

namespace kadr::driver {

namespace {

void append_number(std::string& out, const char* name, std::uint64_t value) {
    out += ",\"";
    out += name;
    out += "\":";
    out += std::to_string(value);
}

void append_start(std::string& out, const Session& session, const SourceRange& range) {
    const LineColumn at = session.sources().locate(range.file, range.begin);
    out += ",\"file\":" + json_string(session.output_name(range.file));
    append_number(out, "line", at.line);
    append_number(out, "column", at.column);
}

}  // namespace

void append_calls(std::string& out, const expand::BlockOrigin& trace, const Session& session) {
    out += ",\"calls\":[";
    for (const expand::SourceCall& call : trace.calls) {
        if (&call != &trace.calls.front()) out += ',';
        out += "{\"function\":" + json_string(call.function);
        if (call.range.file.is_valid()) append_start(out, session, call.range);
        out += '}';
    }
    out += ']';
}

void append_map_entry(std::string& out, LineSpan lines, const expand::BlockOrigin& trace,
                      const Session& session) {
    out += "{\"iso\":" + std::to_string(lines.first);
    append_number(out, "lines", lines.count);
    if (trace.statement.file.is_valid()) {
        append_start(out, session, trace.statement);
        const LineColumn end = session.sources().locate(trace.statement.file, trace.statement.end);
        append_number(out, "end_line", end.line);
        append_number(out, "end_column", end.column);
    }
    append_calls(out, trace, session);
    out += ",\"loops\":[";
    for (std::size_t i = 0; i < trace.loop_counts.size(); ++i) {
        if (i > 0) out += ',';
        out += std::to_string(trace.loop_counts[i]);
    }
    out += "]}\n";
}

}  // namespace kadr::driver
