#include "driver/short_waits.h"

#include <cmath>

namespace kadr::driver {

namespace {

/// Ticks that are shown at each end of a wait: derivatives die out, and what comes begins from
/// rest.
constexpr double kReported = 16;

/// Whether nothing changes while it lasts.
bool is_standstill(const motion::Segment& segment) {
    return segment.profile.length == 0 && segment.train.count == 0;
}

}  // namespace

void ShortWaits::shorten(motion::Segment& segment) {
    segment.start_time -= missing_;
    if (!is_standstill(segment)) return;
    const double ticks = std::floor(segment.duration / tick_) - 2 * kReported;
    if (!(ticks > 0)) return;
    // Whole ticks, so that those behind stand where they would.
    segment.duration -= ticks * tick_;
    missing_ += ticks * tick_;
    const std::lock_guard lock(mutex_);
    cuts_.push_back({segment.start_time + kReported * tick_, missing_});
}

std::size_t ShortWaits::pull(std::span<motion::Segment> out) {
    const std::size_t count = segments_.pull(out);
    for (motion::Segment& segment : out.first(count)) shorten(segment);
    return count;
}

std::span<const motion::Setpoint> ShortWaits::restored(
    std::span<const motion::Setpoint> setpoints) {
    setpoints_.assign(setpoints.begin(), setpoints.end());
    const std::lock_guard lock(mutex_);
    for (motion::Setpoint& setpoint : setpoints_) {
        while (!cuts_.empty() && setpoint.time > cuts_.front().at) {
            passed_ = cuts_.front().total;
            cuts_.pop_front();
        }
        setpoint.time += passed_;
    }
    return setpoints_;
}

}  // namespace kadr::driver
