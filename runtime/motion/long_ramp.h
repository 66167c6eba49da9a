// long_ramp.h — one smooth profile over several stretches of a bent path.
//
// Between stretches the acceleration vanishes, and a stretch has the least of its pieces' limits.
// Where the path bends more and more, its limits change all the time: the speed would come down in
// small steps. Here one ramp is tried over many stretches at once, and held against every piece it
// passes: its own speed limit, and with the speed, the acceleration and the jerk that the ramp has
// just there, what every axis does. What does not keep all of it is not taken, so no limit can be
// passed; the speeds at its ends are those of the look-ahead.
//
// Knows planned stretches and their pieces; no geometry and no time.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "motion/axis_table.h"
#include "motion/lookahead.h"
#include "motion/piece.h"
#include "motion/profile.h"

namespace kadr::motion {

/// A stretch that the look-ahead has given its speeds, and the profile that it has by itself.
struct PlannedStretch {
    Stretch limits;
    JunctionSpeeds speeds;
    Profile profile;
};

/// So many stretches are tried together at most.
inline constexpr std::size_t kMostJoined = 24;

struct LongRamp {
    std::size_t stretches = 0;  // that it replaces, from the first on
    Profile profile;
};

/// The profile that saves most against those of the stretches by themselves; nothing if none does.
///
/// planned  in the order of the path, all with a limited jerk
/// pieces   whose first is the first one of `planned`
std::optional<LongRamp> long_ramp(const std::deque<PlannedStretch>& planned, PieceRing& pieces,
                                  const AxisTable& axes);

}  // namespace kadr::motion
