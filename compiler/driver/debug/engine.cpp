#include "driver/debug/engine.h"

#include <algorithm>
#include <utility>

#include "base/diagnostics/driver.h"
#include "nc/tables.h"

namespace kadr::driver {

DebugEngine::DebugEngine(Session& session) : session_(session), inspection_(session) {}

void DebugEngine::look_on(Aside& aside) {
    aside.watch = this;
    aside.changes = steps_.changes();
    // Steps of a trace are lines: statements are for who wants to stop.
    sees_statements_ = !places_.is_empty() || advance_.how != Resume::Continue;
    if (sees_statements_) aside.statements = this;
}

void DebugEngine::follow(Execution& execution) {
    execution_ = &execution;
    steps_.follow(execution);
    inspection_.follow(execution);
    advance_.from = {execution.program() != nullptr, 0};
}

// ---------------------------------------------------------------- what comes next

FileLine DebugEngine::lines_of(const SourceRange& range) const {
    if (!range.file.is_valid()) return {};
    const Sources& sources = session_.sources();
    return {sources.name(range.file), sources.locate(range.file, range.begin).line,
            sources.locate(range.file, range.end).line};
}

std::string_view DebugEngine::started() const {
    const KadrProgram* program = execution_->program();
    return program == nullptr ? std::string_view(execution_->text_name())
                              : session_.sources().name(program->file);
}

StopArrival DebugEngine::arrival_at(const macro::WatchedLine& line, const TraceStep& step) {
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
    arrival.text = {step.file, line.line, line.line};
    arrival.started = started();
    return arrival;
}

/// The place that counts: the program ends rather than that it stops.
const WatchedPlace* DebugEngine::reach(const StopArrival& arrival) {
    if (places_.is_empty()) return nullptr;
    const WatchedPlace* ends = places_.reach(arrival, WatchedPlace::Effect::Ends);
    return ends != nullptr ? ends : places_.reach(arrival, WatchedPlace::Effect::Stops);
}

bool DebugEngine::comes_to(const macro::WatchedLine& line) {
    if (has_ended_) return false;
    const TraceStep& step = steps_.begin(line);
    const bool is_watched = !places_.is_empty() || advance_.how != Resume::Continue || wants_pause_;
    if (!is_watched) return true;
    Stop stop;
    stop.line = step;
    return goes_on(arrival_at(line, step), {false, line.level}, std::move(stop));
}

expand::StatementWatch::Answer DebugEngine::comes_to(std::uint32_t statement) {
    if (is_finished_) return Answer::GoOn;
    // Behind an alarm nothing is executed; the line that it is in may be read for its block only.
    if (has_ended_ || execution_->reader().has_fault()) return Answer::End;
    if (waits_for_start()) return Answer::Again;
    const std::vector<expand::RunningCall> calls =
        execution_->generated()->expander().running_calls();
    Stop stop;
    stop.statement = execution_->program()->code->names.statements[statement].range;
    StopArrival arrival;
    arrival.started = started();
    const FileLine lines = lines_of(stop.statement);
    const CallTrail::Arrival at = trail_.come_to(calls, stop.statement, lines.first);
    // Of several statements in a line the first is the line.
    if (at.enters_line) arrival.statement = lines;
    if (at.enters_function) {
        arrival.entered = calls.back().function->name;
        if (const std::uint32_t behind = calls.back().return_to; behind != 0)
            stop.entered_by = execution_->program()->code->locations[behind - 1];
    }
    return goes_on(arrival, {true, calls.size()}, std::move(stop)) ? Answer::GoOn : Answer::End;
}

/// False: the program ends in front of it.
bool DebugEngine::goes_on(const StopArrival& arrival, const Arrival& at, Stop stop) {
    const WatchedPlace* place = reach(arrival);
    last_ = stop;
    if (place != nullptr && place->effect == WatchedPlace::Effect::Ends) {
        end(StopReason::Until);
        return false;
    }
    const bool is_paused = wants_pause_.exchange(false);
    const bool is_through = advance_.ends_at(at);
    if (place == nullptr && !is_through && !is_paused) return true;
    stop.reason = place != nullptr ? StopReason::Place
                  : is_through     ? advance_.reason
                                   : StopReason::Pause;
    if (place != nullptr) stop.place = place->id;
    return stand(std::move(stop), at);
}

std::optional<TraceStep> DebugEngine::next_line() {
    if (ahead_ == nullptr)
        ahead_ = std::make_unique<NextLines>(session_, *execution_->program(),
                                             execution_->dialect(), execution_->text_name());
    return ahead_->line(execution_->generated()->made_lines() + 1);
}

/// The lines with which a text begins belong to no statement: they are executed before the first
/// one of which a line stands behind them.
bool DebugEngine::waits_for_start() {
    if (execution_->generated()->has_started()) return false;
    const std::optional<TraceStep> line = next_line();
    return line && !line->statement.file.is_valid();
}

bool DebugEngine::stand(Stop stop, const Arrival& at) {
    if (stop.is_at_statement()) stop.line = next_line();
    inspection_.begin(stop);
    advance_ = {stand_ ? stand_(stop) : Resume::Continue, at, StopReason::Step};
    if (advance_.how != Resume::End) return true;
    end(StopReason::End);
    return false;
}

bool DebugEngine::has_ended() const {
    if (is_finished_) return has_ended_;
    const GeneratedText* text = sees_statements_ ? execution_->generated() : nullptr;
    return has_ended_ || (text != nullptr && text->failed());
}

void DebugEngine::end(StopReason why) {
    has_ended_ = true;
    ending_ = why;
    steps_.drop();
}

// ---------------------------------------------------------------- the end

void DebugEngine::finish(const std::string& alarm) {
    steps_.end();
    is_finished_ = true;
    const bool has_fault = !alarm.empty() || execution_->failed();
    if (!has_fault) return;
    ending_ = StopReason::Alarm;
    const bool is_somewhere = last_.is_at_statement() || last_.line;
    if (has_ended_ || !is_somewhere) return;
    last_.reason = StopReason::Alarm;
    inspection_.begin(last_);
    if (stand_) stand_(last_);
}

bool DebugEngine::is_out_of_reach(const BreakPoint& point) const {
    const KadrProgram* program = execution_ == nullptr ? nullptr : execution_->program();
    if (program == nullptr || point.kind() != BreakPoint::Kind::Line) return false;
    if (point.is_in(execution_->text_name(), started())) return false;
    bool is_known_file = false;
    for (const sema::StatementStart& statement : program->code->names.statements) {
        if (is_on_lines(point, statement.range)) return false;
        const std::string_view file = session_.sources().name(statement.range.file);
        is_known_file = is_known_file || point.is_in(file, started());
    }
    return is_known_file;
}

bool DebugEngine::is_on_lines(const BreakPoint& point, const SourceRange& range) const {
    StopArrival arrival;
    arrival.started = started();
    arrival.statement = lines_of(range);
    return point.is_at(arrival);
}

}  // namespace kadr::driver
