#include "motion/plain_motion.h"

#include <algorithm>
#include <cmath>

#include "path/casteljau.h"

namespace kadr::motion {

namespace {

using path::Vec3;
using Side = PlainLook::Side;

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
/// the answer is sure: a place within the tolerance with its foot near, or an end that the tip has
/// gone past. A tip beside the middle is left to a closer look.
///
/// lower  the least parameter that the tip may have
template <std::size_t N>
PlainLook foot_on(const Points<N>& points, const Vec3& tip, double tolerance, double place,
                  double lower) {
    constexpr int kSteps = 12;
    /// The foot is known well enough when the next step is shorter, mm: it squares what is left.
    constexpr double kNear = 1e-3;
    double u = place;
    for (int step = 0; step < kSteps; ++step) {
        const path::Casteljau<Vec3, N> scheme(points, u);
        const Vec3 off = tip - scheme.at();
        const Vec3 first = scheme.derivative();
        const double square = first.squaredNorm();
        const double along = off.dot(first);
        // (C − Q)·C' = 0; where the curve bends away from the tip the slope is kept from zero.
        const double slope = std::max(square / 8, square - off.dot(scheme.second_derivative()));
        if (u == 1 && along > 0 && off.squaredNorm() > tolerance * tolerance)
            return {Side::Beside, u};
        const double next = std::clamp(u + along / slope, lower, 1.0);
        const double way_square = (next - u) * (next - u) * square;
        if (way_square <= kNear * kNear && off.squaredNorm() <= tolerance * tolerance)
            return {Side::On, next};
        if (next == u) break;
        u = next;
    }
    return {Side::Unknown, u};
}

/// What a span's points say; a line has none.
template <typename Answer, typename Ask>
Answer of_span(const PlainMotion& way, const Ask& ask) {
    if (const auto* cubic = std::get_if<path::Cubic>(&way.curve)) return ask(*cubic);
    return ask(std::get<path::Quintic>(way.curve));
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

PlainMotion plain_way(const path::Line& line) {
    PlainMotion way;
    way.curve = line;
    way.length = line.length;
    return way;
}

PlainMotion plain_way(const path::SteadySpan& steady) {
    PlainMotion way;
    std::visit([&](const auto& points) { way.curve = points; }, steady);
    way.length = of_span<double>(way, [](const auto& points) { return polygon(points); });
    return way;
}

path::Curve curve_of(const PlainMotion& way) {
    if (const auto* line = std::get_if<path::Line>(&way.curve)) return *line;
    return of_span<path::Curve>(way, [](const auto& points) { return measured(points); });
}

const Vec3& end_of(const PlainMotion& way) {
    if (const auto* line = std::get_if<path::Line>(&way.curve)) return line->end;
    return *of_span<const Vec3*>(way, [](const auto& points) { return &points.back(); });
}

PlainLook look_on_span(const PlainMotion& way, const Vec3& tip, double tolerance, double place) {
    const double lower = std::max(0.0, place - 2 * tolerance / way.length);
    return of_span<PlainLook>(
        way, [&](const auto& points) { return foot_on(points, tip, tolerance, place, lower); });
}

double bound_on_span(const PlainMotion& way, double place) {
    if (place >= 1) return way.length;
    return of_span<double>(way, [&]<std::size_t N>(const Points<N>& points) {
        return polygon(path::Casteljau<Vec3, N>(points, place).halves().first);
    });
}

}  // namespace kadr::motion
