// What the axes see of a piece on which the transformation holds the tip.
//
// Every axis takes its own path there, so its derivatives are taken one by one, and what turning
// and speeding up ask of it is added up: never too little.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "motion/axis_table.h"
#include "motion/transformed.h"

namespace kadr::motion {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Shares of what an axis has, as on a spline (axis_table.cpp).
constexpr double kNormalShare = 0.86602540378443865;
constexpr double kSteadyJerk = 0.4;
constexpr double kTurningJerk = 0.3;

constexpr int kSamples = 8;  // of a motion, to find its greatest values

/// The greatest magnitude of what is `value(u)` at 0 ≤ u ≤ 1. It may lie between two samples: there
/// it is that of the parabola through three of them.
template <typename Value>
double greatest(const Value& value) {
    std::array<double, kSamples + 1> samples{};
    double most = 0;
    for (std::size_t k = 0; k < samples.size(); ++k) {
        samples[k] = value(static_cast<double>(k) / kSamples);
        most = std::max(most, std::abs(samples[k]));
    }
    for (std::size_t k = 1; k + 1 < samples.size(); ++k) {
        const double slope = (samples[k + 1] - samples[k - 1]) / 2;
        const double bend = samples[k + 1] - 2 * samples[k] + samples[k - 1];
        if (std::abs(slope) >= std::abs(bend)) continue;  // its vertex is farther away
        most = std::max(most, std::abs(samples[k] - slope * slope / (2 * bend)));
    }
    return most;
}

}  // namespace

AxisRates AxisTable::rates_on(const Segment& piece, double u) const {
    const AxisPolynomials polynomials(*chain_, piece);
    AxisRates rates{};
    for (std::size_t i = 0; i < axes_.size(); ++i)
        rates[i] = polynomials.rate(axes_[i].coordinate, u);
    return rates;
}

AxisRates AxisTable::bends_on(const Segment& piece, double u) const {
    const AxisPolynomials polynomials(*chain_, piece);
    AxisRates bends{};
    for (std::size_t i = 0; i < axes_.size(); ++i)
        bends[i] = polynomials.bend(axes_[i].coordinate, u);
    return bends;
}

AxisTable::Loads AxisTable::transformed_loads(const Segment& piece) const {
    const AxisPolynomials polynomials(*chain_, piece);
    Loads loads;
    loads.curvature = kInfinity;  // along and across are not told apart
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const std::size_t axis = axes_[i].coordinate;
        loads.rising[i] = greatest([&](double u) { return polynomials.rate(axis, u); });
        loads.bend[i] = greatest([&](double u) { return polynomials.bend(axis, u); });
        loads.third[i] = greatest([&](double u) { return polynomials.third(axis, u); });
    }
    return loads;
}

PathLimits AxisTable::transformed_limits(const Segment& piece, double wanted) const {
    const Loads loads = transformed_loads(piece);
    PathLimits limits{wanted, kInfinity, kInfinity, kInfinity};
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        double& speed = limits.speed;
        if (loads.rising[i] * speed > axes_[i].velocity)
            speed = axes_[i].velocity / loads.rising[i];
        if (const double most = kNormalShare * axes_[i].acceleration;
            loads.bend[i] * speed * speed > most)
            speed = std::sqrt(most / loads.bend[i]);
        if (const double most = kSteadyJerk * axes_[i].jerk;
            loads.third[i] * speed * speed * speed > most)
            speed = std::cbrt(most / loads.third[i]);
    }
    const double v = limits.speed;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const double left = axes_[i].acceleration - loads.bend[i] * v * v;
        if (loads.rising[i] * limits.acceleration > left)
            limits.acceleration = left / loads.rising[i];
        const double turning = 3 * loads.bend[i] * v;
        if (turning * limits.turning_acceleration > kTurningJerk * axes_[i].jerk)
            limits.turning_acceleration = kTurningJerk * axes_[i].jerk / turning;
    }
    limits.acceleration = std::min(limits.acceleration, limits.turning_acceleration);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        if (std::isinf(axes_[i].jerk)) continue;
        const double left = axes_[i].jerk - loads.third[i] * v * v * v -
                            3 * loads.bend[i] * v * limits.acceleration;
        if (loads.rising[i] * limits.jerk > left) limits.jerk = left / loads.rising[i];
    }
    return limits;
}

namespace {

/// The greatest value between two points, where there is one; a golden section finds it.
template <typename Value>
double peak_between(const Value& value, double lower, double upper) {
    constexpr int kSteps = 30;  // to a millionth of the width, and so to a billionth of the value
    constexpr double kGolden = 0.61803398874989485;
    double left = upper - kGolden * (upper - lower);
    double right = lower + kGolden * (upper - lower);
    double at_left = value(left);
    double at_right = value(right);
    double most = std::max(at_left, at_right);
    for (int step = 0; step < kSteps; ++step) {
        if (at_left > at_right) {
            upper = std::exchange(right, left);
            at_right = at_left;
            left = upper - kGolden * (upper - lower);
            at_left = value(left);
        } else {
            lower = std::exchange(left, right);
            at_left = at_right;
            right = lower + kGolden * (upper - lower);
            at_right = value(right);
        }
        most = std::max({most, at_left, at_right});
    }
    return most;
}

/// The greatest position in one of the directions, times `sign`, from 0 to 1: samples find the
/// neighbourhood.
double reach_of(const AxisPolynomials& polynomials, std::size_t axis, double sign) {
    constexpr int kPlaces = 2 * kSamples;
    const auto value = [&](double u) { return sign * polynomials.position(axis, u); };
    const auto place = [](int k) { return static_cast<double>(k) / kPlaces; };
    int nearest = 0;
    double most = value(0);
    for (int k = 1; k <= kPlaces; ++k) {
        const double at = value(place(k));
        if (!(at > most)) continue;
        most = at;
        nearest = k;
    }
    // At an end it goes farther inside only if it comes from there.
    if (nearest == 0 && !(sign * polynomials.rate(axis, 0) > 0)) return most;
    if (nearest == kPlaces && !(sign * polynomials.rate(axis, 1) < 0)) return most;
    return std::max(most, peak_between(value, place(std::max(nearest - 1, 0)),
                                       place(std::min(nearest + 1, kPlaces))));
}

}  // namespace

AxisTable::Travel AxisTable::transformed_travel(const Segment& piece) const {
    const AxisPolynomials polynomials(*chain_, piece);
    Travel travel;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        travel.lower[i] = -reach_of(polynomials, axes_[i].coordinate, -1);
        travel.upper[i] = reach_of(polynomials, axes_[i].coordinate, 1);
    }
    return travel;
}

AxisRates AxisTable::transformed_positions(const Segment& piece, double distance) const {
    const LogicalAxes axes = axes_at(*chain_, piece, distance);
    AxisRates positions{};
    for (std::size_t i = 0; i < axes_.size(); ++i) positions[i] = axes[axes_[i].coordinate];
    return positions;
}

AxisBounds AxisTable::bounds() const {
    AxisBounds bounds;
    bounds.velocity.fill(kInfinity);
    bounds.acceleration.fill(kInfinity);
    bounds.jerk.fill(kInfinity);
    for (const Entry& axis : axes_) {
        bounds.velocity[axis.coordinate] = axis.velocity;
        bounds.acceleration[axis.coordinate] = axis.acceleration;
        bounds.jerk[axis.coordinate] = axis.jerk;
    }
    return bounds;
}

}  // namespace kadr::motion
