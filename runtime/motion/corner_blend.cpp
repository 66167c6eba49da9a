#include "motion/corner_blend.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kadr::motion {

namespace {

using path::BlendKind;

/// Directions that differ by less, rad, go on: no corner that any coordinate could show.
constexpr double kTangent = 1e-6;
/// Curvatures that differ by less, 1/mm, are the same: a radius of a kilometre.
constexpr double kSameCurvature = 1e-6;
/// Two and a half degrees from turning back: the curve would be a cusp.
constexpr double kTurnsBack = -0.999;
/// A motion turns by no more than this within the distance that it gives, rad.
constexpr double kMostTurn = 1;
/// Part of the tolerance that is used: the deviation is known to a fiftieth.
constexpr double kUsed = 0.98;
/// A distance that uses so much of it is good enough.
constexpr double kWellUsed = 0.85;
constexpr int kTries = 12;

}  // namespace

BlendedCorner::BlendedCorner(const path::Curve& before, const path::Curve& behind)
    : before_(before),
      behind_(behind),
      length_(path::length(before)),
      in_(path::evaluate(before, length_)),
      out_(path::evaluate(behind, 0)) {}

bool BlendedCorner::is_corner(bool with_curvature) const {
    if ((in_.tangent - out_.tangent).norm() >= kTangent) return true;
    return with_curvature && (in_.curvature - out_.curvature).norm() >= kSameCurvature;
}

std::optional<double> BlendedCorner::most_blend_distance() const {
    if (in_.tangent.dot(out_.tangent) < kTurnsBack) return std::nullopt;
    const double distance = std::min(length_, path::length(behind_)) / 2;
    const double bend = std::max(in_.curvature.norm(), out_.curvature.norm());
    return distance * bend > kMostTurn ? kMostTurn / bend : distance;
}

path::Transition BlendedCorner::curve(double distance) const {
    return path::transition_between(path::evaluate(before_, length_ - distance),
                                    path::evaluate(behind_, distance), distance);
}

double BlendedCorner::deviation(double distance) const {
    return path::deviation(curve(distance), {before_, length_ - distance, length_},
                           {behind_, 0, distance});
}

double longest_blend_distance(const std::function<double(double)>& used, double most) {
    double distance = most;
    double good = 0;
    double bad = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kTries; ++i) {
        const double part = used(distance);
        const bool is_good = part <= kUsed;
        (is_good ? good : bad) = distance;
        if (is_good && (distance == most || part >= kWellUsed)) break;
        // That of a corner grows with the distance, that of a jump of the curvature with its
        // square: from there the mean of a distance too short and one too long leads to the goal.
        const bool is_enclosed = good > 0 && std::isfinite(bad);
        const double next = is_enclosed ? std::sqrt(good * bad) : distance * (0.99 * kUsed / part);
        distance = std::min(next, most);
        if (distance < kLeastBlendDistance) break;
    }
    return good;
}

double distance_of(const path::Blending& before, const path::Blending& behind) {
    const bool has_own = behind.kind == BlendKind::Distance;
    return has_own ? std::min(before.size, behind.size) : before.size;
}

double tolerance_of(const path::Blending& before, const path::Blending& behind) {
    const bool has_own = behind.kind == BlendKind::Tolerance;
    return has_own ? std::min(before.size, behind.size) : before.size;
}

std::optional<CornerBlend> corner_blend(const BlendedSide& before, const BlendedSide& behind) {
    const path::Blending& wish = before.blending;
    if (wish.kind == BlendKind::None || !(wish.size > 0)) return std::nullopt;
    const BlendedCorner corner(before.curve, behind.curve);
    const std::optional<double> most = corner.most_blend_distance();
    if (!most || !corner.is_corner(wish.with_tangents)) return std::nullopt;
    const double tolerance = tolerance_of(wish, behind.blending);
    const auto used = [&](double distance) { return corner.deviation(distance) / tolerance; };
    const double distance = wish.kind == BlendKind::Distance
                                ? std::min(*most, distance_of(wish, behind.blending))
                                : longest_blend_distance(used, *most);
    if (distance < kLeastBlendDistance) return std::nullopt;
    return CornerBlend{distance, corner.curve(distance)};
}

}  // namespace kadr::motion
