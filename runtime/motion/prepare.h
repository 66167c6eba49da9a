// prepare.h — the first half of planning: commands become pieces of path with their own limits.
//
// Follows what a command needs to know of those before it (position, tool length, spindle) and
// translates ahead. Knows one corner at a time; the speeds over many pieces are lookahead.h's.
#pragma once

#include <memory>

#include "base/diagnostic.h"
#include "motion/axis_table.h"
#include "motion/pipeline.h"

namespace kadr::motion {

/// A segment before it has its speeds: `segment.profile`, `start_time` and, for motion, `duration`
/// are still open.
struct Piece {
    Segment segment;
    double length = 0;        // of the path, mm (deg); 0 for a standstill
    double speed = 0;         // limit inside the piece
    double acceleration = 0;  // along the path
    double entry_limit = 0;   // of the corner before it; 0: the path comes to rest there
    double ramp = 1;          // part of its acceleration that the corner before it leaves
    double ramp_before = 1;   // part of its acceleration that the corner leaves to the piece before
    AxisRates rates{};        // dq/ds at its start
    AxisTable::Loads loads;
};

class Preparer {
  public:
    Preparer(Stream<path::Command>& commands, const machine::Machine& machine,
             const AxisTable& axes, const PlannerOptions& options, DiagnosticSink& sink);
    ~Preparer();

    /// The next piece; false at the end.
    bool next(Piece& piece);

    std::uint64_t commands() const;
    bool alarmed() const;
    /// Least and greatest position of every axis so far, start included.
    const AxisTable::Travel& travel() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kadr::motion
