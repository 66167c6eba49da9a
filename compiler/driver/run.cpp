#include "driver/run.h"

#include <array>
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
#include "driver/command_list.h"
#include "driver/command_tap.h"
#include "driver/debugger.h"
#include "driver/drive_table.h"
#include "driver/execution.h"
#include "driver/limit_report.h"
#include "driver/operator_events.h"
#include "driver/output.h"
#include "driver/output_names.h"
#include "driver/page_recorder.h"
#include "driver/pipeline_stages.h"
#include "driver/scanner_list.h"
#include "driver/setpoints.h"
#include "driver/short_waits.h"
#include "driver/summary.h"
#include "driver/variables.h"
#include "driver/work_times.h"
#include "motion/path_check.h"
#include "motion/pipeline.h"
#include "motion/transformed.h"
#include "plot/drive_plot.h"
#include "plot/motion_plot.h"
#include "plot/plot_svg.h"
#include "plot/plot_tools.h"
#include "process/drive_run.h"
#include "process/planned_motion.h"

namespace kadr::driver {

namespace {

constexpr std::size_t kLongest = 20;  // statements that a summary may name

/// The outputs of a run, all open before it begins; null: nobody asked.
struct Outputs {
    std::unique_ptr<Output> commands;
    std::unique_ptr<Output> setpoints;
    std::unique_ptr<Output> plot;
    std::unique_ptr<Output> curves;
    std::unique_ptr<Output> page;
    std::unique_ptr<Output> drive;
    std::unique_ptr<Output> scanner;
    std::unique_ptr<Output> variables;
    std::unique_ptr<Output> print;
    std::unique_ptr<Output> map;
    std::unique_ptr<Output> trace;
    std::unique_ptr<Output> limits;
    std::unique_ptr<Output> summary;

    std::array<Output*, 13> all() const {
        return {commands.get(), setpoints.get(), plot.get(),      curves.get(), drive.get(),
                scanner.get(),  page.get(),      variables.get(), map.get(),    trace.get(),
                print.get(),    limits.get(),    summary.get()};
    }
};

/// Keeps what the program prints; without a file it counts the lines.
class PrintedLines final : public macro::PrintTarget {
  public:
    explicit PrintedLines(Output* output) : output_(output) {}
    void line(std::string_view text) override {
        if (output_ == nullptr) {
            ++lost_;
            return;
        }
        output_->write(text);
        output_->write("\n");
    }
    std::size_t lost() const { return lost_; }

