// drives.h — how the main drive and a feed servo follow what is commanded.
//
// Difference equations for one step in time; what is commanded, and when, is drive_run.h's (a
// program) and facing_pass.h's (the pass of the paper). Speeds of the spindle are in rad/s here,
// torques in N·m, currents in A; positions and velocities of axes in mm and mm/s.
//
// The speed of the spindle has two loops. The inner one is proportional and set to the modulus
// optimum, Kp = J/(2·T·kT); the outer one integrates, with 1/(4·T). Together they answer a
// reference as the modulus optimum does (8 % overshoot), and a load as the symmetric optimum does
// (no error remains).
//
// source: the paper on the simulation of constant cutting speed; reference motion §9.2
#pragma once

#include "machine/process_data.h"

namespace kadr::process {

struct SpindleState {
    double reference = 0;  // rad/s, what the outer loop asks of the inner one
    double current = 0;    // A
    double speed = 0;      // rad/s
};

/// The spindle at a constant speed under a constant load: nothing changes.
SpindleState settled(const machine::SpindleDrive& drive, double speed, double load);

/// The idle torque at a speed.
double idle_torque(const machine::SpindleDrive& drive, double speed);

/// The state a step later.
///
/// wanted       rad/s, ≥ 0
/// load         torque of the cut, N·m, ≥ 0; it brakes, and so does the idle torque
/// step         s, below a fifth of the drive's time constant
SpindleState advanced(const machine::SpindleDrive& drive, SpindleState state, double wanted,
                      double load, double step);

/// One axis, or the command of one.
struct AxisState {
    double position = 0;  // mm
    double velocity = 0;  // mm/s
};

/// The axis a step later.
AxisState advanced(const machine::FeedDrive& drive, AxisState state, const AxisState& command,
                   double step);

/// The longest step at which the equations are stable and true to a thousandth, s.
double longest_step(const machine::Drives& drives);

}  // namespace kadr::process
