// transition.h — a curve around a corner of a path.
//
// Leaves the path before the corner and comes back to it behind, with the path's direction and
// curvature at both points. Geometry only: whether a corner is worth it is motion/corner_blend.h.
#pragma once

#include <array>

#include "path/curve.h"

namespace kadr::path {

/// Four pieces in order, on which first and second derivative run on. The middle of the curve is
/// between the second and the third. As long as a whole follows the path that it replaces:
/// the pieces' lengths are twice `distance`.
using Transition = std::array<Glide, 4>;

/// The transition from one point of a path to another.
///
/// Between two lines it is what two ramps of seven phases make that run at the same time, one down
/// to rest along the first line and one up along the second: with the derivatives by s, each is
/// 25/24/distance² of jerk, then 5/6/distance of acceleration for a third of the ramp.
///
/// from, to  the path `distance` before and `distance` behind the corner
/// distance  length of the path on either side, mm, > 0
/// source    clamped cubic B-spline of six control points. Those next to the ends lie on the
///           tangents, where a ramp has them; where the path is bent at the ends, the inner ones
///           follow from its curvature (derived in the .cpp)
Transition transition_between(const CurvePoint& from, const CurvePoint& to, double distance);

/// A part of a path that a transition takes the place of: a curve between two arc lengths.
struct Leg {
    const Curve& curve;
    double from = 0;
    double to = 0;
};

/// How far a transition and the path are apart, mm: the greatest distance of its points from the
/// path, or of the corner from it, whichever is more. Between the points that are looked at it may
/// be a fiftieth more.
double deviation(const Transition& transition, const Leg& before, const Leg& behind);

}  // namespace kadr::path
