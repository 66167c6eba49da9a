// vec3.h — points and directions in space, and what a curve tells about one of its points.
#pragma once

#include <Eigen/Core>

namespace kadr::path {

using Vec3 = Eigen::Vector3d;  // mm, or a unit vector

/// Point, direction and bending of a curve at one arc length.
struct CurvePoint {
    Vec3 position = Vec3::Zero();
    Vec3 tangent = Vec3::Zero();    // unit vector of travel
    Vec3 curvature = Vec3::Zero();  // d²C/ds², 1/mm; towards the centre of curvature
};

/// Least and greatest coordinates of something.
struct Box {
    Vec3 lower = Vec3::Zero();
    Vec3 upper = Vec3::Zero();
};

}  // namespace kadr::path
