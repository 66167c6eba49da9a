#include "repl/replay.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/units.h"
#include "driver/command_tap.h"
#include "driver/execution.h"
#include "driver/session.h"
#include "driver/summary.h"

namespace kadr::repl {

namespace {

// What stands around a value that a program shows, so that it is told from the author's warnings.
constexpr std::string_view kOpen = "⟦";
constexpr std::string_view kClose = "⟧";
constexpr int kDecimals = 3;

/// Takes the messages of one evaluation apart: values that were asked for, and what a person reads.
class Hearing {
  public:
    Hearing(Outcome& outcome, std::vector<std::string>& seen) : outcome_(outcome), seen_(seen) {}

    void take(std::string_view rendered) {
        const std::size_t open = rendered.find(kOpen);
        const std::size_t close = rendered.find(kClose);
        if (open != std::string_view::npos && close != std::string_view::npos && open < close) {
            const std::size_t begin = open + kOpen.size();
            outcome_.values.emplace_back(rendered.substr(begin, close - begin));
            return;
        }
        std::string text(rendered);
        // What is declared at a prompt is read by inputs to come.
        if (text.find("[K2501]") != std::string::npos) return;
        if (std::find(seen_.begin(), seen_.end(), text) != seen_.end()) return;
        outcome_.messages += text;
        heard_.push_back(std::move(text));
    }
    /// What was said about a program that is kept is not said again.
    void remember() { seen_.insert(seen_.end(), heard_.begin(), heard_.end()); }

  private:
    Outcome& outcome_;
    std::vector<std::string>& seen_;
    std::vector<std::string> heard_;
};

/// Cuts the text into lines and keeps those that are wanted.
class LineKeeper {
  public:
    LineKeeper(Outcome& outcome, std::uint32_t known) : outcome_(outcome), known_(known) {}

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

    Outcome& outcome_;
    std::uint32_t known_;
    std::uint32_t number_ = 0;
    std::string line_;
};

std::string axis_text(const path::Command& command) {
    std::string out;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if ((command.moved >> axis & 1u) == 0) continue;
        out += fmt::format(" {}{:.{}f}", kAxisNames[axis], command.to[axis], kDecimals);
    }
    return out;
}

std::string command_text(const path::Command& command) {
    using path::Op;
    switch (command.op) {
        case Op::Rapid: return "rapid to" + axis_text(command);
        case Op::Line: return "line to" + axis_text(command);
        case Op::Thread: return "thread to" + axis_text(command);
        case Op::Probe: return "probe to" + axis_text(command);
        case Op::Arc:
            return std::string(command.is_clockwise ? "arc clockwise to" : "arc to") +
                   axis_text(command);
        case Op::Spline: return "spline to" + axis_text(command);
        case Op::Dwell: return fmt::format("dwell {:g} s", command.time);
        case Op::Spindle:
            if (command.spindle == path::SpindleMode::Stop) return "spindle stops";
            return fmt::format("spindle {:g} {}", command.speed,
                               command.cutting_speed ? "m/min" : "rpm");
        case Op::SpeedLimit: return fmt::format("spindle at most {:g} rpm", command.speed);
        case Op::Tool: return fmt::format("tool {}", command.tool);
        case Op::ToolLength: return fmt::format("tool length {:g} mm", command.length);
        case Op::Coolant:
            return command.coolant == path::CoolantMode::Off ? "coolant off" : "coolant on";
        case Op::Stop: return "stop";
        case Op::OptionalStop: return "optional stop";
        case Op::Message: return "message";
        case Op::End: return "end";
    }
    return "";
}

void list_names(const sema::Code& code, Outcome& outcome) {
    for (const sema::FunctionCode& function : code.functions) {
        if (function.kind == sema::FunctionKind::Startup || function.name == "prompt") continue;
        outcome.names.push_back(function.name);
        for (const sema::ParameterInfo& parameter : function.parameters) {
            outcome.parameters[function.name].push_back(parameter.name);
        }
    }
}

void execute(driver::Execution& execution, Outcome& outcome, LineKeeper& keeper,
             const driver::Options& options) {
    driver::CommandTap tap(execution, [&](const path::Command& command) {
        keeper.done(command.line, command_text(command));
    });
    motion::PlannerOptions planner_options;
    planner_options.tick = options.tick.value_or(0);
    planner_options.place_of = [&execution](std::uint32_t line, SourceId) {
        return execution.place_of(line);
    };
    motion::Planner planner(tap, execution.machine(), planner_options, execution.sink());
    std::vector<motion::Segment> batch(kBatch);
    while (const std::size_t count = planner.pull(batch)) {
        for (const motion::Segment& segment : std::span(batch).first(count)) {
            outcome.scene.add(segment, mm_min_from_feed(segment.feed));
        }
    }
    tap.pass_until(planner.totals().commands);
    outcome.totals = planner.totals();
    outcome.state = execution.interpreter().state();
    outcome.position = execution.interpreter().position();
    const machine::Machine& machine = execution.machine();
    outcome.plot_subtitle = std::string(execution.dialect().title()) + " · " +
                            (machine.title.empty() ? machine.name : machine.title) + " · " +
                            driver::duration_text(outcome.totals.time);
}

}  // namespace

std::string showing_statements(const std::vector<std::string>& expressions) {
    std::string out;
    for (const std::string& expression : expressions) {
        out += "warn(\"" + std::string(kOpen) + '{' + expression + ":u}" + std::string(kClose) +
               "\");\n";
    }
    return out;
}

Outcome replay(const driver::Options& options, const driver::Share& share,
               const ReplayRequest& request, std::vector<std::string>& seen_messages) {
    Outcome outcome;
    Hearing hearing(outcome, seen_messages);
    Sources sources;
    driver::Messages messages(sources, {}, [&](std::string_view text) { hearing.take(text); });
    driver::Options chosen = options;
    chosen.program = "prompt";
    driver::Session session(chosen, share, sources, messages);
    const FileId file = sources.add("prompt.kadr", request.program);
    LineKeeper keeper(outcome, request.known_lines);
    const auto execution = driver::Execution::open(
        session, file, [&keeper](std::string_view piece) { keeper.take(piece); });
    if (execution) {
        execute(*execution, outcome, keeper, chosen);
        keeper.finish(execution->generated()->body_lines());
        list_names(*execution->program()->code, outcome);
    }
    messages.finish();
    outcome.is_ok = execution && session.status() == driver::Status::Done;
    if (outcome.is_ok) hearing.remember();
    return outcome;
}

}  // namespace kadr::repl
