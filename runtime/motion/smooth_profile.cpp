#include "motion/smooth_profile.h"

#include <algorithm>
#include <cmath>

namespace kadr::motion {

namespace {

// Of two speeds, relative: closer ones are the rounding of a root, and a ramp between them would
// take its length from that rounding.
constexpr double kSameSpeed = 1e-12;

// A ramp may be longer than its room by so much, mm (deg): the rounding of a small difference of
// large speeds, a hundred-thousandth of an increment.
constexpr double kLengthRounding = 1e-8;

/// The positive root of y³ + p·y = r, p ≥ 0, r ≥ 0.
double cubic_root(double p, double r) {
    if (r <= 0) return 0;
    // Both bounds lie above the root, where the cubic is convex: Newton's steps only descend.
    double y = p * p * p > r * r ? r / p : std::min(std::cbrt(r), p > 0 ? r / p : std::cbrt(r));
    for (int i = 0; i < 60; ++i) {
        const double square = y * y;
        const double step = (y * (square + p) - r) / (3 * square + p);
        y -= step;
        if (step <= 1e-15 * y) break;
    }
    return y;
}

/// A ramp as its parts: with jerk, with constant acceleration, with jerk again.
struct Ramp {
    double jerking = 0;       // s, the first and the last part
    double steady = 0;        // s
    double acceleration = 0;  // greatest

    Ramp(double change, const RampLimits& limits) {
        if (change * limits.jerk >= limits.acceleration * limits.acceleration) {
            acceleration = limits.acceleration;
            jerking = acceleration / limits.jerk;
            steady = change / acceleration - jerking;
        } else {
            jerking = std::sqrt(change / limits.jerk);
            acceleration = limits.jerk * jerking;
        }
    }
    double time() const { return 2 * jerking + steady; }
};

/// The two ramps of a profile, and what its peak does to them.
struct Flanks {
    double length;
    double entry;
    double exit;
    RampLimits up;
    RampLimits down;

