// casteljau.h — de Casteljau's scheme for a cubic in Bernstein form, of points in space as of
// homogeneous ones.
#pragma once

#include <array>
#include <utility>

namespace kadr::path {

/// The columns of the scheme at one parameter.
template <typename Point>
struct Casteljau {
    using Points = std::array<Point, 4>;

    Casteljau(const Points& points, double u) : p(points) {
        const double v = 1 - u;
        for (std::size_t i = 0; i < 3; ++i) first[i] = p[i] * v + p[i + 1] * u;
        for (std::size_t i = 0; i < 2; ++i) second[i] = first[i] * v + first[i + 1] * u;
        at = second[0] * v + second[1] * u;
    }
    /// Derivatives by the parameter.
    Point derivative() const { return 3 * (second[1] - second[0]); }
    Point second_derivative() const { return 6 * (first[2] - 2 * first[1] + first[0]); }
    /// The cubics before and behind the parameter.
    std::pair<Points, Points> halves() const {
        return {{p[0], first[0], second[0], at}, {at, second[1], first[2], p[3]}};
    }

    Points p;
    std::array<Point, 3> first;
    std::array<Point, 2> second;
    Point at;
};

}  // namespace kadr::path
