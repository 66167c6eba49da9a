#include "driver/debugger.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostics/driver.h"
#include "base/numbers.h"
#include "base/printable.h"
#include "base/text.h"
#include "nc/tables.h"

namespace kadr::driver {

namespace {

constexpr const char* kHelp =
    ":step       execute this block, stop in front of the next; an empty line does it again\n"
    ":continue   on to the next break point\n"
    ":state      position, codes, feed, speed, tool\n"
    ":vars [R]   variables of the control; those that begin so\n"
    ":calls      the calls of the Kadr program that led here\n"
    ":break N50  stop there too\n"
    ":quit       the program ends here\n";

bool is_same_value(const macro::ControlVariable& a, const macro::ControlVariable& b) {
    return a.kind == b.kind && a.number == b.number && a.text == b.text;
}

/// Each variable once, from its first value in the block to its last; without those that have it
/// back.
std::vector<macro::VariableChange> summed_up(std::vector<macro::VariableChange>& changes) {
    std::vector<macro::VariableChange> sum;
    for (macro::VariableChange& change : changes) {
        const auto known = std::find_if(sum.begin(), sum.end(), [&](const auto& other) {
            return other.after.name == change.after.name;
        });
        if (known == sum.end()) {
            sum.push_back(std::move(change));
        } else {
            known->after = std::move(change.after);
        }
    }
    sum.erase(std::remove_if(
                  sum.begin(), sum.end(),
                  [](const auto& change) { return is_same_value(change.before, change.after); }),
              sum.end());
    changes.clear();
    return sum;
}

std::string position_text(std::string_view label, AxisMask axes, const AxisValues& values) {
    std::string out = fmt::format("{:<9}", label);
    for (std::size_t i = 0; i < kAxes; ++i) {
        if ((axes >> i & 1u) == 0) continue;
        out += fmt::format(" {}{:.3f}", kAxisNames[i], round_to(values[i], 3) + 0.0);
    }
    return out + '\n';
}

}  // namespace

Done Debugger::take_watched_points(const std::vector<std::string>& texts,
                                   std::vector<WatchedPoint>& points, DiagnosticSink& sink) {
    for (const std::string& text : texts) {
        auto point = BreakPoint::parse(text);
        if (!point) {
            sink.report(diag::PlaceUnclear).arg(text);
            return kFailed;
        }
        points.push_back({std::move(*point), false});
    }
    return kDone;
}

std::unique_ptr<Debugger> Debugger::open(Session& session, const RunJob& job, Look look) {
    std::unique_ptr<Debugger> debugger(new Debugger(session, job, std::move(look)));
    Messages& messages = session.messages();
    if (!take_watched_points(job.breaks, debugger->breaks_, messages)) return nullptr;
    if (!take_watched_points(job.until, debugger->until_, messages)) return nullptr;
    return debugger;
}

// ---------------------------------------------------------------- the steps

TraceState Debugger::state() {
    TraceState state;
    state.now = execution_->interpreter().snapshot();
    state.codes = execution_->reader().codes();
    state.modal = modal_entries(state.now);
    return state;
}

void Debugger::find_statement(TraceStep& step) const {
    const GeneratedText* generated = execution_->generated();
    if (generated == nullptr) return;
    const auto line = static_cast<std::uint32_t>(step.line);
    step.statement = execution_->statement(generated->lines().find(line));
    const expand::BlockOrigin* calls = generated->calls_behind(line);
    step.has_calls = calls != nullptr;
    if (step.has_calls) step.calls = *calls;
}

void Debugger::begin_step(const macro::WatchedLine& line) {
    TraceStep& step = step_.emplace();
    step.file = line.file.empty() ? execution_->text_name() : std::string(line.file);
    step.line = line.line;
    step.number = line.number;
    step.program = line.program;
    step.level = line.level;
    step.text = line.text;
    if (line.file.empty()) find_statement(step);
    changes_.clear();
    blocks_before_ = execution_->blocks();
    statements_before_ = execution_->reader().statements();
}

/// The line is executed; one on which nothing was, a comment or a label, is none for the trace.
void Debugger::end_step() {
    if (!step_) return;
    const bool was_executed = execution_->blocks() != blocks_before_ ||
                              execution_->reader().statements() != statements_before_;
    if (look_ && was_executed) {
        step_->block = ++traced_;
        step_->variables = summed_up(changes_);
        look_(*step_, state());
    }
    step_.reset();
}

void Debugger::finish(const std::string& alarm) {
    end_step();
    if (!alarm.empty()) return;
    warn_of(breaks_);
    warn_of(until_);
}

void Debugger::warn_of(const std::vector<WatchedPoint>& points) {
    for (const WatchedPoint& point : points) {
        if (point.was_reached) continue;
        session_.messages().report(diag::PlaceNeverReached).arg(point.point.text());
    }
}

// ---------------------------------------------------------------- break points

FileLine Debugger::lines_of(const SourceRange& range) const {
    if (!range.file.is_valid()) return {};
    const Sources& sources = session_.sources();
    return {sources.name(range.file), sources.locate(range.file, range.begin).line,
            sources.locate(range.file, range.end).line};
}

StopArrival Debugger::arrival_at(const macro::WatchedLine& line) {
    StopArrival arrival;
    arrival.has_number = line.number >= 0;
    arrival.number = arrival.has_number ? static_cast<std::uint64_t>(line.number) : 0;
    arrival.label = line.label;
    if (line.program != program_ || line.level > level_) arrival.program = line.program;
    const nc::CallLanguage& calls_of_control = execution_->dialect().tables().language.calls;
    if (!arrival.program.empty())
        arrival.program_head = nc::shown_program(calls_of_control, arrival.program);
    program_ = line.program;
    level_ = line.level;
    arrival.text = {step_->file, line.line, line.line};
    arrival.statement = lines_of(step_->statement);
    const KadrProgram* program = execution_->program();
    arrival.started = program == nullptr ? std::string_view(execution_->text_name())
                                         : std::string_view(session_.sources().name(program->file));
    const auto& calls = step_->calls.calls;
    for (std::size_t i = calls_.known_calls(step_->calls); i < calls.size(); ++i)
        arrival.entered.push_back({calls[i].function, lines_of(calls[i].range)});
    return arrival;
}

const Debugger::WatchedPoint* Debugger::find(std::vector<WatchedPoint>& points,
                                             const StopArrival& arrival) {
    const WatchedPoint* found = nullptr;
    for (WatchedPoint& point : points) {
        if (!point.point.is_at(arrival)) continue;
        point.was_reached = true;
        if (found == nullptr) found = &point;
    }
    return found;
}

bool Debugger::comes_to(const macro::WatchedLine& line) {
    end_step();
    if (look_ && !has_begun_) {
        TraceStep begin;
        begin.file = execution_->text_name();
        look_(begin, state());
    }
    has_begun_ = true;
    begin_step(line);
    if (breaks_.empty() && until_.empty() && !is_stepping_) return true;
    const StopArrival arrival = arrival_at(line);
    if (find(until_, arrival) != nullptr) {
        step_.reset();
        return false;
    }
    const WatchedPoint* reached = find(breaks_, arrival);
    if (reached == nullptr && !is_stepping_) return true;
    const std::string reason =
        reached == nullptr ? "stopped" : "stopped before `" + reached->point.text() + '`';
    if (stop(reason)) return true;
    step_.reset();
    return false;
}

// ---------------------------------------------------------------- the conversation

void Debugger::say(const std::string& text) const {
    if (job_.onlooker.say) job_.onlooker.say(text);
}

/// Whether the program goes on.
bool Debugger::stop(std::string_view reason) {
    is_stepping_ = false;
    show_stop(reason);
    if (!job_.onlooker.ask) return false;
    for (;;) {
        const std::optional<std::string> command = job_.onlooker.ask();
        if (!command) return false;
        bool is_over = false;
        if (obey(*command, is_over)) return !is_over;
    }
}

/// Does what a command asks. True: the conversation is over; `is_over`: the program too.
bool Debugger::obey(std::string_view line, bool& is_over) {
    const std::size_t begin = std::min(line.find_first_not_of(" \t:"), line.size());
    line.remove_prefix(begin);
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    std::string again;
    if (line.empty()) {
        again = last_command_;
        line = again;
    }
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    const std::string_view name = line.substr(0, end);
    const std::string_view rest =
        line.substr(std::min(line.find_first_not_of(" \t", end), line.size()));
    const auto is = [name](std::string_view command) {
        return !name.empty() && command.starts_with(name);
    };
    if (is("step")) is_stepping_ = true;
    if (is("step") || is("continue")) {
        last_command_ = std::string(line);
        return true;
    }
    if (is("quit")) return is_over = true;
    if (is("state")) {
        show_position();
        show_state();
    } else if (is("vars")) {
        show_variables(rest);
    } else if (is("calls")) {
        show_calls();
    } else if (is("break")) {
        auto point = BreakPoint::parse(rest);
        if (!point) {
            say("a location is missing: `:break N120`, `:break :34`, `:break NAME`\n");
        } else {
            breaks_.push_back({std::move(*point), true});
        }
    } else {
        say(kHelp);
    }
    return false;
}

void Debugger::show_stop(std::string_view reason) {
    if (job_.onlooker.reads_json) return say(stop_json(reason));
    const TraceStep& step = *step_;
    std::string out = fmt::format("{}:{}: {}\n", step.file, step.line, reason);
    const std::string number = fmt::format("{:>4}", step.line);
    const std::size_t indent = std::min(step.text.find_first_not_of(" \t"), step.text.size());
    out += number + " | " + printable(step.text) + '\n';
    out += std::string(number.size(), ' ') + " | " + std::string(indent, ' ') + "^\n";
    if (step.statement.file.is_valid())
        out += "     by " + session_.source_name(step.statement) + '\n';
    say(out);
    show_position();
    if (job_.onlooker.ask) return;
    // Nobody asks for more: all of it.
    show_state();
    show_variables({});
    show_calls();
}

void Debugger::show_position() {
    const interp::Snapshot now = execution_->interpreter().snapshot();
    say(position_text("position", now.axes, now.work) +
        position_text("machine", now.axes, now.machine));
}

void Debugger::show_state() {
    const TraceState now = state();
    std::string out = "codes    ";
    for (const macro::ActiveCode& code : now.codes) out += ' ' + std::string(code.code);
    out += '\n';
    for (const ModalEntry& entry : now.modal)
        out += fmt::format("{:<14} {}\n", entry.name, modal_text(entry.value, "none"));
    say(out);
}

void Debugger::show_variables(std::string_view part) {
    std::string out;
    const std::string wanted = upper_ascii(part);
    for (const macro::ControlVariable& variable : execution_->variables()) {
        if (!upper_ascii(variable.name).starts_with(wanted)) continue;
        out += variable.name + " = " + json_text(variable) + '\n';
    }
    say(out.empty() ? "no variables\n" : out);
}

void Debugger::show_calls() {
    std::string out;
    const auto& calls = step_->calls.calls;
    for (auto call = calls.rbegin(); call != calls.rend(); ++call) {
        out += "in " + std::string(call->function) + ", called at " +
               session_.source_name(call->range) + '\n';
    }
    if (!out.empty()) say(out);
}

std::string Debugger::stop_json(std::string_view reason) {
    const TraceStep& step = *step_;
    const TraceState now = state();
    std::string out;
    JsonWriter json(out);
    json.object([&] {
        json.key("stopped").value(reason);
        json.key("file").value(step.file);
        json.key("line").value(step.line);
        json.key("text").value(step.text);
        if (step.statement.file.is_valid())
            json.key("src").value(session_.source_name(step.statement));
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
            for (const macro::ControlVariable& variable : execution_->variables())
                put_value(json.key_of(variable.name), variable);
        });
    });
    json.end_line();
    return out;
}

}  // namespace kadr::driver
