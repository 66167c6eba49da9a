#include "path/approach_path.h"

#include <numbers>

#include <Eigen/Geometry>

namespace kadr::path {

Element approach_path_from(const Vec2& point, const Vec2& direction, const ApproachPath& approach) {
    if (approach.shape == ApproachShape::Line)
        return line_element(point, point + direction * approach.size);
    const double side = approach.is_left ? 1 : -1;
    const double angle =
        side * (approach.shape == ApproachShape::Half ? std::numbers::pi : std::numbers::pi / 2);
    const Vec2 center = point + Vec2(-direction.y(), direction.x()) * side * approach.size;
    const Vec2 end = center + Eigen::Rotation2D(angle) * (point - center);
    return {point, end, center, angle};
}

/// Travelled back it is the path from the point, whose other side is then the left one.
Element approach_path_to(const Vec2& point, const Vec2& direction, const ApproachPath& approach) {
    return reversed(
        approach_path_from(point, -direction, {approach.shape, approach.size, !approach.is_left}));
}

}  // namespace kadr::path
