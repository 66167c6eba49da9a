#include "motion/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kadr::motion {

namespace {

using path::BlendKind;
using path::CurvePoint;
using path::Vec3;

/// Directions that differ by less, rad, go on: no corner that any coordinate could show.
constexpr double kTangent = 1e-6;
/// Curvatures that differ by less, 1/mm, are the same: a radius of a kilometre.
constexpr double kSameCurvature = 1e-6;
/// Two and a half degrees from turning back: the curve would be a cusp.
constexpr double kTurnsBack = -0.999;
/// A motion turns by no more than this within the way that it gives, rad.
constexpr double kMostTurn = 1;
/// Less of a way, mm, is a corner.
constexpr double kLeastWay = 1e-4;

/// Part of the tolerance that is used: the deviation is known to a fiftieth.
constexpr double kUsed = 0.98;
/// A way that uses so much of it is good enough.
constexpr double kWellUsed = 0.85;
constexpr int kTries = 12;

class Corner {
  public:
    Corner(const path::Curve& before, const path::Curve& behind)
        : before_(before), behind_(behind), length_(path::length(before)) {}

    CurvePoint in() const { return path::evaluate(before_, length_); }
    CurvePoint out() const { return path::evaluate(behind_, 0); }

    path::Transition curve(double way) const {
        return path::transition_between(path::evaluate(before_, length_ - way),
                                        path::evaluate(behind_, way), way);
    }
    double deviation(double way) const {
        return path::deviation(curve(way), {before_, length_ - way, length_}, {behind_, 0, way});
    }

    /// The longest way up to `most` with which the tolerance is kept, or nearly the longest.
    double way_within(double tolerance, double most) const {
        double way = most;
        double good = 0;
        double bad = std::numeric_limits<double>::infinity();
        for (int i = 0; i < kTries; ++i) {
            const double apart = deviation(way);
            const bool is_good = apart <= kUsed * tolerance;
            (is_good ? good : bad) = way;
            if (is_good && (way == most || apart >= kWellUsed * tolerance)) break;
            // That of a corner grows with the way, that of a jump of the curvature with its square:
            // from there the mean of a way too short and one too long leads to the goal.
            const bool is_enclosed = good > 0 && std::isfinite(bad);
            const double next =
                is_enclosed ? std::sqrt(good * bad) : way * (0.99 * kUsed * tolerance / apart);
            way = std::min(next, most);
            if (way < kLeastWay) break;
        }
        return good;
    }

  private:
    const path::Curve& before_;
    const path::Curve& behind_;
    double length_;
};

double distance_behind(const RoundedSide& before, const RoundedSide& behind) {
    const bool has_own = behind.blending.kind == BlendKind::Distance;
    return has_own ? std::min(before.blending.size, behind.blending.size) : before.blending.size;
}

}  // namespace

std::optional<Rounding> rounding(const RoundedSide& before, const RoundedSide& behind) {
    const path::Blending& wish = before.blending;
    if (wish.kind == BlendKind::None || !(wish.size > 0)) return std::nullopt;
    const Corner corner(before.curve, behind.curve);
    const CurvePoint in = corner.in();
    const CurvePoint out = corner.out();
    if (in.tangent.dot(out.tangent) < kTurnsBack) return std::nullopt;
    if ((in.tangent - out.tangent).norm() < kTangent) {
        const double jump = (in.curvature - out.curvature).norm();
        if (!wish.with_tangents || jump < kSameCurvature) return std::nullopt;
    }
    double way = std::min(path::length(before.curve), path::length(behind.curve)) / 2;
    const double bend = std::max(in.curvature.norm(), out.curvature.norm());
    if (way * bend > kMostTurn) way = kMostTurn / bend;
    way = wish.kind == BlendKind::Distance ? std::min(way, distance_behind(before, behind))
                                           : corner.way_within(wish.size, way);
    if (way < kLeastWay) return std::nullopt;
    return Rounding{way, corner.curve(way)};
}

}  // namespace kadr::motion
