// facing_pass.h — the facing pass of the paper on constant cutting speed: in to the centre, through
// it, and back to the base point.
//
// The pass has an interpolator of its own, as the paper's model has: it follows the real speed of
// the spindle, does not brake ahead of the centre, and reverses when the tool has passed it. A
// program, with blocks that end where they are programmed, is drive_run.h's.
#pragma once

#include <functional>

#include "machine/process_data.h"
#include "motion/spindle.h"

namespace kadr::process {

struct FacingPass {
    double radius = 0;                 // mm, of the base point
    motion::CommandedSpindle spindle;  // holds a cutting speed, with a limit
    double feed_per_revolution = 0;    // mm
    double rapid = 0;                  // mm/s, of the return
    double acceleration = 0;           // mm/s², of the interpolator
    double ramp_time = 0;              // s, in which its speed comes close to the commanded one
};

/// The drives at one moment of a pass.
struct FacingSample {
    double time = 0;     // s
    double radius = 0;   // mm, negative behind the centre
    double speed = 0;    // rad/s
    double current = 0;  // A
    double feed = 0;     // mm/s, towards the centre
    bool is_cutting = false;
};

/// Runs the pass from the balance of the spindle under load until the tool is back at the base
/// point, with the time step `step` in s, and shows every step. Returns the time.
///
/// source       reference motion §9.2, §9.3
double run_facing_pass(const machine::Drives& drives, const FacingPass& pass, double step,
                       const std::function<void(const FacingSample&)>& look);

}  // namespace kadr::process
