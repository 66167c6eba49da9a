#include "path/spline.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "path/casteljau.h"
#include "path/helix.h"
#include "path/homogeneous.h"
#include "path/parameter_point.h"
#include "path/quadrature.h"
#include "path/steady.h"

namespace kadr::path {

namespace {

template <std::size_t N>
using ControlPoints = std::array<ControlPoint, N>;

constexpr double kShare = 1.0 / static_cast<double>(CubicSpan::kParts);

/// Below this part of the polygon's length the derivative is taken for zero: the curve stands.
constexpr double kStands = 1e-7;

Vec3 point_of(const ControlPoint& control_point) {
    return control_point.head<3>() / control_point[3];
}

template <std::size_t N>
std::pair<ControlPoints<N>, ControlPoints<N>> split(const ControlPoints<N>& control_points,
                                                    double u) {
    return Casteljau<ControlPoint, N>(control_points, u).halves();
}

template <std::size_t N>
double polygon(const ControlPoints<N>& control_points) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < N; ++i)
        sum += (point_of(control_points[i + 1]) - point_of(control_points[i])).norm();
    return sum;
}

/// |dC/du|.
double speed(const QuinticSpan& spline, double u) { return point_at(spline, u).first.norm(); }
double speed(const CubicSpan& spline, double u) {
    const ControlPoints<4>& p = spline.control_points;
    const double v = 1 - u;
    const ControlPoint first =
        3 * (v * v * (p[1] - p[0]) + 2 * u * v * (p[2] - p[1]) + u * u * (p[3] - p[2]));
    if (!spline.is_rational) return first.head<3>().norm();
    const ControlPoint at =
        v * v * v * p[0] + 3 * u * v * v * p[1] + 3 * u * u * v * p[2] + u * u * u * p[3];
    return (first.head<3>() - at.head<3>() * (first[3] / at[3])).norm() / at[3];
}

/// Where the speed has a least value far below the mean. Quadrature has to end there: beside such a
/// point, at the edge of an interval, the rule and its halves would both look past it.
template <std::size_t N>
std::array<double, 2> slow_parameters(const Bezier<N>& spline) {
    constexpr int kSteps = 32;
    constexpr double kEnd = 1e-6;  // a curve that ends where it stands does not turn back
    std::array<double, 2> found = {1, 1};
    if (!spline.is_rational) {
        std::array<Vec3, N> points;
        for (std::size_t i = 0; i < N; ++i) points[i] = spline.control_points[i].template head<3>();
        if (is_steady(points)) return found;
    }
    std::array<double, kSteps + 1> rate{};
    double mean = 0;
    for (int i = 0; i <= kSteps; ++i) {
        rate[static_cast<std::size_t>(i)] = speed(spline, static_cast<double>(i) / kSteps);
        mean += rate[static_cast<std::size_t>(i)] / (kSteps + 1);
    }
    if (!(mean > 0)) return found;  // a point, where nothing is slower than the rest
    const auto falls_behind = [&](double u) {
        const SplinePoint at = point_at(spline, u);
        return at.first.dot(at.second) < 0;
    };
    std::size_t count = 0;
    for (std::size_t i = 0; i <= kSteps && count < found.size(); ++i) {
        // At an end the least value is inside if the speed falls towards the inside.
        if (i > 0 ? rate[i] > rate[i - 1] : !falls_behind(0)) continue;
        if (i < kSteps ? rate[i] > rate[i + 1] : falls_behind(1)) continue;
        double lower = i > 0 ? static_cast<double>(i - 1) / kSteps : 0;
        double upper = i < kSteps ? static_cast<double>(i + 1) / kSteps : 1;
        for (int pass = 0; pass < 80; ++pass) {
            const double a = lower + (upper - lower) / 3;
            const double b = upper - (upper - lower) / 3;
            (speed(spline, a) < speed(spline, b) ? upper : lower) =
                speed(spline, a) < speed(spline, b) ? b : a;
        }
        const double parameter = 0.5 * (lower + upper);
        const bool is_inside = parameter > kEnd && parameter < 1 - kEnd;
        if (is_inside && speed(spline, parameter) < kNearlyStands * mean)
            found[count++] = parameter;
    }
    return found;
}

/// Arc length between two parameters inside one eighth.
template <std::size_t N>
double careful_length(const Bezier<N>& spline, double from, double to) {
    const auto rate = [&](double u) { return speed(spline, u); };
    double sum = 0;
    double begin = from;
    for (const double parameter : spline.slow) {
        if (parameter <= begin || parameter >= to) continue;
        sum += integrate(rate, begin, parameter, 0.1 * kArcLengthTolerance).value;
        begin = parameter;
    }
    sum += integrate(rate, begin, to, 0.1 * kArcLengthTolerance).value;
    return sum;
}

