#include "motion/plain_motion.h"

#include <algorithm>
#include <cmath>

#include "path/casteljau.h"

namespace kadr::motion {

namespace {

using path::Vec3;
using LookResult = PlainLook::LookResult;

template <std::size_t N>
using Points = std::array<Vec3, N>;

/// Never shorter than the curve.
template <std::size_t N>
double polygon(const Points<N>& points) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < N; ++i) length += (points[i + 1] - points[i]).norm();
    return length;
}

/// Newton's iteration for the foot of the tip, as programmed_path.h does it, but it ends as soon as
/// the answer is sure: a point within the tolerance with its foot near, or an end that the tip has
/// gone past. A tip beside the middle is left to a closer look.
///
/// lower  the least parameter that the tip may have
template <std::size_t N>
PlainLook foot_on(const Points<N>& points, const Vec3& tip, double tolerance, double parameter,
                  double lower) {
    constexpr int kSteps = 12;
    /// The foot is known well enough when the next step is shorter, mm: it squares what is left.
    constexpr double kNear = 1e-3;
    double u = parameter;
    for (int step = 0; step < kSteps; ++step) {
        const path::Casteljau<Vec3, N> scheme(points, u);
        const Vec3 off = tip - scheme.at();
        const Vec3 first = scheme.derivative();
        const double square = first.squaredNorm();
        const double along = off.dot(first);
        // (C − Q)·C' = 0; where the curve bends away from the tip the slope is kept from zero.
        const double slope = std::max(square / 8, square - off.dot(scheme.second_derivative()));
        if (u == 1 && along > 0 && off.squaredNorm() > tolerance * tolerance)
            return {LookResult::Beside, u};
        const double next = std::clamp(u + along / slope, lower, 1.0);
        const double distance_square = (next - u) * (next - u) * square;
        if (distance_square <= kNear * kNear && off.squaredNorm() <= tolerance * tolerance)
            return {LookResult::On, next};
        if (next == u) break;
        u = next;
    }
    return {LookResult::Unknown, u};
}

/// What a span's points tell; a line has none.
template <typename Answer, typename Ask>
Answer of_span(const PlainMotion& plain, const Ask& ask) {
    if (const auto* cubic = std::get_if<path::Cubic>(&plain.curve)) return ask(*cubic);
    return ask(std::get<path::Quintic>(plain.curve));
}

path::Curve measured(const path::Cubic& points) {
    path::SplineShape shape;
    shape.inner = {points[1], points[2]};
    return path::make_spline(points.front(), points.back(), shape);
}

path::Curve measured(const path::Quintic& points) {
    path::SplineShape shape;
    shape.degree = 5;
    shape.inner = {points[1], points[2], points[3], points[4]};
    return path::make_quintic(points.front(), points.back(), shape);
}

}  // namespace

PlainMotion plain_motion_of(const path::Line& line) {
    PlainMotion plain;
    plain.curve = line;
    plain.length = line.length;
    return plain;
}

PlainMotion plain_motion_of(const path::SteadySpan& steady) {
    PlainMotion plain;
    std::visit([&](const auto& points) { plain.curve = points; }, steady);
    plain.length = of_span<double>(plain, [](const auto& points) { return polygon(points); });
    return plain;
}

path::Curve curve_of(const PlainMotion& plain) {
    if (const auto* line = std::get_if<path::Line>(&plain.curve)) return *line;
    return of_span<path::Curve>(plain, [](const auto& points) { return measured(points); });
}

const Vec3& end_of(const PlainMotion& plain) {
    if (const auto* line = std::get_if<path::Line>(&plain.curve)) return line->end;
    return *of_span<const Vec3*>(plain, [](const auto& points) { return &points.back(); });
}

PlainLook look_on_span(const PlainMotion& plain, const Vec3& tip, double tolerance,
                       double parameter) {
    const double lower = std::max(0.0, parameter - 2 * tolerance / plain.length);
    return of_span<PlainLook>(plain, [&](const auto& points) {
        return foot_on(points, tip, tolerance, parameter, lower);
    });
}

double bound_on_span(const PlainMotion& plain, double parameter) {
    if (parameter >= 1) return plain.length;
    return of_span<double>(plain, [&]<std::size_t N>(const Points<N>& points) {
        return polygon(path::Casteljau<Vec3, N>(points, parameter).halves().first);
    });
}

}  // namespace kadr::motion
