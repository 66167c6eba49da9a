#include "path/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace kadr::path {

namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

/// Below this angle start and end are the same direction from the centre: a full turn. 1e-9 rad is
/// a micrometre at a radius of a kilometre.
constexpr double kSameDirection = 1e-9;

/// Lengths below this are no lengths: a thousandth of the finest increment of any control.
constexpr double kNoLength = 1e-9;  // mm

/// Sine of the angle below which three points, or a tangent and a chord, are on one line.
constexpr double kOneLine = 1e-9;

/// The part of a vector that lies in the plane.
Vec3 in_plane(const Vec3& vector, const Vec3& normal) {
    return vector - vector.dot(normal) * normal;
}

/// Angle from `from` to `to`, counter-clockwise about `normal`, in (0, 2π].
double sweep_between(const Vec3& from, const Vec3& to, const Vec3& normal) {
    double angle = std::atan2(normal.dot(from.cross(to)), from.dot(to));
    if (angle < 0) angle += kTwoPi;
    return angle < kSameDirection ? kTwoPi : angle;
}

Vec3 normal_of(const ArcTurning& turning) {
    const Vec3 third = unit(axes_of(turning.plane).normal);
    return turning.is_clockwise ? Vec3(-third) : third;
}

bool is_possible(int turns) { return turns >= 0 && turns <= kMaxTurns; }

/// Moves the centre onto the perpendicular bisector of start and end, at the distance `radius` from
/// both, on the side where it was. Both vectors lie in the plane and point from the start.
Result<Vec3, ArcFault> shifted_center(const Vec3& to_center, const Vec3& chord, const Vec3& normal,
                                      double most_turn) {
    const double half_chord = chord.norm() / 2;
    if (half_chord < kNoLength) return to_center;
    const double radius = std::max(to_center.norm(), half_chord);
    const Vec3 left = normal.cross(chord).normalized();
    const double height = std::sqrt(radius * radius - half_chord * half_chord);
    const double side = to_center.dot(left) < 0 ? -1 : 1;
    const Vec3 shifted = chord / 2 + side * height * left;
    const double turned = std::atan2(to_center.cross(shifted).norm(), to_center.dot(shifted));
    if (turned > most_turn) return ArcFault::RadiusMismatch;
    return shifted;
}

}  // namespace

Result<Arc, ArcFault> arc_about_center(const ArcEnds& ends, const Vec3& center,
                                       const ArcTurning& turning, const ArcTolerance& tolerance) {
    if (!is_possible(turning.turns)) return ArcFault::BadTurns;
    const Vec3 normal = normal_of(turning);
    Vec3 to_center = in_plane(center - ends.start, normal);
    const Vec3 chord = in_plane(ends.end - ends.start, normal);
    const double start_radius = to_center.norm();
    if (start_radius < kNoLength) return ArcFault::NoRadius;

    const double error = std::abs((chord - to_center).norm() - start_radius);
    // kNoLength: a miss of exactly the tolerance, in decimal text, is accepted.
    if (error > std::max(tolerance.constant, tolerance.factor * start_radius) + kNoLength) {
        return ArcFault::RadiusMismatch;
    }
    if (error > kNoLength && tolerance.mode == RadiusError::ShiftCenter) {
        const Result<Vec3, ArcFault> shifted =
            shifted_center(to_center, chord, normal, tolerance.shift_angle);
        if (!shifted) return shifted.error();
        to_center = *shifted;
    }
    const double sweep = sweep_between(-to_center, chord - to_center, normal);
    return Arc{ends.start, ends.end, ends.start + to_center, normal,
               sweep + turning.turns * kTwoPi};
}

Result<Arc, ArcFault> arc_of_radius(const ArcEnds& ends, double radius, const ArcTurning& turning) {
    if (!is_possible(turning.turns)) return ArcFault::BadTurns;
    const Vec3 normal = normal_of(turning);
    const Vec3 chord = in_plane(ends.end - ends.start, normal);
    const double half_chord = chord.norm() / 2;
    if (half_chord < kNoLength) return ArcFault::NoChord;
    if (2 * (half_chord - std::abs(radius)) > kSemicircleSlack) return ArcFault::RadiusTooSmall;

    const double size = std::max(std::abs(radius), half_chord);
    const double height = std::sqrt(size * size - half_chord * half_chord);
    // Counter-clockwise about the normal, the centre of the short arc lies left of the chord.
    const Vec3 left = normal.cross(chord).normalized();
    const Vec3 to_center = chord / 2 + (radius > 0 ? height : -height) * left;
    const double half_sweep = std::asin(std::min(1.0, half_chord / size));
    const double sweep = radius > 0 ? 2 * half_sweep : kTwoPi - 2 * half_sweep;
    return Arc{ends.start, ends.end, ends.start + to_center, normal,
               sweep + turning.turns * kTwoPi};
}

