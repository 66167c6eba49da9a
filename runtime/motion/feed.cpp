#include "motion/feed.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace kadr::motion {

namespace {

Result<double, FeedFault> feed_per_revolution(double feed, const path::Curve& curve,
                                              const Spindle& spindle) {
    const double first = spindle.speed_at(path::start(curve)[0]);
    if (!(first > 0)) return FeedFault::SpindleStands;
    if (!spindle.holds_cutting_speed) return feed * first;
    const double middle = spindle.speed_at(path::position(curve, path::length(curve) / 2)[0]);
    const double last = spindle.speed_at(path::end(curve)[0]);
    return feed * 6 / (1 / first + 4 / middle + 1 / last);
}

/// From the slowest to the fastest place of a part its feed grows by this factor at most; the mean
/// over it is then within a hundredth of every one.
constexpr double kEven = 1.018;
/// No part is shorter, mm: beside the axis the spindle would run away.
constexpr double kShortest = 1e-3;

struct SpeedRange {
    double least = 0;  // rev/s
    double most = 0;

    double ratio() const { return least > 0 ? most / least : 1; }
};

SpeedRange speed_range(const path::Curve& curve, const Spindle& spindle) {
    const path::Box box = path::bounds(curve);
    const double farthest = std::max(std::abs(box.lower[0]), std::abs(box.upper[0]));
    const double nearest = std::max({box.lower[0], -box.upper[0], 0.0});
    return {spindle.speed_at(farthest), spindle.speed_at(nearest)};
}

struct Part {
    double from = 0;
    double to = 0;
};

/// Halves a part until one feed does; appends where the parts end.
void cut_evenly(const path::Curve& curve, const Part& part, const Spindle& spindle,
                std::vector<double>& bounds) {
    const path::Curve here = path::part(curve, part.from, part.to);
    if (part.to - part.from < 2 * kShortest || speed_range(here, spindle).ratio() <= kEven) {
        bounds.push_back(part.to);
        return;
    }
    const double middle = (part.from + part.to) / 2;
    cut_evenly(curve, {part.from, middle}, spindle, bounds);
    cut_evenly(curve, {middle, part.to}, spindle, bounds);
}

}  // namespace

Result<double, FeedFault> path_feed(const path::Command& command, const Segment& piece,
                                    double length, const Spindle& spindle) {
    if (!(command.feed > 0)) return FeedFault::NoFeed;
    switch (command.feed_mode) {
        case path::FeedMode::PerMinute: return feed_from_mm_min(command.feed);
        case path::FeedMode::InverseTime: return length * command.feed / 60;
        case path::FeedMode::PerRevolution:
            return feed_per_revolution(command.feed, piece.curve, spindle);
    }
    return FeedFault::NoFeed;
}

std::vector<double> feed_bounds(const path::Command& command, const Segment& piece, double length,
                                const Spindle& spindle) {
    std::vector<double> bounds;
    if (!spindle.is_turning || !spindle.holds_cutting_speed ||
        command.feed_mode != path::FeedMode::PerRevolution) {
        return bounds;
    }
    if (speed_range(piece.curve, spindle).ratio() <= kEven) return bounds;
    bounds.push_back(0);
    cut_evenly(piece.curve, {0, length}, spindle, bounds);
    return bounds;
}

}  // namespace kadr::motion
