#include "path/glide.h"

#include <algorithm>

#include "path/casteljau.h"
#include "path/helix.h"
#include "path/quadrature.h"

namespace kadr::path {

Vec3 position(const Glide& glide, double s) {
    if (s <= 0) return glide.cubic[0];
    if (s >= glide.length) return glide.cubic[3];
    return Casteljau<Vec3>(glide.cubic, s / glide.length).at();
}

CurvePoint evaluate(const Glide& glide, double s) {
    const double u = std::clamp(s / glide.length, 0.0, 1.0);
    const Casteljau<Vec3> scheme(glide.cubic, u);
    return {position(glide, s), scheme.derivative() / glide.length,
            scheme.second_derivative() / (glide.length * glide.length)};
}

Vec3 third_derivative(const Glide& glide) {
    const Cubic& c = glide.cubic;
    return 6 * (c[3] - 3 * (c[2] - c[1]) - c[0]) / (glide.length * glide.length * glide.length);
}

Glide part(const Glide& glide, double from, double to) {
    const double first = std::clamp(from / glide.length, 0.0, 1.0);
    const double last = std::clamp(to / glide.length, first, 1.0);
    const Cubic behind = first > 0 ? split(glide.cubic, first).second : glide.cubic;
    const double share = first < 1 ? (last - first) / (1 - first) : 1;
    const Cubic piece = last < 1 ? split(behind, share).first : behind;
    return {piece, to - from};
}

Box bounds(const Glide& glide) {
    Box box{glide.cubic[0], glide.cubic[0]};
    for (const Vec3& point : glide.cubic) {
        box.lower = box.lower.cwiseMin(point);
        box.upper = box.upper.cwiseMax(point);
    }
    return box;
}

double arc_length(const Glide& glide) {
    const auto rate = [&](double s) { return evaluate(glide, s).tangent.norm(); };
    return integrate(rate, 0, glide.length, kArcLengthTolerance).value;
}

}  // namespace kadr::path
