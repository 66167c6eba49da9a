// profile.h — distance over time along one piece of path.
//
// Two kinds behind the same questions (duration, state_at): the trapezoid of constant acceleration,
// cruise and constant deceleration, and a run of phases of constant jerk (smooth_profile.h). The
// sampler does not look into the phases.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "base/result.h"
#include "motion/varying_feed.h"

namespace kadr::motion {

/// What a profile has to keep. mm and s; deg instead of mm if only rotary axes move.
struct ProfileLimits {
    double speed = 0;                                       // > 0
    double acceleration = 0;                                // > 0
    double deceleration = 0;                                // > 0
    double jerk = std::numeric_limits<double>::infinity();  // > 0
};

/// Of a smooth profile: up with jerk, with constant acceleration, easing off; cruise; and the same
/// down.
inline constexpr std::size_t kPhases = 7;

/// A time of constant jerk.
struct Phase {
    double duration = 0;      // s
    double acceleration = 0;  // at its start, either sign
    double jerk = 0;          // either sign
};

struct Profile {
    double length = 0;  // of the path
    double entry_speed = 0;
    double peak_speed = 0;
    double exit_speed = 0;
    double acceleration = 0;  // greatest while accelerating; of a part, in the whole
    double deceleration = 0;  // greatest while braking
    double accelerating = 0;  // s, first part
    double cruising = 0;      // s, second part
    double braking = 0;       // s, third part
    double jerk = std::numeric_limits<double>::infinity();  // greatest, of either sign

    bool is_smooth = false;                // a run of phases, else a trapezoid
    double entry_acceleration = 0;         // smooth, and a part of a longer one: either sign
    std::array<double, kPhases> phases{};  // smooth: how long each lasts, s

    /// Of a feed that changes along the piece: the phases are those of its rate ρ, with these
    /// limits in 1/s and 1/s², and what is above is of the path all the same (varying_feed.h).
    struct Rate {
        VaryingFeed varying_feed;
        double entry = 0;
        double entry_acceleration = 0;
        double exit = 0;
        double acceleration = 0;
        double deceleration = 0;
        double jerk = std::numeric_limits<double>::infinity();
    };
    std::shared_ptr<const Rate> rate;  // hardly a piece has one

    bool has_varying_feed() const { return rate != nullptr; }
    double duration() const { return accelerating + cruising + braking; }
};

/// One phase of a smooth profile.
inline Phase phase_of(const Profile& profile, std::size_t i, bool is_first) {
    constexpr std::array<int, kPhases> kUp{0, 1, 1, 0, 0, 0, 0};
    constexpr std::array<int, kPhases> kDown{0, 0, 0, 0, 0, 1, 1};
    constexpr std::array<int, kPhases> kJerk{1, 0, -1, 0, -1, 0, 1};
    const double start = is_first ? profile.entry_acceleration
                                  : kUp[i] * profile.acceleration - kDown[i] * profile.deceleration;
    return {profile.phases[i], start, kJerk[i] == 0 ? 0 : kJerk[i] * profile.jerk};
}

/// Calls `visit` with every phase that lasts, in order, until it returns false.
template <typename Visit>
void for_each_phase(const Profile& profile, const Visit& visit) {
    bool is_first = true;
    for (std::size_t i = 0; i < kPhases; ++i) {
        if (!(profile.phases[i] > 0)) continue;
        if (!visit(phase_of(profile, i, is_first))) return;
        is_first = false;
    }
}

/// Greatest acceleration along the path of a profile, either way.
inline double path_acceleration(const Profile& profile) {
    if (profile.has_varying_feed()) return profile.acceleration;
    if (profile.is_smooth) {
        double greatest = 0;
        for_each_phase(profile, [&](const Phase& phase) {
            const double end = phase.acceleration + phase.jerk * phase.duration;
            greatest = std::max({greatest, std::abs(phase.acceleration), std::abs(end)});
            return true;
        });
        return greatest;
    }
    const double up = profile.accelerating > 0 ? profile.acceleration : 0;
    const double down = profile.braking > 0 ? profile.deceleration : 0;
    return up > down ? up : down;
}

/// Greatest jerk along the path of a profile, either way; infinite if the acceleration jumps.
inline double path_jerk(const Profile& profile) {
    if (profile.has_varying_feed()) return profile.jerk;
    if (!profile.is_smooth) return path_acceleration(profile) > 0 ? profile.jerk : 0;
    const auto& lasts = profile.phases;
    const bool changes = lasts[0] > 0 || lasts[2] > 0 || lasts[4] > 0 || lasts[6] > 0;
    return changes ? profile.jerk : 0;
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

/// The profile with its peak lowered so that it lasts a whole number of ticks; of a run of phases
/// only if it is a whole one, with no acceleration at its ends.
/// source       reference motion §2.7 (b)
Result<Profile, ProfileFault> fitted_to_ticks(const Profile& profile, double tick);

/// A state a time later in a phase that has begun in it.
inline ProfileState advanced(const ProfileState& from, const Phase& phase, double time) {
    const double half = 0.5 * phase.jerk * time;
    return {from.distance + (from.speed + (0.5 * phase.acceleration + half / 3) * time) * time,
            from.speed + (phase.acceleration + half) * time, phase.acceleration + 2 * half};
}

/// The profile over a piece with such a feed by the one of its rate, over its time.
Profile over_varying_feed(const Profile& rate, const VaryingFeed& varying_feed);
/// … and back: the profile of the rate of one that has a varying feed.
Profile rate_of(const Profile& profile);
ProfileState state_on_varying_feed(const Profile& profile, double time);

/// `state_at` of a run of phases. At most seven are added up, so nothing accumulates over pieces.
inline ProfileState state_in_phases(const Profile& profile, double time) {
    ProfileState at{0, profile.entry_speed, 0};
    bool is_over = true;
    for_each_phase(profile, [&](const Phase& phase) {
        at = advanced(at, phase, std::clamp(time, 0.0, phase.duration));
        is_over = time >= phase.duration;
        time -= phase.duration;
        return is_over;
    });
    if (is_over) return {profile.length, profile.exit_speed, at.acceleration};
    // The sum of rounding errors must not leave the piece.
    return {std::min(at.distance, profile.length), std::max(at.speed, 0.0), at.acceleration};
}

/// The state at `time` from the start. Computed from the start or the end of the phase, so nothing
/// accumulates; at the duration and after it the distance is the length, exactly.
inline ProfileState state_at(const Profile& profile, double time) {
    if (profile.is_smooth) {
        return profile.has_varying_feed() ? state_on_varying_feed(profile, time)
                                          : state_in_phases(profile, time);
    }
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
