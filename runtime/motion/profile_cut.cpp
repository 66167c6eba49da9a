#include "motion/profile_cut.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"

namespace kadr::motion {

namespace {

double distance_in(const Phase& phase, double speed, double t) {
    return (speed + (0.5 * phase.acceleration + phase.jerk / 6 * t) * t) * t;
}

double speed_in(const Phase& phase, double speed, double t) {
    return std::max(0.0, speed + (phase.acceleration + 0.5 * phase.jerk * t) * t);
}

}  // namespace

ProfileCut::ProfileCut(const Profile& whole) : whole_(whole), speed_(whole.entry_speed) {
    KADR_ASSERT(whole.is_smooth, "only a run of phases is cut");
    while (first_ < kPhases && !(whole.phases[first_] > 0)) ++first_;
    starts_[0] = {0, whole.entry_speed};
    for (std::size_t i = 0; i < kPhases; ++i) {
        const Phase phase = this->phase(i);
        starts_[i + 1] = {
            starts_[i].distance + distance_in(phase, starts_[i].speed, phase.duration),
            speed_in(phase, starts_[i].speed, phase.duration)};
    }
}

/// The time in the current phase at which a distance is reached that lies in it.
double ProfileCut::time_at(double distance) const {
    const Phase phase = this->phase(phase_);
    const Start& start = starts_[phase_];
    const double length = distance - start.distance;
    if (phase.jerk == 0 && phase.acceleration == 0) return length / start.speed;
    // The distance grows with time, so Newton's steps stay in a bracket.
    double low = time_;
    double high = phase.duration;
    double t =
        low + (high - low) * (distance - distance_) / (starts_[phase_ + 1].distance - distance_);
    for (int i = 0; i < 60; ++i) {
        const double miss = distance_in(phase, start.speed, t) - length;
        (miss > 0 ? high : low) = t;
        const double speed = speed_in(phase, start.speed, t);
        const double next = t - miss / speed;
        if (std::abs(next - t) <= 1e-15 * phase.duration) break;
        t = next > low && next < high ? next : (low + high) / 2;
        if (high - low <= 1e-15 * phase.duration) break;
    }
    return t;
}

/// Hands the current phase on up to a time in it.
void ProfileCut::take_phase(Profile& part, double until) {
    const double duration = until - time_;
    if (duration <= 0) return;
    if (part.duration() == 0) {
        const Phase phase = this->phase(phase_);
        part.entry_acceleration = phase.acceleration + phase.jerk * time_;
    }
    part.phases[phase_] = duration;
    (phase_ < 3 ? part.accelerating : phase_ == 3 ? part.cruising : part.braking) += duration;
}

Profile ProfileCut::next(double length, bool is_last) {
    Profile part;
    part.length = length;
    part.jerk = whole_.jerk;
    part.acceleration = whole_.acceleration;
    part.deceleration = whole_.deceleration;
    part.is_smooth = true;
    part.entry_speed = part.peak_speed = speed_;
    const double end = distance_ + length;
    for (; phase_ < kPhases; ++phase_) {
        const Phase phase = this->phase(phase_);
        const Start& behind = starts_[phase_ + 1];
        if (!is_last && behind.distance > end) {
            const double until = std::clamp(time_at(end), time_, phase.duration);
            take_phase(part, until);
            time_ = until;
            speed_ = speed_in(phase, starts_[phase_].speed, until);
            break;
        }
        take_phase(part, phase.duration);
        time_ = 0;
        speed_ = behind.speed;
        part.peak_speed = std::max(part.peak_speed, speed_);
    }
    distance_ = end;
    if (is_last) speed_ = whole_.exit_speed;
    part.exit_speed = speed_;
    part.peak_speed = std::min(std::max(part.peak_speed, speed_), whole_.peak_speed);
    return part;
}

}  // namespace kadr::motion
