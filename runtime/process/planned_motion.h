// planned_motion.h — the motion that a machine makes of commands, with all the modules it has.
//
// The axes' planner, and around it what the machine file describes besides: a pulsed laser, whose
// pulses the blocks are timed for, and a scanner, which moves while the axes stand.
//
//     commands → [served by modules] → [scanner's taken out] → planner → [pulses] → [scanner's put
//     in] → segments
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "process/command_modules.h"
#include "process/pulse_timer.h"
#include "process/scanner.h"

namespace kadr::process {

class PlannedMotion final : public Stream<motion::Segment> {
  public:
    /// References outlive the motion. `look`, which may be empty, sees the scanner's lists.
    PlannedMotion(Stream<path::Command>& commands, const machine::Machine& machine,
                  const motion::PlannerOptions& options, DiagnosticSink& sink,
                  ScannerSegments::Look look = {});

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
    Stream<path::Command>& first(Stream<path::Command>& commands);
    Stream<motion::Segment>& timed();
    Stream<motion::Segment>& last();

    std::optional<ServedCommands> served_;
    ScanLists lists_;
    std::optional<ScannerCommands> front_;
    motion::Planner planner_;
    std::optional<PulseTimer> timer_;
    std::optional<ScannerSegments> behind_;
};

}  // namespace kadr::process
