#include "path/involute.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace kadr::path {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Ends that are closer to each other, or to the base circle, than this, mm, as seen from the
/// centre: rounding of the text.
constexpr double kSameRadius = 1e-6;

/// The angle about the centre while the string unwinds by t.
double turned(double t) { return t - std::atan(t); }

/// … and back. t lies between the angle and a quarter of a turn more.
double unwound(double angle) {
    double low = angle;
    double high = angle + std::numbers::pi / 2;
    double t = std::min(high, std::max(low, std::cbrt(3 * angle)));
    for (int pass = 0; pass < 100; ++pass) {
        const double miss = turned(t) - angle;
        (miss > 0 ? high : low) = t;
        const double next = t - miss * (1 + 1 / (t * t));
        const double before = t;
        t = next > low && next < high ? next : (low + high) / 2;
        if (std::fabs(t - before) <= 1e-15 * t) break;
    }
    return t;
}

double unwound_at(double distance, double radius) {
    const double ratio = distance / radius;
    return std::sqrt(std::max(0.0, (ratio - 1) * (ratio + 1)));
}

/// The part of a distance that lies in the plane.
Vec3 in_plane(const Vec3& delta, const Vec3& normal) { return delta - delta.dot(normal) * normal; }

double flat_rate(const Involute& involute) {
    return std::sqrt(1 + involute.height_rate * involute.height_rate);
}

double direction_of(const Involute& involute) { return involute.last > involute.first ? 1 : -1; }

/// t at an arc length.
double unwound_at_length(const Involute& involute, double s) {
    const double flat = s / flat_rate(involute);
    const double square =
        involute.first * involute.first + direction_of(involute) * 2 * flat / involute.radius;
    return std::sqrt(std::max(0.0, square));
}

Vec3 string_direction(const Involute& involute, double t) {
    const double angle = involute.hand * t;
    return std::cos(angle) * involute.e1 + std::sin(angle) * involute.e2;
}

Vec3 across_string(const Involute& involute, double t) {
    const double angle = involute.hand * t;
    return std::cos(angle) * involute.e2 - std::sin(angle) * involute.e1;
}

Vec3 point_at(const Involute& involute, double t) {
    const double flat = involute.radius * (t * t - involute.first * involute.first) / 2;
    return involute.base +
           involute.radius *
               (string_direction(involute, t) - involute.hand * t * across_string(involute, t)) +
           involute.height_rate * std::fabs(flat) * involute.normal;
}

}  // namespace

Involute make_involute(const Vec3& start, const Vec3& end, const Vec3& center, const Vec3& normal,
                       double base_radius) {
    Involute involute;
    involute.normal = normal;
    involute.start = start;
    involute.end = end;
    involute.radius = base_radius;
    involute.height = (end - start).dot(normal);
    involute.base = center + (start - center).dot(normal) * normal;
    const Vec3 out = start - involute.base;
    const double distance = out.norm();
    involute.first = unwound_at(distance, base_radius);
    involute.last = unwound_at(in_plane(end - center, normal).norm(), base_radius);
    // Away from the circle the string unwinds in the direction of the motion, towards it the other
    // way round.
    involute.hand = involute.last > involute.first ? 1 : -1;
    const Vec3 u = out / distance;
    const Vec3 v = normal.cross(u);
    const double angle = -involute.hand * turned(involute.first);
    involute.e1 = std::cos(angle) * u + std::sin(angle) * v;
    involute.e2 = normal.cross(involute.e1);
    const double flat = base_radius *
                        std::fabs(involute.last * involute.last - involute.first * involute.first) /
                        2;
    involute.height_rate = flat > 0 ? involute.height / flat : 0;
    involute.length = std::hypot(flat, involute.height);
    return involute;
}

Vec3 position(const Involute& involute, double s) {
    if (s <= 0) return involute.start;
    if (s >= involute.length) return involute.end;
    return point_at(involute, unwound_at_length(involute, s));
}

CurvePoint evaluate(const Involute& involute, double s) {
    const double t = unwound_at_length(involute, std::clamp(s, 0.0, involute.length));
    const double rate = flat_rate(involute);
    CurvePoint point;
    point.position = position(involute, s);
    point.tangent = (direction_of(involute) * string_direction(involute, t) +
                     involute.height_rate * involute.normal) /
                    rate;
    // At the base circle the curve turns on the spot; a control keeps away from it.
    if (t > 0) {
        point.curvature =
            involute.hand * across_string(involute, t) / (involute.radius * t * rate * rate);
    }
    return point;
}

