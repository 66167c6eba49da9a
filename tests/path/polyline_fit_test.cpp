// Lines as few cubics: which lines stay, where the parts meet, and what is given at the start.
#include "path/polyline_fit.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "path/complete_spline.h"

namespace kadr::path {
namespace {

PolylineFitOptions within(double tolerance) {
    PolylineFitOptions options;
    options.tolerance = tolerance;
    return options;
}

std::vector<Vec3> arc(int count) {
    std::vector<Vec3> points;
    for (int i = 0; i <= count; ++i) {
        const double angle = std::numbers::pi / 2 * i / count;
        points.emplace_back(10 * std::sin(angle), 10 - 10 * std::cos(angle), 0);
    }
    return points;
}

/// The parts lead from point to point, each from where the one before ended.
void expect_chain(const std::vector<PolylinePart>& parts, const std::vector<Vec3>& points) {
    std::size_t at = 0;
    for (const PolylinePart& part : parts) {
        EXPECT_EQ(part.from, at);
        EXPECT_GT(part.to, part.from);
        EXPECT_EQ(part.cubic[0], points[part.from]);
        EXPECT_EQ(part.cubic[3], points[part.to]);
        at = part.to;
    }
    EXPECT_EQ(at, points.size() - 1);
}

TEST(PolylineFit, AnArcIsAFewCubics) {
    const auto points = arc(200);
    for (const auto& [tolerance, most] :
         {std::pair(0.1, 4u), std::pair(0.01, 4u), std::pair(1e-4, 16u)}) {
        const auto parts = fit_polyline(points, within(tolerance));
        expect_chain(parts, points);
        EXPECT_LE(parts.size(), most);
        for (const PolylinePart& part : parts) EXPECT_FALSE(part.is_line);
        // One direction and one second derivative by the length of the polyline.
        const double step = (points[1] - points[0]).norm();
        for (std::size_t i = 1; i < parts.size(); ++i) {
            const Cubic& a = parts[i - 1].cubic;
            const Cubic& b = parts[i].cubic;
            const double h0 = step * static_cast<double>(parts[i - 1].to - parts[i - 1].from);
            const double h1 = step * static_cast<double>(parts[i].to - parts[i].from);
            EXPECT_LE(((a[3] - a[2]) / h0 - (b[1] - b[0]) / h1).norm(), 1e-9);
            EXPECT_LE(((a[3] - 2 * a[2] + a[1]) / (h0 * h0) - (b[2] - 2 * b[1] + b[0]) / (h1 * h1))
                          .norm(),
                      1e-9);
        }
    }
}

TEST(PolylineFit, AKinkStays) {
    auto points = arc(50);
    const Vec3 end = points.back();
    for (int i = 1; i <= 50; ++i) points.push_back(end + 0.2 * i * Vec3(0.4, 0.9, 0));
    const auto parts = fit_polyline(points, within(0.001));
    expect_chain(parts, points);
    bool has_joint = false;
    for (const PolylinePart& part : parts) has_joint |= part.to == 50;
    EXPECT_TRUE(has_joint);
    EXPECT_LT(parts.size(), 60u);
}

TEST(PolylineFit, WithinLittleEveryLineStays) {
    const std::vector<Vec3> zigzag = {{0, 0, 0}, {1, 0.1, 0}, {2, 0, 0}, {3, 0.1, 0}, {4, 0, 0}};
    const auto parts = fit_polyline(zigzag, within(1e-4));
    expect_chain(parts, zigzag);
    EXPECT_EQ(parts.size(), 4u);
    for (const PolylinePart& part : parts) EXPECT_TRUE(part.is_line);
}

TEST(PolylineFit, BeginsWithTheGivenSlopeAndEndsWhereItMust) {
    const auto points = arc(100);
    const std::size_t ends[] = {30, 70};
    const Vec3 slope = Vec3(1, -0.001, 0).normalized();
    const auto parts =
        fit_polyline(points, {.tolerance = 0.01, .first_slope = slope, .ends = ends});
    expect_chain(parts, points);
    EXPECT_LE(((parts[0].cubic[1] - parts[0].cubic[0]).normalized() - slope).norm(), 1e-9);
    for (const std::size_t end : ends) {
        bool is_end = false;
        for (const PolylinePart& part : parts) is_end |= part.to == end;
        EXPECT_TRUE(is_end) << end;
    }
}

TEST(CompleteSpline, ReproducesACubic) {
    // x³ − 2x and its slopes 3x² − 2 at uneven places.
    std::vector<SplineNode> nodes;
    for (const double x : {-1.0, -0.3, 0.5, 0.7, 2.0})
        nodes.push_back({x, {x * x * x - 2 * x, x, 0}});
    const auto slope = [](double x) { return Vec3(3 * x * x - 2, 1, 0); };
    const auto slopes = complete_slopes(nodes, slope(-1), slope(2));
    for (std::size_t i = 0; i < nodes.size(); ++i)
        EXPECT_LE((slopes[i] - slope(nodes[i].parameter)).norm(), 1e-12);
}

}  // namespace
}  // namespace kadr::path
