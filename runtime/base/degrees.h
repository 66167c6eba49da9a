// degrees.h — sine and cosine of degrees, which are reduced as degrees: sin(180) is 0 and cos(60)
// is 0.5, not something near it.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace kadr {

inline constexpr double kRadPerDeg = std::numbers::pi / 180.0;

namespace detail {

struct Reduced {
    double angle;      // degrees, -45 to 45
    unsigned quarter;  // how many right angles were taken off, 0 to 3
};

/// Takes right angles off. Exact: `quarter·90` and the difference are multiples of the last bit of
/// the angle and no larger than it.
inline Reduced reduce(double angle_deg) {
    if (!(std::fabs(angle_deg) < 1e15)) {
        angle_deg = std::fmod(angle_deg, 360.0);
        if (std::isnan(angle_deg)) return {angle_deg, 0};  // it was infinite, or no number before
    }
    const auto turns =
        static_cast<std::int64_t>(angle_deg * (1.0 / 90.0) + (angle_deg < 0 ? -0.5 : 0.5));
    return {angle_deg - static_cast<double>(turns) * 90.0, static_cast<unsigned>(turns) & 3u};
}

inline double sin_small(double angle_deg) {
    if (std::fabs(angle_deg) == 30.0) return angle_deg < 0 ? -0.5 : 0.5;
    return std::sin(angle_deg * kRadPerDeg);
}

inline double cos_small(double angle_deg) {
    // sin and cos of 45° are the same number.
    if (std::fabs(angle_deg) == 45.0) return std::sin(45.0 * kRadPerDeg);
    return std::cos(angle_deg * kRadPerDeg);
}

}  // namespace detail

/// Sine and cosine of degrees; exact at multiples of 30° where the result is a fraction.
inline double sin_deg(double angle_deg) {
    const detail::Reduced r = detail::reduce(angle_deg);
    switch (r.quarter) {
        case 0: return detail::sin_small(r.angle);
        case 1: return detail::cos_small(r.angle);
        case 2: return -detail::sin_small(r.angle);
        default: return -detail::cos_small(r.angle);
    }
}
inline double cos_deg(double angle_deg) {
    const detail::Reduced r = detail::reduce(angle_deg);
    switch (r.quarter) {
        case 0: return detail::cos_small(r.angle);
        case 1: return -detail::sin_small(r.angle);
        case 2: return -detail::cos_small(r.angle);
        default: return detail::sin_small(r.angle);
    }
}

}  // namespace kadr
