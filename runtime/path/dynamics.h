// dynamics.h — how fast motions may be run as programmed: parts of what the program asks for
// otherwise, and of what the machine allows.
//
// What they mean for a motion is motion/'s matter.
#pragma once

#include <cstdint>
#include <limits>
#include <numbers>

#include "base/axes.h"
#include "path/feed_polynomial.h"

namespace kadr::path {

/// So far from its axis a degree of a rotary axis is a millimetre of path, mm.
inline constexpr double kRadiusOfDegrees = 180 / std::numbers::pi;

/// How the feed comes to F along a motion.
enum class FeedCharacteristic : std::uint8_t {
    Constant,    // F from its start on
    Linear,      // evenly over the path, from the feed before
    Spline,      // by a cubic spline over the path of several blocks
    Polynomial,  // by one of the third degree, from the feed before
};

/// The programmed feed characteristic along a motion, and what has come of it.
struct FeedLaw {
    FeedCharacteristic kind = FeedCharacteristic::Constant;
    std::uint32_t block = 0;  // of the program: its motions have one characteristic together
    double square = 0;        // Polynomial: coefficients, unit of F, over the path of the block
    double cube = 0;
    /// The feed in the unit of F over the part of this motion's path, 0 … 1, by powers; all 0 where
    /// F is the feed.
    FeedPolynomial feed{};

    bool is_given() const { return feed[0] > 0; }
    bool is_constant() const { return feed[1] == 0 && feed[2] == 0 && feed[3] == 0; }
    friend bool operator==(const FeedLaw&, const FeedLaw&) = default;
};

/// Every part is ≥ 0, 1 where nothing is programmed.
struct Dynamics {
    double feed = 1;   // of F
    double rapid = 1;  // of the speed at rapid
    AxisValues velocity;
    AxisValues acceleration;
    AxisValues jerk;
    AxisValues speed;  // greatest of an axis that is not among the feed axes, mm/s or rad/s
    /// F is the speed of these axes together, the others follow; 0: of X, Y and Z, or of the
    /// others where these stand.
    AxisMask feed_axes = 0;
    AxisValues feed_radius;  // of rotary ones: at which it is the speed, mm
    FeedLaw law;

    Dynamics() {
        velocity.fill(1);
        acceleration.fill(1);
        jerk.fill(1);
        speed.fill(std::numeric_limits<double>::infinity());
        feed_radius.fill(kRadiusOfDegrees);
    }
    bool is_feed_axis(Axis axis) const {
        return ((feed_axes != 0 ? feed_axes : kLinearXYZ) & bit(axis)) != 0;
    }
    friend bool operator==(const Dynamics&, const Dynamics&) = default;
};

}  // namespace kadr::path
