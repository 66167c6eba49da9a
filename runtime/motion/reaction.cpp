#include "motion/reaction.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "motion/smooth_profile.h"

namespace kadr::motion {

namespace {

// Of two speeds, relative: closer ones differ by the rounding of a root. Less than in
// smooth_profile.cpp, which has to take them for the same as well.
constexpr double kSameSpeed = 1e-13;
// As in smooth_profile.cpp: by so much may a ramp be longer than its room, mm (deg).
constexpr double kLengthRounding = 1e-8;
// Slower is standing, mm/s (deg/s): the rounding of a ramp that ends at rest.
constexpr double kStanding = 1e-7;
// A rest of a stretch that is shorter is none.
constexpr double kNoLength = 1e-9;
// Where the end of a ramp was planned before and is planned again, mm (deg).
constexpr double kReplanned = 1e-6;

double braking_length(double from, double to, const Stretch& stretch) {
    if (from <= to * (1 + kSameSpeed)) return 0;
    if (std::isinf(stretch.jerk)) return (from * from - to * to) / (2 * stretch.acceleration);
    return smooth_ramp_length(from, to, {stretch.acceleration, stretch.jerk});
}

bool fits(double length, double parameter) {
    return length <= parameter + kLengthRounding + 1e-9 * parameter;
}

/// The ramp from a moment to a steady speed, and its length in `length`.
Profile ramp_from(const PathMoment& at, double to, const RampLimits& limits, double level) {
    const bool rises = to >= level;
    const double change = rises ? to - at.speed : at.speed - to;
    const double first = rises ? at.acceleration : -at.acceleration;
    // change = (peak² − first²)/2j + peak²/2j, unless the peak is cut off.
    const double square = std::max(0.0, limits.jerk * change + first * first / 2);
    const double peak = std::min(std::sqrt(square), limits.acceleration);
    const std::size_t phase = rises ? 0 : 4;
    Profile profile;
    profile.is_smooth = true;
    profile.jerk = limits.jerk;
    profile.entry_speed = at.speed;
    profile.entry_acceleration = at.acceleration;
    profile.exit_speed = to;
    profile.peak_speed = std::max({at.speed, to, level});
    profile.phases[phase] = std::max(0.0, (peak - first) / limits.jerk);
    profile.phases[phase + 1] =
        peak < limits.acceleration ? 0 : (square - peak * peak) / (peak * limits.jerk);
    profile.phases[phase + 2] = peak / limits.jerk;
    (rises ? profile.acceleration : profile.deceleration) = peak;
    double& time = rises ? profile.accelerating : profile.braking;
    ProfileState end{0, at.speed, at.acceleration};
    for_each_phase(profile, [&](const Phase& part) {
        end = advanced(end, part, part.duration);
        time += part.duration;
        return true;
    });
    profile.length = end.distance;
    return profile;
}

/// Reactions on one stretch whose jerk is limited.
class SmoothReaction {
  public:
    SmoothReaction(const PathMoment& at, const Stretch& stretch, double exit_limit)
        : at_(at),
          stretch_(stretch),
          exit_limit_(exit_limit),
          // Where the speed is steady again soonest.
          level_(std::max(
              0.0, at.speed + at.acceleration * std::abs(at.acceleration) / (2 * stretch.jerk))) {}

    Profile profile() const {
        const double most = stretch_.speed;
        if (need(most) <= stretch_.length) return ramp_to(most);
        const double least = std::min({level_, exit_limit_, most});
        // What the plan before came to must not be missed for its rounding: the next speed that
        // fits may be far above it.
        if (ramp_to(least).length <= stretch_.length + rounding_)
            return ramp_to(most_within(least, most));
        return braking_through(least);
    }

