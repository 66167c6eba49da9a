// complete_spline.h — slopes with which cubics through points have a continuous second derivative.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "path/vec3.h"

namespace kadr::path {

/// A point that the cubics run through.
struct SplineNode {
    double parameter = 0;  // ascending
    Vec3 position = Vec3::Zero();
};

/// Slopes by the parameter at every node, with those at both ends given.
///
/// nodes        two or more, no two with one parameter
/// first, last  an end without a slope has no second derivative (natural)
/// source       complete cubic splines: C. de Boor, A Practical Guide to Splines, ch. IV; motion
///              reference §1.4, solved for slopes by Thomas' algorithm
std::vector<Vec3> complete_slopes(std::span<const SplineNode> nodes,
                                  const std::optional<Vec3>& first,
                                  const std::optional<Vec3>& last);

}  // namespace kadr::path
