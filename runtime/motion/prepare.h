// prepare.h — the first half of planning: commands become pieces of path with their own limits.
//
// Follows what a command needs to know of those before it (position, tool length, spindle) and
// translates ahead. Knows one corner at a time; the speeds over many pieces are lookahead.h's.
#pragma once

#include <deque>
#include <memory>

#include "base/diagnostic.h"
#include "motion/axis_table.h"
#include "motion/piece.h"
#include "motion/pipeline.h"

namespace kadr::motion {

class Preparer {
  public:
    /// Pieces are appended to `pieces`. References outlive the preparer.
    Preparer(Stream<path::Command>& commands, const machine::Machine& machine,
             const AxisTable& axes, const PlannerOptions& options, DiagnosticSink& sink,
             PieceRing& pieces);
    ~Preparer();

    /// Appends the pieces of the next command that has any, and returns how many; 0 at the end.
    std::size_t next();

    std::uint64_t commands() const;
    bool alarmed() const;
    /// M functions that pieces issue, in their order, for the planner to take; without their times.
    std::deque<IssuedFunction>& issued();
    /// Least and greatest position of every axis so far, start included.
    const AxisTable::Travel& travel() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kadr::motion
