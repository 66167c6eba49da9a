#include "path/frame.h"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace kadr::path {

namespace {

Mat3 rotation_about(Axis axis, double angle) {
    return Eigen::AngleAxisd(angle, unit(axis)).toRotationMatrix();
}

Frame linear_frame(const Mat3& linear) { return {linear, Vec3::Zero()}; }

}  // namespace

Frame operator*(const Frame& outer, const Frame& inner) {
    return {outer.linear * inner.linear, outer(inner.shift)};
}

Frame translation(const Vec3& shift) { return {Mat3::Identity(), shift}; }

Frame rotation_rpy(const AxisAngles& angles) {
    return linear_frame(rotation_about(Axis::Z, angles.z) * rotation_about(Axis::Y, angles.y) *
                        rotation_about(Axis::X, angles.x));
}

Frame rotation_euler(const AxisAngles& angles) {
    return linear_frame(rotation_about(Axis::Z, angles.z) * rotation_about(Axis::X, angles.x) *
                        rotation_about(Axis::Z, angles.y));
}

Frame rotation_in_plane(Plane plane, double angle) {
    return linear_frame(rotation_about(axes_of(plane).normal, angle));
}

Frame scaling(const Vec3& factors) { return linear_frame(factors.asDiagonal()); }

Frame mirroring(AxisMask axes) {
    Vec3 signs = Vec3::Ones();
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
        if ((axes & bit(axis)) != 0) signs[static_cast<Eigen::Index>(index(axis))] = -1;
    }
    return scaling(signs);
}

Mat3 unit_axes(const Frame& frame) {
    const Vec3 x = frame.linear.col(0).normalized();
    const Vec3 y = (frame.linear.col(1) - x * x.dot(frame.linear.col(1))).normalized();
    const Vec3 z = frame.linear.col(2);
    Mat3 axes;
    axes << x, y, (z - x * x.dot(z) - y * y.dot(z)).normalized();
    return axes;
}

Result<Frame, FrameFault> inverse(const Frame& frame) {
    Mat3 back;
    double determinant = 0;
    bool is_invertible = false;
    // Any volume at all can be undone; only a flattened space cannot.
    frame.linear.computeInverseAndDetWithCheck(back, determinant, is_invertible,
                                               std::numeric_limits<double>::min());
    if (!is_invertible) return FrameFault::Singular;
    return Frame{back, -(back * frame.shift)};
}

AxisAngles rpy_of(const Mat3& r) {
    // R31 = −sin y; near ±1 the other two axes coincide, and x is put to 0.
    constexpr double kGimbal = 1.0 - 1e-12;
    const double sin_y = -r(2, 0);
    if (std::abs(sin_y) > kGimbal) {
        return {0, std::copysign(std::acos(0.0), sin_y), std::atan2(-r(0, 1), r(1, 1))};
    }
    return {std::atan2(r(2, 1), r(2, 2)), std::asin(sin_y), std::atan2(r(1, 0), r(0, 0))};
}

}  // namespace kadr::path
