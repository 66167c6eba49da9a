#include "driver/trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.h"
#include "base/printable.h"
#include "base/render.h"
#include "base/text.h"
#include "driver/source_map.h"

namespace kadr::driver {

namespace {

constexpr std::size_t kBlockColumns = 34;   // of the table, for the text of a block
constexpr std::size_t kSourceColumns = 26;  // … for the statement behind it

std::string json_number(double value) {
    return std::isfinite(value) ? format_shortest(round_to(value, 9)) : "null";
}

std::string count_text(std::int64_t value) { return std::to_string(value); }

std::string_view spindle_word(path::SpindleMode mode) {
    switch (mode) {
        case path::SpindleMode::Stop: return "\"stop\"";
        case path::SpindleMode::Cw: return "\"cw\"";
        case path::SpindleMode::Ccw: return "\"ccw\"";
        case path::SpindleMode::Orient: return "\"orient\"";
    }
    return "null";
}

std::string_view coolant_word(path::CoolantMode mode) {
    switch (mode) {
        case path::CoolantMode::Off: return "\"off\"";
        case path::CoolantMode::Flood: return "\"flood\"";
        case path::CoolantMode::Mist: return "\"mist\"";
    }
    return "null";
}

/// A JSON value for people: without quotes, and `-` for nothing.
std::string_view plain(std::string_view json) {
    if (json == "null") return "-";
    if (json.size() >= 2 && json.front() == '"') return json.substr(1, json.size() - 2);
    return json;
}

void append_key(std::string& out, std::string_view name) {
    out += ",\"";
    out += name;
    out += "\":";
}

/// `"name":[before,after]` behind what stands there already.
void append_change(std::string& out, std::string_view name, std::string_view before,
                   std::string_view after) {
    if (!out.empty()) out += ',';
    out += json_string(name);
    out += ":[";
    out += before;
    out += ',';
    out += after;
    out += ']';
}

/// Fills up to a width, in characters.
void pad(std::string& out, std::size_t begin, std::size_t width) {
    const std::size_t used = count_code_points(std::string_view(out).substr(begin));
    if (used < width) out.append(width - used, ' ');
}

std::string_view code_of(const std::vector<macro::ActiveCode>& codes, std::string_view group) {
    const auto found = std::find_if(codes.begin(), codes.end(),
                                    [group](const auto& code) { return code.group == group; });
    return found == codes.end() ? std::string_view() : found->code;
}

/// Calls `report` with group, code before and code after for every group whose code is another one.
template <typename Tell>
void each_code_change(const std::vector<macro::ActiveCode>& before,
                      const std::vector<macro::ActiveCode>& after, Tell report) {
    if (before == after) return;
    for (const macro::ActiveCode& code : after) {
        const std::string_view old = code_of(before, code.group);
        if (old != code.code) report(code.group, old, code.code);
    }
    for (const macro::ActiveCode& code : before) {
        if (code_of(after, code.group).empty()) report(code.group, code.code, std::string_view());
    }
}

/// The same for the entries of the modal state.
template <typename Tell>
void each_modal_change(const std::vector<ModalEntry>& before, const std::vector<ModalEntry>& after,
                       Tell report) {
    for (std::size_t i = 0; i < after.size(); ++i) {
        std::string_view old = "null";
        if (i < before.size()) old = before[i].value;
        if (old != after[i].value) report(after[i], old);
    }
}

std::string json_code(std::string_view code) { return code.empty() ? "null" : json_string(code); }

}  // namespace

std::vector<ModalEntry> modal_entries(const interp::Snapshot& now) {
    std::vector<ModalEntry> out = {
        {"feed", "F", now.feed ? json_number(*now.feed) : "null"},
        {"speed", "S", json_number(now.speed)},
        {"spindle", "spindle", std::string(spindle_word(now.spindle))},
        {"tool", "tool", count_text(now.tool)},
        {"selected_tool", "T", count_text(now.selected_tool)},
    };
    // Of machines with several spindles: all of them by their numbers.
    struct Names {
        std::string_view mode;
        std::string_view mode_label;
        std::string_view speed;
        std::string_view speed_label;
    };
    static constexpr std::array<Names, machine::kMostSpindles> kNames = {
        {{"spindle_1", "spindle 1", "speed_1", "S1"},
         {"spindle_2", "spindle 2", "speed_2", "S2"},
         {"spindle_3", "spindle 3", "speed_3", "S3"},
         {"spindle_4", "spindle 4", "speed_4", "S4"}}};
    if (now.master_spindle != 0)
        out.push_back({"master_spindle", "master", count_text(now.master_spindle)});
    for (const auto& spindle : now.spindles) {
        const Names& names = kNames.at(static_cast<std::size_t>(spindle.number) - 1);
        out.push_back({names.mode, names.mode_label, std::string(spindle_word(spindle.mode))});
        out.push_back({names.speed, names.speed_label, json_number(spindle.speed)});
    }
    // Where D calls an edge of the tool there are no numbers of offsets.
    if (now.edge) {
        out.push_back({"edge", "D", count_text(*now.edge)});
    } else {
        out.push_back({"length_offset", "H", count_text(now.length_offset)});
        out.push_back({"radius_offset", "D", count_text(now.radius_offset)});
    }
    const ModalEntry rest[] = {
        {"tool_length", "length", json_number(now.tool_length)},
        {"work_offset", "offset", count_text(now.work_offset)},
        {"coolant", "coolant", std::string(coolant_word(now.coolant))},
        {"cycle", "cycle", now.cycle.empty() ? "null" : json_string(now.cycle)}};
    out.insert(out.end(), std::begin(rest), std::end(rest));
    return out;
}

std::string json_value(const macro::ControlVariable& variable) {
    using Kind = macro::ControlVariable::Kind;
    switch (variable.kind) {
        case Kind::Vacant: return "null";
        case Kind::Text: return json_string(variable.text);
        case Kind::Bool: return variable.number != 0 ? "true" : "false";
        case Kind::Int:
        case Kind::Real: break;
    }
    return std::isfinite(variable.number) ? format_shortest(variable.number) : "null";
}

std::string json_axes(AxisMask axes, const AxisValues& values) {
    std::string out = "{";
    for (std::size_t i = 0; i < kAxes; ++i) {
        if ((axes >> i & 1u) == 0) continue;
        if (out.size() > 1) out += ',';
        out += '"';
        out += kAxisNames[i];
        out += "\":" + json_number(values[i]);
    }
    return out + '}';
}

// ---------------------------------------------------------------- JSON Lines

void Trace::append_json(const TraceStep& step, const TraceState& state, std::string& out) const {
    out += "{\"block\":" + std::to_string(step.block);
    out += ",\"file\":" + json_string(step.file);
    out += ",\"line\":" + std::to_string(step.line);
    if (step.number >= 0) out += ",\"number\":" + std::to_string(step.number);
    if (!step.program.empty()) out += ",\"program\":" + json_string(step.program);
    if (step.level > 0) out += ",\"level\":" + std::to_string(step.level);
    out += ",\"text\":" + json_string(step.text);
    if (step.statement.file.is_valid())
        out += ",\"src\":" + json_string(session_.source_name(step.statement));
    if (step.has_calls) append_calls(out, step.calls, session_);
    std::string members;
    for (const macro::VariableChange& change : step.variables) {
        append_change(members, change.after.name, json_value(change.before),
                      json_value(change.after));
    }
    append_key(out, "variables");
    out += '{' + std::exchange(members, {}) + '}';
    each_code_change(before_.codes, state.codes, [&](auto group, auto before, auto after) {
        append_change(members, group, json_code(before), json_code(after));
    });
    append_key(out, "codes");
    out += '{' + std::exchange(members, {}) + '}';
    each_modal_change(before_.modal, state.modal, [&](const ModalEntry& entry, auto before) {
        append_change(members, entry.name, before, entry.value);
    });
    append_key(out, "modal");
    out += '{' + members + '}';
    append_key(out, "position");
    out += json_axes(state.now.axes, state.now.work);
    append_key(out, "machine");
    out += json_axes(state.now.axes, state.now.machine) + "}\n";
}

// ---------------------------------------------------------------- the table

void Trace::append_head(AxisMask axes, std::string& out) const {
    std::string row = fmt::format("{:>7} {:>9}", "block", "line");
    for (const char* system : {"", "machine "}) {
        bool is_first = true;
        for (std::size_t i = 0; i < kAxes; ++i) {
            if ((axes >> i & 1u) == 0) continue;
            row += fmt::format("{:>11}", (is_first ? system : "") + std::string(kAxisNames[i]));
            is_first = false;
        }
    }
    const std::size_t begin = row.size();
    row += "  text";
    pad(row, begin, kBlockColumns + 2);
    out += row + "  changes\n";
}

/// What a block has changed, variables first: `R1 5 -> 6, G1 -> G0, F - -> 200`.
std::string Trace::changes(const TraceStep& step, const TraceState& state) const {
    std::string out;
    const auto add = [&out](std::string_view name, std::string_view before,
                            std::string_view after) {
        if (!out.empty()) out += ", ";
        out += name;
        if (!name.empty()) out += ' ';
        out += before;
        out += " → ";
        out += after;
    };
    for (const macro::VariableChange& change : step.variables) {
        add(change.after.name, plain(json_value(change.before)), plain(json_value(change.after)));
    }
    // What the program begins with has come from nowhere.
    const auto begin = [&out](std::string_view name, std::string_view value) {
        if (!out.empty()) out += name.empty() ? " " : ", ";
        out += name;
        if (!name.empty()) out += ' ';
        out += value;
    };
    each_code_change(before_.codes, state.codes, [&](auto, auto before, auto after) {
        if (step.block == 0) return begin({}, after);
        add({}, before.empty() ? "-" : before, after.empty() ? "-" : after);
    });
    each_modal_change(before_.modal, state.modal, [&](const ModalEntry& entry, auto before) {
        if (step.block == 0) return begin(entry.label, plain(entry.value));
        add(entry.label, plain(before), plain(entry.value));
    });
    return out;
}

/// Where another program goes on than in the row before: `in 9100`, `back in the main program`.
std::string Trace::entered(const TraceStep& step) const {
    const bool is_same = step.level == level_ && step.program == program_;
    if (is_same || step.block == 0) return {};
    const std::string name = step.level == 0        ? "the main program"
                             : step.program.empty() ? "the same program"
                                                    : step.program;
    return (step.level < level_ ? "back in " : "in ") + name;
}

void Trace::append_row(const TraceStep& step, const TraceState& state, std::string& out) const {
    const std::string line = std::to_string(step.line);
    std::string row = fmt::format("{:>7} {:>9}", step.block,
                                  step.block == 0      ? "-"
                                  : step.file == main_ ? line
                                                       : step.file + ':' + line);
    for (const AxisValues* values : {&state.now.work, &state.now.machine}) {
        for (std::size_t i = 0; i < kAxes; ++i) {
            if ((state.now.axes >> i & 1u) == 0) continue;
            row += fmt::format("{:>11.3f}", round_to((*values)[i], 3) + 0.0);
        }
    }
    std::size_t begin = row.size();
    // Programs that were called stand to the right of their callers.
    row += "  " + std::string(2 * step.level, ' ') +
           (step.block == 0 ? std::string("(begin)") : step.text);
    pad(row, begin, kBlockColumns + 2);
    if (step.statement.file.is_valid()) {
        begin = row.size();
        row += "  " + session_.source_name(step.statement);
        for (auto call = step.calls.calls.rbegin(); call != step.calls.calls.rend(); ++call) {
            row += " < " + std::string(call->function) + ' ' + session_.source_name(call->range);
        }
        pad(row, begin, kSourceColumns + 2);
    }
    const std::string where = entered(step);
    const std::string what = changes(step, state);
    row += "  " + where + (where.empty() || what.empty() ? "" : "; ") + what;
    row.erase(row.find_last_not_of(' ') + 1);
    out += printable(row) + '\n';
}

// ---------------------------------------------------------------- both

void Trace::append(const TraceStep& step, TraceState state, std::string& out) {
    if (format_ == TraceFormat::Json) {
        append_json(step, state, out);
    } else {
        if (!has_state_) append_head(state.now.axes, out);
        append_row(step, state, out);
        program_ = step.program;
        level_ = step.level;
    }
    has_state_ = true;
    before_ = std::move(state);
}

void Trace::append_alarm(std::string_view text, std::string& out) const {
    if (format_ == TraceFormat::Json) {
        out += "{\"alarm\":" + json_string(text) + "}\n";
    } else {
        out += "# not complete, ended by " + printable(text) + '\n';
    }
}

}  // namespace kadr::driver
