// through_run.h — a spline through points whose blocks are still coming.
#pragma once

#include <deque>

#include "interp/spline_run.h"
#include "nc/block.h"
#include "path/through_spline.h"

namespace kadr::interp {

/// What is programmed for the ends of such splines.
struct SplineEnds {
    path::SplineEnd::Kind start = path::SplineEnd::Kind::Natural;
    path::SplineEnd::Kind end = path::SplineEnd::Kind::Natural;
};

struct ThroughRun {
    nc::Function function = nc::Function::None;  // its motion: blocks may program it again
    path::ThroughSpline spline;
    std::deque<ControlPointBlock>
        blocks;          // of the spans to come: that of the point where each ends
    AxisMask moved = 0;  // axes that its blocks have named
};

}  // namespace kadr::interp
