#include "path/cubic.h"

#include <algorithm>
#include <cmath>

#include "path/casteljau.h"

namespace kadr::path {

Cubic hermite(const Vec3& from, const Vec3& slope_from, const Vec3& to, const Vec3& slope_to) {
    return {from, from + slope_from / 3, to - slope_to / 3, to};
}

CubicPoint evaluate(const Cubic& cubic, double u) {
    const Casteljau<Vec3> scheme(cubic, u);
    return {scheme.at(), scheme.derivative()};
}

std::pair<Cubic, Cubic> split(const Cubic& cubic, double u) {
    return Casteljau<Vec3>(cubic, u).halves();
}

double interpolation_error(double u, const Vec3& miss, const Vec3& slope_miss) {
    const double v = 1 - u;
    const double shape = u * u * v * v;
    const double shape_slope = 2 * u * v * (v - u);
    const Vec3 level = miss / shape;
    const Vec3 slope = (slope_miss - level * shape_slope) / shape;
    // u²(1 − u)² is at most 1/16, and |u − u0| at most the longer side.
    return (level.norm() + slope.norm() * std::max(u, v)) / 16;
}

DistanceBounds distance_range(const Cubic& cubic, const Vec3& center) {
    // The square of the distance is a polynomial of degree six; the products of the control points
    // give its Bernstein coefficients, weighted C(3,i)·C(3,j)/C(6,i+j).
    static constexpr double kOfThree[4] = {1, 3, 3, 1};
    static constexpr double kOfSix[7] = {1, 6, 15, 20, 15, 6, 1};
    double coefficient[7] = {};
    std::array<Eigen::Vector2d, 4> way;
    for (std::size_t i = 0; i < 4; ++i) way[i] = (cubic[i] - center).head<2>();
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j)
            coefficient[i + j] += kOfThree[i] * kOfThree[j] * way[i].dot(way[j]);
    }
    double lower = coefficient[0];
    double upper = coefficient[0];
    for (std::size_t k = 1; k < 7; ++k) {
        const double value = coefficient[k] / kOfSix[k];
        if (!(value >= lower)) lower = value;  // also what is not a number
        if (!(value <= upper)) upper = value;
    }
    return {std::sqrt(std::max(lower, 0.0)), std::sqrt(upper)};
}

double distance_to_line(const Vec3& point, const Vec3& from, const Vec3& to) {
    const Vec3 chord = to - from;
    const double square = chord.squaredNorm();
    const double share = square > 0 ? std::clamp((point - from).dot(chord) / square, 0.0, 1.0) : 0;
    return (point - from - chord * share).norm();
}

}  // namespace kadr::path
