#include "process/planned_motion.h"

#include <utility>

namespace kadr::process {

namespace {

std::optional<ServedCommands> served_by(Stream<path::Command>& commands,
                                        const machine::Machine& machine) {
    std::optional<ServedCommands> served;
    if (!machine.pipeline.modules.empty()) served.emplace(commands, machine);
    return served;
}

std::optional<ScannerCommands> scanner_front(Stream<path::Command>& commands,
                                             const machine::Machine& machine,
                                             const motion::PlannerOptions& options,
                                             DiagnosticSink& sink, ScanLists& lists) {
    std::optional<ScannerCommands> front;
    if (machine.scanner) front.emplace(commands, machine, options, sink, lists);
    return front;
}

}  // namespace

PlannedMotion::PlannedMotion(Stream<path::Command>& commands, const machine::Machine& machine,
                             const motion::PlannerOptions& options, DiagnosticSink& sink,
                             Onlookers onlookers)
    : served_(served_by(commands, machine)),
      front_(scanner_front(served_ ? *served_ : commands, machine, options, sink, lists_)),
      planner_(first(commands, std::move(onlookers.command)), machine, options, sink) {
    if (machine.laser && machine.laser->pulse > 0) timer_.emplace(planner_, machine);
    if (machine.scanner) behind_.emplace(timed(), lists_, std::move(onlookers.list));
}

std::size_t PlannedMotion::Shown::pull(std::span<path::Command> out) {
    const std::size_t count = commands_.pull(out);
    for (const path::Command& command : out.first(count)) look_(command);
    return count;
}

Stream<path::Command>& PlannedMotion::first(Stream<path::Command>& commands,
                                            std::function<void(const path::Command&)> look) {
    Stream<path::Command>& last = front_    ? static_cast<Stream<path::Command>&>(*front_)
                                  : served_ ? static_cast<Stream<path::Command>&>(*served_)
                                            : commands;
    if (!look) return last;
    return shown_.emplace(last, std::move(look));
}

Stream<motion::Segment>& PlannedMotion::timed() {
    if (timer_) return *timer_;
    return planner_;
}

Stream<motion::Segment>& PlannedMotion::last() {
    if (behind_) return *behind_;
    return timed();
}

motion::Totals PlannedMotion::totals() const {
    return timer_ ? timer_->totals(planner_.totals()) : planner_.totals();
}

bool PlannedMotion::alarmed() const { return planner_.alarmed() || (front_ && front_->alarmed()); }

// The command that is refused was read last.
std::uint64_t PlannedMotion::executed() const {
    const std::uint64_t planned = planner_.totals().commands;
    const bool is_refused = planner_.alarmed();
    std::uint64_t taken = planned;
    if (front_) taken = is_refused ? front_->taken_for(planned) : front_->taken();
    const bool is_last_refused = is_refused || (front_ && front_->alarmed());
    // At the end modules may have answered the last commands with none.
    if (served_) taken = is_last_refused ? served_->taken_for(taken) : served_->taken();
    return is_last_refused ? taken - 1 : taken;
}

std::optional<std::uint64_t> PlannedMotion::pulses() const {
    if (!timer_) return std::nullopt;
    return timer_->pulses();
}

}  // namespace kadr::process
