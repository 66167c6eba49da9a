// steady.h — polynomial spans that go on towards their end everywhere, known by control points.
//
// What most spans are whose points lie close. Nothing of such a span comes back beside another part
// of it, and nowhere does it nearly stand; who knows that need not look for it.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <variant>

#include "path/cubic.h"
#include "path/spline.h"

namespace kadr::path {

/// A span whose speed falls below this part of the mean nearly stands there, as in a cusp.
inline constexpr double kNearlyStands = 0.1;

/// Whether the speed of a polynomial is nowhere below kNearlyStands of the mean, by a proof: its
/// derivative is in the hull of the differences of the control points, so along the chord none is
/// less than the least of them, and none is greater than the greatest. False may be either.
template <std::size_t N>
bool is_steady(const std::array<Vec3, N>& points) {
    constexpr double kRounding = 1 + 1e-9;
    const Vec3 chord = points[N - 1] - points[0];
    double least = std::numeric_limits<double>::infinity();  // times the chord
    double greatest_square = 0;
    for (std::size_t i = 0; i + 1 < N; ++i) {
        const Vec3 delta = points[i + 1] - points[i];
        least = std::min(least, delta.dot(chord));
        greatest_square = std::max(greatest_square, delta.squaredNorm());
    }
    constexpr double kShare = kRounding * kNearlyStands;
    return least > 0 && least * least >= kShare * kShare * greatest_square * chord.squaredNorm();
}

/// The control points of degree three of a span of degree one to three.
///
/// first, last  at the ends
/// inner        degree − 1 of them hold
template <typename Point>
std::array<Point, 4> raised_to_cubic(int degree, const Point& first,
                                     const std::array<Point, 2>& inner, const Point& last) {
    switch (degree) {
        case 1: return {first, (2 * first + last) / 3, (first + 2 * last) / 3, last};
        case 2: return {first, (first + 2 * inner[0]) / 3, (2 * inner[0] + last) / 3, last};
        default: return {first, inner[0], inner[1], last};
    }
}

/// Control points of a span that has a degree less, raised to one more: every one between its
/// neighbours of before.
///
/// points  the first degree + 1 of them hold
template <typename Point, std::size_t N>
void raise_degree(std::array<Point, N>& points, std::size_t degree) {
    for (std::size_t d = degree; d + 1 < N; ++d) {
        points[d + 1] = points[d];
        for (std::size_t i = d; i > 0; --i) {
            const double share = static_cast<double>(i) / static_cast<double>(d + 1);
            points[i] = share * points[i - 1] + (1 - share) * points[i];
        }
    }
}

/// Control points of a polynomial of degree five, mm.
using Quintic = std::array<Vec3, 6>;
using SteadySpan = std::variant<Cubic, Quintic>;

/// The span from start to end, if it is a steady polynomial: a cubic up to degree three.
std::optional<SteadySpan> steady_span(const Vec3& start, const Vec3& end, const SplineShape& shape);

}  // namespace kadr::path