template <std::size_t N>
double length_between(const Bezier<N>& spline, double from, double to) {
    if (!spline.is_smooth) return careful_length(spline, from, to);
    return gauss([&](double u) { return speed(spline, u); }, from, to);
}

template <std::size_t N>
void measure(Bezier<N>& spline) {
    const auto rate = [&](double u) { return speed(spline, u); };
    spline.slow = slow_parameters(spline);
    const bool is_slow = spline.slow[0] < 1;
    spline.is_smooth = !is_slow;
    spline.length = 0;
    for (std::size_t i = 0; i < CubicSpan::kParts; ++i) {
        const double from = kShare * static_cast<double>(i);
        const double quick = gauss(rate, from, from + kShare);
        const double part =
            is_slow ? careful_length(spline, from, from + kShare)
                    : integrate(rate, from, from + kShare, 0.1 * kArcLengthTolerance, quick).value;
        spline.is_smooth &= std::fabs(quick - part) <= kArcLengthTolerance;
        spline.length += part;
        spline.reached[i] = spline.length;
    }
}

template <std::size_t N>
Bezier<N> of_control_points(const ControlPoints<N>& control_points, const Vec3& start,
                            const Vec3& end) {
    Bezier<N> spline;
    spline.control_points = control_points;
    spline.start = start;
    spline.end = end;
    spline.is_rational = std::any_of(control_points.begin(), control_points.end(),
                                     [&](const ControlPoint& control_point) {
                                         return control_point[3] != control_points[0][3];
                                     });
    if (!spline.is_rational) {
        for (ControlPoint& control_point : spline.control_points) control_point /= control_point[3];
    }
    measure(spline);
    return spline;
}

}  // namespace

ControlPoint control_point_of(const Vec3& point, double weight) {
    ControlPoint control_point;
    control_point << point * weight, weight;
    return control_point;
}

CubicSpan make_spline(const Vec3& start, const Vec3& end, const SplineShape& shape) {
    KADR_ASSERT(shape.degree >= 1 && shape.degree <= 3, "a span of degree one to three");
    const auto last = static_cast<std::size_t>(shape.degree);
    return of_control_points<4>(
        raised_to_cubic<ControlPoint>(shape.degree, control_point_of(start, shape.weights[0]),
                                      {control_point_of(shape.inner[0], shape.weights[1]),
                                       control_point_of(shape.inner[1], shape.weights[2])},
                                      control_point_of(end, shape.weights[last])),
        start, end);
}

QuinticSpan make_quintic(const Vec3& start, const Vec3& end, const SplineShape& shape) {
    KADR_ASSERT(shape.degree >= 1 && shape.degree <= 5, "a span of degree one to five");
    const auto degree = static_cast<std::size_t>(shape.degree);
    ControlPoints<6> control_points;
    control_points[0] = control_point_of(start, shape.weights[0]);
    for (std::size_t i = 1; i < degree; ++i)
        control_points[i] = control_point_of(shape.inner[i - 1], shape.weights[i]);
    control_points[degree] = control_point_of(end, shape.weights[degree]);
    raise_degree(control_points, degree);
    return of_control_points<6>(control_points, start, end);
}

template <std::size_t N>
SplinePoint point_at(const Bezier<N>& spline, double u) {
    const Casteljau<ControlPoint, N> scheme(spline.control_points, u);
    return projected(scheme.at(), scheme.derivative(), scheme.second_derivative());
}

template <std::size_t N>
double parameter_at(const Bezier<N>& spline, double s) {
    if (s <= 0) return 0;
    if (s >= spline.length) return 1;
    const auto& reached = spline.reached;
    const auto found = std::upper_bound(reached.begin(), reached.end() - 1, s);
    const auto i = static_cast<std::size_t>(found - reached.begin());
    const double from = kShare * static_cast<double>(i);
    const double begin = i == 0 ? 0 : reached[i - 1];
    double lower = from;
    double upper = from + kShare;
    // The first guess divides the eighth by length; Newton's step is kept in the bracket.
    double u = from + kShare * (s - begin) / (reached[i] - begin);
    for (int pass = 0; pass < 60; ++pass) {
        const double miss = begin + length_between(spline, from, u) - s;
        if (std::fabs(miss) <= 0.1 * kArcLengthTolerance) return u;
        (miss > 0 ? upper : lower) = u;
        const double next = u - miss / speed(spline, u);
        u = next > lower && next < upper ? next : 0.5 * (lower + upper);
    }
    return u;
}

