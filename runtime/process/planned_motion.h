// planned_motion.h — the motion that a machine makes of commands, with all the modules it has.
//
// The axes' planner, and around it what the machine file describes besides: a pulsed laser, whose
// pulses the blocks are timed for, and a scanner, which moves while the axes stand.
//
//     commands → [served by modules] → [scanner's taken out] → planner → [pulses] → [scanner's put
//     in] → segments
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "process/command_modules.h"
#include "process/pulse_timer.h"
#include "process/scanner.h"

namespace kadr::process {

class PlannedMotion final : public Stream<motion::Segment> {
  public:
    /// Who looks on; each may be empty.
    struct Onlookers {
        ScannerSegments::Look list = {};  // sees the scanner's lists
        /// Sees what the axes get: the commands as the planner reads them.
        std::function<void(const path::Command&)> command = {};
    };

    /// References outlive the motion.
    PlannedMotion(Stream<path::Command>& commands, const machine::Machine& machine,
                  const motion::PlannerOptions& options, DiagnosticSink& sink)
        : PlannedMotion(commands, machine, options, sink, Onlookers{}) {}
    PlannedMotion(Stream<path::Command>& commands, const machine::Machine& machine,
                  const motion::PlannerOptions& options, DiagnosticSink& sink, Onlookers onlookers);

    std::size_t pull(std::span<motion::Segment> out) override { return last().pull(out); }

    /// Of the segments that were delivered; complete at the end of the stream.
    motion::Totals totals() const;
    /// What the axes' planner has reached, s: cheap, for progress.
    double planned_time() const { return planner_.totals().time; }
    /// An alarm of the motion was reported.
    bool alarmed() const;
    /// What the operator would have done at blocks that were not begun.
    const std::vector<motion::OperatorEvent>& events_ahead() const {
        return planner_.events_ahead();
    }
    /// Commands that were executed: those read, without one that was refused.
    std::uint64_t executed() const;
    /// Of a pulsed laser; nothing: the machine has none.
    std::optional<std::uint64_t> pulses() const;
    /// Of a scanner; null: the machine has none.
    const ScanFigures* scan() const { return behind_ ? &behind_->figures() : nullptr; }

  private:
    Stream<path::Command>& first(Stream<path::Command>& commands,
                                 std::function<void(const path::Command&)> look);
    Stream<motion::Segment>& timed();
    Stream<motion::Segment>& last();

    /// Shows commands on their way.
    class Shown final : public Stream<path::Command> {
      public:
        Shown(Stream<path::Command>& commands, std::function<void(const path::Command&)> look)
            : commands_(commands), look_(std::move(look)) {}
        std::size_t pull(std::span<path::Command> out) override;

      private:
        Stream<path::Command>& commands_;
        std::function<void(const path::Command&)> look_;
    };

    std::optional<ServedCommands> served_;
    ScanLists lists_;
    std::optional<ScannerCommands> front_;
    std::optional<Shown> shown_;  // nothing: nobody looks on
    motion::Planner planner_;
    std::optional<PulseTimer> timer_;
    std::optional<ScannerSegments> behind_;
};

}  // namespace kadr::process