Involute part(const Involute& involute, double from, double to) {
    Involute piece = involute;
    piece.first = unwound_at_length(involute, from);
    piece.last = unwound_at_length(involute, to);
    piece.start = position(involute, from);
    piece.end = position(involute, to);
    piece.height = (piece.end - piece.start).dot(involute.normal);
    piece.base += (piece.start - involute.start).dot(involute.normal) * involute.normal;
    piece.length = to - from;
    return piece;
}

Box bounds(const Involute& involute) {
    Box box{involute.start.cwiseMin(involute.end), involute.start.cwiseMax(involute.end)};
    const double low = std::min(involute.first, involute.last);
    const double high = std::max(involute.first, involute.last);
    for (Eigen::Index i = 0; i < 3; ++i) {
        // A coordinate turns back where d·e(θ) + rate·normal has no part along it.
        const double amplitude = std::hypot(involute.e1[i], involute.e2[i]);
        const double rise = -direction_of(involute) * involute.height_rate * involute.normal[i];
        if (!(std::fabs(rise) <= amplitude) || amplitude == 0) continue;
        const double middle = std::atan2(involute.e2[i], involute.e1[i]);
        const double aside = std::acos(rise / amplitude);
        for (const double angle : {middle - aside, middle + aside}) {
            const double t = involute.hand * angle;
            for (double at = t + std::ceil((low - t) / kTurn) * kTurn; at <= high; at += kTurn) {
                const double value = point_at(involute, at)[i];
                box.lower[i] = std::min(box.lower[i], value);
                box.upper[i] = std::max(box.upper[i], value);
            }
        }
    }
    return box;
}

Result<double, InvoluteFault> base_radius_through(const InvoluteWords& words, const Vec3& end,
                                                  double tolerance) {
    if (!(words.base_radius > 0)) return InvoluteFault::Radius;
    const Vec3 from = in_plane(words.start - words.center, words.normal);
    const Vec3 to = in_plane(end - words.center, words.normal);
    const double near = std::min(from.norm(), to.norm());
    const double far = std::max(from.norm(), to.norm());
    if (near <= words.base_radius + kSameRadius) return InvoluteFault::Inside;
    if (far - near <= kSameRadius) return InvoluteFault::Even;
    double seen = std::atan2(words.normal.dot(from.cross(to)), from.dot(to));
    if (seen <= 0) seen += kTurn;
    const auto swept = [&](double radius) {
        return turned(unwound_at(far, radius)) - turned(unwound_at(near, radius));
    };
    const double whole = swept(words.base_radius);
    seen += kTurn * std::max(0.0, std::round((whole - seen) / kTurn));
    // Involutes of one circle are everywhere as far apart as the arc between their beginnings.
    if (std::fabs(whole - seen) * words.base_radius > tolerance) return InvoluteFault::EndOff;
    double radius = words.base_radius;
    for (int pass = 0; pass < 50; ++pass) {
        // d(swept)/dr = −(t of the far end − t of the near one)/r
        const double change = (unwound_at(far, radius) - unwound_at(near, radius)) / radius;
        const double step = (swept(radius) - seen) / change;
        radius += step;
        if (!(radius > 0) || !(radius < near)) return InvoluteFault::EndOff;
        if (std::fabs(step) <= 1e-15 * radius) break;
    }
    return radius;
}

Result<Vec3, InvoluteFault> involute_end(const InvoluteWords& words, double opening) {
    if (!(words.base_radius > 0)) return InvoluteFault::Radius;
    const Vec3 from = in_plane(words.start - words.center, words.normal);
    const double distance = from.norm();
    if (distance <= words.base_radius + kSameRadius) return InvoluteFault::Inside;
    if (opening == 0) return InvoluteFault::Even;
    const double angle = turned(unwound_at(distance, words.base_radius)) + opening;
    if (!(angle > 0)) return InvoluteFault::Inside;
    const double t = unwound(angle);
    const double reach = words.base_radius * std::sqrt(1 + t * t);
    if (reach <= words.base_radius + kSameRadius) return InvoluteFault::Inside;
    const Vec3 u = from / distance;
    const Vec3 v = words.normal.cross(u);
    const double seen = std::fabs(opening);
    return Vec3(words.start - from + reach * (std::cos(seen) * u + std::sin(seen) * v));
}

}  // namespace kadr::path
