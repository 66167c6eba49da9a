// Lines as few cubics: which lines stay, where the parts meet, and what is given at the start.
#include "path/polyline_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "path/complete_spline.h"
#include "path/polyline_deviation.h"

namespace kadr::path::polyline_fit_test {
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

/// Of samples of the cubic from the lines, and of the points from the samples.
double sampled_deviation(const Cubic& cubic, std::span<const Vec3> points) {
    const auto distance = [](const Vec3& at, std::span<const Vec3> lines) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; i < lines.size(); ++i)
            least = std::min(least, distance_to_line(at, lines[i - 1], lines[i]));
        return least;
    };
    std::vector<Vec3> samples;
    const int count = 40 * static_cast<int>(points.size());
    for (int i = 0; i <= count; ++i)
        samples.push_back(evaluate(cubic, static_cast<double>(i) / count).position);
    double most = 0;
    for (const Vec3& sample : samples) most = std::max(most, distance(sample, points));
    for (const Vec3& point : points) most = std::max(most, distance(point, samples));
    return most;
}

// Chains whose ends lie off a smooth curve by 0.3 to 3 tolerances, smooth ones whose chord error is
// so much, and zigzags: whatever comes out is within the tolerance, and there are few curves where
// there can be.
TEST(PolylineFit, ThousandsOfChainsKeepToTheTolerance) {
    std::mt19937_64 engine(7);
    const auto between = [&](double from, double to) {
        return from + (to - from) * static_cast<double>(engine() >> 11) * 0x1p-53;
    };
    constexpr double kTolerance = 0.01;
    for (int chain = 0; chain < 3000; ++chain) {
        const double error = kTolerance * std::exp(between(std::log(0.3), std::log(3)));
        const double radius = between(2, 30);
        const bool is_noisy = chain % 3 == 0;
        const bool is_zigzag = chain % 30 == 1;
        const double step = std::sqrt(8 * radius * error) / (is_noisy ? 4 : 1);
        std::vector<Vec3> points;
        const auto count = static_cast<int>(between(2, 60));
        double turn = 0;
        Vec3 at = Vec3::Zero();
        for (int i = 0; i <= count; ++i) {
            const Vec3 off = is_noisy    ? Vec3(between(-1, 1), between(-1, 1), 0) * error / 2
                             : is_zigzag ? Vec3(0, (i % 2 == 0 ? 0.5 : -0.5) * error, 0)
                                         : Vec3(Vec3::Zero());
            points.emplace_back(at + off);
            turn += step / radius * (1 + 0.5 * std::sin(0.2 * i));
            at += step * Vec3(std::cos(turn), std::sin(turn), 0.1);
        }
        SCOPED_TRACE(chain);
        const auto parts = fit_polyline(points, within(kTolerance));
        expect_chain(parts, points);
        for (const PolylinePart& part : parts) {
            const auto lines = std::span(points).subspan(part.from, part.to - part.from + 1);
            const double off = sampled_deviation(part.cubic, lines);
            ASSERT_LE(off, part.apart + 1e-4 * step);
            ASSERT_LE(part.apart, kTolerance);
        }
        if (!is_noisy && !is_zigzag && error < 0.5 * kTolerance) {
            EXPECT_LE(parts.size(), 12u + points.size() / 4);
        }
    }
}

TEST(PolylineDeviation, IsThatOfBothDirections) {
    const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const Vec3 delta(0, 1, 0);
    // Straight from the first to the last point: it is within 1 mm of the lines, they are 1 mm
    // from it.
    const Cubic chord = hermite(square.front(), delta, square.back(), delta);
    EXPECT_FALSE(deviation_from_lines(chord, square, 0.9).has_value());
    // On the lines, but forth and back: no point is off, and the corner is not passed.
    const std::vector<Vec3> back = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}};
    const Vec3 along(1, 0, 0);
    EXPECT_FALSE(deviation_from_lines(hermite(back[0], along, back[2], along), back, 0.5));
    // A bow over two lines of its height 0.1, which lie in it by a half of that.
    const std::vector<Vec3> bow = {{-1, 0, 0}, {0, 0.1, 0}, {1, 0, 0}};
    const Cubic arch = {bow[0], Vec3(-1.0 / 3, 0.4 / 3, 0), Vec3(1.0 / 3, 0.4 / 3, 0), bow[2]};
    const auto off = deviation_from_lines(arch, bow, 0.1);
    ASSERT_TRUE(off.has_value());
    EXPECT_GE(*off, sampled_deviation(arch, bow));
    EXPECT_LE(*off, 2 * sampled_deviation(arch, bow));
    // Longer than the lines by 3 %: in waves.
    const Cubic wave = {Vec3(0, 0, 0), Vec3(1.0 / 3, 0.3, 0), Vec3(2.0 / 3, -0.3, 0),
                        Vec3(1, 0, 0)};
    EXPECT_FALSE(deviation_from_lines(wave, std::vector<Vec3>{wave[0], wave[3]}, 1));
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
}  // namespace kadr::path::polyline_fit_test
