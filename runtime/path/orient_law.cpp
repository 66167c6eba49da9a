#include "path/orient_law.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace kadr::path {

namespace {

/// Shorter than this a part of a unit vector has no direction of its own.
constexpr double kNoLength = 1e-12;

Vec3 turned(const OrientLaw& orientation, double distance) {
    const double angle = orientation.rate * distance;
    if (angle == 0) return orientation.start;
    return Eigen::AngleAxisd(angle, orientation.axis) * orientation.start;
}

/// The tip is where the curve is at the distance; of a Point it stands.
Vec3 along_point(const OrientLaw& orientation, const Curve& curve, double distance) {
    const Vec3 second = orientation.start + distance * orientation.axis;
    if (orientation.outwards == 0) return (second - position(curve, distance)).normalized();
    const CurvePoint at = evaluate(curve, distance);
    return (second - at.position + orientation.outwards * at.curvature.normalized()).normalized();
}

}  // namespace

Vec3 direction_at(const OrientLaw& orientation, const Curve& curve, double distance) {
    switch (orientation.kind) {
        case OrientKind::None:
        case OrientKind::Straight:
        case OrientKind::Joints:
        case OrientKind::Axes: return orientation.start;
        case OrientKind::Cone: return turned(orientation, distance);
        case OrientKind::Surface: {
            const Vec3 normal = turned(orientation, distance);
            if (orientation.lead_tilt.lead == 0 && orientation.lead_tilt.tilt == 0) return normal;
            return leant(normal, evaluate(curve, distance).tangent, orientation.lead_tilt);
        }
        case OrientKind::Point: return along_point(orientation, curve, distance);
    }
    return orientation.start;
}

OrientLaw part_of(const OrientLaw& orientation, double from, double to) {
    OrientLaw part = orientation;
    part.length = to - from;
    if (orientation.kind == OrientKind::Joints)
        part.joints = path::part(orientation.joints, from, to);
    part.start = orientation.kind == OrientKind::Point
                     ? Vec3(orientation.start + from * orientation.axis)
                     : turned(orientation, from);
    return part;
}

Vec3 leant(const Vec3& normal, const Vec3& tangent, const LeadTiltAngles& lead_tilt) {
    const Vec3 in_surface = tangent - tangent.dot(normal) * normal;
    const double length = in_surface.norm();
    if (length < kNoLength) return normal;
    const Vec3 forward = in_surface / length;
    const Vec3 leant = std::cos(lead_tilt.lead) * normal + std::sin(lead_tilt.lead) * forward;
    if (lead_tilt.tilt == 0) return leant;
    const Vec3& about = lead_tilt.about == TiltAbout::Normal ? normal : forward;
    return Eigen::AngleAxisd(lead_tilt.tilt, about) * leant;
}

double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

double rise_of(const Vec3& normal, const Vec3& tangent) {
    return std::asin(std::clamp(normal.dot(tangent), -1.0, 1.0));
}

}  // namespace kadr::path
