#include "motion/varying_feed.h"

#include <algorithm>
#include <cmath>

#include "path/quadrature.h"

namespace kadr::motion {

namespace {

/// Places at which the feed's own acceleration and jerk are looked at, and what they may be above
/// between them: they are polynomials over which the feed changes little.
constexpr int kPlaces = 16;
constexpr double kBetween = 1.02;
/// Of its limits this is left to ρ at least, whatever corners have taken beside the feed.
constexpr double kLeastShare = 0.1;
/// Intervals in which five points of Gauss have a time to the last digits.
constexpr int kIntervals = 4;

double time_between(const FeedCourse& course, double from, double to) {
    double time = 0;
    const double step = (to - from) / kIntervals;
    for (int i = 0; i < kIntervals; ++i) {
        const double begin = from + i * step;
        time += path::gauss([&](double s) { return 1 / course.at(s); }, begin, begin + step);
    }
    return time;
}

}  // namespace

FeedCourse course_of(const path::FeedPolynomial& feed, double length) {
    FeedCourse course;
    course.feed = feed;
    course.length = length;
    const path::FeedRange range = path::feed_range(feed, 0, length);
    course.least = range.least;
    course.most = range.most;
    course.time = time_between(course, 0, length);
    for (int i = 0; i <= kPlaces; ++i) {
        const double s = length * i / kPlaces;
        const double f = course.at(s);
        const double slope = course.slope(s);
        const double bend = 2 * feed[2] + 6 * feed[3] * s;
        course.acceleration = std::max(course.acceleration, std::abs(f * slope));
        course.jerk = std::max(course.jerk, std::abs(f * (slope * slope + f * bend)));
    }
    course.acceleration *= kBetween;
    course.jerk *= kBetween;
    return course;
}

double place_at(const FeedCourse& course, double time) {
    if (time <= 0) return 0;
    if (time >= course.time) return course.length;
    // dτ/ds = 1/f: Newton's steps, which the even feed keeps inside.
    double s = course.length * time / course.time;
    constexpr int kMostSteps = 20;
    for (int i = 0; i < kMostSteps; ++i) {
        const double step = (time - time_between(course, 0, s)) * course.at(s);
        s = std::clamp(s + step, 0.0, course.length);
        if (std::abs(step) <= 1e-14 * course.length) break;
    }
    return s;
}

RateLimits rate_limits(const FeedCourse& course, double acceleration, double jerk) {
    RateLimits limits;
    limits.acceleration =
        std::max(acceleration - course.acceleration, kLeastShare * acceleration) / course.most;
    if (std::isinf(jerk)) return limits;
    // 3·f·f'·ρ' and f·ρ'' share what f leaves: a third and two thirds.
    const double left = std::max(jerk - course.jerk, kLeastShare * jerk);
    if (9 * course.acceleration * limits.acceleration > left)
        limits.acceleration = left / (9 * course.acceleration);
    limits.jerk = (left - 3 * course.acceleration * limits.acceleration) / course.most;
    return limits;
}

}  // namespace kadr::motion
