// input_events.cpp — assignments that the machine makes while the program runs, at their times.
#include "macro/input_events.h"

#include <algorithm>
#include <utility>

#include "base/diagnostics/driver.h"
#include "macro/program_run.h"

namespace kadr::macro {

using nc::Block;

void InputEvents::begin(std::span<const InputEvent> events) {
    for (const InputEvent& event : events) {
        const bool is_at_block = event.line != 0 || event.number >= 0;
        pending_.push_back({&event, is_at_block ? std::nullopt : std::optional(0.0)});
        waits_for_block_ |= is_at_block;
    }
}

/// Whether the next line is one that an event waits for.
bool InputEvents::comes_next() {
    next_ = {};
    if (run_.phase.is_only_checking || run_.phase.is_waiting || run_.modal_calls.has_due() ||
        run_.frame->is_returning)
        return false;
    const std::uint64_t offset = run_.source().offset();
    std::string_view text;
    bool is_too_long = false;
    if (run_.source().seek(run_.frame->here.offset) && run_.source().next(text, is_too_long))
        next_.number = nc::front_of(run_.tables, text).number;
    run_.source().seek(offset);
    if (run_.frame->unit->text == run_.units.main().text) next_.line = run_.frame->here.line;
    return std::ranges::any_of(pending_,
                               [this](const PendingEvent& each) { return is_here(each); });
}

bool InputEvents::is_here(const PendingEvent& event) const {
    if (event.begun) return false;
    return event.event->number >= 0 ? event.event->number == next_.number
                                    : event.event->line == next_.line;
}

void InputEvents::begin_block() {
    const double now = run_.interpreter == nullptr ? 0 : run_.interpreter->elapsed();
    for (PendingEvent& each : pending_)
        if (is_here(each)) each.begun = now;
    waits_for_block_ = std::ranges::any_of(
        pending_, [](const PendingEvent& each) { return !each.begun.has_value(); });
}

/// What is due in front of the statement that comes next.
void InputEvents::act() {
    if (run_.interpreter == nullptr || run_.phase.is_only_checking || is_acting_) return;
    const double now = run_.interpreter->elapsed();
    // Those of one time in their order; by the time that is their own, not by that of the line.
    constexpr double kSameTime = 1e-9;
    std::vector<PendingEvent> due_now;
    std::erase_if(pending_, [&](const PendingEvent& each) {
        const bool is_due = each.begun && *each.begun + each.event->time <= now + kSameTime;
        if (is_due) due_now.push_back(each);
        return is_due;
    });
    std::ranges::stable_sort(
        due_now, {}, [](const PendingEvent& each) { return *each.begun + each.event->time; });
    is_acting_ = true;
    for (const PendingEvent& each : due_now) act_event(*each.event);
    is_acting_ = false;
}

/// As a text of its own: what it holds is no line of the program.
void InputEvents::act_event(const InputEvent& event) {
    CompiledLine line;
    line.text = event.text;
    nc::TextBounds apart;
    apart.name = event.file;
    const LinePosition goes_on = std::exchange(run_.frame->goes_on, line.program_line.next);
    const std::size_t resume = std::exchange(run_.frame->resume, 0);
    const bool has_executed = run_.frame->has_executed;
    run_.lines.bounds().enter(apart);
    run_.lines.begin(event.file_line);
    DiagnosticList heard;
    run_.ear.listen(&heard);
    run_.variables.machine_values().let_machine_write(true);
    run_.variables.system_variables().set_in_step(true);
    Block none;
    none.reset();
    if (run_.machine_inputs.run(line, none) == Outcome::Block)
        run_.fail(line, diag::InputNoValue, {0, 1});
    run_.variables.machine_values().let_machine_write(false);
    run_.ear.listen(nullptr);
    if (run_.lines.faults().failed()) {
        run_.lines.faults().forget_fault();
        run_.machine_inputs.report_wrong(event.text, heard.all(), true);
        run_.lines.faults().note_fault();
        run_.end();
    }
    run_.lines.bounds().enter(run_.frame->text);
    run_.lines.begin(run_.frame->here.line);
    run_.frame->goes_on = goes_on;
    run_.frame->resume = resume;
    run_.frame->has_executed = has_executed;
}

}  // namespace kadr::macro
