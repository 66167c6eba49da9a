#include "repl/replay.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/units.h"
#include "driver/command_tap.h"
#include "driver/execution.h"
#include "driver/session.h"
#include "driver/summary.h"
#include "process/planned_motion.h"

namespace kadr::repl {

namespace {

constexpr int kDecimals = 3;

/// A message as it is whichever inputs stand before its own: without numbers of lines, with the
/// columns of the quoted source only.
std::string without_lines(std::string_view message) {
    constexpr std::string_view kDigits = "0123456789";
    std::string out;
    for (std::size_t begin = 0; begin < message.size();) {
        const std::size_t end = std::min(message.find('\n', begin), message.size());
        const std::string_view line = message.substr(begin, end - begin);
        const std::size_t gutter = line.find_first_not_of(" 0123456789");
        const std::size_t index = line.find(':');
        const bool is_source =
            line.starts_with(' ') && gutter != std::string_view::npos && line[gutter] == '|';
        if (is_source) {
            out += line.substr(gutter);
        } else if (index != std::string_view::npos) {
            out += line.substr(0, index);
            out += line.substr(std::min(line.find_first_not_of(kDigits, index + 1), line.size()));
        } else {
            out += line;
        }
        out += '\n';
        begin = end + 1;
    }
    return out;
}

/// What a person reads of the messages of one evaluation.
class Hearing {
  public:
    Hearing(ReplayOutcome& outcome, std::vector<std::string> reported_before)
        : outcome_(outcome), messages_(std::move(reported_before)) {}

    void take(std::string_view rendered) {
        const std::string text(rendered);
        // What is declared at a prompt is read by inputs to come.
        if (text.find("[K2501]") != std::string::npos) return;
        outcome_.reported.push_back(without_lines(text));
        const auto known = std::find(messages_.begin(), messages_.end(), outcome_.reported.back());
        if (known == messages_.end()) outcome_.messages += text;
        else messages_.erase(known);  // two inputs with the same mistake are two messages
    }

  private:
    ReplayOutcome& outcome_;
    std::vector<std::string> messages_;
};

/// Cuts the text into lines and keeps those that are wanted.
class LineKeeper {
  public:
    LineKeeper(ReplayOutcome& outcome, std::uint32_t known) : outcome_(outcome), known_(known) {}

    void take(std::string_view piece) {
        for (const char c : piece) {
            if (c != '\n') {
                line_ += c;
                continue;
            }
            if (!line_.empty() && line_.back() == '\r') line_.pop_back();
            if (++number_ > known_) keep();
            line_.clear();
        }
    }
    /// Drops what belongs to the end of the frame.
    void finish(std::uint32_t body_lines) {
        outcome_.lines = body_lines;
        std::erase_if(outcome_.first,
                      [&](const TextLine& line) { return line.number > body_lines; });
        std::erase_if(outcome_.last,
                      [&](const TextLine& line) { return line.number > body_lines; });
    }
    void done(std::uint32_t number, const std::string& what) {
        for (TextLine& line : outcome_.first) {
            if (line.number == number) line.done += (line.done.empty() ? "" : "; ") + what;
        }
    }

  private:
    void keep() {
        TextLine line{number_, line_, {}};
        if (outcome_.first.size() < kFirstLines) {
            outcome_.first.push_back(std::move(line));
            return;
        }
        outcome_.last.push_back(std::move(line));
        // The frame's end is dropped later: a few more than are wanted are kept.
        if (outcome_.last.size() > kLastLines + 16) outcome_.last.pop_front();
    }

