#include "driver/run.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "base/diagnostics/driver.h"
#include "base/diagnostics/machine.h"
#include "base/done.h"
#include "base/numbers.h"
#include "base/readable.h"
#include "base/units.h"
#include "driver/command_tap.h"
#include "driver/debug/conversation.h"
#include "driver/execution.h"
#include "driver/operator_events.h"
#include "driver/output.h"
#include "driver/output_names.h"
#include "driver/outputs.h"
#include "driver/pipeline_stages.h"
#include "driver/short_waits.h"
#include "motion/path_check.h"
#include "motion/pipeline.h"
#include "process/planned_motion.h"

namespace kadr::driver {

namespace {

/// An output that was asked for, its file open before the run begins.
struct OpenOutput {
    const OutputRow* row = nullptr;
    std::unique_ptr<Output> file;
    std::unique_ptr<RunOutput> output;
    Wants wants;
};

/// The outputs that want to see something of a kind.
struct Viewers {
    std::vector<RunOutput*> commands;
    std::vector<RunOutput*> segments;
    std::vector<RunOutput*> setpoints;
    std::vector<RunOutput*> speed_losses;
    std::vector<RunOutput*> scanner_lists;
    std::vector<RunOutput*> steps;

    void take(RunOutput& output, const Wants& wants) {
        if (wants.commands) commands.push_back(&output);
        if (wants.segments) segments.push_back(&output);
        if (wants.setpoints) setpoints.push_back(&output);
        if (wants.speed_losses) speed_losses.push_back(&output);
        if (wants.scanner_lists) scanner_lists.push_back(&output);
        if (wants.steps) steps.push_back(&output);
    }
};

/// Counts what a program prints and nobody gets.
class LostLines final : public macro::PrintTarget {
  public:
    void line(std::string_view) override { ++count_; }
    std::size_t count() const { return count_; }

  private:
    std::size_t count_ = 0;
};

bool asks_for_nothing(const RunJob& job) {
    const auto is_asked = [&](const OutputRow& row) {
        return row.kind != OutputRow::Kind::Setting && !job.value_of(row.flag).empty();
    };
    return job.breaks.empty() && std::ranges::none_of(output_rows(), is_asked);
}

/// Where an output goes; empty: nobody asked for it.
std::string destination_of(const OutputRow& row, const RunJob& job) {
    const std::string& value = job.value_of(row.flag);
    switch (row.kind) {
        case OutputRow::Kind::File:
        case OutputRow::Kind::FileOfExpansion: return value;
        case OutputRow::Kind::Word: return value.empty() && !asks_for_nothing(job) ? "" : "-";
        case OutputRow::Kind::Setting: return {};
    }
    return {};
}

/// Looks at planned motion on its way to the sampler, at each piece and behind each batch.
class SegmentTap final : public Stream<motion::Segment> {
  public:
    using Look = std::function<void(motion::Segment&)>;
    SegmentTap(Stream<motion::Segment>& segments, Look look, std::function<void()> report)
        : segments_(segments), look_(std::move(look)), report_(std::move(report)) {}

    std::size_t pull(std::span<motion::Segment> out) override {
        const std::size_t count = segments_.pull(out);
        for (motion::Segment& segment : out.first(count)) look_(segment);
        report_();
        return count;
    }

  private:
    Stream<motion::Segment>& segments_;
    Look look_;
    std::function<void()> report_;
};

/// For the message.
std::string_view what_is_off(motion::DeviationKind fault) {
    switch (fault) {
        case motion::DeviationKind::Tip: return "the tip";
        case motion::DeviationKind::LeftOut: return "the end of a motion, which is passed by,";
        case motion::DeviationKind::Tool: return "the direction of the tool";
        case motion::DeviationKind::Followers: return "an axis beside X, Y and Z";
        case motion::DeviationKind::End: return "the end of the path";
    }
    return "";
}

class Run {
  public:
    Run(Session& session, const RunJob& job, const std::function<void(motion::Segment&)>& spoil)
        : session_(session), job_(job), spoil_(spoil) {}
    Status perform();

