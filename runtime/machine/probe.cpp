#include "machine/probe.h"

#include <algorithm>
#include <cmath>

namespace kadr::machine {

using path::Vec3;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// mm: contact, far below the resolution of any probe.
constexpr double kContact = 1e-9;
/// mm: a ball that stands so near at the beginning has touched already, as after a touch before.
constexpr double kStanding = 1e-6;

/// The distance from where two walls at a right angle meet: from the edge outside of both, from the
/// nearer wall elsewhere.
double beyond(double first, double second) {
    return first > 0 && second > 0 ? std::hypot(first, second) : std::max(first, second);
}

double distance(const ProbeSolid& solid, const Vec3& point) {
    switch (solid.kind) {
        case ProbeSolid::Kind::Plane: {
            const double height = point[static_cast<Eigen::Index>(solid.axis)] - solid.at;
            return solid.is_above ? -height : height;
        }
        case ProbeSolid::Kind::Block: {
            const Vec3 outside = (solid.from - point).cwiseMax(point - solid.to);
            const Vec3 beside = outside.cwiseMax(0.0);
            return outside.maxCoeff() > 0 ? beside.norm() : outside.maxCoeff();
        }
        case ProbeSolid::Kind::Boss: {
            const Vec3 delta = point - solid.from;
            const double across = std::hypot(delta.x(), delta.y()) - solid.radius;
            return beyond(across, std::max(delta.z(), -solid.height - delta.z()));
        }
    }
    return kInfinity;
}

/// How deep a point lies in the hole; negative beside it.
double depth_in(const ProbeBore& bore, const Vec3& point) {
    const Vec3 delta = point - bore.center;
    return std::min(bore.radius - std::hypot(delta.x(), delta.y()), delta.z() + bore.depth);
}

}  // namespace

double distance_to_material(const ProbeScene& scene, const Vec3& point) {
    double to_solid = scene.solids.empty() ? -kInfinity : kInfinity;
    for (const ProbeSolid& solid : scene.solids)
        to_solid = std::min(to_solid, distance(solid, point));
    // Holes alone are in a plate whose upper face is at their mouths.
    if (scene.solids.empty()) {
        for (const ProbeBore& bore : scene.bores)
            to_solid = std::max(to_solid, point.z() - bore.center.z());
    }
    double out = to_solid;
    for (const ProbeBore& bore : scene.bores)
        out = std::max(out, beyond(to_solid, depth_in(bore, point)));
    return out;
}

std::optional<double> first_touch(const ProbeScene& scene, const Vec3& from, const Vec3& to,
                                  double radius) {
    const double length = (to - from).norm();
    if (length <= kContact) return std::nullopt;
    const auto gap_at = [&](double distance) {
        return distance_to_material(scene, from + (to - from) * (distance / length)) - radius;
    };
    double gap = gap_at(0);
    double distance = 0;
    // One step away from the material tells whether the ball leaves it.
    if (gap <= kStanding) {
        constexpr double kStep = 1e-4;
        distance = std::min(kStep, length);
        if (gap_at(distance) <= gap) return 0;
        gap = gap_at(distance);
    }
    // No step is longer than the gap, so nothing is stepped over; on a path along a face steps
    // would become ever smaller, so none is below a hundredth of a micrometre.
    constexpr double kLeastStep = 1e-5;
    while (distance < length) {
        const double next = std::min(distance + std::max(gap, kLeastStep), length);
        const double gap_there = gap_at(next);
        if (gap_there > kContact) {
            distance = next;
            gap = gap_there;
            if (distance >= length) return std::nullopt;
            continue;
        }
        // Between the two: where exactly.
        double before = distance;
        double behind = next;
        for (int i = 0; i < 60; ++i) {
            const double middle = (before + behind) / 2;
            (gap_at(middle) > 0 ? before : behind) = middle;
        }
        return behind / length;
    }
    return std::nullopt;
}

std::optional<double> first_release(const ProbeScene& scene, const Vec3& from, const Vec3& to,
                                    double radius) {
    const double length = (to - from).norm();
    const auto gap_at = [&](double part) {
        return distance_to_material(scene, from + (to - from) * part) - radius;
    };
    if (length <= kContact || gap_at(0) > kStanding || gap_at(1) <= kStanding) return std::nullopt;
    double before = 0;
    double behind = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = (before + behind) / 2;
        (gap_at(middle) > 0 ? behind : before) = middle;
    }
    return behind;
}

}  // namespace kadr::machine
