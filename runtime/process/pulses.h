// pulses.h — how long a block can be made, so that it ends on a pulse of a laser.
//
// The pulses as windows of ticks are machine/pulse_clock.h's.
//
// source: the laser dissertation; reference motion §3.4
#pragma once

#include <optional>

#include "machine/pulse_clock.h"
#include "motion/profile.h"

namespace kadr::process {

using machine::PulseClock;
using machine::PulseWindow;

/// What a block has to keep: mm, s.
struct PulseLeg {
    double length = 0;        // > 0
    double speed = 0;         // limit inside, > 0
    double acceleration = 0;  // > 0, along the path, the same for braking
    double entry_limit = 0;   // speed of the corner before it; 0: it begins at rest
};

/// How long a leg can last between two end speeds.
struct Durations {
    double least = 0;  // s, the fastest trapezoid
    double most = 0;   // s, the slowest dip below both end speeds; infinite if it can stand
};

/// Nothing if the length does not suffice for the change of speed. The speeds are within the leg's.
/// source       reference motion §3.4
std::optional<Durations> durations(const PulseLeg& leg, double entry, double exit);

/// The profile that lasts exactly so long: its middle speed is found by bisection.
///
/// duration     s, within the bounds of `durations`
motion::Profile profile_lasting(const PulseLeg& leg, double entry, double exit, double duration);

}  // namespace kadr::process
