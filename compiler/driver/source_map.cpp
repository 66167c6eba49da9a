#include "driver/source_map.h"

namespace kadr::driver {

namespace {

void put_start(JsonWriter& json, const Session& session, const SourceRange& range) {
    const LineColumn at = session.sources().locate(range.file, range.begin);
    json.key("file").value(session.output_name(range.file));
    json.key("line").value(at.line);
    json.key("column").value(at.column);
}

void put_statement(JsonWriter& json, const Session& session, const SourceRange& statement) {
    if (!statement.file.is_valid()) return;
    put_start(json, session, statement);
    const LineColumn end = session.sources().locate(statement.file, statement.end);
    json.key("end_line").value(end.line);
    json.key("end_column").value(end.column);
}

}  // namespace

void put_calls(JsonWriter& json, const expand::BlockOrigin& trace, const Session& session) {
    json.key("calls").array([&] {
        for (const expand::SourceCall& call : trace.calls) {
            json.object([&] {
                json.key("function").value(call.function);
                if (call.range.file.is_valid()) put_start(json, session, call.range);
            });
        }
    });
}

void append_map_entry(std::string& out, LineSpan lines, const expand::BlockOrigin& trace,
                      const Session& session) {
    JsonWriter json(out);
    json.object([&] {
        json.key("iso").value(lines.first);
        json.key("lines").value(lines.count);
        put_statement(json, session, trace.statement);
        put_calls(json, trace, session);
        json.key("loops").array([&] {
            for (const auto count : trace.loop_counts) json.value(count);
        });
    });
    json.end_line();
}

}  // namespace kadr::driver
