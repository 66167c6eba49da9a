#include "path/complete_spline.h"

namespace kadr::path {

namespace {

Vec3 mean_slope(const SplineNode& from, const SplineNode& to) {
    return (to.position - from.position) / (to.parameter - from.parameter);
}

}  // namespace

std::vector<Vec3> complete_slopes(std::span<const SplineNode> nodes,
                                  const std::optional<Vec3>& first,
                                  const std::optional<Vec3>& last) {
    const std::size_t end = nodes.size() - 1;
    std::vector<Vec3> slopes(nodes.size(), Vec3::Zero());
    // h1·m(i−1) + 2(h0 + h1)·m(i) + h0·m(i+1) = 3(h1·d0 + h0·d1); h0, d0 width and mean slope
    // before the node, h1, d1 behind it.
    std::vector<double> factor(nodes.size(), 0);
    // Without a second derivative: 2·m(0) + m(1) = 3·d0, and the same at the end.
    slopes[0] = first ? *first : Vec3(1.5 * mean_slope(nodes[0], nodes[1]));
    if (!first) factor[0] = 0.5;
    for (std::size_t i = 1; i < end; ++i) {
        const double h0 = nodes[i].parameter - nodes[i - 1].parameter;
        const double h1 = nodes[i + 1].parameter - nodes[i].parameter;
        const Vec3 d0 = mean_slope(nodes[i - 1], nodes[i]);
        const Vec3 d1 = mean_slope(nodes[i], nodes[i + 1]);
        const double diagonal = 2 * (h0 + h1) - h1 * factor[i - 1];
        factor[i] = h0 / diagonal;
        slopes[i] = (3 * (h1 * d0 + h0 * d1) - h1 * slopes[i - 1]) / diagonal;
    }
    slopes[end] = last ? *last
                       : Vec3((3 * mean_slope(nodes[end - 1], nodes[end]) - slopes[end - 1]) /
                              (2 - factor[end - 1]));
    for (std::size_t i = end; i-- > 0;) slopes[i] -= factor[i] * slopes[i + 1];
    return slopes;
}

}  // namespace kadr::path
