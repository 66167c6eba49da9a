// spline.h — one span of a spline: a rational Bézier curve of degree three, walked by arc length.
//
// What controls call spline, B-spline and NURBS are chains of such spans: nurbs.h cuts them. Spans
// of lower degree are raised to three, which changes nothing but the number of control points.
#pragma once

#include <array>
#include <utility>

#include "path/vec3.h"

namespace kadr::path {

/// A control point times its weight, and the weight.
using Pole = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;
Pole pole_of(const Vec3& point, double weight);

/// A span as a Command states it: control points between the ends, and the weights of all.
struct SplineShape {
    int degree = 3;                                // 1 … 3
    std::array<Vec3, 2> inner{};                   // degree − 1 of them hold, mm
    std::array<double, 4> weights = {1, 1, 1, 1};  // degree + 1 of them hold, > 0
};

struct Spline {
    static constexpr std::size_t kParts = 8;

    std::array<Pole, 4> poles;
    Vec3 start;  // as programmed
    Vec3 end;    // as programmed
    double length;
    std::array<double, kParts> reached;  // arc length at the end of each eighth of the parameter
    std::array<double, 2> slow;  // parameters at which the curve nearly stands, as in a cusp; or 1
    bool is_rational;
    bool is_smooth;  // Gauss' rule is exact enough for an eighth
};

/// The span between two points.
Spline make_spline(const Vec3& start, const Vec3& end, const SplineShape& shape);

inline double length(const Spline& spline) { return spline.length; }
inline Vec3 start(const Spline& spline) { return spline.start; }
inline Vec3 end(const Spline& spline) { return spline.end; }
/// The point at an arc length. The parameter is found by Newton's iteration on the length from the
/// start of the span, in a bracket, to kArcLengthTolerance: nothing accumulates.
/// source: motion reference §1.8
Vec3 position(const Spline& spline, double s);
CurvePoint evaluate(const Spline& spline, double s);
Spline part(const Spline& spline, double from, double to);
/// The pieces before and behind a parameter, 0 < u < 1.
std::pair<Spline, Spline> split(const Spline& spline, double u);
/// Bounds of the control points of the halved and halved again span: never too small.
Box bounds(const Spline& spline);

/// Point and derivatives by the parameter, 0 … 1.
struct SplinePoint {
    Vec3 position;
    Vec3 first;
    Vec3 second;
};
SplinePoint point_at(const Spline& spline, double u);
/// The parameter at an arc length.
double parameter_at(const Spline& spline, double s);

/// Tangent and curvature at a parameter; where the curve stands, those of the way on.
CurvePoint curvature_at(const Spline& spline, double u);

}  // namespace kadr::path
