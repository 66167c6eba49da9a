// approach_path.h — the paths on which a smooth approach meets a contour, and a retraction leaves
// it: lines and arcs that have the contour's direction where they touch it.
#pragma once

#include <cstdint>

#include "path/contour.h"

namespace kadr::path {

enum class ApproachShape : std::uint8_t { Line, Quarter, Half };  // of a circle

struct ApproachPath {
    ApproachShape shape = ApproachShape::Line;
    double size = 0;      // mm: length of the line, radius of the arc, > 0
    bool is_left = true;  // of the arc: the side of the contour, seen in its direction
};

/// The path that ends at a point in a direction, a unit vector.
Element approach_path_to(const Vec2& point, const Vec2& direction, const ApproachPath& approach);
/// The path that begins there.
Element approach_path_from(const Vec2& point, const Vec2& direction, const ApproachPath& approach);

}  // namespace kadr::path