  private:
    Output* output_;
    std::size_t lost_ = 0;
};

bool asks_for_nothing(const RunJob& job) {
    return job.summary == SummaryFormat::None && job.commands.empty() && job.setpoints.empty() &&
           job.plot.empty() && job.curves.empty() && job.page.empty() && job.drive.empty() &&
           job.scanner.empty() && job.variables.empty() && job.limits.empty() &&
           job.print.empty() && job.map.empty() && job.trace.empty() && job.breaks.empty();
}

/// Opens an output if it has a name.
Done open_if_named(std::unique_ptr<Output>& output, const std::string& name, Session& session) {
    if (name.empty()) return kDone;
    output = Output::open(name, session.messages(), session.output_rules());
    return Done(output != nullptr);
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
    Done open_outputs(bool is_kadr);
    std::function<void(const nc::Block&)> block_look();
    Done open_execution(std::unique_ptr<FileText> text);
    void execute();
    void draw(const motion::Segment& segment);
    void sample(Stream<motion::Segment>& segments, double tick);
    void write_setpoints(std::span<const motion::Setpoint> some);
    bool samples() const { return outputs_.setpoints || outputs_.curves || page_; }
    void finish_check(const motion::PlannerOptions& options);
    Done open_machine_output();
    void report_events_ahead();
    bool has_threads() const;
    RunFigures figures(const motion::Totals& totals) const;
    void finish(const RunFigures& figures);
    void write_plot(const RunFigures& figures);
    void write_curves(const RunFigures& figures);
    void write_page(const RunFigures& figures);
    std::string subtitle(const RunFigures& figures) const;
    Done open_events();
    Done check_events() const;
    Done open_drives();
    Done open_scanner();
    void finish_drives(const RunFigures& figures);
    std::string machine_title() const;
    Status commit();
    Status refused() {
        session_.mark_usage();
        return session_.status();
    }

    Session& session_;
    const RunJob& job_;
    const std::function<void(motion::Segment&)>& spoil_;  // empty: nobody makes the motion wrong
    Outputs outputs_;
    std::unique_ptr<Debugger> debugger_;  // null: nobody looks on
    std::unique_ptr<Execution> execution_;
    std::unique_ptr<CommandList> list_;
    std::vector<motion::OperatorEvent> events_;      // what the operator does
    std::vector<interp::ProbeTouch> touches_;        // … where its probe touches
    std::vector<macro::InputEvent> input_events_;    // … what the machine gives meanwhile
    std::map<std::uint32_t, std::int32_t> numbers_;  // of the lines of blocks that events name
    plot::PlotScene scene_;
    plot::PlotTools tools_;                      // along the path that is drawn
    std::unique_ptr<process::DriveRun> drives_;  // null: nobody asked
    std::unique_ptr<DriveTable> drive_table_;    // null: they are drawn
    std::unique_ptr<ScannerText> scanner_;       // null: nobody asked
    plot::DriveTrace drive_trace_;
    std::unique_ptr<WorkTimes> times_;           // null: nobody reads a summary
    std::unique_ptr<LimitReport> limits_;        // null: nobody asked
    std::unique_ptr<plot::MotionTrace> motion_;  // null: nobody asked
    std::unique_ptr<PageRecorder> page_;         // likewise
    std::unique_ptr<SetpointTable> table_;       // likewise
    std::unique_ptr<motion::PathCheck> check_;   // null: no setpoints are made
    std::atomic<std::uint64_t> setpoints_ = 0;   // progress is reported by another thread
    std::uint64_t commands_ = 0;
};

Done Run::open_outputs(bool is_kadr) {
    Messages& messages = session_.messages();
    const bool has_summary = job_.summary != SummaryFormat::None || asks_for_nothing(job_);
    const std::array<std::string, 13> names = {
        job_.commands, job_.setpoints, job_.plot,  job_.variables,         job_.map,
        job_.trace,    job_.print,     job_.drive, has_summary ? "-" : "", job_.curves,
        job_.scanner,  job_.limits,    job_.page};
    if (!require_outputs_apart(job_.source, names, messages)) return kFailed;
    if (!job_.map.empty() && !is_kadr) {
        messages.report(diag::NoSourceMap).arg(job_.source);
        return kFailed;
    }
    return Done(open_if_named(outputs_.commands, names[0], session_) &&
                open_if_named(outputs_.setpoints, names[1], session_) &&
                open_if_named(outputs_.plot, names[2], session_) &&
                open_if_named(outputs_.variables, names[3], session_) &&
                open_if_named(outputs_.map, names[4], session_) &&
                open_if_named(outputs_.trace, names[5], session_) &&
                open_if_named(outputs_.print, names[6], session_) &&
                open_if_named(outputs_.drive, names[7], session_) &&
                open_if_named(outputs_.summary, names[8], session_) &&
                open_if_named(outputs_.curves, names[9], session_) &&
                open_if_named(outputs_.scanner, names[10], session_) &&
                open_if_named(outputs_.limits, names[11], session_) &&
                open_if_named(outputs_.page, names[12], session_));
}

void Run::draw(const motion::Segment& segment) {
    double shade = round_to(mm_min_from_feed(segment.feed), 3);
    if (job_.plot_color == plot::PlotColor::Line) {
        const SourceRange range = execution_->statement(segment.source);
        shade = range.file.is_valid() ? session_.sources().locate(range.file, range.begin).line
                                      : segment.line;
    }
    const auto& kinematics = execution_->machine().kinematics;
    if (!segment.goes_straight()) {
        scene_.add(segment, shade);
    } else {
        for (const motion::Segment& line : motion::tip_lines(kinematics->chain, segment))
            scene_.add(line, shade);
    }
    if (kinematics) tools_.add(kinematics->chain, segment);
}

void Run::execute() {
    const machine::Machine& machine = execution_->machine();
    PrintedLines printed(outputs_.print.get());
    execution_->print_to(printed);
    if (outputs_.commands) {
        list_ = std::make_unique<CommandList>(*execution_, session_, *outputs_.commands);
    }
    const auto look = [this](const path::Command& command) {
        ++commands_;
        if (list_) list_->write(command);
        if (limits_) limits_->see(command);
    };
    const bool has_pulses = machine.laser && machine.laser->pulse > 0;
    if (outputs_.limits) limits_ = std::make_unique<LimitReport>(*execution_, session_, has_pulses);
    // An alarm of the motion has to come before the next block is shown.
    if (outputs_.summary) times_ = std::make_unique<WorkTimes>(*execution_, session_);
    CommandTap tap(*execution_, look, debugger_ ? 1 : 0);
    motion::PlannerOptions options;
    options.lookahead = machine.pipeline.ahead;
    options.feed_override = job_.feed_override;
    options.rapid_override = job_.rapid_override;
    options.events = events_;
    options.number_of = [this](std::uint32_t line) {
        const auto found = numbers_.find(line);
        return found == numbers_.end() ? -1 : found->second;
    };
    process::PlannedMotion::Onlookers onlookers;
    onlookers.list = [this](const process::StartedList& list) {
        if (scanner_) scanner_->write(list);
    };
    if (samples()) {
        check_ = std::make_unique<motion::PathCheck>(machine, session_.options().tick.value_or(0));
        onlookers.command = [this](const path::Command& command) { check_->read(command); };
    }
    if (limits_)
        options.report_loss = [this](const motion::SpeedLoss& loss) { limits_->lose(loss); };
    execution_->place_messages(options);
    process::PlannedMotion motion(tap, machine, options, execution_->sink(), std::move(onlookers));
    SegmentTap segments(
        motion,
        [this](motion::Segment& segment) {
            if (spoil_) spoil_(segment);
            if (outputs_.plot) draw(segment);
            if (drives_) drives_->add(segment);
            if (times_) times_->add(segment);
            if (limits_) limits_->add(segment);
            if (page_) page_->add(segment);
            // For the setpoints, whose thread must not ask what is being executed.
            if (!macro::NcProgram::is_in_main_text(segment.line))
                segment.line = execution_->location_of(segment.line).line;
        },
        [&] {
            session_.report({execution_->blocks(), setpoints_, motion.planned_time()});
        });
    if (samples()) {
        sample(segments, session_.options().tick.value_or(0));
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
    if (printed.lost() > 0) session_.messages().report(diag::PrintLost).arg(printed.lost());
    RunFigures all = figures(motion.totals());
    all.pulses = motion.pulses();
    if (motion.scan() != nullptr) all.scan = *motion.scan();
    finish(all);
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
    if (outputs_.setpoints) table_ = open_setpoints(machine, *outputs_.setpoints);
    if (outputs_.curves) {
        motion_ = std::make_unique<plot::MotionTrace>(machine, tick > 0 ? tick : machine.tick,
                                                      job_.curves_window);
    }
    // Who draws needs no ticks of a long wait.
    ShortWaits waits(segments, tick > 0 ? tick : machine.tick);
    Stream<motion::Segment>& walked =
        table_ ? segments : static_cast<Stream<motion::Segment>&>(waits);
    run_stages(walked, machine, tick, has_threads(),
               {.write =
                    [&](std::span<const motion::Setpoint> some) {
                        write_setpoints(table_ ? some : waits.restored(some));
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

void Run::write_setpoints(std::span<const motion::Setpoint> some) {
    if (!check_->follow(some)) return;
    if (motion_) {
        for (const motion::Setpoint& setpoint : some) motion_->add(setpoint);
    }
    if (page_) {
        for (const motion::Setpoint& setpoint : some) page_->add(setpoint);
    }
    if (!table_) return;
    table_->write(some);
    setpoints_ += some.size();
}

RunFigures Run::figures(const motion::Totals& totals) const {
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
    figures.totals = totals;
    if (times_) {
        figures.tools = times_->tools();
        figures.cycles = times_->cycles();
        figures.longest = times_->longest(kLongest);
    }
    return figures;
}

/// Writes what is known only at the end, and into each output that it is not complete.
void Run::finish(const RunFigures& figures) {
    if (debugger_) debugger_->finish(figures.alarm);
    const machine::Machine& machine = execution_->machine();
    if (list_ && !figures.alarm.empty()) list_->write_alarm(figures.alarm);
    if (table_) table_->finish(figures.alarm);
    if (scanner_) scanner_->finish(figures.alarm);
    if (limits_) limits_->write(*outputs_.limits, figures.source, figures.alarm);
    if (outputs_.plot) write_plot(figures);
    if (motion_) write_curves(figures);
    if (page_) write_page(figures);
    if (drives_) finish_drives(figures);
    if (outputs_.variables) outputs_.variables->write(variables_json(execution_->variables()));
    if (outputs_.summary) {
        const bool is_json = job_.summary == SummaryFormat::Json;
        outputs_.summary->write(is_json ? summary_json(figures, machine)
                                        : summary_text(figures, machine));
    }
}

void Run::write_curves(const RunFigures& figures) {
    plot::MotionText text;
    text.title = figures.source + ": the axes over time";
    text.subtitle = subtitle(figures);
    if (motion_->has_too_many_blocks())
        text.subtitle += " · too many blocks to be marked, a shorter window shows them";
    if (!figures.alarm.empty()) text.warning = "not complete, ended by " + figures.alarm;
    outputs_.curves->write(plot::motion_svg(*motion_, text));
}

void Run::write_page(const RunFigures& figures) {
    plot::PageHead head;
    head.title = figures.source;
    head.subtitle = subtitle(figures);
    if (!figures.alarm.empty()) head.warning = "not complete, ended by " + figures.alarm;
    page_->write(head, *outputs_.page);
}

void Run::write_plot(const RunFigures& figures) {
    plot::PlotText text;
    text.title = figures.source;
    text.subtitle = subtitle(figures);
    text.has_diameters = execution_->machine().is_lathe;
    if (!figures.alarm.empty()) text.warning = "not complete, ended by " + figures.alarm;
    outputs_.plot->write(plot::plot_svg(scene_, text, job_.plot_color, tools_.all()));
}

/// The control, the machine and how long it took.
std::string Run::subtitle(const RunFigures& figures) const {
    return figures.dialect + " · " + machine_title() + " · " + duration_text(figures.totals.time);
}

std::string Run::machine_title() const {
    const machine::Machine& machine = execution_->machine();
    return machine.title.empty() ? machine.name : machine.title;
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
    std::string name = execution_->machine().pipeline.setpoints.file;
    if (outputs_.setpoints || name.empty()) return kDone;
    constexpr std::string_view kProgram = "{program}";
    const std::string program =
        job_.source == "-" ? "stdin" : std::filesystem::path(job_.source).stem().string();
    if (const std::size_t at = name.find(kProgram); at != std::string::npos)
        name.replace(at, kProgram.size(), program);
    // A machine file may come from somebody else: it writes where the command was given, no
    // farther.
    Files here;
    here.allow(".");
    if (!here.may_be_read(name)) {
        session_.messages()
            .report(diag::MachineOutputElsewhere)
            .arg(name)
            .fix("if they are to go there, say so: `--setpoints " + name + '`');
        return kFailed;
    }
    std::vector<std::string> names = {name};
    for (const Output* output : outputs_.all()) {
        if (output != nullptr) names.push_back(output->name());
    }
    if (!require_outputs_apart(job_.source, names, session_.messages())) return kFailed;
    return open_if_named(outputs_.setpoints, name, session_);
}

/// The simulation of the drives, if it was asked for.
Done Run::open_drives() {
    if (!outputs_.drive) return kDone;
    const machine::Machine& machine = execution_->machine();
    if (!machine.drives) {
        session_.messages().report(diag::MachineWithoutDrives).arg(machine.name);
        return kFailed;
    }
    if (job_.drive.ends_with(".csv")) drive_table_ = std::make_unique<DriveTable>(*outputs_.drive);
    const auto look = [this](process::DriveSample sample) {
        if (!drive_table_) {
            drive_trace_.add(sample);
            return;
        }
        if (!macro::NcProgram::is_in_main_text(sample.line))
            sample.line = execution_->location_of(sample.line).line;
        drive_table_->add(sample);
    };
    const double period = session_.options().tick.value_or(machine.tick);
    drives_ = std::make_unique<process::DriveRun>(machine, period, look);
    return kDone;
}

/// The lists of the scanner, if they were asked for.
Done Run::open_scanner() {
    if (!outputs_.scanner) return kDone;
    const machine::Machine& machine = execution_->machine();
    if (!machine.scanner) {
        session_.messages().report(diag::MachineWithoutScanner).arg(machine.name);
        return kFailed;
    }
    scanner_ = std::make_unique<ScannerText>(*machine.scanner, *outputs_.scanner);
    return kDone;
}

void Run::finish_drives(const RunFigures& figures) {
    if (drives_->has_stalled()) {
        session_.messages()
            .report(diag::SpindleStalls)
            .arg(round_to(rpm_from_angular_speed(drives_->wanted_speed()), 1))
            .arg(round_to(rpm_from_angular_speed(drives_->speed()), 1));
    }
    const std::string warning = !figures.alarm.empty() ? "not complete, ended by " + figures.alarm
                                : drives_->has_stalled()
                                    ? std::string("not complete, the spindle drive stalls")
                                    : std::string();
    if (drive_table_) {
        drive_table_->finish();
        if (!warning.empty()) outputs_.drive->write("# " + warning + '\n');
        return;
    }
    plot::DriveText text;
    text.title = figures.source + ": the drives";
    text.subtitle = figures.dialect + " · " + machine_title();
    text.warning = warning;
    outputs_.drive->write(plot::drive_svg(drive_trace_, *execution_->machine().drives, text));
}

Status Run::commit() {
    Messages& messages = session_.messages();
    if (!session_.require_output_room()) return session_.status();
    const Status status = session_.status();
    if (status != Status::Done && status != Status::Alarm) return status;
    for (const Output* output : outputs_.all()) {
        if (output != nullptr && !output->require_no_source(messages)) return refused();
    }
    for (Output* output : outputs_.all()) {
        if (output == nullptr) continue;
        if (!output->commit(messages)) return refused();
        if (status == Status::Alarm && !output->is_standard_output()) {
            messages.report(diag::EndedByAlarm).arg(output->name());
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

Done Run::open_execution(std::unique_ptr<FileText> text) {
    Aside aside;
    aside.map = outputs_.map.get();
    aside.in_step = outputs_.variables != nullptr || outputs_.print != nullptr;
    aside.keeps_calls = outputs_.summary != nullptr || outputs_.limits != nullptr;
    if (debugger_) debugger_->look_on(aside);
    if (page_) page_->look_on(aside);
    aside.look_at = block_look();
    aside.input_events = input_events_;
    aside.touches = touches_;
    execution_ = Execution::open(session_, job_.source, std::move(text), aside);
    if (execution_ && debugger_) debugger_->follow(*execution_);
    if (execution_ && page_) page_->follow(*execution_);
    return Done(execution_ != nullptr);
}

Status Run::perform() {
    auto text = open_source(session_, job_.source);
    if (!text) return session_.status();
    if (!open_events()) return refused();
    if (!open_outputs(is_kadr_source(job_.source, *text))) return refused();
    const bool is_watched = outputs_.trace || !job_.breaks.empty() || !job_.until.empty();
    if (is_watched) {
        debugger_ = Debugger::open(session_, job_, outputs_.trace.get());
        if (!debugger_) return refused();
    }
    if (outputs_.page) {
        page_ = PageRecorder::open(session_);
        if (!page_) return refused();
    }
    if (!open_execution(std::move(text))) return session_.status();
    if (!open_machine_output()) return refused();
    if (!check_events() || !open_drives() || !open_scanner()) return refused();
    execute();
    return commit();
}

}  // namespace

Status run(Session& session, const RunJob& job,
           const std::function<void(motion::Segment&)>& spoil) {
    return Run(session, job, spoil).perform();
}

}  // namespace kadr::driver
