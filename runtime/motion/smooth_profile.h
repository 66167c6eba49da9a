// smooth_profile.h — changes of speed under a limit of the jerk, and the profile of seven phases.
//
// A smooth ramp begins and ends without acceleration: jerk up, constant acceleration if there is
// time for it, jerk down. Knows one set of limits and one length; which length that may be, and how
// its profile is shared out among pieces, is the planner's matter (stretch.h, profile_cut.h).
#pragma once

#include "motion/profile.h"

namespace kadr::motion {

/// What a smooth ramp has to keep, along the path.
struct RampLimits {
    double acceleration = 0;  // > 0
    double jerk = 0;          // > 0, finite
};

/// Time and length of the smooth ramp between two speeds, ≥ 0 each.
/// source       reference motion §2.3
double smooth_ramp_time(double from, double to, const RampLimits& limits);
double smooth_ramp_length(double from, double to, const RampLimits& limits);

/// The greatest speed that a smooth ramp from `from` reaches within `length`.
///
/// Not monotone in `from`: a slow start can reach more than a faster one.
/// source       reference motion §2.3, §2.5
double smooth_reach(double from, double length, const RampLimits& limits);

/// The least of smooth_reach over all speeds ≥ `from`: monotone, so that a look-ahead may raise
/// speeds when it learns more and never has to take one back. Below smooth_reach by 5.5 % at most.
/// source       reference motion §2.5
double steady_reach(double from, double length, const RampLimits& limits);

/// The time over `length` from one speed up to another one, ≥ 0 each, as soon as the limits allow.
///
/// limits  the jerk may be infinite
double time_over(double length, double from, double speed, const RampLimits& limits);

/// The greatest speed that is reached within `length` from rest.
///
/// limits  the jerk may be infinite
double speed_from_rest(double length, const RampLimits& limits);

/// The least time over `length` from rest to `exit`, which is lowered to what can be reached so.
///
/// limits  the jerk may be infinite
double time_from_rest(double length, double exit, const ProfileLimits& limits);

/// The fastest profile of seven phases over `length`, without acceleration at its ends and nowhere
/// below the lower end speed.
///
/// length       ≥ 0
/// entry, exit  speeds at the ends, 0 ≤ … ≤ limits.speed
/// limits       with a finite jerk
/// source       reference motion §2.3
Result<Profile, ProfileFault> seven_phases(double length, double entry, double exit,
                                           const ProfileLimits& limits);

/// A profile of seven phases with its peak lowered so that it lasts as long as given.
///
/// duration     not shorter than the profile's
Result<Profile, ProfileFault> slowed_to(const Profile& profile, double duration);

}  // namespace kadr::motion
