// linear.h — X, Y and Z of the axes as a vector, and back.
#pragma once

#include "base/axes.h"
#include "path/curve.h"

namespace kadr::path {

inline Vec3 linear(const AxisValues& values) { return {values[0], values[1], values[2]}; }

inline void set_linear(AxisValues& values, const Vec3& at) {
    for (std::size_t i = 0; i < 3; ++i) values[i] = at[static_cast<Eigen::Index>(i)];
}

/// The same axes with another point.
inline AxisValues with_linear(AxisValues values, const Vec3& at) {
    set_linear(values, at);
    return values;
}

}  // namespace kadr::path
