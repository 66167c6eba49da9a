#include "path/orient_law.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace kadr::path {

namespace {

/// Shorter than this a part of a unit vector has no direction of its own.
constexpr double kNoLength = 1e-12;

Vec3 turned(const Turn& turn, double distance) {
    const double angle = turn.rate * distance;
    if (angle == 0) return turn.start;
    return Eigen::AngleAxisd(angle, turn.axis) * turn.start;
}

/// The tip is where the curve is at the distance; of a Point it stands.
Vec3 along_point(const Turn& turn, const Curve& curve, double distance) {
    const Vec3 second = turn.start + distance * turn.axis;
    if (turn.outwards == 0) return (second - position(curve, distance)).normalized();
    const CurvePoint at = evaluate(curve, distance);
    return (second - at.position + turn.outwards * at.curvature.normalized()).normalized();
}

}  // namespace

Vec3 direction_at(const Turn& turn, const Curve& curve, double distance) {
    switch (turn.kind) {
        case Turning::None:
        case Turning::Straight:
        case Turning::Joints:
        case Turning::Axes: return turn.start;
        case Turning::Cone: return turned(turn, distance);
        case Turning::Surface: {
            const Vec3 normal = turned(turn, distance);
            if (turn.lean.lead == 0 && turn.lean.tilt == 0) return normal;
            return leaning(normal, evaluate(curve, distance).tangent, turn.lean);
        }
        case Turning::Point: return along_point(turn, curve, distance);
    }
    return turn.start;
}

Turn part_of(const Turn& turn, double from, double to) {
    Turn part = turn;
    part.length = to - from;
    if (turn.kind == Turning::Joints) part.joints = path::part(turn.joints, from, to);
    part.start =
        turn.kind == Turning::Point ? Vec3(turn.start + from * turn.axis) : turned(turn, from);
    return part;
}

Vec3 leaning(const Vec3& normal, const Vec3& tangent, const Lean& lean) {
    const Vec3 in_surface = tangent - tangent.dot(normal) * normal;
    const double length = in_surface.norm();
    if (length < kNoLength) return normal;
    const Vec3 forward = in_surface / length;
    const Vec3 leant = std::cos(lean.lead) * normal + std::sin(lean.lead) * forward;
    if (lean.tilt == 0) return leant;
    const Vec3& about = lean.about == TiltAbout::Normal ? normal : forward;
    return Eigen::AngleAxisd(lean.tilt, about) * leant;
}

double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

double rise_of(const Vec3& normal, const Vec3& tangent) {
    return std::asin(std::clamp(normal.dot(tangent), -1.0, 1.0));
}

}  // namespace kadr::path
