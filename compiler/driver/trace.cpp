#include "driver/trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.h"
#include "base/printable.h"
#include "base/text.h"
#include "driver/source_map.h"

namespace kadr::driver {

namespace {

constexpr std::size_t kBlockColumns = 34;   // of the table, for the text of a block
constexpr std::size_t kSourceColumns = 26;  // … for the statement behind it

ModalValue number_value(double value) {
    if (!std::isfinite(value)) return {};
    return round_to(value, 9);
}

ModalValue word_value(path::SpindleMode mode) {
    switch (mode) {
        case path::SpindleMode::Stop: return "stop";
        case path::SpindleMode::Cw: return "cw";
        case path::SpindleMode::Ccw: return "ccw";
        case path::SpindleMode::Orient: return "orient";
    }
    return {};
}

ModalValue word_value(path::CoolantMode mode) {
    switch (mode) {
        case path::CoolantMode::Off: return "off";
        case path::CoolantMode::Flood: return "flood";
        case path::CoolantMode::Mist: return "mist";
    }
    return {};
}

ModalValue word_value(std::string_view word) {
    if (word.empty()) return {};
    return std::string(word);
}

/// A value of a variable for people: without quotes, and `-` for nothing.
std::string plain(const macro::ControlVariable& variable) {
    const std::string text = json_text(variable);
    if (text == "null") return "-";
    return text.front() == '"' ? text.substr(1, text.size() - 2) : text;
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
        const ModalValue old = i < before.size() ? before[i].value : ModalValue();
        if (old != after[i].value) report(after[i], old);
    }
}

void put_code(JsonWriter& json, std::string_view code) {
    if (code.empty()) json.null();
    else json.value(code);
}

}  // namespace

std::vector<ModalEntry> modal_entries(const interp::Snapshot& now) {
    std::vector<ModalEntry> out = {
        {"feed", "F", now.feed ? number_value(*now.feed) : ModalValue()},
        {"speed", "S", number_value(now.speed)},
        {"spindle", "spindle", word_value(now.spindle)},
        {"tool", "tool", now.tool},
        {"selected_tool", "T", now.selected_tool},
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
    if (now.master_spindle != 0) out.push_back({"master_spindle", "master", now.master_spindle});
    for (const auto& spindle : now.spindles) {
        const Names& names = kNames.at(static_cast<std::size_t>(spindle.number) - 1);
        out.push_back({names.mode, names.mode_label, word_value(spindle.mode)});
        out.push_back({names.speed, names.speed_label, number_value(spindle.speed)});
    }
    // Where D calls an edge of the tool there are no numbers of offsets.
    if (now.edge) {
        out.push_back({"edge", "D", *now.edge});
    } else {
        out.push_back({"length_offset", "H", now.length_offset});
        out.push_back({"radius_offset", "D", now.radius_offset});
    }
    const ModalEntry rest[] = {{"tool_length", "length", number_value(now.tool_length)},
                               {"work_offset", "offset", now.work_offset},
                               {"coolant", "coolant", word_value(now.coolant)},
                               {"cycle", "cycle", word_value(now.cycle)}};
    out.insert(out.end(), std::begin(rest), std::end(rest));
    return out;
}

std::string modal_text(const ModalValue& value, std::string_view nothing) {
    struct Shown {
        std::string_view nothing;
        std::string operator()(std::monostate) const { return std::string(nothing); }
        std::string operator()(double number) const { return format_shortest(number); }
        std::string operator()(std::int64_t count) const { return std::to_string(count); }
        std::string operator()(const std::string& word) const { return word; }
    };
    return std::visit(Shown{nothing}, value);
}

std::string json_text(const macro::ControlVariable& variable) {
    std::string text;
    JsonWriter json(text);
    put_value(json, variable);
    return text;
}

void put_value(JsonWriter& json, const ModalValue& value) {
    struct Put {
        JsonWriter& json;
        void operator()(std::monostate) const { json.null(); }
        void operator()(double number) const { json.number(number); }
        void operator()(std::int64_t count) const { json.value(count); }
        void operator()(const std::string& word) const { json.value(word); }
    };
    std::visit(Put{json}, value);
}

void put_value(JsonWriter& json, const macro::ControlVariable& variable) {
    using Kind = macro::ControlVariable::Kind;
    switch (variable.kind) {
        case Kind::Vacant: json.null(); return;
        case Kind::Text: json.value(variable.text); return;
        case Kind::Bool: json.value(variable.number != 0); return;
        case Kind::Int:
        case Kind::Real: break;
    }
    json.number(variable.number);
}

void put_axis_values(JsonWriter& json, AxisMask axes, const AxisValues& values) {
    json.object([&] {
        for (std::size_t i = 0; i < kAxes; ++i) {
            if ((axes >> i & 1u) != 0) json.key_of(kAxisNames[i]).rounded(values[i], 9);
        }
    });
}

// ---------------------------------------------------------------- JSON Lines

/// Which block it is, and where it stands.
void Trace::put_step(JsonWriter& json, const TraceStep& step) const {
    json.key("block").value(step.block);
    json.key("file").value(step.file);
    json.key("line").value(step.line);
    if (step.number >= 0) json.key("number").value(step.number);
    if (!step.program.empty()) json.key("program").value(step.program);
    if (step.level > 0) json.key("level").value(step.level);
    json.key("text").value(step.text);
    if (step.statement.file.is_valid()) json.key("src").value(session_.source_name(step.statement));
    if (step.has_calls) put_calls(json, step.calls, session_);
}

void Trace::append_json(const TraceStep& step, const TraceState& state, std::string& out) const {
    JsonWriter json(out);
    // `"name":[before,after]`
    const auto put_variable = [&](const macro::VariableChange& change) {
        json.key_of(change.after.name).array([&] {
            put_value(json, change.before);
            put_value(json, change.after);
        });
    };
    const auto put_group = [&](auto group, auto before, auto after) {
        json.key_of(group).array([&] {
            put_code(json, before);
            put_code(json, after);
        });
    };
    const auto put_entry = [&](const ModalEntry& entry, const ModalValue& before) {
        json.key_of(entry.name).array([&] {
            put_value(json, before);
            put_value(json, entry.value);
        });
    };
    json.object([&] {
        put_step(json, step);
        json.key("variables").object([&] {
            for (const macro::VariableChange& change : step.variables) put_variable(change);
        });
        json.key("codes").object([&] { each_code_change(before_.codes, state.codes, put_group); });
        json.key("modal").object([&] { each_modal_change(before_.modal, state.modal, put_entry); });
        put_axis_values(json.key("position"), state.now.axes, state.now.work);
        put_axis_values(json.key("machine"), state.now.axes, state.now.machine);
    });
    json.end_line();
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
        add(change.after.name, plain(change.before), plain(change.after));
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
    const auto report = [&](const ModalEntry& entry, const ModalValue& before) {
        if (step.block == 0) return begin(entry.label, modal_text(entry.value, "-"));
        add(entry.label, modal_text(before, "-"), modal_text(entry.value, "-"));
    };
    each_modal_change(before_.modal, state.modal, report);
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
        JsonWriter json(out);
        json.object([&] { json.key("alarm").value(text); });
        json.end_line();
    } else {
        out += "# not complete, ended by " + printable(text) + '\n';
    }
}

}  // namespace kadr::driver
