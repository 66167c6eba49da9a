// path_check.h — setpoints held against the path that is programmed.
//
// The last look at what a machine is given, by other means than those that made it. The commands
// are taken as the planner reads them, before lines are compressed, corners are blended and motions
// are cut into pieces, and each is laid as one curve. The tip of every setpoint, worked out from
// its axes by the chain of the machine, is led along these curves: it has to be within the
// tolerance that is in force, in the order of the program, and where there is no tolerance none of
// the ends between two setpoints may be left out. No speed takes part but to know how far the tip
// may have come in a tick, and nothing that was planned.
//
// A setpoint counts to the first motion that it can belong to: if there is any way to lead the
// setpoints along the path in order, this one is. So nothing that keeps to the tolerances is
// refused.
//
// Beside the tip: the tool's direction under a transformation, and axes that follow a path without
// one. Memory is bounded by how far the planner looks ahead.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "base/done.h"
#include "machine/machine.h"
#include "motion/pipeline.h"
#include "motion/report.h"
#include "path/command.h"

namespace kadr::motion {

/// What is not as programmed.
enum class DeviationKind : std::uint8_t {
    Tip,        // the tip is beside the path, mm
    LeftOut,    // the path goes through a point that the tip keeps away from, mm
    Tool,       // the tool deviates from its direction, rad
    Followers,  // an axis beside X, Y, Z is somewhere else, rad or mm
    End,        // the motion ends before the path does, mm
};

struct PathDeviation {
    DeviationKind fault = DeviationKind::Tip;
    double distance = 0;     // by which it is off
    double allowed = 0;      // the tolerance in force
    double time = 0;         // s, of the setpoint
    CommandLocation motion;  // of which it is off
};

class PathCheck {
  public:
    /// The machine outlives the check. tick  s, between setpoints; 0: the machine's
    explicit PathCheck(const machine::Machine& machine, double tick = 0);
    ~PathCheck();

    /// The next command, as the planner reads it. Another thread than that of the setpoints may
    /// give them.
    void read(const path::Command& command);

    /// The next setpoints, whose commands have all been read; not done if one of them, or an
    /// earlier one, is off.
    Done follow(std::span<const Setpoint> setpoints);

    /// The last setpoint has been seen, and nothing has kept the motion from its end.
    void finish();

    /// The first one; the rest is not looked at.
    const std::optional<PathDeviation>& deviation() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kadr::motion
