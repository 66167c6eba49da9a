// run_record.h — what a run amounts to: sums and peaks over the segments that were delivered.
//
// Peaks are what setpoints show, from tick to tick: inside the pieces, and at the corners between
// two of them.
#pragma once

#include <cstdint>

#include "motion/axis_table.h"
#include "motion/piece.h"
#include "motion/pipeline.h"

namespace kadr::motion {

class RunRecord {
  public:
    /// References outlive the record.
    ///
    /// tick  of the machine, s
    RunRecord(const AxisTable& axes, double tick) : axes_(axes), tick_(tick) {}

    const Totals& totals() const { return totals_; }
    /// Of all that was delivered, s.
    double time() const { return totals_.time; }

    /// The next piece, planned.
    void add(const Piece& piece);
    /// The axes stand until an event of the operator, s.
    void add_hold(double duration);
    void set_commands(std::uint64_t commands) { totals_.commands = commands; }
    void set_travel(const AxisTable::Travel& travel);

  private:
    /// What the corner behind a piece asks of it.
    struct Last {
        AxisRates rates{};  // at its end
        AxisTable::Loads loads;
        AxisRates bends{};
        double along = 0;  // its acceleration along the path
        double near = 0;   // … within a tick of its end
        double jerk = 0;   // its jerk along the path
    };
    void add_time(const Segment& segment);
    void add_corner(const Piece& piece);
    void add_jerk(const Piece& piece, double along);

    const AxisTable& axes_;
    double tick_;
    Totals totals_;
    Last last_;  // delivered last
};

}  // namespace kadr::motion
