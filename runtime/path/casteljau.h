// casteljau.h — de Casteljau's scheme for a curve in Bernstein form, of points in space as of
// homogeneous ones.
#pragma once

#include <array>
#include <utility>

namespace kadr::path {

/// The columns of the scheme at one parameter; N control points, a cubic if nothing else is given.
template <typename Point, std::size_t N = 4>
struct Casteljau {
    using Points = std::array<Point, N>;

    Casteljau(const Points& points, double u) {
        const double v = 1 - u;
        columns[0] = points;
        for (std::size_t k = 1; k < N; ++k) {
            for (std::size_t i = 0; i + k < N; ++i)
                columns[k][i] = columns[k - 1][i] * v + columns[k - 1][i + 1] * u;
        }
    }
    const Point& at() const { return columns[N - 1][0]; }
    /// Derivatives by the parameter.
    Point derivative() const {
        constexpr double kDegree = N - 1;
        return kDegree * (columns[N - 2][1] - columns[N - 2][0]);
    }
    Point second_derivative() const {
        constexpr double kFactor = (N - 1) * (N - 2);
        const Points& third = columns[N - 3];
        return kFactor * (third[2] - 2 * third[1] + third[0]);
    }
    /// The curves before and behind the parameter.
    std::pair<Points, Points> halves() const {
        std::pair<Points, Points> halves;
        for (std::size_t k = 0; k < N; ++k) {
            halves.first[k] = columns[k][0];
            halves.second[N - 1 - k] = columns[k][N - 1 - k];
        }
        return halves;
    }

    std::array<Points, N> columns;  // of column k the first N − k hold
};

}  // namespace kadr::path
