#include "driver/debug/stop_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/json_writer.h"
#include "base/numbers.h"
#include "base/printable.h"
#include "base/text.h"

namespace kadr::driver {

namespace {

/// A line of a text with a mark below the character at this column, from 1.
std::string marked_line(std::uint64_t line, std::string_view text, std::size_t column) {
    const std::string number = fmt::format("{:>4}", line);
    return number + " | " + printable(text) + '\n' + std::string(number.size(), ' ') + " | " +
           std::string(column - 1, ' ') + "^\n";
}

std::string position_text(std::string_view label, AxisMask axes, const AxisValues& values) {
    std::string out = fmt::format("{:<9}", label);
    for (std::size_t i = 0; i < kAxes; ++i) {
        if ((axes >> i & 1u) == 0) continue;
        out += fmt::format(" {}{:.3f}", kAxisNames[i], round_to(values[i], 3) + 0.0);
    }
    return out + '\n';
}

bool is_inside(const SourceRange& part, const SourceRange& whole) {
    return part.file == whole.file && part.begin >= whole.begin && part.begin < whole.end;
}

/// The statement as a line of its file.
struct ShownStatement {
    std::string_view file;
    LineColumn at;
    std::string_view text;
};

ShownStatement shown(const SourceRange& statement, const Session& session) {
    const Sources& sources = session.sources();
    return {sources.name(statement.file), sources.locate(statement.file, statement.begin),
            sources.line_at(statement.file, statement.begin)};
}

}  // namespace

std::string reason_of(const Stop& stop, const Places& places) {
    switch (stop.reason) {
        case StopReason::Place:
            if (const WatchedPlace* place = places.find(stop.place))
                return "stopped before `" + place->point.text() + '`';
            break;
        case StopReason::Entry: return "stopped at the beginning";
        case StopReason::Alarm: return "the run has ended here";
        case StopReason::Step:
        case StopReason::Pause:
        case StopReason::Until:
        case StopReason::End: break;
    }
    return "stopped";
}

bool shows_line(const Stop& stop, const DebugEngine& engine) {
    if (!stop.is_at_statement()) return true;
    const WatchedPlace* place = engine.places().find(stop.place);
    if (!stop.line || place == nullptr) return false;
    const bool is_function = place->point.kind() == BreakPoint::Kind::Name;
    const auto is_there = [&](const SourceRange& range) {
        return !is_function && range.file.is_valid() && engine.is_on_lines(place->point, range);
    };
    return is_there(stop.line->statement) ||
           std::ranges::any_of(stop.line->calls.calls, [&](const expand::SourceCall& call) {
               return is_there(call.range) || (is_function && call.range == stop.entered_by);
           });
}

std::string line_head(const Stop& stop, std::string_view reason, const Session& session) {
    const TraceStep& step = *stop.line;
    const std::size_t indent = std::min(step.text.find_first_not_of(" \t"), step.text.size());
    std::string out = fmt::format("{}:{}: {}\n", step.file, step.line, reason);
    out += marked_line(step.line, step.text, indent + 1);
    if (step.statement.file.is_valid())
        out += "     by " + session.source_name(step.statement) + '\n';
    return out;
}

std::string statement_head(const Stop& stop, std::string_view reason, const Session& session) {
    const ShownStatement at = shown(stop.statement, session);
    std::string out = fmt::format("{}:{}: {}\n", at.file, at.at.line, reason);
    out += marked_line(at.at.line, at.text, at.at.column);
    if (!stop.line) return out;
    out += fmt::format("next      {}:{}: {}", stop.line->file, stop.line->line,
                       printable(stop.line->text));
    if (stop.line->statement.file.is_valid() && !is_inside(stop.line->statement, stop.statement))
        out += ", by " + session.source_name(stop.line->statement);
    return out + '\n';
}

std::string position_lines(const TraceState& now) {
    return position_text("position", now.now.axes, now.now.work) +
           position_text("machine", now.now.axes, now.now.machine);
}

std::string state_lines(const TraceState& now) {
    std::string out = "codes    ";
    for (const macro::ActiveCode& code : now.codes) out += ' ' + std::string(code.code);
    out += '\n';
    for (const ModalEntry& entry : now.modal)
        out += fmt::format("{:<14} {}\n", entry.name, modal_text(entry.value, "none"));
    return out;
}

namespace {

/// A value in one line: the ends of lines in a text as they are written in a source.
std::string in_one_line(std::string_view value) {
    std::string out;
    for (const char c : printable(value)) {
        if (c == '\n') out += "\\n";
        else out += c;
    }
    return out;
}

}  // namespace

std::string variable_lines(const std::vector<Variable>& variables, std::string_view part) {
    std::string out;
    for (const Variable& variable : variables) {
        if (!std::string_view(variable.name).starts_with(part)) continue;
        out += variable.type + ' ' + variable.name + " = " + in_one_line(variable.value) + '\n';
    }
    return out;
}

namespace {

/// The line that is next, and the statement behind it; of a statement that makes none its own.
void put_location(JsonWriter& json, const Stop& stop, const DebugEngine& engine,
                  const Session& session) {
    if (shows_line(stop, engine)) {
        json.key("file").value(stop.line->file);
        json.key("line").value(stop.line->line);
        json.key("text").value(stop.line->text);
        if (stop.line->statement.file.is_valid())
            json.key("src").value(session.source_name(stop.line->statement));
        return;
    }
    const ShownStatement at = shown(stop.statement, session);
    json.key("file").value(at.file);
    json.key("line").value(at.at.line);
    json.key("text").value(at.text);
    json.key("src").value(session.source_name(stop.statement));
}

void put_locals(JsonWriter& json, DebugEngine& engine) {
    Inspection& inspection = engine.inspection();
    json.key("locals").object([&] {
        if (inspection.frames().empty()) return;
        for (const Variable& variable : inspection.variables(inspection.scopes(0)[0].variables))
            json.key_of(variable.name).value(variable.value);
    });
}

}  // namespace

std::string stop_json(const Stop& stop, std::string_view reason, DebugEngine& engine,
                      const Session& session) {
    const TraceState now = engine.inspection().state();
    std::string out;
    JsonWriter json(out);
    json.object([&] {
        json.key("stopped").value(reason);
        put_location(json, stop, engine, session);
        put_axis_values(json.key("position"), now.now.axes, now.now.work);
        put_axis_values(json.key("machine"), now.now.axes, now.now.machine);
        json.key("codes").object([&] {
            for (const macro::ActiveCode& code : now.codes)
                json.key_of(code.group).value(code.code);
        });
        json.key("modal").object([&] {
            for (const ModalEntry& entry : now.modal)
                put_value(json.key_of(entry.name), entry.value);
        });
        json.key("variables").object([&] {
            for (const macro::ControlVariable& variable : engine.execution().variables())
                put_value(json.key_of(variable.name), variable);
        });
        if (stop.is_at_statement()) put_locals(json, engine);
    });
    json.end_line();
    return out;
}

}  // namespace kadr::driver
