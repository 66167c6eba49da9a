#include "driver/bench.h"

#include <algorithm>
#include <utility>

#include "base/assert.h"
#include "base/diagnostics/test.h"
#include "base/text.h"
#include "driver/command_tap.h"
#include "driver/execution.h"
#include "driver/generated_text.h"
#include "motion/pipeline.h"
#include "motion/transformed.h"

namespace kadr::driver {

using expand::CallUnderTest;

void Bench::begin(const std::string& dialect, DiagnosticSink& sink) {
    dialect_ = dialect;
    sink_ = &sink;
    was_asked_ = false;
    recordings_.clear();
}

const nc::Dialect* Bench::wanted_dialect(const CallUnderTest& call, const std::string& name) {
    // Once a name is enough to look through the files.
    if (cycles_.contains(name)) {
        if (const nc::Dialect* loaded = session_.dialect(name, {})) return loaded;
    }
    const auto known = nc::list_dialects(session_.share().dialects, session_.files());
    const bool is_known = std::any_of(known.begin(), known.end(),
                                      [&](const auto& summary) { return summary.name == name; });
    if (is_known || session_.files().is_file(name)) {
        if (const nc::Dialect* loaded = session_.dialect(name, {})) return loaded;
    }
    auto builder = sink_->report(diag::ControlUnknown, call.range);
    builder.arg(name);
    std::vector<std::string_view> names;
    names.reserve(known.size());
    for (const nc::DialectSummary& summary : known) names.push_back(summary.name);
    if (const auto near = nearest_name(name, names.data(), names.size())) {
        builder.fix("did you mean `" + std::string(*near) + "`?");
    }
    return nullptr;
}

LibraryCycles& Bench::cycles_of(const std::string& name, const nc::Dialect& dialect) {
    std::unique_ptr<LibraryCycles>& cycles = cycles_[name];
    if (!cycles) cycles = std::make_unique<LibraryCycles>(session_, dialect);
    return *cycles;
}

Entry Bench::entry(const CallUnderTest& call) const {
    const sema::FunctionCode& function = program_.code->functions[call.call->function];
    Entry entry;
    entry.name = function.name;
    entry.is_inch = function.units == sema::Units::Inch;
    entry.range = function.range;
    entry.function = &function;
    entry.start = [&call](expand::Expander& expander) {
        expander.start_call(call);
        return kDone;
    };
    return entry;
}

/// Executes the call to its end or to what stops it. Null: there is no machine.
std::unique_ptr<Recording> Bench::perform(const CallUnderTest& call, const std::string& name,
                                          DiagnosticList& messages) {
    was_asked_ = true;
    const nc::Dialect* dialect = wanted_dialect(call, name);
    const machine::Machine* machine = session_.machine();
    if (dialect == nullptr || machine == nullptr) return nullptr;
    auto recording = std::make_unique<Recording>();
    recording->dialect = name;
    const Subject subject{program_, *dialect,        entry(call), cycles_of(name, *dialect),
                          messages, &recording->text};
    const std::unique_ptr<Execution> execution = Execution::open(session_, subject);
    if (execution) {
        CommandTap tap(*execution, [&](const path::Command& command) { recording->add(command); });
        motion::PlannerOptions options;
        execution->place_messages(options);
        motion::Planner planner(tap, *machine, options, execution->sink());
        std::vector<motion::Segment> batch(64);
        while (const std::size_t count = planner.pull(batch)) {
            for (std::size_t i = 0; i < count; ++i) {
                if (batch[i].goes_straight()) {
                    for (const motion::Segment& line :
                         motion::tip_lines(machine->kinematics->chain, batch[i]))
                        recording->add(line);
                } else {
                    recording->add(batch[i]);
                }
            }
        }
        const std::uint64_t read = planner.totals().commands;
        tap.pass_until(planner.alarmed() && read > 0 ? read - 1 : read);
        recording->blocks = execution->statement_lines();
    }
    for (const Diagnostic& diagnostic : messages.all()) {
        switch (diagnostic.severity) {
            case Severity::Warning: ++recording->warnings; continue;
            case Severity::Error: ++recording->errors; break;
            case Severity::Alarm: ++recording->alarms; break;
        }
        if (recording->message.empty()) recording->message = diagnostic.message();
    }
    recording->finish();
    return recording;
}

/// A call with an error: what it reports becomes what the test reports.
Done Bench::require_no_error(const DiagnosticList& messages) {
    if (!messages.has_errors()) return kDone;
    for (const Diagnostic& diagnostic : messages.all()) {
        if (diagnostic.severity != Severity::Warning) sink_->take(diagnostic);
    }
    return kFailed;
}

std::optional<std::int64_t> Bench::execute(const CallUnderTest& call) {
    DiagnosticList messages;
    std::unique_ptr<Recording> recording = perform(call, call.text.value_or(dialect_), messages);
    if (!recording) return std::nullopt;
    const bool may_fail = call.call->purpose == sema::TestCall::Purpose::Attempt;
    if (!may_fail && !require_no_error(messages)) return std::nullopt;
    recordings_.push_back(std::move(recording));
    return static_cast<std::int64_t>(recordings_.size());
}

std::optional<std::string> Bench::write(const CallUnderTest& call) {
    DiagnosticList messages;
    const std::unique_ptr<Recording> recording =
        perform(call, call.text.value_or(dialect_), messages);
    if (!recording || !require_no_error(messages)) return std::nullopt;
    return recording->text;
}

Done Bench::require_error(const CallUnderTest& call) {
    DiagnosticList messages;
    const std::unique_ptr<Recording> recording = perform(call, dialect_, messages);
    if (!recording) return kFailed;
    const std::string wanted = call.text.value_or("");
    const Diagnostic* first = nullptr;
    for (const Diagnostic& diagnostic : messages.all()) {
        if (diagnostic.severity == Severity::Warning) continue;
        if (diagnostic.row->code == wanted || diagnostic.alarm_number == wanted) return kDone;
        if (first == nullptr) first = &diagnostic;
    }
    auto builder = sink_->report(diag::ErrorExpected, call.range);
    builder.arg('`' + wanted + '`');
    if (first == nullptr) {
        builder.arg("none");
    } else {
        const std::string& number = first->alarm_number;
        builder.arg('`' + (number.empty() ? std::string(first->row->code) : number) +
                    "`: " + first->message());
        if (first->range.file.is_valid()) builder.note(first->range, "it stands here");
    }
    return kFailed;
}

expand::FigureAnswer Bench::ask(std::int64_t execution, sema::Figure figure,
                                std::span<const sema::Slot> arguments) {
    KADR_ASSERT(execution > 0 && execution <= static_cast<std::int64_t>(recordings_.size()),
                "a figure of an execution that the bench has not made");
    return recordings_[static_cast<std::size_t>(execution - 1)]->ask(figure, arguments);
}

std::string Bench::dialect() const {
    was_asked_ = true;
    return dialect_;
}

std::vector<std::string> Bench::dialects() const { return dialects_; }

}  // namespace kadr::driver
