#include "motion/feed_axes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kadr::motion {

namespace {

/// Slower than this beside the path an axis stands: rounding of directions.
constexpr double kStands = 1e-9;
/// On a turn of half a circle and more a rate has its least and its greatest value between ends.
constexpr int kPlaces = 8;

/// dq/ds of the axes beside X, Y, Z; rad or mm.
std::array<double, kFollowers> follower_rates(const Segment& piece, double distance,
                                              const AxisTable* axes) {
    if (axes == nullptr || !piece.is_transformed()) return piece.follower_rate;
    const AxisRates rates = distance > 0 ? axes->end_rates(piece) : axes->start_rates(piece);
    std::array<double, kFollowers> followers = piece.follower_rate;
    for (std::size_t i = 0; i < kFollowers; ++i) {
        const std::size_t slot = axes->slot(static_cast<Axis>(i + 3));
        if (slot < axes->size()) followers[i] = rates[slot];
    }
    return followers;
}

path::Vec3 direction(const Segment& piece, double distance) {
    if (std::holds_alternative<path::Point>(piece.curve)) return path::Vec3::Zero();
    return path::evaluate(piece.curve, distance).tangent;
}

struct Rates {
    path::Vec3 linear = path::Vec3::Zero();
    std::array<double, kFollowers> followers{};

    double square_of(AxisMask mask, const path::Dynamics& dynamics) const {
        double sum = 0;
        for (std::size_t i = 0; i < kAxes; ++i) {
            const auto axis = static_cast<Axis>(i);
            if ((mask & bit(axis)) == 0) continue;
            double rate = i < 3 ? linear[static_cast<Eigen::Index>(i)] : followers[i - 3];
            if (is_rotary(axis)) rate *= dynamics.feed_radius[i];
            sum += rate * rate;
        }
        return sum;
    }
};

}  // namespace

double feed_axes_rate(const path::Dynamics& dynamics, const Segment& piece, double distance,
                      const AxisTable* axes) {
    const bool is_swivel = piece.is_transformed() && piece.is_rotary_only;
    // As delivered: the path is that of X, Y, Z or, where these stand, of what moves; and what the
    // tool swivels by is in degrees.
    if (dynamics.feed_axes == 0 && (!piece.is_rotary_only || is_swivel)) return 1;
    const Rates rates{direction(piece, distance), follower_rates(piece, distance, axes)};
    constexpr auto kOthers = static_cast<AxisMask>(~kRotaryABC);
    const AxisMask wanted = dynamics.feed_axes != 0 ? dynamics.feed_axes : kLinearXYZ;
    const double square = rates.square_of(wanted, dynamics);
    if (square > kStands * kStands) return std::sqrt(square);
    if (rates.square_of(kOthers, dynamics) > kStands * kStands) return 0;
    return is_swivel ? 1 : std::sqrt(rates.square_of(kRotaryABC, dynamics));
}

double mean_feed_axes_rate(const path::Dynamics& dynamics, const Segment& piece, double length,
                           const AxisTable* axes) {
    const auto at = [&](double distance) {
        return feed_axes_rate(dynamics, piece, distance, axes);
    };
    if (std::holds_alternative<path::Line>(piece.curve) && !piece.is_transformed()) return at(0);
    if (piece.is_transformed()) return (at(0) + at(length)) / 2;
    return (at(0) + 4 * at(length / 2) + at(length)) / 6;  // Simpson's rule
}

FeedAxesRange feed_axes_range(const path::Dynamics& dynamics, const Segment& piece, double from,
                              double to) {
    const double first = feed_axes_rate(dynamics, piece, from, nullptr);
    FeedAxesRange range{first, first};
    for (int i = 1; i <= kPlaces; ++i) {
        const double rate =
            feed_axes_rate(dynamics, piece, from + (to - from) * i / kPlaces, nullptr);
        range.least = std::min(range.least, rate);
        range.most = std::max(range.most, rate);
    }
    return range;
}

}  // namespace kadr::motion
