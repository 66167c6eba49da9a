// homogeneous.h — from homogeneous points, weight in the fourth coordinate, to points in space.
#pragma once

#include "path/spline.h"

namespace kadr::path {

/// The point and its derivatives of a homogeneous point and its derivatives: the quotient rule.
inline SplinePoint projected(const ControlPoint& at, const ControlPoint& first,
                             const ControlPoint& second) {
    const double w = at[3];
    SplinePoint point;
    point.position = at.head<3>() / w;
    point.first = (first.head<3>() - first[3] * point.position) / w;
    point.second = (second.head<3>() - 2 * first[3] * point.first - second[3] * point.position) / w;
    return point;
}

}  // namespace kadr::path
