// numbers.h — numbers on their way into a block.
#pragma once

#include <cmath>

namespace kadr::expand {

inline constexpr double kMinute = 60;  // s

/// Anything a control could be given; beyond it the calculation has run away.
inline bool is_sane(double value) { return std::fabs(value) < 1e15; }

/// 240 m/min is 240·1000/60 mm/s and comes back as 240.00000000000003: what was a short decimal
/// number before the units changed is one again.
inline double neat(double value) {
    const double rounded = std::nearbyint(value * 1e6) / 1e6;
    return std::fabs(rounded - value) <= 1e-15 * std::fabs(value) ? rounded : value;
}

}  // namespace kadr::expand
