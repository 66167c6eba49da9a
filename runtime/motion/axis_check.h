// axis_check.h — can the machine's axes go where a piece of path leads?
//
// Reports axes that the machine does not have and limits that would be passed, each once until the
// axis is back inside, and keeps the travel of the whole run.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "base/done.h"
#include "machine/machine.h"
#include "motion/axis_table.h"
#include "motion/pipeline.h"

namespace kadr::motion {

/// What has been reported of the axes: that one is missing is reported once, that one is outside of
/// its limits again when it has been back.
class ReportedAxes {
  public:
    bool first_time_missing(std::size_t logical) { return !std::exchange(missing_[logical], true); }
    bool first_time_outside(std::size_t slot) { return !std::exchange(outside_[slot], true); }
    void forget_outside(std::size_t slot) { outside_[slot] = false; }

  private:
    std::array<bool, kAxes> missing_{};  // per logical axis
    std::array<bool, kAxes> outside_{};  // per machine axis
};

class AxisCheck {
  public:
    /// References outlive the check.
    AxisCheck(const machine::Machine& machine, const AxisTable& axes, const PlannerOptions& options,
              DiagnosticSink& sink);

    enum class Answer : std::uint8_t {
        Possible,
        Beyond,      // passes a limit
        Impossible,  // needs an axis that is not there
    };
    /// Asks about a piece of this path length and reports what is wrong with it.
    Answer check(const path::Command& command, const Segment& piece, double length);

    /// Counts the piece that was checked last into the travel.
    void widen_travel();
    /// Least and greatest position of every axis so far, start included.
    const AxisTable::Travel& travel() const { return travel_; }

  private:
    Done require_all_axes(const path::Command& command, const Segment& piece, double length);
    Done require_limits(const path::Command& command, const AxisTable::Travel& reached);

    const machine::Machine& machine_;
    const AxisTable& axes_;
    const PlannerOptions& options_;
    DiagnosticSink& sink_;
    std::vector<Axis> missing_;  // logical axes without a machine axis
    AxisMask missing_mask_ = 0;  // … the same
    ReportedAxes reported_;
    AxisTable::Travel reached_;  // of the piece that was checked last
    AxisTable::Travel travel_;
};

}  // namespace kadr::motion
