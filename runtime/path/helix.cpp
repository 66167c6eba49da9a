#include "path/helix.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <Eigen/Geometry>

#include "base/assert.h"
#include "path/quadrature.h"

namespace kadr::path {

namespace {

/// ds/dφ = sqrt(r² + r'² + h'²).
double length_rate(const Helix& helix, double angle) {
    const double r = helix.radius + helix.radius_rate * angle;
    return std::sqrt(r * r + helix.radius_rate * helix.radius_rate +
                     helix.height_rate * helix.height_rate);
}

/// ∫ sqrt(r² + c²) dr = (r·sqrt(r² + c²) + c²·asinh(r/c))/2 with c² = r'² + h'², and dr = r' dφ.
/// Only for r' that is not small against r: else the difference loses all digits.
double spiral_length(const Helix& helix, double angle) {
    const double c = std::hypot(helix.radius_rate, helix.height_rate);
    const auto primitive = [c](double r) {
        return 0.5 * (r * std::sqrt(r * r + c * c) + c * c * std::asinh(r / c));
    };
    const double r = helix.radius + helix.radius_rate * angle;
    return (primitive(r) - primitive(helix.radius)) / helix.radius_rate;
}

/// ∫ ds/dφ by Gauss-Legendre with five points; its error is far below the tolerance as long as
/// the radius changes by less than a tenth (it falls with the tenth power of the change).
double smooth_length(const Helix& helix, double angle) {
    return gauss([&](double at) { return length_rate(helix, at); }, 0, angle);
}

double length_to(const Helix& helix, double angle) {
    const bool spreads_much =
        std::abs(helix.radius_rate * helix.sweep) > 0.1 * std::abs(helix.radius);
    return spreads_much ? spiral_length(helix, angle) : smooth_length(helix, angle);
}

/// Sets `length` and the law that leads back from the length to the angle.
void measure(Helix& helix) {
    helix.rate = length_rate(helix, 0);
    helix.rate_slope = 0;
    helix.needs_newton = false;
    if (helix.radius_rate == 0) {
        helix.length = helix.rate * helix.sweep;
        return;
    }
    helix.length = length_to(helix, helix.sweep);
    // A slope that meets the whole length; what it misses in between is judged at the middle.
    helix.rate_slope = 2 * (helix.length / helix.sweep - helix.rate) / helix.sweep;
    const double middle = 0.5 * helix.sweep;
    const double guess = (helix.rate + 0.5 * helix.rate_slope * middle) * middle;
    // The miss is a cubic with zeros at both ends, at most 1.3 times its value at the middle.
    helix.needs_newton = 2 * std::abs(guess - length_to(helix, middle)) > kArcLengthTolerance;
}

}  // namespace

Helix make_helix(const Vec3& start, const Vec3& end, const Vec3& center, const Vec3& normal,
                 double sweep) {
    KADR_ASSERT(sweep > 0, "an arc needs a sweep");
    const Vec3 from = start - center;
    const Vec3 to = end - center;
    const double from_height = from.dot(normal);
    const double to_height = to.dot(normal);
    const Vec3 out = from - from_height * normal;
    Helix helix;
    helix.radius = out.norm();
    // A start on the axis itself has no direction from it; any will do.
    helix.e1 = helix.radius > 0 ? Vec3(out / helix.radius) : Vec3(normal.unitOrthogonal());
    helix.e2 = normal.cross(helix.e1);
    helix.normal = normal;
    helix.base = center + from_height * normal;
    helix.start = start;
    helix.end = end;
    helix.sweep = sweep;
    helix.height_rate = (to_height - from_height) / sweep;
    helix.radius_rate = ((to - to_height * normal).norm() - helix.radius) / sweep;
    // What rounding makes of an exact circle is not a spiral.
    if (std::abs(helix.radius_rate) * sweep < 1e-12 * helix.radius) helix.radius_rate = 0;
    measure(helix);
    return helix;
}

double angle_at(const Helix& helix, double s) {
    if (helix.radius_rate == 0) return s / helix.rate;
    // The root of rate·φ + rate_slope·φ²/2 = s, in the form that stays exact for a small slope.
    const double root =
        std::sqrt(std::max(0.0, helix.rate * helix.rate + 2 * helix.rate_slope * s));
    double angle = 2 * s / (helix.rate + root);
    if (!helix.needs_newton) return angle;
    // Newton for length_to(φ) = s; convex, so a handful of steps from this close.
    for (int step = 0; step < 8; ++step) {
        const double miss = length_to(helix, angle) - s;
        if (std::abs(miss) <= 0.1 * kArcLengthTolerance) break;
        angle = std::clamp(angle - miss / length_rate(helix, angle), 0.0, helix.sweep);
    }
    return angle;
}

Vec3 position_at_angle(const Helix& helix, double angle) {
    const double r = helix.radius + helix.radius_rate * angle;
    return helix.base + (r * std::cos(angle)) * helix.e1 + (r * std::sin(angle)) * helix.e2 +
           (helix.height_rate * angle) * helix.normal;
}

Vec3 position(const Helix& helix, double s) {
    if (s <= 0) return helix.start;
    if (s >= helix.length) return helix.end;
    return position_at_angle(helix, angle_at(helix, s));
}

CurvePoint evaluate(const Helix& helix, double s) {
    const double angle = angle_at(helix, std::clamp(s, 0.0, helix.length));
    const double r = helix.radius + helix.radius_rate * angle;
    const Vec3 out = std::cos(angle) * helix.e1 + std::sin(angle) * helix.e2;
    const Vec3 along = std::cos(angle) * helix.e2 - std::sin(angle) * helix.e1;
    const Vec3 first = helix.radius_rate * out + r * along + helix.height_rate * helix.normal;
    const Vec3 second = 2 * helix.radius_rate * along - r * out;
    const double rate_squared = first.squaredNorm();
    const Vec3 tangent = first / std::sqrt(rate_squared);
    // d²C/ds² is the part of C'' across the tangent, divided by |C'|².
    return {position(helix, s), tangent, (second - second.dot(tangent) * tangent) / rate_squared};
}

Helix part(const Helix& helix, double from, double to) {
    const double first = angle_at(helix, from);
    const double last = to >= helix.length ? helix.sweep : angle_at(helix, to);
    Helix piece = helix;
    piece.start = position(helix, from);
    piece.end = position(helix, to);
    piece.e1 = std::cos(first) * helix.e1 + std::sin(first) * helix.e2;
    piece.e2 = helix.normal.cross(piece.e1);
    piece.base = helix.base + (helix.height_rate * first) * helix.normal;
    piece.radius = helix.radius + helix.radius_rate * first;
    piece.sweep = last - first;
    measure(piece);
    return piece;
}

Extremes wave_extremes(double mean, double a, double b, double sweep) {
    const double amplitude = std::hypot(a, b);
    if (sweep >= 2 * std::numbers::pi) return {mean - amplitude, mean + amplitude};
    const double first = mean + a;
    const double last = mean + a * std::cos(sweep) + b * std::sin(sweep);
    Extremes extremes{std::min(first, last), std::max(first, last)};
    if (amplitude == 0) return extremes;
    // Is the crest, and is the trough half a turn later, within the sweep?
    const auto passes = [sweep](double angle) {
        const double turn = 2 * std::numbers::pi;
        angle -= turn * std::floor(angle / turn);
        return angle <= sweep;
    };
    const double crest = std::atan2(b, a);
    if (passes(crest)) extremes.upper = mean + amplitude;
    if (passes(crest + std::numbers::pi)) extremes.lower = mean - amplitude;
    return extremes;
}

namespace {

/// Least and greatest value of `mean + a·cos φ + b·sin φ + rise·φ` for φ from 0 to `sweep`.
Extremes rising_extremes(double mean, double a, double b, double rise, double sweep) {
    const double amplitude = std::hypot(a, b);
    const auto at = [&](double angle) {
        return mean + a * std::cos(angle) + b * std::sin(angle) + rise * angle;
    };
    Extremes extremes{std::min(at(0), at(sweep)), std::max(at(0), at(sweep))};
    if (std::abs(rise) >= amplitude) return extremes;  // it rises all along
    // A·sin(φ − δ) = rise; of those a turn apart the first and the last one are the extremes.
    constexpr double kTurn = 2 * std::numbers::pi;
    const double delta = std::atan2(b, a);
    const double inclination = std::asin(rise / amplitude);
    for (const double angle : {delta + inclination, delta + std::numbers::pi - inclination}) {
        const double first = angle - kTurn * std::floor(angle / kTurn);
        if (first > sweep) continue;
        const double last = first + kTurn * std::floor((sweep - first) / kTurn);
        extremes.lower = std::min({extremes.lower, at(first), at(last)});
        extremes.upper = std::max({extremes.upper, at(first), at(last)});
    }
    return extremes;
}

}  // namespace

Box bounds(const Helix& helix) {
    // Exact where the radius stays; where it changes each point lies between those on the radii of
    // both ends: never too small.
    const double radii[] = {helix.radius, helix.radius + helix.radius_rate * helix.sweep};
    const std::span<const double> different(radii, helix.radius_rate == 0 ? 1 : 2);
    Box box{helix.start.cwiseMin(helix.end), helix.start.cwiseMax(helix.end)};
    for (int i = 0; i < 3; ++i) {
        const double rise = helix.height_rate * helix.normal[i];
        for (const double r : different) {
            const Extremes circle =
                rising_extremes(helix.base[i], r * helix.e1[i], r * helix.e2[i], rise, helix.sweep);
            box.lower[i] = std::min(box.lower[i], circle.lower);
            box.upper[i] = std::max(box.upper[i], circle.upper);
        }
    }
    return box;
}

}  // namespace kadr::path
