#include "path/complete_spline.h"

namespace kadr::path {

std::vector<Vec3> complete_slopes(std::span<const SplineNode> nodes, const Vec3& first,
                                  const Vec3& last) {
    const std::size_t end = nodes.size() - 1;
    std::vector<Vec3> slopes(nodes.size(), Vec3::Zero());
    slopes[0] = first;
    slopes[end] = last;
    // h1·m(i−1) + 2(h0 + h1)·m(i) + h0·m(i+1) = 3(h1·d0 + h0·d1); h0, d0 width and mean slope
    // before the node, h1, d1 behind it.
    std::vector<double> factor(nodes.size(), 0);
    for (std::size_t i = 1; i < end; ++i) {
        const double h0 = nodes[i].parameter - nodes[i - 1].parameter;
        const double h1 = nodes[i + 1].parameter - nodes[i].parameter;
        const Vec3 d0 = (nodes[i].position - nodes[i - 1].position) / h0;
        const Vec3 d1 = (nodes[i + 1].position - nodes[i].position) / h1;
        const double diagonal = 2 * (h0 + h1) - h1 * factor[i - 1];
        factor[i] = h0 / diagonal;
        slopes[i] = (3 * (h1 * d0 + h0 * d1) - h1 * slopes[i - 1]) / diagonal;
    }
    for (std::size_t i = end; i-- > 1;) slopes[i] -= factor[i] * slopes[i + 1];
    return slopes;
}

}  // namespace kadr::path
