#include "motion/varying_feed.h"

#include <algorithm>
#include <cmath>

#include "path/quadrature.h"

namespace kadr::motion {

namespace {

/// Points at which the feed's own acceleration and jerk are looked at, and what they may be above
/// between them: they are polynomials over which the feed changes little.
constexpr int kPlaces = 16;
constexpr double kBetween = 1.02;
/// Of its limits this is left to ρ at least, whatever corners have taken beside the feed.
constexpr double kLeastShare = 0.1;
/// Intervals in which five points of Gauss have a time to the last digits.
constexpr int kIntervals = 4;

double time_between(const VaryingFeed& varying_feed, double from, double to) {
    double time = 0;
    const double step = (to - from) / kIntervals;
    for (int i = 0; i < kIntervals; ++i) {
        const double begin = from + i * step;
        time += path::gauss([&](double s) { return 1 / varying_feed.at(s); }, begin, begin + step);
    }
    return time;
}

}  // namespace

VaryingFeed varying_feed_of(const path::FeedPolynomial& feed, double length) {
    VaryingFeed varying_feed;
    varying_feed.feed = feed;
    varying_feed.length = length;
    const path::FeedRange range = path::feed_range(feed, 0, length);
    varying_feed.least = range.least;
    varying_feed.most = range.most;
    varying_feed.time = time_between(varying_feed, 0, length);
    for (int i = 0; i <= kPlaces; ++i) {
        const double s = length * i / kPlaces;
        const double f = varying_feed.at(s);
        const double slope = varying_feed.slope(s);
        const double bend = 2 * feed[2] + 6 * feed[3] * s;
        varying_feed.acceleration = std::max(varying_feed.acceleration, std::abs(f * slope));
        varying_feed.jerk = std::max(varying_feed.jerk, std::abs(f * (slope * slope + f * bend)));
    }
    varying_feed.acceleration *= kBetween;
    varying_feed.jerk *= kBetween;
    return varying_feed;
}

double distance_at(const VaryingFeed& varying_feed, double time) {
    if (time <= 0) return 0;
    if (time >= varying_feed.time) return varying_feed.length;
    // dτ/ds = 1/f: Newton's steps, which the even feed keeps inside.
    double s = varying_feed.length * time / varying_feed.time;
    constexpr int kMostSteps = 20;
    for (int i = 0; i < kMostSteps; ++i) {
        const double step = (time - time_between(varying_feed, 0, s)) * varying_feed.at(s);
        s = std::clamp(s + step, 0.0, varying_feed.length);
        if (std::abs(step) <= 1e-14 * varying_feed.length) break;
    }
    return s;
}

RateLimits rate_limits(const VaryingFeed& varying_feed, double acceleration, double jerk) {
    RateLimits limits;
    limits.acceleration =
        std::max(acceleration - varying_feed.acceleration, kLeastShare * acceleration) /
        varying_feed.most;
    if (std::isinf(jerk)) return limits;
    // 3·f·f'·ρ' and f·ρ'' share what f leaves: a third and two thirds.
    const double left = std::max(jerk - varying_feed.jerk, kLeastShare * jerk);
    if (9 * varying_feed.acceleration * limits.acceleration > left)
        limits.acceleration = left / (9 * varying_feed.acceleration);
    limits.jerk = (left - 3 * varying_feed.acceleration * limits.acceleration) / varying_feed.most;
    return limits;
}

}  // namespace kadr::motion
