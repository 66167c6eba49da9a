// pulses.h — the pulses of a pumped laser as windows of ticks, and how long a block can be made.
//
// The pump pulses all the time; one interval after a working pulse may be shorter or longer than
// the nominal one by the tolerance, the others are nominal. So a block of k intervals lasts
// (k − 1)·nominal + least … (k − 1)·nominal + most ticks.
//
// source: the laser dissertation; reference motion §3.3, §3.4
#pragma once

#include <cstdint>
#include <optional>

#include "motion/profile.h"

namespace kadr::process {

/// The interval between pulses in ticks.
struct PulseClock {
    std::int64_t nominal = 0;
    std::int64_t least = 0;
    std::int64_t most = 0;
};

/// frequency    Hz, > 0
/// tolerance    share of the interval, 0 … 1
/// tick         s
/// returns      nothing if no whole number of ticks is within the tolerance
std::optional<PulseClock> pulse_clock(double frequency, double tolerance, double tick);

struct PulseWindow {
    std::int64_t first = 0;  // ticks from the last pulse
    std::int64_t last = 0;
};

/// The window of the k-th pulse, k ≥ 1.
PulseWindow pulse_window(const PulseClock& clock, std::int64_t k);

/// The first window that ends `ticks` or later after the last pulse.
std::int64_t pulse_at_or_after(const PulseClock& clock, std::int64_t ticks);

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
