// varying_feed.h — a feed that changes along a piece of path, and how it is run.
//
// Where f(s) is the feed at the distance s, the piece has a time of its own: τ(s) = ∫ ds/f. To run
// it as it is means that τ goes by like the time. What the axes need to come up to it, to brake and
// to pass corners slowly is a rate ρ = dτ/dt between 0 and 1, with a profile over τ as one of speed
// over length: v = f·ρ, and
//   dv/dt   = f·f'·ρ² + f·ρ'
//   d²v/dt² = f·(f·f')'·ρ³ + 3·f·f'·ρ·ρ' + f·ρ''
// What f itself takes of the acceleration and the jerk is left out of what ρ may have, so the sums
// are within the limits. Where neighbours go on with the same feed, ρ goes on.
#pragma once

#include <limits>

#include "path/feed_polynomial.h"

namespace kadr::motion {

/// What a feed takes where it is run as it is.
struct VaryingFeed {
    path::FeedPolynomial feed{};  // mm/s (deg/s) over mm (deg)
    double length = 0;            // mm, of the piece
    double time = 0;          // s: τ at its end; 0: the feed is constant, and this has no meaning
    double least = 0;         // mm/s
    double most = 0;          // mm/s
    double acceleration = 0;  // greatest |f·f'|
    double jerk = 0;          // greatest |f·(f·f')'|

    bool is_on() const { return time > 0; }
    double entry() const { return feed[0]; }
    double exit() const { return at(length); }
    double at(double s) const { return path::feed_at(feed, s); }
    double slope(double s) const { return path::feed_slope(feed, s); }
};

/// A piece of path with this feed.
///
/// length  > 0; the feed is above 0 on it and changes by a factor of two at most
VaryingFeed varying_feed_of(const path::FeedPolynomial& feed, double length);

/// The distance at the feed's own time τ, 0 … time; to the last digits.
double distance_at(const VaryingFeed& varying_feed, double time);

/// What ρ may have: 1/s and 1/s².
struct RateLimits {
    double acceleration = 0;
    double jerk = std::numeric_limits<double>::infinity();
};

/// acceleration, jerk  along the path, that the axes leave; the jerk may be infinite
RateLimits rate_limits(const VaryingFeed& varying_feed, double acceleration, double jerk);

}  // namespace kadr::motion
