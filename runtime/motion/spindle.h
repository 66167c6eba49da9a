// spindle.h — how fast the spindle turns, for feed per revolution and dwells in revolutions.
//
// Commanded speeds only: the time that a spindle needs to reach them is not modelled here; that is
// the matter of process/ (drives).
#pragma once

#include <cmath>

#include "path/command.h"

namespace kadr::motion {

struct CommandedSpindle {
    bool is_turning = false;
    bool is_counterclockwise = false;
    bool holds_cutting_speed = false;  // the speed follows the radius
    double speed = 0;                  // rev/s, if it does not
    double cutting_speed = 0;          // mm/s, if it does
    double limit = 0;                  // rev/s, of the program; 0: none
    double least = 0;                  // … below which it does not turn then; `limit` comes first
    double machine_limit = 0;          // rev/s; 0: none

    /// rev/s with the tool at this distance from the spindle's axis, mm; 0 if it stands.
    /// source       reference motion §9.1
    double speed_at(double radius) const;
};

}  // namespace kadr::motion
