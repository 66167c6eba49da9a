// profile.h — distance over time along one piece of path.
//
// Trapezoidal: constant acceleration, cruise, constant deceleration. The jerk-limited profile of
// seven phases will be a second kind behind the same questions (duration, state_at); the planner
// and the sampler do not look into the phases.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/result.h"

namespace kadr::motion {

/// What a profile has to keep. mm and s; deg instead of mm for pure turning.
struct ProfileLimits {
    double speed = 0;         // > 0
    double acceleration = 0;  // > 0
    double deceleration = 0;  // > 0
};

struct Profile {
    double length = 0;  // of the path
    double entry_speed = 0;
    double peak_speed = 0;
    double exit_speed = 0;
    double acceleration = 0;  // of the first phase, > 0
    double deceleration = 0;  // of the last phase, > 0
    double accelerating = 0;  // s, first phase
    double cruising = 0;      // s, second phase
    double braking = 0;       // s, third phase

    double duration() const { return accelerating + cruising + braking; }
};

/// Greatest acceleration along the path of a profile, either way.
constexpr double path_acceleration(const Profile& profile) {
    const double up = profile.accelerating > 0 ? profile.acceleration : 0;
    const double down = profile.braking > 0 ? profile.deceleration : 0;
    return up > down ? up : down;
}

/// Distance, speed and acceleration at one moment.
struct ProfileState {
    double distance = 0;
    double speed = 0;
    double acceleration = 0;
};

enum class ProfileFault : std::uint8_t {
    TooShort,    // the length does not suffice for the change of speed
    EndTooFast,  // the profile cannot be slowed by its peak, because an end speed is the peak
};

/// The fastest trapezoid over `length` from one speed to the other.
///
/// length       ≥ 0
/// entry, exit  speeds at the ends, 0 ≤ … ≤ limits.speed
/// source       reference motion §2.2
Result<Profile, ProfileFault> trapezoid(double length, double entry, double exit,
                                        const ProfileLimits& limits);

/// The least length for a change of speed under constant acceleration.
double ramp_length(double from, double to, const ProfileLimits& limits);

/// How many ticks a duration takes. A billionth of a tick is rounding, not time.
double ticks_of(double duration, double tick);

/// The profile with its peak lowered so that it lasts a whole number of ticks.
/// source       reference motion §2.7 (b)
Result<Profile, ProfileFault> fitted_to_ticks(const Profile& profile, double tick);

/// The state at `time` from the start. Computed from the start or the end of the phase, so nothing
/// accumulates; at the duration and after it the distance is the length, exactly.
inline ProfileState state_at(const Profile& profile, double time) {
    if (time < profile.accelerating) {
        const double t = std::max(0.0, time);
        return {(profile.entry_speed + 0.5 * profile.acceleration * t) * t,
                profile.entry_speed + profile.acceleration * t, profile.acceleration};
    }
    time -= profile.accelerating;
    if (time < profile.cruising) {
        const double ramp = 0.5 * (profile.entry_speed + profile.peak_speed) * profile.accelerating;
        return {ramp + profile.peak_speed * time, profile.peak_speed, 0};
    }
    const double left = std::max(0.0, profile.cruising + profile.braking - time);
    return {profile.length - (profile.exit_speed + 0.5 * profile.deceleration * left) * left,
            profile.exit_speed + profile.deceleration * left,
            profile.braking > 0 ? -profile.deceleration : 0.0};
}

}  // namespace kadr::motion
