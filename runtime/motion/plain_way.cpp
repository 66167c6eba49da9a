#include "motion/plain_way.h"

#include <algorithm>
#include <cmath>

#include "path/casteljau.h"

namespace kadr::motion {

namespace {

using path::Cubic;
using path::Vec3;
using Side = PlainLook::Side;

/// Never shorter than the curve.
double polygon(const Cubic& cubic) {
    return (cubic[1] - cubic[0]).norm() + (cubic[2] - cubic[1]).norm() +
           (cubic[3] - cubic[2]).norm();
}

}  // namespace

PlainWay plain_way(const path::Line& line) {
    PlainWay way;
    way.curve = line;
    way.length = line.length;
    return way;
}

PlainWay plain_way(const Cubic& cubic) {
    PlainWay way;
    way.curve = cubic;
    way.length = polygon(cubic);
    return way;
}

path::Curve curve_of(const PlainWay& way) {
    if (const auto* line = std::get_if<path::Line>(&way.curve)) return *line;
    const auto& cubic = std::get<Cubic>(way.curve);
    path::SplineShape shape;
    shape.inner = {cubic[1], cubic[2]};
    return path::make_spline(cubic[0], cubic[3], shape);
}

const Vec3& end_of(const PlainWay& way) {
    if (const auto* line = std::get_if<path::Line>(&way.curve)) return line->end;
    return std::get<Cubic>(way.curve)[3];
}

/// Newton's iteration for the foot of the tip, as programmed_path.h does it, but it ends as soon as
/// the answer is sure: a place within the tolerance with its foot near, or an end that the tip has
/// gone past. A tip beside the middle is left to a closer look.
PlainLook look_on_cubic(const PlainWay& way, const Vec3& tip, double tolerance, double place) {
    constexpr int kSteps = 12;
    /// The foot is known well enough when the next step is shorter, mm: it squares what is left.
    constexpr double kNear = 1e-3;
    const auto& cubic = std::get<Cubic>(way.curve);
    const double lower = std::max(0.0, place - 2 * tolerance / way.length);
    double u = place;
    for (int step = 0; step < kSteps; ++step) {
        const path::Casteljau<Vec3> scheme(cubic, u);
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

double bound_on_cubic(const PlainWay& way, double place) {
    const auto& cubic = std::get<Cubic>(way.curve);
    return polygon(place < 1 ? path::split(cubic, place).first : cubic);
}

}  // namespace kadr::motion
