#include "motion/profile.h"

#include <cmath>

#include "motion/smooth_profile.h"

namespace kadr::motion {

double ramp_length(double from, double to, const ProfileLimits& limits) {
    const double rate = to > from ? limits.acceleration : limits.deceleration;
    return std::abs(to * to - from * from) / (2 * rate);
}

Result<Profile, ProfileFault> trapezoid(double length, double entry, double exit,
                                        const ProfileLimits& limits) {
    const double a = limits.acceleration;
    const double d = limits.deceleration;
    // The look-ahead leaves ends that are feasible exactly, up to the rounding of v² + 2·a·S, which
    // for a short piece at high speed is far more than a share of its length.
    constexpr double kRounding = 1e-12;
    const double fastest = std::max(entry, exit);
    const double rate = exit > entry ? a : d;
    if (std::abs(exit * exit - entry * entry) >
        2 * rate * length * (1 + 1e-9) + kRounding * fastest * fastest) {
        return ProfileFault::TooShort;
    }
    const double reachable =
        std::sqrt((2 * a * d * length + d * entry * entry + a * exit * exit) / (a + d));
    Profile profile;
    profile.length = length;
    profile.entry_speed = entry;
    profile.exit_speed = exit;
    profile.peak_speed = std::max({std::min(limits.speed, reachable), entry, exit});
    profile.acceleration = a;
    profile.deceleration = d;
    profile.accelerating = (profile.peak_speed - entry) / a;
    profile.braking = (profile.peak_speed - exit) / d;
    const double ramps = 0.5 * ((entry + profile.peak_speed) * profile.accelerating +
                                (exit + profile.peak_speed) * profile.braking);
    // Below the limit the difference is rounding, and 1e-12 mm at a crawl would be a pause.
    if (reachable >= limits.speed && length > ramps) {
        profile.cruising = (length - ramps) / profile.peak_speed;
    }
    return profile;
}

double ticks_of(double duration, double tick) { return std::ceil(duration / tick - 1e-9); }

Result<Profile, ProfileFault> fitted_to_ticks(const Profile& profile, double tick) {
    const double duration = ticks_of(profile.duration(), tick) * tick;
    if (profile.is_smooth) return slowed_to(profile, duration);
    const double a = profile.acceleration;
    const double d = profile.deceleration;
    const double entry = profile.entry_speed;
    const double exit = profile.exit_speed;
    if (std::abs(duration - profile.duration()) <= 1e-9 * tick) return profile;
    // The duration as a function of the peak p, times p, is a parabola:
    // p²·(1/2a + 1/2d) − p·(T + entry/a + exit/d) + (S + entry²/2a + exit²/2d) = 0.
    // The lower root is the slow one.
    const double square = 0.5 / a + 0.5 / d;
    const double linear = duration + entry / a + exit / d;
    const double constant = profile.length + 0.5 * (entry * entry / a + exit * exit / d);
    const double root = std::sqrt(std::max(0.0, linear * linear - 4 * square * constant));
    const double peak = 2 * constant / (linear + root);
    if (peak < std::max(entry, exit)) return ProfileFault::EndTooFast;
    return trapezoid(profile.length, entry, exit, {peak, a, d});
}

}  // namespace kadr::motion
