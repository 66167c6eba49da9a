#include "path/polyline_deviation.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace kadr::path {

namespace {

/// How often the cubic beside a line may be halved for a closer bound. The inner control points of
/// a bow lie a third higher than the bow; halved once, by a twelfth of it.
constexpr int kHalvings = 6;
/// Steps of Newton's method to the point beside the end of a line; the parameter is even along the
/// lines, so the first guess is close.
constexpr int kSteps = 2;
constexpr double kLonger = 1.01;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct StraightLine {
    const Vec3& from;
    const Vec3& to;
};

/// Bound of how far a cubic is from a line: what is within a distance of a line is convex, so the
/// control points are the farthest. Infinite if it is above `most`, or no number.
double bound(const Cubic& cubic, const StraightLine& line, double most, int halvings) {
    const auto distance = [&](const Vec3& point) {
        return distance_to_line(point, line.from, line.to);
    };
    const double ends = std::max(distance(cubic[0]), distance(cubic[3]));
    if (!(ends <= most)) return kInfinity;
    const double inner = std::max(distance(cubic[1]), distance(cubic[2]));
    if (inner <= most) return std::max(ends, inner);
    if (halvings == 0) return kInfinity;
    const auto [before, behind] = split(cubic, 0.5);
    const double first = bound(before, line, most, halvings - 1);
    if (first == kInfinity) return kInfinity;
    return std::max(first, bound(behind, line, most, halvings - 1));
}

/// Where a cubic is beside a point, near a parameter.
double beside(const Cubic& cubic, const Vec3& point, double parameter) {
    for (int step = 0; step < kSteps; ++step) {
        const auto [position, derivative] = evaluate(cubic, parameter);
        parameter += (point - position).dot(derivative) / derivative.squaredNorm();
        if (!(parameter > 0)) return 0;
        if (parameter > 1) return 1;
    }
    return parameter;
}

/// Length of a cubic that bends little: the mean of chord and polygon, to the fourth order.
double length_of(const Cubic& cubic) {
    double polygon = 0;
    for (std::size_t i = 1; i < 4; ++i) polygon += (cubic[i] - cubic[i - 1]).norm();
    return ((cubic[3] - cubic[0]).norm() + polygon) / 2;
}

}  // namespace

std::optional<double> deviation_from_lines(const Cubic& cubic, std::span<const Vec3> points,
                                           double most) {
    double whole = 0;
    for (std::size_t i = 1; i < points.size(); ++i) whole += (points[i] - points[i - 1]).norm();
    double apart = 0;
    double along = 0;   // the lines
    double length = 0;  // of the cubic so far
    double parameter = 0;
    Cubic rest = cubic;  // from there on
    for (std::size_t i = 1; i < points.size(); ++i) {
        along += (points[i] - points[i - 1]).norm();
        Cubic piece = rest;
        if (i + 1 < points.size()) {
            const double next = std::max(parameter, beside(cubic, points[i], along / whole));
            const double share = parameter < 1 ? (next - parameter) / (1 - parameter) : 1;
            std::tie(piece, rest) = split(rest, share);
            parameter = next;
        }
        const double off = std::max((piece[3] - points[i]).norm(),
                                    bound(piece, {points[i - 1], points[i]}, most, kHalvings));
        if (!(off <= most)) return std::nullopt;
        apart = std::max(apart, off);
        length += length_of(piece);
    }
    if (!(length <= kLonger * whole)) return std::nullopt;
    return apart;
}

}  // namespace kadr::path
