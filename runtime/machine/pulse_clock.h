// pulse_clock.h — the pulses of a pumped laser as windows of ticks.
//
// The pump pulses all the time; one interval after a working pulse may be shorter or longer than
// the nominal one by the tolerance, the others are nominal. So a block of k intervals lasts
// (k − 1)·nominal + least … (k − 1)·nominal + most ticks.
//
// source: the laser dissertation; reference motion §3.3
#pragma once

#include <cstdint>
#include <optional>

#include "machine/process_data.h"

namespace kadr::machine {

/// The interval between pulses in ticks.
struct PulseClock {
    std::int64_t nominal = 0;
    std::int64_t least = 0;
    std::int64_t most = 0;
};

/// The clock of a pulsed laser.
///
/// tick         s
/// returns      nothing if no whole number of ticks is within the tolerance
std::optional<PulseClock> pulse_clock(const Laser& laser, double tick);

struct PulseWindow {
    std::int64_t first = 0;  // ticks from the last pulse
    std::int64_t last = 0;
};

/// The window of the k-th pulse, k ≥ 1.
PulseWindow pulse_window(const PulseClock& clock, std::int64_t k);

/// The tick of the k-th window at which a point is burnt best. A single interval lies between two
/// working pulses, whose energy is that of the nominal frequency. Of several the first one ends
/// with an empty pulse, and that may come early.
///
/// source: the laser dissertation, condition 2 of its Fig. 11; reference motion §3.3
std::int64_t best_tick(const PulseClock& clock, std::int64_t k);

/// The first window that ends `ticks` or later after the last pulse.
std::int64_t pulse_at_or_after(const PulseClock& clock, std::int64_t ticks);

}  // namespace kadr::machine