Result<Arc, ArcFault> arc_through(const ArcEnds& ends, const Vec3& through) {
    // a and b from the start to the middle and the end, w their normal:
    // centre − start = ((a² b − b² a) × w) / (2 w²).
    const Vec3 a = through - ends.start;
    const Vec3 b = ends.end - ends.start;
    const Vec3 w = a.cross(b);
    if (w.norm() <= kOneLine * a.norm() * b.norm()) {
        const bool is_between = a.dot(b) >= 0 && a.squaredNorm() <= b.squaredNorm();
        return is_between && b.norm() > kNoLength ? ArcFault::Straight : ArcFault::Collinear;
    }
    const Vec3 to_center =
        (a.squaredNorm() * b - b.squaredNorm() * a).cross(w) / (2 * w.squaredNorm());
    const Vec3 normal = w.normalized();
    const double sweep = sweep_between(-to_center, b - to_center, normal);
    // Of a circle so large that start and end are the same point on it nobody knows how it goes.
    constexpr double kLargest = 1e12;  // mm
    if (!(sweep > 0) || !(to_center.norm() < kLargest)) return ArcFault::Collinear;
    return Arc{ends.start, ends.end, ends.start + to_center, normal, sweep};
}

Result<Arc, ArcFault> arc_along_tangent(const ArcEnds& ends, const Vec3& tangent) {
    const Vec3 along = tangent.normalized();
    const Vec3 chord = ends.end - ends.start;
    if (chord.norm() < kNoLength) return ArcFault::NoChord;
    const Vec3 across = chord - chord.dot(along) * along;
    if (across.norm() <= kOneLine * chord.norm()) {
        return chord.dot(along) > 0 ? ArcFault::Straight : ArcFault::Backwards;
    }
    // The chord makes half the sweep's angle with the tangent: r = b² / (2 b·n).
    const Vec3 inwards = across.normalized();
    const double radius = chord.squaredNorm() / (2 * chord.dot(inwards));
    const double sweep = 2 * std::atan2(across.norm(), chord.dot(along));
    return Arc{ends.start, ends.end, ends.start + radius * inwards, along.cross(inwards), sweep};
}

ArcMeasures measures_of(const Arc& arc) {
    const Vec3 to_end = arc.end - arc.center;
    const double height = to_end.dot(arc.normal) - (arc.start - arc.center).dot(arc.normal);
    return {in_plane(arc.start - arc.center, arc.normal).norm(),
            in_plane(to_end, arc.normal).norm(), height};
}

ArcPoint point_at(const Arc& arc, double angle) {
    const ArcMeasures shape = measures_of(arc);
    const Vec3 outwards = in_plane(arc.start - arc.center, arc.normal) / shape.start_radius;
    const Vec3 sideways = arc.normal.cross(outwards);
    const double growth = (shape.end_radius - shape.start_radius) / arc.sweep;  // of the radius
    const double radius = shape.start_radius + growth * angle;
    const Vec3 e = std::cos(angle) * outwards + std::sin(angle) * sideways;
    const Vec3 de = -std::sin(angle) * outwards + std::cos(angle) * sideways;
    const double climb = shape.height / arc.sweep;
    const Vec3 floor = arc.center + (arc.start - arc.center).dot(arc.normal) * arc.normal;
    return {floor + radius * e + climb * angle * arc.normal,
            growth * e + radius * de + climb * arc.normal, 2 * growth * de - radius * e};
}

double length_of(const Arc& arc) {
    // |C'|² = r² + g², where g² gathers what does not change along the arc: growth of the radius
    // and climb, both by the angle.
    const ArcMeasures shape = measures_of(arc);
    const double growth = (shape.end_radius - shape.start_radius) / arc.sweep;
    const double g = std::hypot(growth, shape.height / arc.sweep);
    const auto speed = [g](double r) { return std::hypot(r, g); };
    // The closed form divides by the growth; while that is small, Simpson's rule is exact to the
    // last digit (its error goes with the fourth power of the growth).
    const double middle = (shape.start_radius + shape.end_radius) / 2;
    if (std::abs(shape.end_radius - shape.start_radius) < 1e-3 * middle) {
        return (speed(shape.start_radius) + 4 * speed(middle) + speed(shape.end_radius)) / 6 *
               arc.sweep;
    }
    const auto primitive = [g, speed](double r) {
        return (r * speed(r) + g * g * (g > 0 ? std::asinh(r / g) : 0)) / 2;
    };
    return (primitive(shape.end_radius) - primitive(shape.start_radius)) / growth;
}

}  // namespace kadr::path
