// feed_polynomial.h — a feed over a path, as a polynomial of the third degree.
//
// The unit of the feed and that of the path are the caller's: a program has its F over a part of a
// path, 0 … 1, an interpolator mm/s over mm.
#pragma once

#include <array>

namespace kadr::path {

/// f(s) = Σ c_i·s^i.
using FeedPolynomial = std::array<double, 4>;

inline double feed_at(const FeedPolynomial& feed, double s) {
    return feed[0] + s * (feed[1] + s * (feed[2] + s * feed[3]));
}

/// f'(s).
inline double feed_slope(const FeedPolynomial& feed, double s) {
    return feed[1] + s * (2 * feed[2] + s * 3 * feed[3]);
}

/// Least and greatest feed between two points.
struct FeedRange {
    double least = 0;
    double most = 0;
};
FeedRange feed_range(const FeedPolynomial& feed, double from, double to);

/// The same feed counted from another point.
FeedPolynomial feed_from(const FeedPolynomial& feed, double from);

/// The same feed, in a unit of which `scale` are one, over a path whose unit is `stretch` times as
/// long.
FeedPolynomial feed_in_units(const FeedPolynomial& feed, double scale, double stretch);

}  // namespace kadr::path