  private:
    Profile ramp_to(double speed) const {
        return ramp_from(at_, speed, {stretch_.acceleration, stretch_.jerk}, level_);
    }
    /// Length to a steady speed, and from there to what is allowed behind the stretch.
    double need(double speed) const {
        return ramp_to(speed).length + braking_length(speed, exit_limit_, stretch_);
    }
    /// A speed between one that fits and one that does not, from which the end can just be reached.
    double most_within(double low, double high) const {
        for (int i = 0; i < 100; ++i) {
            const double middle = (low + high) / 2;
            if (middle <= low || middle >= high) break;
            (need(middle) <= stretch_.length ? low : high) = middle;
        }
        return low;
    }
    bool is_place_for(double speed) const { return ramp_to(speed).length <= stretch_.length; }
    /// Where what is allowed behind the stretch cannot be met. Below a²/2j a ramp to a lower speed
    /// is the shorter one (reference motion §2.5), so there may be speeds that can be reached below
    /// it, down to 0; these are allowed as well. If not, the stretch is left faster than it may be
    /// now, and never faster than in the plan before: the ramp gets shorter with higher speeds
    /// then.
    Profile braking_through(double least) const {
        const bool can_rest = ramp_to(0).length <= stretch_.length + rounding_;
        double good = can_rest ? 0 : level_;
        double bad = least;
        // What was planned several times may be too long by a few roundings.
        for (int i = 0; i < 100 && is_place_for(good); ++i) {
            const double middle = (good + bad) / 2;
            if (middle <= std::min(good, bad) || middle >= std::max(good, bad)) break;
            (is_place_for(middle) ? good : bad) = middle;
        }
        Profile profile = ramp_to(good < kStanding ? 0 : good);
        KADR_ASSERT(profile.length <= stretch_.length + rounding_,
                    "a ramp that was planned to end in its stretch does not");
        profile.length = stretch_.length;
        return profile;
    }

    PathMoment at_;
    const Stretch& stretch_;
    double exit_limit_;
    double level_;
    double rounding_ = kReplanned * (1 + stretch_.length);
};

Profile sharp_reaction(double speed, const Stretch& stretch, double exit_limit) {
    const double square = speed * speed - 2 * stretch.acceleration * stretch.length;
    const double slowest = square > kStanding * speed ? std::sqrt(square) : 0;
    const double to = slowest > exit_limit ? slowest : stretch.speed;
    Profile profile;
    profile.entry_speed = profile.peak_speed = speed;
    profile.exit_speed = to;
    profile.acceleration = profile.deceleration = stretch.acceleration;
    profile.braking = (speed - to) / stretch.acceleration;
    profile.length = slowest > exit_limit ? stretch.length : 0.5 * (speed + to) * profile.braking;
    return profile;
}

}  // namespace

std::optional<Profile> reaction(const PathMoment& at, const Stretch& stretch, double exit_limit) {
    const bool is_slow = at.speed <= stretch.speed * (1 + kSameSpeed);
    if (is_slow && at.acceleration == 0 &&
        fits(braking_length(at.speed, exit_limit, stretch), stretch.length)) {
        return std::nullopt;
    }
    Profile profile = std::isinf(stretch.jerk) ? sharp_reaction(at.speed, stretch, exit_limit)
                                               : SmoothReaction(at, stretch, exit_limit).profile();
    if (profile.length > stretch.length - kNoLength) {
        profile.length = stretch.length;
        if (std::abs(profile.exit_speed - exit_limit) < kStanding) profile.exit_speed = exit_limit;
    }
    return profile;
}

Profile head_of(const Profile& profile, double time) {
    const ProfileState end = state_at(profile, time);
    Profile head = profile;
    head.length = end.distance;
    head.exit_speed = end.speed;
    head.accelerating = std::min(profile.accelerating, time);
    head.cruising = std::clamp(time - profile.accelerating, 0.0, profile.cruising);
    head.braking = std::clamp(time - profile.accelerating - profile.cruising, 0.0, profile.braking);
    if (profile.is_smooth) {
        double left = time;
        for (double& phase : head.phases) {
            phase = std::clamp(left, 0.0, phase);
            left -= phase;
        }
    } else if (time < profile.accelerating) {
        head.peak_speed = end.speed;
    }
    return head;
}

}  // namespace kadr::motion
