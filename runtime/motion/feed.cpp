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

int feed_parts(const path::Command& command, const Segment& piece, const Spindle& spindle) {
    constexpr double kRadiusStep = 0.05;
    constexpr double kMost = 64;  // a facing cut to the centre stays a handful of pieces
    if (!spindle.is_turning || !spindle.holds_cutting_speed ||
        command.feed_mode != path::FeedMode::PerRevolution) {
        return 1;
    }
    const path::Box box = path::bounds(piece.curve);
    const double change = box.upper[0] - box.lower[0];
    if (!(change > 0)) return 1;
    const double nearest = std::max({box.lower[0], -box.upper[0], change / kMost});
    return static_cast<int>(std::clamp(std::ceil(change / (kRadiusStep * nearest)), 1.0, kMost));
}

}  // namespace kadr::motion
