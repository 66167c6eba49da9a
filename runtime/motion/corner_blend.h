// corner_blend.h — the curve that takes the place of a corner between two motions.
//
// Geometry: how much of both motions it takes, so that it keeps the distance or the tolerance that
// the program gives. Whether the corner is passed faster with it is prepare_blending.cpp's
// question.
#pragma once

#include <functional>
#include <optional>

#include "path/command.h"
#include "path/curve.h"
#include "path/transition.h"

namespace kadr::motion {

/// Less of a distance, mm, is a corner.
inline constexpr double kLeastBlendDistance = 1e-3;

/// A motion beside the corner: its whole path, and what the program asks for behind it.
struct BlendedSide {
    const path::Curve& curve;
    path::Blending blending;
};

struct CornerBlend {
    double distance = 0;     // mm of the path on either side of the corner
    path::Transition curve;  // two pieces before the middle, two behind it
};

/// Where two curves meet, and what a curve around that point would be like.
class BlendedCorner {
  public:
    /// before, behind  have to live as long
    BlendedCorner(const path::Curve& before, const path::Curve& behind);

    /// Whether the direction jumps, or, if that counts, the curvature.
    bool is_corner(bool with_curvature) const;
    /// So far the curve may begin before the corner, mm: half of each side; nothing if the path
    /// turns back.
    std::optional<double> most_blend_distance() const;
    path::Transition curve(double distance) const;
    /// How far it leaves the path, mm.
    double deviation(double distance) const;

  private:
    const path::Curve& before_;
    const path::Curve& behind_;
    double length_;
    path::CurvePoint in_;
    path::CurvePoint out_;
};

/// The longest distance up to `most` of which no more than all of a tolerance is used, or nearly
/// the longest; 0 if there is none.
///
/// used  part of the tolerance that a distance takes, known to a fiftieth
double longest_blend_distance(const std::function<double(double)>& used, double most);

/// How far from a corner its curve begins by a blending that gives a distance.
double distance_of(const path::Blending& before, const path::Blending& behind);

/// How far a curve may leave the path of either motion by a blending that gives a tolerance.
double tolerance_of(const path::Blending& before, const path::Blending& behind);

/// The curve around the corner between two motions.
///
/// Each gives half of its length at most, so that the corner at its other end has the other half,
/// and both give the same. A distance is that of the motion before the corner and, where the one
/// behind it has a distance of its own, as at rapid, also that one; and so is a tolerance, for the
/// curve leaves the path of both.
///
/// returns   nothing if there is no corner, if it turns back, or if no distance is left
/// source    reference motion §2.4, rule 4; sinumerik §3.3 (G641, G642, G645)
std::optional<CornerBlend> corner_blend(const BlendedSide& before, const BlendedSide& behind);

}  // namespace kadr::motion