    double highest_end() const { return std::max(entry, exit); }
    double ramps_length(double peak) const {
        return smooth_ramp_length(entry, peak, up) + smooth_ramp_length(peak, exit, down);
    }
    double duration(double peak) const {
        return smooth_ramp_time(entry, peak, up) + smooth_ramp_time(peak, exit, down) +
               (length - ramps_length(peak)) / peak;
    }
    Profile profile(double peak, bool has_cruise) const;
};

/// From the phase `first` on.
Ramp add_ramp(Profile& profile, double change, const RampLimits& limits, std::size_t first) {
    const Ramp ramp(change, limits);
    profile.phases[first] = profile.phases[first + 2] = ramp.jerking;
    profile.phases[first + 1] = ramp.steady;
    return ramp;
}

Profile Flanks::profile(double peak, bool has_cruise) const {
    Profile profile;
    profile.length = length;
    profile.entry_speed = entry;
    profile.exit_speed = exit;
    profile.peak_speed = peak;
    profile.jerk = up.jerk;
    profile.is_smooth = true;
    const Ramp rise = add_ramp(profile, peak - entry, up, 0);
    profile.acceleration = rise.acceleration;
    profile.accelerating = rise.time();
    if (has_cruise) {
        profile.cruising = std::max(0.0, length - ramps_length(peak)) / peak;
        profile.phases[3] = profile.cruising;
    }
    const Ramp fall = add_ramp(profile, peak - exit, down, 4);
    profile.deceleration = fall.acceleration;
    profile.braking = fall.time();
    return profile;
}

/// How the length of a ramp from `from` grows with y, if it ends at `base` + y²: finite at y = 0
/// also for from = base, where it would grow infinitely with the speed itself.
double growth(double from, double base, double y, const RampLimits& limits) {
    const double change = base + y * y - from;
    const double sum = from + base + y * y;
    const Ramp ramp(change, limits);
    if (ramp.steady > 0) return y * (ramp.time() + sum / limits.acceleration);
    const double share = change > 0 ? y / std::sqrt(change) : 1;
    return 2 * y * ramp.jerking + sum * share / std::sqrt(limits.jerk);
}

/// The peak, below the limit, at which the two ramps fill the length.
double touching_peak(const Flanks& flanks, double limit) {
    const double base = flanks.highest_end();
    double low = 0;
    double high = std::sqrt(limit - base);
    double y = high;
    for (int i = 0; i < 100 && high - low > 1e-16 * high; ++i) {
        const double miss = flanks.ramps_length(base + y * y) - flanks.length;
        (miss > 0 ? high : low) = y;
        const double slope =
            growth(flanks.entry, base, y, flanks.up) + growth(flanks.exit, base, y, flanks.down);
        const double next = y - miss / slope;
        if (std::abs(next - y) <= 1e-15 * y) break;
        y = next > low && next < high ? next : (low + high) / 2;
    }
    return base + y * y;
}

}  // namespace

double smooth_ramp_time(double from, double to, const RampLimits& limits) {
    return Ramp(std::abs(to - from), limits).time();
}

double smooth_ramp_length(double from, double to, const RampLimits& limits) {
    return 0.5 * (from + to) * smooth_ramp_time(from, to, limits);
}

double smooth_reach(double from, double length, const RampLimits& limits) {
    const double a = limits.acceleration;
    const double gain = a * a / limits.jerk;  // of a ramp that just reaches its acceleration
    if ((2 * from + gain) * a <= length * limits.jerk) {
        return std::hypot(from - gain / 2, std::sqrt(2 * a * length)) - gain / 2;
    }
    // (v0 + v)·sqrt((v − v0)/j) = s; with y² = v − v0 that is y³ + 2·v0·y = s·sqrt(j).
    const double y = cubic_root(2 * from, length * std::sqrt(limits.jerk));
    return from + y * y;
}

double steady_reach(double from, double length, const RampLimits& limits) {
    const double a = limits.acceleration;
    const double j = limits.jerk;
    if (length * j * j >= 2 * a * a * a) {
        const double half_gain = a * a / (2 * j);
        if (from <= half_gain) return std::sqrt(2 * a * length) - half_gain;
    } else {
        // The cube of the lowest point's speed tells which side it is on; its root is rarely
        // needed.
        const double cube = j * length * length / 32;
        if (from * from * from <= cube) return 3 * std::cbrt(cube);
    }
    return smooth_reach(from, length, limits);
}

double time_over(double length, double from, double speed, const RampLimits& limits) {
    from = std::min(from, speed);
    const double a = limits.acceleration;
    const bool is_jerk_free = std::isinf(limits.jerk);
    const double reached =
        is_jerk_free ? std::sqrt(from * from + 2 * a * length) : smooth_reach(from, length, limits);
    const double top = std::min(reached, speed);
    const double ramp_time = is_jerk_free ? (top - from) / a : smooth_ramp_time(from, top, limits);
    if (reached <= speed) return ramp_time;
    const double ramp_length =
        is_jerk_free ? (top * top - from * from) / (2 * a) : smooth_ramp_length(from, top, limits);
    return ramp_time + (length - ramp_length) / speed;
}

double speed_from_rest(double length, const RampLimits& limits) {
    return std::isinf(limits.jerk) ? std::sqrt(2 * limits.acceleration * length)
                                   : smooth_reach(0, length, limits);
}

double time_from_rest(double length, double exit, const ProfileLimits& limits) {
    const RampLimits up{limits.acceleration, limits.jerk};
    exit = std::min({exit, limits.speed, speed_from_rest(length, up)});
    const auto profile = std::isinf(limits.jerk) ? trapezoid(length, 0, exit, limits)
                                                 : seven_phases(length, 0, exit, limits);
    return profile ? profile->duration() : time_over(length, 0, limits.speed, up);
}

Result<Profile, ProfileFault> seven_phases(double length, double entry, double exit,
                                           const ProfileLimits& limits) {
    const Flanks flanks{length,
                        entry,
                        exit,
                        {limits.acceleration, limits.jerk},
                        {limits.deceleration, limits.jerk}};
    const double base = flanks.highest_end();
    const double excess = flanks.ramps_length(base) - length;
    if (excess > 0 && std::abs(entry - exit) <= kSameSpeed * base) {
        Flanks level = flanks;
        level.entry = level.exit = base;
        Profile cruise = level.profile(base, true);
        cruise.entry_speed = entry;
        cruise.exit_speed = exit;
        return cruise;
    }
    if (excess > kLengthRounding + 1e-9 * length) return ProfileFault::TooShort;
    if (excess >= 0) return flanks.profile(base, false);
    if (base >= limits.speed) return flanks.profile(base, true);
    if (flanks.ramps_length(limits.speed) <= length) return flanks.profile(limits.speed, true);
    return flanks.profile(touching_peak(flanks, limits.speed), false);
}

Result<Profile, ProfileFault> slowed_to(const Profile& profile, double duration) {
    const Flanks flanks{profile.length,
                        profile.entry_speed,
                        profile.exit_speed,
                        {profile.acceleration, profile.jerk},
                        {profile.deceleration, profile.jerk}};
    double low = flanks.highest_end();
    double high = profile.peak_speed;
    if (std::abs(duration - profile.duration()) <= 1e-12 * duration) return profile;
    if (high <= low || (low > 0 && flanks.duration(low) < duration)) {
        return ProfileFault::EndTooFast;
    }
    // The lower the peak, the longer it takes.
    for (int i = 0; i < 200; ++i) {
        const double peak = (low + high) / 2;
        if (peak <= low || peak >= high) break;
        (flanks.duration(peak) > duration ? low : high) = peak;
    }
    return flanks.profile(high, true);
}

}  // namespace kadr::motion
