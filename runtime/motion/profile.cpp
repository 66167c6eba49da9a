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

// ------------------------------------------------------------------------------ a varying feed

namespace {

/// A trapezoid as a run of phases.
Profile in_phases(const Profile& trapezoid) {
    Profile profile = trapezoid;
    profile.is_smooth = true;
    profile.phases = {0, trapezoid.accelerating, 0, trapezoid.cruising, 0, trapezoid.braking, 0};
    profile.entry_acceleration = trapezoid.accelerating > 0 ? trapezoid.acceleration
                                 : trapezoid.cruising > 0   ? 0
                                                            : -trapezoid.deceleration;
    return profile;
}

}  // namespace

Profile rate_of(const Profile& profile) {
    const Profile::Rate& own = *profile.rate;
    Profile rate = profile;
    rate.rate = nullptr;
    rate.length = own.varying_feed.time;
    rate.entry_speed = own.entry;
    rate.exit_speed = own.exit;
    rate.entry_acceleration = own.entry_acceleration;
    rate.acceleration = own.acceleration;
    rate.deceleration = own.deceleration;
    rate.jerk = own.jerk;
    return rate;
}

Profile over_varying_feed(const Profile& rate, const VaryingFeed& varying_feed) {
    const Profile phased = rate.is_smooth ? rate : in_phases(rate);
    Profile profile = phased;
    profile.rate = std::make_shared<const Profile::Rate>(
        Profile::Rate{varying_feed, phased.entry_speed, phased.entry_acceleration,
                      phased.exit_speed, phased.acceleration, phased.deceleration, phased.jerk});
    profile.length = varying_feed.length;
    profile.entry_speed = varying_feed.entry() * phased.entry_speed;
    profile.exit_speed = varying_feed.exit() * phased.exit_speed;
    profile.peak_speed = varying_feed.most * phased.peak_speed;
    const double ramp = path_acceleration(phased);
    const double highest = phased.peak_speed;
    profile.acceleration = varying_feed.acceleration * highest * highest + varying_feed.most * ramp;
    profile.deceleration = profile.acceleration;
    const double ramp_jerk = path_jerk(phased);
    profile.jerk = varying_feed.jerk * highest * highest * highest +
                   3 * varying_feed.acceleration * highest * ramp + varying_feed.most * ramp_jerk;
    profile.entry_acceleration =
        varying_feed.entry() * (varying_feed.slope(0) * phased.entry_speed * phased.entry_speed +
                                phased.entry_acceleration);
    return profile;
}

ProfileState state_on_varying_feed(const Profile& profile, double time) {
    const VaryingFeed& varying_feed = profile.rate->varying_feed;
    const ProfileState rate = state_in_phases(rate_of(profile), time);
    const double parameter = distance_at(varying_feed, rate.distance);
    const double feed = varying_feed.at(parameter);
    return {parameter, feed * rate.speed,
            feed * (varying_feed.slope(parameter) * rate.speed * rate.speed + rate.acceleration)};
}

}  // namespace kadr::motion
