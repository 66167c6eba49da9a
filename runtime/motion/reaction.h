// reaction.h — how a stretch of path is begun in a state that no look-ahead chose: faster than is
// allowed now, or in the middle of a ramp, because an override has changed.
//
// The speed goes to what is allowed now as fast as the stretch lets it. What the stretch may do
// (acceleration, jerk) holds at every speed that was ever planned on it, so nothing is passed on
// the way. Under a limit of the jerk the acceleration vanishes at the end of the stretch, as the
// look-ahead wants it; where the speed cannot come down within the stretch, it comes down as far as
// it can, and the next stretch goes on with it.
//
// Lengths and speeds only; the events are operator_panel.h's.
#pragma once

#include <optional>

#include "motion/profile.h"
#include "motion/stretch.h"

namespace kadr::motion {

/// Speed and acceleration along the path at one moment.
struct PathMoment {
    double speed = 0;         // ≥ 0
    double acceleration = 0;  // of either sign; 0 where the jerk is not limited
};

/// The profile from a moment to a steady speed, not longer than the stretch; as long as the stretch
/// if it takes all of it. Nothing if the profile from one end of the stretch to the other does.
///
/// stretch      its `speed` is what is allowed now, ≥ 0
/// exit_limit   speed allowed behind it now
/// source       reference motion §2.3 (start with an acceleration), §2.8
std::optional<Profile> reaction(const PathMoment& at, const Stretch& stretch, double exit_limit);

/// What of a profile lasts up to a time from its start.
Profile head_of(const Profile& profile, double time);

}  // namespace kadr::motion