    ReplayOutcome& outcome_;
    std::uint32_t known_;
    std::uint32_t number_ = 0;
    std::string line_;
};

std::string axis_text(const path::Command& command) {
    std::string out;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if ((command.motion().moved >> axis & 1u) == 0) continue;
        out += fmt::format(" {}{:.{}f}", kAxisNames[axis], command.motion().to[axis], kDecimals);
    }
    return out;
}

std::string command_text(const path::Command& command) {
    using path::Op;
    switch (command.op()) {
        case Op::Rapid: return "rapid to" + axis_text(command);
        case Op::Line: return "line to" + axis_text(command);
        case Op::Thread: return "thread to" + axis_text(command);
        case Op::Probe: return "probe to" + axis_text(command);
        case Op::Arc:
            return std::string(command.motion().arc().is_clockwise ? "arc clockwise to"
                                                                   : "arc to") +
                   axis_text(command);
        case Op::Spline: return "spline to" + axis_text(command);
        case Op::Involute: return "involute to" + axis_text(command);
        case Op::Parametric: return "curve to" + axis_text(command);
        case Op::Dwell: return fmt::format("dwell {:g} s", command.dwell().time);
        case Op::Spindle:
            if (command.spindle().mode == path::SpindleMode::Stop) return "spindle stops";
            return fmt::format("spindle {:g} {}", command.spindle().speed,
                               command.spindle().has_cutting_speed ? "m/min" : "rpm");
        case Op::OtherSpindle:
            if (command.spindle().mode == path::SpindleMode::Stop)
                return fmt::format("spindle {} stops", command.spindle().number);
            return fmt::format("spindle {}: {:g} rpm", command.spindle().number,
                               command.spindle().speed);
        case Op::SpeedLimit:
            if (command.speed_limit().least == 0)
                return fmt::format("spindle at most {:g} rpm", command.speed_limit().most);
            if (command.speed_limit().most == 0)
                return fmt::format("spindle at least {:g} rpm", command.speed_limit().least);
            return fmt::format("spindle from {:g} to {:g} rpm", command.speed_limit().least,
                               command.speed_limit().most);
        case Op::Tool: return fmt::format("tool {}", command.tool().number);
        case Op::ToolLength:
            return fmt::format("tool length {:g} mm", command.tool_length().length);
        case Op::Coolant:
            return command.coolant().mode == path::CoolantMode::Off ? "coolant off" : "coolant on";
        case Op::Function: return fmt::format("M{}", command.function().code);
        case Op::Stop: return "stop";
        case Op::OptionalStop: return "optional stop";
        case Op::Message: return "message";
        case Op::End: return "end";
        case Op::ScannerOn: return "scanner on";
        case Op::ScannerOff: return "scanner off";
        case Op::External: return fmt::format("external {:g} s", command.external().time);
    }
    return "";
}

void list_names(const sema::Code& code, ReplayOutcome& outcome) {
    for (const sema::FunctionCode& function : code.functions) {
        if (function.kind == sema::FunctionKind::Startup || function.name == "prompt") continue;
        outcome.names.push_back(function.name);
        for (const sema::ParameterInfo& parameter : function.parameters) {
            outcome.parameters[function.name].push_back(parameter.name);
        }
    }
}

void execute(driver::Execution& execution, ReplayOutcome& outcome, LineKeeper& keeper) {
    driver::CommandTap tap(execution, [&](const path::Command& command) {
        keeper.done(command.line, command_text(command));
    });
    motion::PlannerOptions planner_options;
    execution.place_messages(planner_options);
    process::PlannedMotion motion(tap, execution.machine(), planner_options, execution.sink());
    std::vector<motion::Segment> batch(kBatch);
    while (const std::size_t count = motion.pull(batch)) {
        for (const motion::Segment& segment : std::span(batch).first(count)) {
            outcome.scene.add(segment, mm_min_from_feed(segment.feed));
        }
    }
    // A command that the motion refused is shown beside its alarm.
    tap.pass_until(motion.executed() + (motion.alarmed() ? 1 : 0));
    outcome.totals = motion.totals();
    outcome.state = execution.interpreter().state();
    outcome.position = execution.interpreter().position();
    const machine::Machine& machine = execution.machine();
    outcome.plot_subtitle = std::string(execution.dialect().title()) + " · " +
                            (machine.title.empty() ? machine.name : machine.title) + " · " +
                            driver::duration_text(outcome.totals.time);
}

}  // namespace

ReplayOutcome replay(const driver::Options& options, driver::SharedInputs& inputs,
                     const ReplayRequest& request, std::vector<std::string> reported_before) {
    ReplayOutcome outcome;
    Hearing hearing(outcome, std::move(reported_before));
    Sources sources = inputs.new_sources();
    driver::Messages messages(sources, {}, [&](std::string_view text) { hearing.take(text); });
    driver::Options chosen = options;
    chosen.program = "prompt";
    chosen.check = {.shown_from = request.shown_from, .calls_programs = "prompt"};
    chosen.shown = &outcome.values;
    driver::Session session(chosen, inputs, sources, messages);
    const FileId file = sources.add("prompt.kadr", request.program);
    LineKeeper keeper(outcome, request.known_lines);
    const auto execution = driver::Execution::open(
        session, file, [&keeper](std::string_view piece) { keeper.take(piece); });
    if (execution) {
        execute(*execution, outcome, keeper);
        keeper.finish(execution->generated()->body_lines());
        list_names(*execution->program()->code, outcome);
    }
    messages.finish();
    outcome.is_ok = execution && session.status() == driver::Status::Done;
    return outcome;
}

}  // namespace kadr::repl