  private:
    Done open_events();
    Done check_events() const;
    Done open_outputs(bool is_kadr);
    Done open_output(const OutputRow& row, const std::string& name);
    Done open_machine_output();
    Done open_debugger();
    Done look_on(Aside& aside);
    Done follow();
    std::function<void(const nc::Block&)> block_look();
    bool wants(bool Wants::*what) const;

    void execute();
    void end_debugging();
    motion::PlannerOptions planner_options();
    void see(motion::Segment& segment);
    void sample(Stream<motion::Segment>& segments, double tick);
    void see_setpoints(std::span<const motion::Setpoint> some);
    void finish_check(const motion::PlannerOptions& options);
    void report_events_ahead();
    bool has_threads() const;
    RunFigures figures(const process::PlannedMotion& motion) const;
    void finish(const RunFigures& figures);
    Status commit();
    Status refused() {
        session_.mark_usage();
        return session_.status();
    }

    Session& session_;
    const RunJob& job_;
    const std::function<void(motion::Segment&)>& spoil_;  // empty: nobody makes the motion wrong
    std::vector<OpenOutput> outputs_;
    Viewers viewers_;
    LostLines lost_;
    std::unique_ptr<DebugEngine> debugger_;       // null: nobody looks on
    std::unique_ptr<Conversation> conversation_;  // … or is told of it
    std::unique_ptr<Execution> execution_;
    std::vector<motion::OperatorEvent> events_;      // what the operator does
    std::vector<interp::ProbeTouch> touches_;        // … where its probe touches
    std::vector<macro::InputEvent> input_events_;    // … what the machine gives meanwhile
    std::map<std::uint32_t, std::int32_t> numbers_;  // of the lines of blocks that events name
    std::unique_ptr<motion::PathCheck> check_;       // null: no setpoints are made
    std::atomic<std::uint64_t> setpoints_ = 0;       // progress is reported by another thread
    std::uint64_t commands_ = 0;
};

/// Names first: nothing is opened if two are one file.
Done Run::open_outputs(bool is_kadr) {
    Messages& messages = session_.messages();
    std::vector<const OutputRow*> asked;
    std::vector<std::string> names;
    for (const OutputRow& row : output_rows()) {
        std::string name = destination_of(row, job_);
        if (name.empty()) continue;
        asked.push_back(&row);
        names.push_back(std::move(name));
    }
    if (!require_outputs_apart(session_.files(), job_.source, names, messages)) return kFailed;
    for (const OutputRow* row : asked) {
        if (row->kind != OutputRow::Kind::FileOfExpansion || is_kadr) continue;
        messages.report(diag::NoSourceMap).arg(job_.source);
        return kFailed;
    }
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (!open_output(*asked[i], names[i])) return kFailed;
    }
    return kDone;
}

/// Opens the file and makes the output that writes into it.
Done Run::open_output(const OutputRow& row, const std::string& name) {
    OpenOutput open;
    open.row = &row;
    open.file = Output::open(session_.files(), name, session_.messages(), session_.output_rules());
    if (!open.file) return kFailed;
    open.output = row.make({session_, job_, *open.file});
    open.wants = open.output->wants();
    viewers_.take(*open.output, open.wants);
    const auto behind = std::ranges::upper_bound(
        outputs_, row.turn, {}, [](const OpenOutput& other) { return other.row->turn; });
    outputs_.insert(behind, std::move(open));
    return kDone;
}

bool Run::wants(bool Wants::*what) const {
    return std::ranges::any_of(outputs_,
                               [what](const OpenOutput& open) { return open.wants.*what; });
}

/// How the motion is planned, and who is told of it.
motion::PlannerOptions Run::planner_options() {
    motion::PlannerOptions options;
    options.lookahead = execution_->machine().pipeline.ahead;
    options.feed_override = job_.feed_override;
    options.rapid_override = job_.rapid_override;
    options.events = events_;
    options.number_of = [this](std::uint32_t line) {
        const auto found = numbers_.find(line);
        return found == numbers_.end() ? -1 : found->second;
    };
    if (wants(&Wants::speed_losses)) {
        options.report_loss = [this](const motion::SpeedLoss& loss) {
            for (RunOutput* output : viewers_.speed_losses) output->see_speed_loss(loss);
        };
    }
    execution_->place_messages(options);
    return options;
}

void Run::see(motion::Segment& segment) {
    if (spoil_) spoil_(segment);
    for (RunOutput* output : viewers_.segments) output->see_segment(segment);
    // For the setpoints, whose thread must not ask what is being executed.
    if (!macro::NcProgram::is_in_main_text(segment.line))
        segment.line = execution_->location_of(segment.line).line;
}

void Run::execute() {
    const machine::Machine& machine = execution_->machine();
    const auto look = [this](const path::Command& command) {
        ++commands_;
        for (RunOutput* output : viewers_.commands) output->see_command(command);
    };
    // An alarm of the motion has to come before the next block is shown.
    CommandTap tap(*execution_, look, debugger_ ? 1 : 0);
    process::PlannedMotion::Onlookers onlookers;
    onlookers.list = [this](const process::StartedList& list) {
        for (RunOutput* output : viewers_.scanner_lists) output->see_scanner_list(list);
    };
    const double tick = session_.options().tick.value_or(0);
    if (wants(&Wants::setpoints)) {
        check_ = std::make_unique<motion::PathCheck>(machine, tick);
        onlookers.command = [this](const path::Command& command) { check_->read(command); };
    }
    const motion::PlannerOptions options = planner_options();
    process::PlannedMotion motion(tap, machine, options, execution_->sink(), std::move(onlookers));
    SegmentTap segments(
        motion, [this](motion::Segment& segment) { see(segment); },
        [&] {
            session_.report({execution_->blocks(), setpoints_, motion.planned_time()});
        });
    if (check_) {
        sample(segments, tick);
        finish_check(options);
    } else {
        std::vector<motion::Segment> batch(kBatch);
        while (segments.pull(batch) > 0) continue;
    }
    tap.pass_until(motion.executed());
    for (const motion::OperatorEvent& event : motion.events_ahead())
        session_.messages()
            .report(diag::OperatorBlockNotBegun)
            .arg(block_name(event.number, event.line));
    report_events_ahead();
    if (lost_.count() > 0) session_.messages().report(diag::PrintLost).arg(lost_.count());
    end_debugging();
    finish(figures(motion));
}

/// Shows once more where the run has ended. A program that came to its end by itself is evaluated
/// as far behind it as it is without anybody who looks on: its errors there count.
void Run::end_debugging() {
    if (!debugger_) return;
    const std::string& alarm = session_.messages().first_alarm();
    debugger_->finish(alarm);
    if (!debugger_->has_ended_run()) execution_->finish_text();
    if (alarm.empty()) conversation_->warn_of_places();
}

/// What was to happen at a block or a time to which the run did not come.
void Run::report_events_ahead() {
    const auto report = [this](const std::string& what, const std::string& why) {
        session_.messages().report(diag::EventNotMet).arg(what).arg(why);
    };
    const auto name = [](const auto& event) { return block_name(event.number, event.line); };
    for (const auto& ahead : std::as_const(*execution_).reader().events_ahead())
        report(ahead.event->text, ahead.has_begun ? "the run ends before"
                                                  : "no block begins at " + name(*ahead.event));
    for (const interp::ProbeTouch& touch : execution_->interpreter().touches_ahead())
        report("touch", "no probing block begins at " + name(touch));
}

/// Whoever looks on wants to see one thing after the other.
bool Run::has_threads() const {
    if (debugger_) return false;
    return job_.threads.value_or(std::thread::hardware_concurrency() > 1);
}

/// Walks the motion at the tick, for those who want to see it.
void Run::sample(Stream<motion::Segment>& segments, double tick) {
    const machine::Machine& machine = execution_->machine();
    // Who draws needs no ticks of a long wait.
    const bool has_all = wants(&Wants::every_tick);
    ShortWaits waits(segments, tick > 0 ? tick : machine.tick);
    Stream<motion::Segment>& walked =
        has_all ? segments : static_cast<Stream<motion::Segment>&>(waits);
    run_stages(walked, machine, tick, has_threads(),
               {.write =
                    [&](std::span<const motion::Setpoint> some) {
                        see_setpoints(has_all ? some : waits.restored(some));
                    },
                .has_enough =
                    [this] {
                        return execution_->is_time_over() || check_->deviation().has_value() ||
                               session_.output_limit().is_over();
                    }});
    execution_->end_in_time();
}

/// The end of the path is to be reached unless something was reported that keeps the motion from
/// it.
void Run::finish_check(const motion::PlannerOptions& options) {
    const Messages& messages = session_.messages();
    const bool is_whole = !session_.output_limit().is_over();
    if (is_whole && messages.errors() == 0 && messages.alarms() == 0) check_->finish();
    const std::optional<motion::PathDeviation>& deviation = check_->deviation();
    if (!deviation) return;
    const auto amount = [&](double value) {
        const bool is_angle = deviation->fault == motion::DeviationKind::Tool;
        return readable(round_to(is_angle ? deg_from_rad(value) : value, 9)) +
               (is_angle                                               ? " deg"
                : deviation->fault == motion::DeviationKind::Followers ? ""
                                                                       : " mm");
    };
    motion::report(execution_->sink(), diag::PathLeft, deviation->motion, options.locate_command)
        .arg(what_is_off(deviation->fault))
        .arg(amount(deviation->distance))
        .arg(round_to(deviation->time, 6))
        .arg(amount(deviation->allowed));
}

void Run::see_setpoints(std::span<const motion::Setpoint> some) {
    if (!check_->follow(some)) return;
    for (RunOutput* output : viewers_.setpoints) output->see_setpoints(some);
    if (wants(&Wants::every_tick)) setpoints_ += some.size();
}

RunFigures Run::figures(const process::PlannedMotion& motion) const {
    const Messages& messages = session_.messages();
    RunFigures figures;
    figures.source =
        job_.source == "-" ? "<stdin>" : std::filesystem::path(job_.source).filename().string();
    figures.dialect = execution_->dialect().title();
    figures.blocks = execution_->blocks();
    figures.commands = commands_;
    figures.setpoints = setpoints_;
    figures.errors = messages.errors();
    figures.alarms = messages.alarms();
    figures.warnings = messages.warnings();
    figures.alarm = messages.first_alarm();
    figures.totals = motion.totals();
    figures.pulses = motion.pulses();
    if (motion.scan() != nullptr) figures.scan = *motion.scan();
    return figures;
}

void Run::finish(const RunFigures& figures) {
    for (const OpenOutput& open : outputs_) open.output->finish(figures);
}

/// What the operator does, from the options and from a file.
Done Run::open_events() {
    events_ = job_.operator_events;
    if (job_.events.empty()) return kDone;
    const auto more = read_events(session_, job_.events);
    if (!more) return kFailed;
    events_.insert(events_.end(), more->panel.begin(), more->panel.end());
    input_events_ = more->inputs;
    touches_ = more->touches;
    return kDone;
}

/// The laser does not pulse while the operator intervenes.
Done Run::check_events() const {
    const machine::Machine& machine = execution_->machine();
    const bool has_pulses = machine.laser && machine.laser->pulse > 0;
    if (events_.empty() || !has_pulses) return kDone;
    session_.messages().report(diag::OperatorAndPulses).arg(machine.name);
    return kFailed;
}

/// The setpoints that the machine file asks for, unless the command line tells where they go.
Done Run::open_machine_output() {
    const OutputRow& row = output_row("--setpoints");
    std::string name = execution_->machine().pipeline.setpoints.file;
    if (name.empty() || !job_.value_of(row.flag).empty()) return kDone;
    constexpr std::string_view kProgram = "{program}";
    const std::string program =
        job_.source == "-" ? "stdin" : std::filesystem::path(job_.source).stem().string();
    if (const std::size_t at = name.find(kProgram); at != std::string::npos)
        name.replace(at, kProgram.size(), program);
    // A machine file may come from somebody else: it writes where the command was given, no
    // farther.
    FileAccess here(session_.files());
    here.allow(".");
    if (!here.may_be_read(name)) {
        session_.messages()
            .report(diag::MachineOutputElsewhere)
            .arg(name)
            .fix("if they are to go there, say so: `--setpoints " + name + '`');
        return kFailed;
    }
    std::vector<std::string> names = {name};
    for (const OpenOutput& open : outputs_) names.push_back(open.file->name());
    if (!require_outputs_apart(session_.files(), job_.source, names, session_.messages()))
        return kFailed;
    return open_output(row, name);
}

Status Run::commit() {
    Messages& messages = session_.messages();
    if (!session_.require_output_room()) return session_.status();
    const Status status = session_.status();
    if (status != Status::Done && status != Status::Alarm) return status;
    for (const OpenOutput& open : outputs_) {
        if (!open.file->require_no_source(messages)) return refused();
    }
    for (const OpenOutput& open : outputs_) {
        if (!open.file->commit(messages)) return refused();
        if (status == Status::Alarm && !open.file->is_standard_output()) {
            messages.report(diag::EndedByAlarm).arg(open.file->name());
        }
    }
    return status;
}

/// Keeps the lines of the blocks that events name by their numbers; empty: there are none.
std::function<void(const nc::Block&)> Run::block_look() {
    std::set<std::int32_t> named;
    for (const motion::OperatorEvent& event : events_) {
        if (event.number >= 0) named.insert(event.number);
    }
    if (named.empty()) return {};
    return [this, named](const nc::Block& block) {
        if (named.contains(block.number)) numbers_[block.line] = block.number;
    };
}

/// What goes on beside the execution, for all who want it.
Done Run::look_on(Aside& aside) {
    aside.in_step = wants(&Wants::in_step);
    aside.keeps_calls = wants(&Wants::calls);
    aside.look_at = block_look();
    aside.input_events = input_events_;
    aside.touches = touches_;
    if (debugger_) debugger_->look_on(aside);
    for (const OpenOutput& open : outputs_) {
        if (!open.output->look_on(aside)) return kFailed;
    }
    return kDone;
}

/// The program is open: whoever looks on looks at it.
Done Run::follow() {
    execution_->print_to(lost_);  // unless an output wants the lines
    for (const OpenOutput& open : outputs_) {
        if (!open.output->follow(*execution_)) return kFailed;
    }
    return kDone;
}

Done Run::open_debugger() {
    const bool has_steps = wants(&Wants::steps);
    if (!has_steps && job_.breaks.empty() && job_.until.empty()) return kDone;
    debugger_ = std::make_unique<DebugEngine>(session_);
    conversation_ = std::make_unique<Conversation>(session_, job_.onlooker, *debugger_);
    if (has_steps) {
        debugger_->trace_to([this](const TraceStep& step, const TraceState& state) {
            for (RunOutput* output : viewers_.steps) output->see_step(step, state);
        });
    }
    return conversation_->take_places(job_);
}

Status Run::perform() {
    auto text = open_source(session_, job_.source);
    if (!text) return session_.status();
    if (!open_events()) return refused();
    if (!open_outputs(is_kadr_source(job_.source, *text))) return refused();
    Aside aside;
    if (!open_debugger() || !look_on(aside)) return refused();
    execution_ = Execution::open(session_, job_.source, std::move(text), aside);
    if (!execution_) return session_.status();
    if (debugger_) debugger_->follow(*execution_);
    if (!open_machine_output() || !check_events() || !follow()) return refused();
    execute();
    return commit();
}

}  // namespace

Status run(Session& session, const RunJob& job,
           const std::function<void(motion::Segment&)>& spoil) {
    return Run(session, job, spoil).perform();
}

}  // namespace kadr::driver