template <std::size_t N>
double length_to(const Bezier<N>& spline, double u) {
    if (u <= 0) return 0;
    if (u >= 1) return spline.length;
    const auto eighth = static_cast<std::size_t>(u / kShare);
    const double begin = eighth == 0 ? 0 : spline.reached[eighth - 1];
    return begin + length_between(spline, kShare * static_cast<double>(eighth), u);
}

template <std::size_t N>
Vec3 position(const Bezier<N>& spline, double s) {
    if (s <= 0) return spline.start;
    if (s >= spline.length) return spline.end;
    return point_at(spline, parameter_at(spline, s)).position;
}

template <std::size_t N>
CurvePoint curvature_at(const Bezier<N>& spline, double u) {
    return parameter_point([&](double at) { return point_at(spline, at); }, u,
                           kStands * polygon<N>(spline.control_points));
}

template <std::size_t N>
CurvePoint evaluate(const Bezier<N>& spline, double s) {
    CurvePoint point = curvature_at(spline, parameter_at(spline, s));
    point.position = position(spline, s);
    return point;
}

template <std::size_t N>
Bezier<N> part(const Bezier<N>& spline, double from, double to) {
    const double first = parameter_at(spline, from);
    const double last = parameter_at(spline, to);
    const ControlPoints<N> behind =
        first > 0 ? split<N>(spline.control_points, first).second : spline.control_points;
    const double share = first < 1 ? (last - first) / (1 - first) : 1;
    const ControlPoints<N> piece = last < 1 ? split<N>(behind, share).first : behind;
    return of_control_points<N>(piece, position(spline, from), position(spline, to));
}

template <std::size_t N>
std::pair<Bezier<N>, Bezier<N>> split(const Bezier<N>& spline, double u) {
    const auto [before, behind] = split<N>(spline.control_points, u);
    const Vec3 middle = point_of(behind[0]);
    return {of_control_points<N>(before, spline.start, middle),
            of_control_points<N>(behind, middle, spline.end)};
}

namespace {

/// Widens a box by what is between the ends of a piece, which are in it: by the control points
/// where they hardly leave it, or by the halves.
template <std::size_t N>
void widen(Box& box, const ControlPoints<N>& control_points, int depth = 0) {
    // A half leaves its ends by a quarter of what the whole does: mostly ten halvings suffice.
    constexpr double kNear = 1e-6;  // mm
    constexpr int kDeepest = 40;
    Box hull = box;
    for (const ControlPoint& control_point : control_points) {
        hull.lower = hull.lower.cwiseMin(point_of(control_point));
        hull.upper = hull.upper.cwiseMax(point_of(control_point));
    }
    const double out =
        std::max((box.lower - hull.lower).maxCoeff(), (hull.upper - box.upper).maxCoeff());
    if (out <= kNear || depth >= kDeepest) {
        box = hull;
        return;
    }
    const auto [before, behind] = split<N>(control_points, 0.5);
    box.lower = box.lower.cwiseMin(point_of(behind[0]));
    box.upper = box.upper.cwiseMax(point_of(behind[0]));
    widen<N>(box, before, depth + 1);
    widen<N>(box, behind, depth + 1);
}

}  // namespace

template <std::size_t N>
Box bounds(const Bezier<N>& spline) {
    Box box{spline.start.cwiseMin(spline.end), spline.start.cwiseMax(spline.end)};
    widen<N>(box, spline.control_points);
    return box;
}

template Vec3 position(const Bezier<4>&, double);
template CurvePoint evaluate(const Bezier<4>&, double);
template Bezier<4> part(const Bezier<4>&, double, double);
template std::pair<Bezier<4>, Bezier<4>> split(const Bezier<4>&, double);
template Box bounds(const Bezier<4>&);
template SplinePoint point_at(const Bezier<4>&, double);
template double parameter_at(const Bezier<4>&, double);
template double length_to(const Bezier<4>&, double);
template CurvePoint curvature_at(const Bezier<4>&, double);
template Vec3 position(const Bezier<6>&, double);
template CurvePoint evaluate(const Bezier<6>&, double);
template Bezier<6> part(const Bezier<6>&, double, double);
template std::pair<Bezier<6>, Bezier<6>> split(const Bezier<6>&, double);
template Box bounds(const Bezier<6>&);
template SplinePoint point_at(const Bezier<6>&, double);
template double parameter_at(const Bezier<6>&, double);
template double length_to(const Bezier<6>&, double);
template CurvePoint curvature_at(const Bezier<6>&, double);

}  // namespace kadr::path
