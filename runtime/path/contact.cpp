#include "path/contact.h"

#include <cmath>

#include <Eigen/Geometry>

namespace kadr::path {

namespace {

// Sine of the angle below which a tool lies along its path, or a surface square to it.
constexpr double kAlong = 1e-9;

std::optional<Vec3> unit_or_none(const Vec3& vector) {
    const double length = vector.norm();
    if (!(length > kAlong)) return std::nullopt;
    return vector / length;
}

/// The cutter's axis at equal distance from two lines that meet: where both sides, seen along the
/// tool, intersect (motion.md §8.1).
std::optional<Vec3> between(const Contact& contact, const Vec3& tool) {
    const auto first = beside(contact.guide, tool);
    const auto second = beside(contact.axis, tool);
    if (!first || !second) return std::nullopt;
    return contact.radius * (*first + *second) / (1 + first->dot(*second)) - contact.depth * tool;
}

/// The edge is a torus: its tube touches along the normal, its middle circle lies square to the
/// tool.
Vec3 off_face(const Contact& contact, const Vec3& normal, const Vec3& tool) {
    const auto outwards = unit_or_none(normal - normal.dot(tool) * tool);
    const Vec3 across =
        outwards ? Vec3((contact.radius - contact.depth) * *outwards) : Vec3(Vec3::Zero());
    return contact.depth * normal + across - contact.depth * tool;
}

}  // namespace

std::optional<Vec3> beside(const Vec3& tangent, const Vec3& tool) {
    return unit_or_none(tangent.cross(tool));
}

std::optional<Vec3> tip_beside(const Contact& contact, const Vec3& guide, const Vec3& tool) {
    switch (contact.kind) {
        case ContactKind::Tip: return Vec3::Zero();
        case ContactKind::Corner: return between(contact, tool);
        case ContactKind::Face: return off_face(contact, guide, tool);
        case ContactKind::Side:
        case ContactKind::Pivot: break;
    }
    const auto aside = beside(guide, tool);
    if (!aside) return std::nullopt;
    return contact.radius * *aside - contact.depth * tool;
}

Vec3 guide_at(const Contact& contact, double share) {
    if (contact.turn == 0) return contact.guide;
    return Eigen::AngleAxisd(share * contact.turn, contact.axis) * contact.guide;
}

}  // namespace kadr::path
