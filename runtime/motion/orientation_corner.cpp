#include "motion/orientation_corner.h"

#include <algorithm>
#include <cmath>

#include "machine/orientation.h"

namespace kadr::motion {

namespace {

using machine::Chain;
using path::CurvePoint;
using path::Vec3;

/// Between two nodes of a path no rotary axis turns farther, rad.
constexpr double kNodeTurn = 0.2;
/// A swing of R1 near the pole may be cut as finely as this, in parts of the path.
constexpr double kFinest = 1e-9;

/// The derivatives of the rotary axes come from points so far apart, in parts of the path to the
/// next end of the motion.
constexpr double kStencil = 1.0 / 64;
/// Speeds of the rotary axes that differ by less, rad/mm, go on.
constexpr double kSameRate = 1e-7;

/// Samples of each of the four pieces for how far the tool is from its programmed direction.
constexpr int kSamples = 4;

double most_turn(const LogicalAxes& a, const LogicalAxes& b) {
    double most = 0;
    for (std::size_t i = 3; i < kAxes; ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

}  // namespace

// ------------------------------------------------------------------------------ the path

OrientationPath::OrientationPath(const Chain& chain, const Segment& whole)
    : chain_(&chain), whole_(&whole) {
    const double length = whole.orientation.length;
    nodes_.push_back({0, axes_near(chain, whole, 0, start_of(whole))});
    double step = length / 8;
    while (nodes_.back().distance < length) {
        const Node& last = nodes_.back();
        const double left = length - last.distance;
        const double next = left < step * (1 + kFinest) ? length : last.distance + step;
        const LogicalAxes there = axes_near(chain, whole, next, last.axes);
        if (most_turn(there, last.axes) > kNodeTurn && step > kFinest * length) {
            step /= 2;
            continue;
        }
        nodes_.push_back({next, there});
        step = std::min(2 * step, length / 8);
    }
}

LogicalAxes OrientationPath::axes(double distance) const {
    auto next = std::ranges::upper_bound(nodes_, distance, {}, &Node::distance);
    if (next != nodes_.begin()) --next;
    return axes_near(*chain_, *whole_, distance, next->axes);
}

Vec3 OrientationPath::joints_at(double distance) const {
    const LogicalAxes there = axes(distance);
    std::array<double, kFollowers> followers{};
    std::copy(there.begin() + 3, there.end(), followers.begin());
    return joints_of(*chain_, followers);
}

/// Central differences of the fourth order.
CurvePoint OrientationPath::joints(double distance) const {
    const double h = kStencil * std::min(distance, whole_->orientation.length - distance);
    const Vec3 here = joints_at(distance);
    const Vec3 far_before = joints_at(distance - 2 * h);
    const Vec3 before = joints_at(distance - h);
    const Vec3 behind = joints_at(distance + h);
    const Vec3 far_behind = joints_at(distance + 2 * h);
    const Vec3 rate = (far_before - far_behind + 8 * (behind - before)) / (12 * h);
    const Vec3 bend = (16 * (before + behind) - far_before - far_behind - 30 * here) / (12 * h * h);
    return {here, rate, bend};
}

Vec3 OrientationPath::tool(double distance) const {
    return machine::tool_vector(*chain_, joints_at(distance));
}

Segment OrientationPath::part(double from, double to) const {
    Segment piece = part_of(*whole_, from, to);
    const LogicalAxes start = axes(from);
    std::copy(start.begin() + 3, start.end(), piece.follower_start.begin());
    return piece;
}

// ------------------------------------------------------------------------------ the corner

namespace {

class OrientationCorner {
  public:
    OrientationCorner(const Chain& chain, const OrientationPath& before,
                      const OrientationPath& behind)
        : chain_(chain),
          before_(before),
          behind_(behind),
          length_(before.whole().orientation.length),
          tip_(before.whole().curve, behind.whole().curve) {}

    path::Transition joints(double distance) const {
        return path::transition_between(before_.joints(length_ - distance),
                                        behind_.joints(distance), distance);
    }

    /// Whether the rotary axes go on with the speed that they have, on `distance` beside the
    /// corner.
    bool turns_evenly(double distance) const {
        const double beside = distance / 16;
        const CurvePoint in = before_.joints(length_ - beside);
        const CurvePoint out = behind_.joints(beside);
        const Vec3 at_corner = in.tangent + beside * in.curvature;
        return (at_corner - (out.tangent - beside * out.curvature)).norm() < kSameRate;
    }

    /// How far the tool is from the direction that it has on the programmed path, rad.
    double leant(double distance) const {
        const path::Transition curve = joints(distance);
        double most = 0;
        double from = 0;
        for (const path::Glide& glide : curve) {
            for (int k = 1; k <= kSamples; ++k) {
                const double s = glide.length * k / kSamples;
                const double along = from + s;
                const Vec3 programmed =
                    along < distance ? before_.tool(length_ - distance + along)
                                     : behind_.tool(std::min(along - distance, 2 * distance));
                const Vec3 tool = machine::tool_vector(chain_, path::position(glide, s));
                most = std::max(most, path::angle_between(programmed, tool));
            }
            from += glide.length;
        }
        return most;
    }

    /// tip  around the corner as well; nothing: along its path
    OrientationBlend pieces(double distance, const std::optional<path::Transition>& tip) const {
        const path::Transition turn = joints(distance);
        OrientationBlend found;
        found.distance = distance;
        const std::array<Segment, 2> sides = {before_.part(length_ - distance, length_),
                                              behind_.part(0, distance)};
        std::array<double, 2> from{};
        for (std::size_t i = 0; i < found.pieces.size(); ++i) {
            const std::size_t side = i / 2;
            Segment& piece = found.pieces[i];
            piece = part_of(sides[side], from[side], from[side] + turn[i].length);
            from[side] += turn[i].length;
            if (tip) piece.curve = (*tip)[i];
            piece.orientation = {};
            piece.orientation.kind = path::OrientKind::Joints;
            piece.orientation.length = turn[i].length;
            piece.orientation.joints = turn[i];
            put_joints(chain_, path::start(turn[i]), piece.follower_start);
            for (const machine::RotaryJoint& joint : chain_.joints)
                if (joint.is_present) piece.follower_rate[index(joint.axis) - 3] = 0;
        }
        return found;
    }

    const BlendedCorner& tip() const { return tip_; }

  private:
    const Chain& chain_;
    const OrientationPath& before_;
    const OrientationPath& behind_;
    double length_;
    BlendedCorner tip_;
};

}  // namespace

std::optional<OrientationBlend> orientation_blend(const Chain& chain, const OrientationPath& before,
                                                  const path::Blending& wish,
                                                  const OrientationPath& behind,
                                                  const path::Blending& wish_behind) {
    const OrientationCorner corner(chain, before, behind);
    const std::optional<double> most = corner.tip().most_blend_distance();
    if (!most) return std::nullopt;
    if (!corner.tip().is_corner(wish.with_tangents) && corner.turns_evenly(*most))
        return std::nullopt;
    const bool by_distance = wish.kind == path::BlendKind::Distance;
    const double tolerance = tolerance_of(wish, wish_behind);
    const double distance =
        by_distance ? std::min(*most, distance_of(wish, wish_behind))
                    : longest_blend_distance(
                          [&](double candidate) {
                              const double used = corner.tip().deviation(candidate) / tolerance;
                              if (std::isinf(wish.orientation)) return used;
                              return std::max(used, corner.leant(candidate) / wish.orientation);
                          },
                          *most);
    if (distance < kLeastBlendDistance) return std::nullopt;
    return corner.pieces(distance, corner.tip().curve(distance));
}

std::optional<OrientationBlend> smoothed_orientation(const Chain& chain,
                                                     const OrientationPath& before,
                                                     const OrientationPath& behind,
                                                     double tolerance) {
    const OrientationCorner corner(chain, before, behind);
    const double most =
        std::min(before.whole().orientation.length, behind.whole().orientation.length) / 2;
    if (corner.turns_evenly(most)) return std::nullopt;
    const auto used = [&](double distance) { return corner.leant(distance) / tolerance; };
    const double distance = longest_blend_distance(used, most);
    if (distance < kLeastBlendDistance) return std::nullopt;
    return corner.pieces(distance, std::nullopt);
}

}  // namespace kadr::motion
