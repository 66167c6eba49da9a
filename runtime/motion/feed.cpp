#include "motion/feed.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "motion/feed_axes.h"

namespace kadr::motion {

namespace {

Result<double, FeedFault> feed_per_revolution(double feed, const path::Curve& curve,
                                              const CommandedSpindle& spindle) {
    const double first = spindle.speed_at(path::start(curve)[0]);
    if (!(first > 0)) return FeedFault::SpindleStands;
    if (!spindle.holds_cutting_speed) return feed * first;
    const double middle = spindle.speed_at(path::position(curve, path::length(curve) / 2)[0]);
    const double last = spindle.speed_at(path::end(curve)[0]);
    return feed * 6 / (1 / first + 4 / middle + 1 / last);
}

/// From the slowest to the fastest point of a part its feed grows by this factor at most; the mean
/// over it is then within a hundredth of every one.
constexpr double kEven = 1.018;
/// No part is shorter, mm: beside the axis the spindle would run away.
constexpr double kShortest = 1e-3;

struct SpeedRange {
    double least = 0;  // rev/s
    double most = 0;

    double ratio() const { return least > 0 ? most / least : 1; }
};

SpeedRange speed_range(const path::Curve& curve, const CommandedSpindle& spindle) {
    const path::Box box = path::bounds(curve);
    const double farthest = std::max(std::abs(box.lower[0]), std::abs(box.upper[0]));
    const double nearest = std::max({box.lower[0], -box.upper[0], 0.0});
    return {spindle.speed_at(farthest), spindle.speed_at(nearest)};
}

struct Part {
    double from = 0;
    double to = 0;
};

/// What makes the feed of a piece uneven.
struct Uneven {
    const Segment& piece;
    const path::Dynamics* dynamics = nullptr;   // feed axes; null: they are even
    const CommandedSpindle* spindle = nullptr;  // null: it keeps its speed

    bool is_even(const Part& part) const {
        if (dynamics != nullptr) {
            const FeedAxesRange range = feed_axes_range(*dynamics, piece, part.from, part.to);
            if (range.most > kEven * range.least) return false;
        }
        if (spindle == nullptr) return true;
        const path::Curve here = path::part(piece.curve, part.from, part.to);
        return speed_range(here, *spindle).ratio() <= kEven;
    }
};

/// Halves a part until one feed does; appends where the parts end.
void cut_evenly(const Uneven& uneven, const Part& part, std::vector<double>& bounds) {
    if (part.to - part.from < 2 * kShortest || uneven.is_even(part)) {
        bounds.push_back(part.to);
        return;
    }
    const double middle = (part.from + part.to) / 2;
    cut_evenly(uneven, {part.from, middle}, bounds);
    cut_evenly(uneven, {middle, part.to}, bounds);
}

/// What is programmed of the feed axes, if F is not about X, Y and Z; of a thread it never is.
const path::Dynamics* feed_axes_of(const path::Motion& motion) {
    if (!motion.dynamics || motion.op() == path::Op::Thread) return nullptr;
    static const path::Dynamics kPlain;
    const path::Dynamics& programmed = *motion.dynamics;
    const bool is_plain =
        programmed.feed_axes == kPlain.feed_axes && programmed.feed_radius == kPlain.feed_radius;
    return is_plain ? nullptr : &programmed;
}

}  // namespace

Result<double, FeedFault> path_feed(const path::Motion& motion, const Segment& piece, double length,
                                    const CommandedSpindle& spindle, const AxisTable* axes) {
    if (!(motion.feed > 0)) return FeedFault::NoFeed;
    // The time of the block is what it is, whatever the path that F is about.
    if (motion.feed_mode == path::FeedMode::InverseTime) return length * motion.feed / 60;
    const path::Dynamics* programmed = feed_axes_of(motion);
    const double rate =
        programmed == nullptr ? 1 : mean_feed_axes_rate(*programmed, piece, length, axes);
    if (motion.feed_mode == path::FeedMode::PerMinute) return feed_from_mm_min(motion.feed) / rate;
    const auto feed = feed_per_revolution(motion.feed, piece.curve, spindle);
    return feed ? Result<double, FeedFault>(*feed / rate) : feed;
}

std::vector<double> feed_bounds(const path::Motion& motion, const Segment& piece, double length,
                                const CommandedSpindle& spindle) {
    const bool is_by_turns = spindle.is_turning && spindle.holds_cutting_speed &&
                             motion.feed_mode == path::FeedMode::PerRevolution;
    const bool is_straight = std::holds_alternative<path::Line>(piece.curve);
    const bool is_by_axes =
        !is_straight && !piece.is_transformed() && motion.feed_mode != path::FeedMode::InverseTime;
    const Uneven uneven{piece, is_by_axes ? feed_axes_of(motion) : nullptr,
                        is_by_turns ? &spindle : nullptr};
    const Part whole{0, length};
    std::vector<double> bounds;
    if (uneven.is_even(whole)) return bounds;
    bounds.push_back(0);
    cut_evenly(uneven, whole, bounds);
    return bounds;
}

}  // namespace kadr::motion
