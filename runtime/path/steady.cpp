#include "path/steady.h"

namespace kadr::path {

namespace {

template <std::size_t N>
std::optional<SteadySpan> if_steady(const std::array<Vec3, N>& points) {
    if (!is_steady(points)) return std::nullopt;
    return points;
}

Quintic raised_to_quintic(const Vec3& start, const Vec3& end, const SplineShape& shape) {
    const auto degree = static_cast<std::size_t>(shape.degree);
    Quintic points;
    points[0] = start;
    for (std::size_t i = 1; i < degree; ++i) points[i] = shape.inner[i - 1];
    points[degree] = end;
    raise_degree(points, degree);
    return points;
}

}  // namespace

std::optional<SteadySpan> steady_span(const Vec3& start, const Vec3& end,
                                      const SplineShape& shape) {
    for (int i = 1; i <= shape.degree; ++i)
        if (shape.weights[static_cast<std::size_t>(i)] != shape.weights[0]) return std::nullopt;
    if (shape.degree > 3) return if_steady(raised_to_quintic(start, end, shape));
    return if_steady(
        raised_to_cubic<Vec3>(shape.degree, start, {shape.inner[0], shape.inner[1]}, end));
}

}  // namespace kadr::path
