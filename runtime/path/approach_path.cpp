#include "path/approach_path.h"

#include <numbers>

#include <Eigen/Geometry>

namespace kadr::path {

Element way_from(const Vec2& place, const Vec2& direction, const ApproachPath& way) {
    if (way.shape == ApproachShape::Line) return line_element(place, place + direction * way.size);
    const double side = way.is_left ? 1 : -1;
    const double angle =
        side * (way.shape == ApproachShape::Half ? std::numbers::pi : std::numbers::pi / 2);
    const Vec2 center = place + Vec2(-direction.y(), direction.x()) * side * way.size;
    const Vec2 end = center + Eigen::Rotation2D(angle) * (place - center);
    return {place, end, center, angle};
}

/// Travelled back it is the way from the place, whose other side is then the left one.
Element way_to(const Vec2& place, const Vec2& direction, const ApproachPath& way) {
    return reversed(way_from(place, -direction, {way.shape, way.size, !way.is_left}));
}

}  // namespace kadr::path
