#include "path/feed_polynomial.h"

#include <algorithm>
#include <cmath>

namespace kadr::path {

FeedRange feed_range(const FeedPolynomial& feed, double from, double to) {
    FeedRange range{std::min(feed_at(feed, from), feed_at(feed, to)),
                    std::max(feed_at(feed, from), feed_at(feed, to))};
    const auto look = [&](double s) {
        if (!(s > from && s < to)) return;
        range.least = std::min(range.least, feed_at(feed, s));
        range.most = std::max(range.most, feed_at(feed, s));
    };
    // f' = 0; the second root by the product of both.
    const double root = feed[2] * feed[2] - 3 * feed[1] * feed[3];
    if (root < 0) return range;
    const double q = -(feed[2] + std::copysign(std::sqrt(root), feed[2]));
    if (feed[3] != 0) look(q / (3 * feed[3]));
    if (q != 0) look(feed[1] / q);
    return range;
}

FeedPolynomial feed_from(const FeedPolynomial& feed, double from) {
    return {feed_at(feed, from), feed_slope(feed, from), feed[2] + 3 * feed[3] * from, feed[3]};
}

FeedPolynomial feed_in_units(const FeedPolynomial& feed, double scale, double stretch) {
    FeedPolynomial other = feed;
    for (double& coefficient : other) {
        coefficient *= scale;
        scale *= stretch;
    }
    return other;
}

}  // namespace kadr::path
