#include "path/steady.h"

namespace kadr::path {

std::optional<Cubic> steady_cubic(const Vec3& start, const Vec3& end, const SplineShape& shape) {
    if (shape.degree > 3) return std::nullopt;
    for (int i = 1; i <= shape.degree; ++i)
        if (shape.weights[static_cast<std::size_t>(i)] != shape.weights[0]) return std::nullopt;
    const Cubic cubic =
        raised_to_cubic<Vec3>(shape.degree, start, {shape.inner[0], shape.inner[1]}, end);
    if (!is_steady(cubic)) return std::nullopt;
    return cubic;
}

}  // namespace kadr::path
