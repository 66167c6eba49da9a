// spline.h — one span of a spline: a rational Bézier curve, walked by arc length.
//
// What controls call spline, B-spline and NURBS are chains of spans of degree three: nurbs.h and
// through_spline.h cut them. Spans of lower degree are raised to three, which changes nothing but
// the number of control points. Polynomials that controls let one write by their coefficients go
// up to degree five.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "path/vec3.h"

namespace kadr::path {

/// A control point times its weight, and the weight.
using ControlPoint = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;
ControlPoint control_point_of(const Vec3& point, double weight);

/// A span as a Command states it: control points between the ends, and the weights of all.
struct SplineShape {
    int degree = 3;  // 1 … 5
    /// degree − 1 of them hold, mm
    std::array<Vec3, 4> inner = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    std::array<double, 6> weights = {1, 1, 1, 1, 1, 1};  // degree + 1 of them hold, > 0
};

/// N control points, a curve of degree N − 1.
template <std::size_t N>
struct Bezier {
    static constexpr std::size_t kParts = 8;

    std::array<ControlPoint, N> control_points;
    Vec3 start;  // as programmed
    Vec3 end;    // as programmed
    double length;
    std::array<double, kParts> reached;  // arc length at the end of each eighth of the parameter
    std::array<double, 2> slow;  // parameters at which the curve nearly stands, as in a cusp; or 1
    bool is_rational;
    bool is_smooth;  // Gauss' rule is exact enough for an eighth
};

using CubicSpan = Bezier<4>;
using QuinticSpan = Bezier<6>;

/// The span between two points, of degree 1 to 3.
CubicSpan make_spline(const Vec3& start, const Vec3& end, const SplineShape& shape);
/// The same, of any degree.
QuinticSpan make_quintic(const Vec3& start, const Vec3& end, const SplineShape& shape);

template <std::size_t N>
double length(const Bezier<N>& spline) {
    return spline.length;
}
template <std::size_t N>
Vec3 start(const Bezier<N>& spline) {
    return spline.start;
}
template <std::size_t N>
Vec3 end(const Bezier<N>& spline) {
    return spline.end;
}
// Below: of degree three and five.

/// The point at an arc length. The parameter is found by Newton's iteration on the length from the
/// start of the span, in a bracket, to kArcLengthTolerance: nothing accumulates.
/// source: motion reference §1.8
template <std::size_t N>
Vec3 position(const Bezier<N>& spline, double s);
template <std::size_t N>
CurvePoint evaluate(const Bezier<N>& spline, double s);
template <std::size_t N>
Bezier<N> part(const Bezier<N>& spline, double from, double to);
/// The pieces before and behind a parameter, 0 < u < 1.
template <std::size_t N>
std::pair<Bezier<N>, Bezier<N>> split(const Bezier<N>& spline, double u);
/// A parameter inside at which the curve nearly stands, as where it turns back.
template <std::size_t N>
std::optional<double> slow_parameter(const Bezier<N>& spline) {
    if (spline.slow[0] >= 1) return std::nullopt;
    return spline.slow[0];
}
/// Never too small; and too great by the resolution of most controls at most, 1e-6 mm.
template <std::size_t N>
Box bounds(const Bezier<N>& spline);

/// Point and derivatives by the parameter, 0 … 1.
struct SplinePoint {
    Vec3 position;
    Vec3 first;
    Vec3 second;
};
template <std::size_t N>
SplinePoint point_at(const Bezier<N>& spline, double u);
/// The parameter at an arc length.
template <std::size_t N>
double parameter_at(const Bezier<N>& spline, double s);

/// Arc length up to a parameter, mm.
template <std::size_t N>
double length_to(const Bezier<N>& spline, double u);

/// Tangent and curvature at a parameter; where the curve stands, those of the path onwards.
template <std::size_t N>
CurvePoint curvature_at(const Bezier<N>& spline, double u);

}  // namespace kadr::path
