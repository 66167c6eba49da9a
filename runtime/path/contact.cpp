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
std::optional<Vec3> off_face(const Contact& contact, const Vec3& normal, const Vec3& tool) {
    const Vec3 off = (contact.depth + contact.allowance) * normal - contact.depth * tool;
    const double across = contact.radius - contact.depth;
    if (across == 0) return off;  // a ball, or a surface square to the tool
    const auto outwards = unit_or_none(normal - normal.dot(tool) * tool);
    if (!outwards) return std::nullopt;
    return off + across * *outwards;
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
        case ContactKind::Flank:
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

Vec3 tip_square(const Contact& contact, const Vec3& tool) { return contact.allowance * tool; }

double tip_travel_about(const Contact& contact, const Vec3& tool) {
    if (contact.kind == ContactKind::Pivot) return std::abs(contact.turn * contact.radius);
    if (contact.kind != ContactKind::Face || contact.turn == 0) return 0;
    constexpr int kChords = 16;
    const auto aside = [&](double share) {
        return tip_or_limit(
                   share,
                   [&](double at) { return tip_beside(contact, guide_at(contact, at), tool); })
            .value_or(Vec3::Zero());
    };
    double distance = 0;
    Vec3 last = aside(0);
    for (int i = 1; i <= kChords; ++i) {
        const Vec3 next = aside(static_cast<double>(i) / kChords);
        distance += (next - last).norm();
        last = next;
    }
    return distance;
}

}  // namespace kadr::path
