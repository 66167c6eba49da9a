// points.h — the blocks that the peers of `kadr expand` write: a circle that rises.
#pragma once

#include <cmath>
#include <numbers>

/// Point i of the circle, mm.
struct Point {
    double x;
    double y;
    double z;
};

inline Point point(long i) {
    const double angle = static_cast<double>(i) * 0.37 * (std::numbers::pi / 180.0);
    return {100 * std::cos(angle), 100 * std::sin(angle), static_cast<double>(i) * 0.001};
}
