// What the axes see of a piece on which the transformation holds the tip.
//
// Every axis goes its own way there, so its derivatives are taken one by one, and what turning and
// speeding up ask of it is added up: never too little.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/axis_table.h"
#include "motion/transformed.h"

namespace kadr::motion {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Shares of what an axis has, as on a spline (axis_table.cpp).
constexpr double kNormalShare = 0.86602540378443865;
constexpr double kSteadyJerk = 0.4;
constexpr double kTurningJerk = 0.3;

constexpr int kSamples = 8;  // of a course, to find its greatest values

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
    const AxisCourse course(*chain_, piece);
    AxisRates rates{};
    for (std::size_t i = 0; i < axes_.size(); ++i) rates[i] = course.rate(axes_[i].coordinate, u);
    return rates;
}

AxisRates AxisTable::bends_on(const Segment& piece, double u) const {
    const AxisCourse course(*chain_, piece);
    AxisRates bends{};
    for (std::size_t i = 0; i < axes_.size(); ++i) bends[i] = course.bend(axes_[i].coordinate, u);
    return bends;
}

AxisTable::Loads AxisTable::transformed_loads(const Segment& piece) const {
    const AxisCourse course(*chain_, piece);
    Loads loads;
    loads.curvature = kInfinity;  // along and across are not told apart
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const std::size_t axis = axes_[i].coordinate;
        loads.rising[i] = greatest([&](double u) { return course.rate(axis, u); });
        loads.bend[i] = greatest([&](double u) { return course.bend(axis, u); });
        loads.third[i] = greatest([&](double u) { return course.third(axis, u); });
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

AxisTable::Travel AxisTable::transformed_travel(const Segment& piece) const {
    const AxisCourse course(*chain_, piece);
    Travel travel;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const std::size_t axis = axes_[i].coordinate;
        travel.lower[i] = travel.upper[i] = course.position(axis, 0);
        for (int k = 1; k <= 2 * kSamples; ++k) {
            const double at = course.position(axis, static_cast<double>(k) / (2 * kSamples));
            travel.lower[i] = std::min(travel.lower[i], at);
            travel.upper[i] = std::max(travel.upper[i], at);
        }
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
