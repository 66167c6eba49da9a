// Splines through points: the oracle's, their continuity, the window against all points at once.
#include "path/through_spline.h"

#include <cmath>
#include <fstream>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "path/curve.h"
#include "tests/path/oracle_arcs.h"

namespace kadr::path::through_spline_test {
namespace {

using Kind = SplineEnd::Kind;

struct Ends {
    SplineEnd start;
    SplineEnd end;
};

/// params  of the points; none: chords
std::vector<CubicSpan> curve_through(ThroughKind kind, const std::vector<Vec3>& points,
                                     const Ends& ends, const std::vector<double>& params = {},
                                     const Mat3& axes = Mat3::Identity()) {
    ThroughSpline spline(kind, ends.start, points[0], axes);
    std::vector<CubicSpan> spans;
    const auto take = [&] {
        while (const auto span = spline.next())
            spans.push_back(make_spline(span->start, span->end, span->shape));
    };
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (params.empty()) EXPECT_TRUE(spline.add_point(points[i]));
        else spline.add_point(points[i], params[i] - params[i - 1]);
        take();
    }
    spline.finish(ends.end);
    take();
    EXPECT_EQ(spans.size() + 1, points.size());
    return spans;
}

SplineEnd end_of(const test::Json& input, std::size_t which) {
    const std::string text = input.value("end", "");
    if (text == "clamped") return {Kind::Tangent, test::vec3(input["end_derivatives"][which])};
    return {text == "natural" ? Kind::Natural : Kind::Auto, Vec3::Zero()};
}

TEST(ThroughSpline, PointsOfTheOracle) {
    std::ifstream file(KADR_ROOT "/tests/oracles/curves.json");
    const test::Json oracle = test::Json::parse(file);
    int splines = 0;
    for (const test::Json& entry : oracle["cases"]) {
        if (entry["type"] != "cubic" && entry["type"] != "akima") continue;
        SCOPED_TRACE(entry["id"].get<std::string>());
        ++splines;
        const test::Json& input = entry["input"];
        std::vector<Vec3> points;
        for (const test::Json& point : input["points"]) points.push_back(test::vec3(point));
        const auto kind = entry["type"] == "cubic" ? ThroughKind::CubicSpline : ThroughKind::Akima;
        const auto params = input["params"].get<std::vector<double>>();
        const Ends ends{end_of(input, 0), end_of(input, 1)};
        const auto spans = curve_through(kind, points, ends, params);
        for (const test::Json& sample : entry["expect"]["samples"]) {
            const double u = sample["u"];
            std::size_t i = 0;
            while (i + 2 < params.size() && u >= params[i + 1]) ++i;
            const double width = params[i + 1] - params[i];
            const SplinePoint point = point_at(spans[i], (u - params[i]) / width);
            EXPECT_LT((point.position - test::vec3(sample["C"])).norm(), 1e-9);
            const Vec3 first = test::vec3(sample["C1"]);
            const Vec3 second = test::vec3(sample["C2"]);
            EXPECT_LT((point.first / width - first).norm(), 1e-9 * (1 + first.norm()));
            EXPECT_LT((point.second / (width * width) - second).norm(), 1e-8 * (1 + second.norm()));
        }
        double sum = 0;
        for (const CubicSpan& span : spans) sum += span.length;
        EXPECT_NEAR(sum, entry["expect"]["length"].get<double>(), 1e-7);
    }
    EXPECT_EQ(splines, 5);
}

/// Slopes at all points from one system of equations, without a window.
std::vector<Vec3> global_slopes(const std::vector<Vec3>& points, const Ends& ends) {
    const auto n = static_cast<Eigen::Index>(points.size()) - 1;
    std::vector<double> h;
    std::vector<Vec3> d;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        h.push_back((points[i + 1] - points[i]).norm());
        d.emplace_back((points[i + 1] - points[i]) / h.back());
    }
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(n + 1, n + 1);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n + 1, 3);
    for (Eigen::Index i = 1; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        // C'' is the same on both sides of the point.
        rows(i, i - 1) = 2 / h[k - 1];
        rows(i, i) = 4 / h[k - 1] + 4 / h[k];
        rows(i, i + 1) = 2 / h[k];
        right.row(i) = 6 * (d[k - 1] / h[k - 1] + d[k] / h[k]);
    }
    const auto end_row = [&](Eigen::Index row, const SplineEnd& end, bool is_start) {
        const Eigen::Index at = is_start ? 0 : n;
        const Eigen::Index by = is_start ? 1 : n - 1;
        const std::size_t k = is_start ? 0 : static_cast<std::size_t>(n) - 1;
        if (end.kind == Kind::Tangent) {
            rows(row, at) = 1;
            right.row(row) = end.tangent;
        } else if (end.kind == Kind::Natural) {
            rows(row, at) = 4;
            rows(row, by) = 2;
            right.row(row) = 6 * d[k];
        } else {
            // C''' = (6·m0 + 6·m1 − 12·d)/h² is the same on both sides of the point inside.
            const std::size_t j = is_start ? 1 : k - 1;
            const Eigen::Index beyond = is_start ? 2 : n - 2;
            rows(row, at) = 1 / (h[k] * h[k]);
            rows(row, by) = 1 / (h[k] * h[k]) - 1 / (h[j] * h[j]);
            rows(row, beyond) = -1 / (h[j] * h[j]);
            right.row(row) = 2 * d[k] / (h[k] * h[k]) - 2 * d[j] / (h[j] * h[j]);
        }
    };
    end_row(0, ends.start, true);
    end_row(n, ends.end, false);
    const Eigen::MatrixXd found = rows.fullPivLu().solve(right);
    std::vector<Vec3> slopes;
    for (Eigen::Index i = 0; i <= n; ++i) slopes.emplace_back(found.row(i).transpose());
    return slopes;
}

std::vector<Vec3> any_points(std::size_t least, std::size_t most) {
    const auto count = *rc::gen::inRange<std::size_t>(least, most);
    std::vector<Vec3> points = {Vec3::Zero()};
    for (std::size_t i = 1; i < count; ++i) {
        // Chords from hundredths to tens of millimetres, in any direction.
        const double size = std::pow(10.0, *rc::gen::inRange(-200, 150) / 100.0);
        const Vec3 delta(*rc::gen::inRange(-100, 101), *rc::gen::inRange(-100, 101),
                         *rc::gen::inRange(1, 101));
        points.push_back(points.back() + size * delta.normalized());
    }
    return points;
}

SplineEnd any_end() {
    const auto kind = *rc::gen::element(Kind::Auto, Kind::Natural, Kind::Tangent);
    const Vec3 tangent(*rc::gen::inRange(-9, 10), *rc::gen::inRange(-9, 10),
                       *rc::gen::inRange(1, 10));
    return {kind, tangent.normalized()};
}

RC_GTEST_PROP(ThroughSplines, WindowIsTheGlobalCurve, ()) {
    const std::vector<Vec3> points = any_points(4, 90);
    const Ends ends{any_end(), any_end()};
    const auto spans = curve_through(ThroughKind::CubicSpline, points, ends);
    const std::vector<Vec3> slopes = global_slopes(points, ends);
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const double width = (points[i + 1] - points[i]).norm();
        const CubicSpan exact = make_spline(
            points[i], points[i + 1],
            {3, {points[i] + slopes[i] * width / 3, points[i + 1] - slopes[i + 1] * width / 3}});
        for (const double u : {0.2, 0.5, 0.8}) {
            const Vec3 gap = point_at(spans[i], u).position - point_at(exact, u).position;
            RC_ASSERT(gap.norm() < 2 * kWindowError);
        }
    }
}

/// Derivatives by the chord, at both sides of every point inside.
RC_GTEST_PROP(ThroughSplines, RunThroughTheirPointsSmoothly, ()) {
    const std::vector<Vec3> points = any_points(2, 60);
    const auto kind = *rc::gen::element(ThroughKind::Akima, ThroughKind::CubicSpline);
    const Ends ends{any_end(), any_end()};
    const auto spans = curve_through(kind, points, ends);
    for (std::size_t i = 0; i < spans.size(); ++i) {
        RC_ASSERT((point_at(spans[i], 0).position - points[i]).norm() < 1e-9);
        RC_ASSERT((point_at(spans[i], 1).position - points[i + 1]).norm() < 1e-9);
        if (i == 0) continue;
        const double before = (points[i] - points[i - 1]).norm();
        const double behind = (points[i + 1] - points[i]).norm();
        const SplinePoint in = point_at(spans[i - 1], 1);
        const SplinePoint out = point_at(spans[i], 0);
        RC_ASSERT((in.first / before - out.first / behind).norm() <
                  1e-9 * (1 + 1 / std::min(before, behind)));
        if (kind != ThroughKind::CubicSpline) continue;
        // A slope that the window leaves off by δ shows as 4·δ/h.
        const double least = std::min(before, behind);
        const Vec3 jump = in.second / (before * before) - out.second / (behind * behind);
        RC_ASSERT(jump.norm() < 100 * kWindowError / (least * least));
    }
}

TEST(ThroughSpline, EndsAsTheyAreAsked) {
    const std::vector<Vec3> points = {{0, 0, 0}, {10, 5, 0}, {20, -5, 3}, {25, 0, 0}, {40, 2, 0}};
    const Vec3 t = Vec3(1, 2, 3).normalized();
    for (const auto kind : {ThroughKind::Akima, ThroughKind::CubicSpline}) {
        const auto natural =
            curve_through(kind, points, {{Kind::Natural, {}}, {Kind::Natural, {}}});
        EXPECT_LT(point_at(natural.front(), 0).second.norm(), 1e-9);
        EXPECT_LT(point_at(natural.back(), 1).second.norm(), 1e-9);
        const auto bound = curve_through(kind, points, {{Kind::Tangent, t}, {Kind::Tangent, -t}});
        EXPECT_LT((point_at(bound.front(), 0).first.normalized() - t).norm(), 1e-12);
        EXPECT_LT((point_at(bound.back(), 1).first.normalized() + t).norm(), 1e-12);
    }
    // Three points without a condition: one parabola, whose third derivative is nothing.
    const auto three = curve_through(ThroughKind::CubicSpline, {points[0], points[1], points[2]},
                                     {{Kind::Auto, {}}, {Kind::Auto, {}}});
    for (const CubicSpan& span : three)
        EXPECT_LT((point_at(span, 0).second - point_at(span, 1).second).norm(), 1e-9);
    // Two points: straight, whatever the ends but a direction.
    for (const auto kind : {ThroughKind::Akima, ThroughKind::CubicSpline}) {
        for (const Kind end : {Kind::Auto, Kind::Natural}) {
            const auto two = curve_through(kind, {points[0], points[1]}, {{end, {}}, {end, {}}});
            EXPECT_NEAR(two[0].length, points[1].norm(), 1e-12);
            EXPECT_LT((point_at(two[0], 0.5).position - points[1] / 2).norm(), 1e-12);
        }
        const auto bent =
            curve_through(kind, {points[0], points[1]}, {{Kind::Tangent, t}, {Kind::Natural, {}}});
        EXPECT_LT((point_at(bent[0], 0).first.normalized() - t).norm(), 1e-12);
        EXPECT_LT(point_at(bent[0], 1).second.norm(), 1e-9);
    }
}

TEST(ThroughSpline, AkimaStaysStraightOnStraightRuns) {
    const auto spans =
        curve_through(ThroughKind::Akima,
                      {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {4, 0, 0}, {6, 0, 0}, {8, 5, 0}, {9, 9, 0}},
                      {{Kind::Auto, {}}, {Kind::Auto, {}}});
    for (std::size_t i = 0; i < 3; ++i)
        for (const double u : {0.25, 0.5, 0.75}) EXPECT_EQ(point_at(spans[i], u).position.y(), 0);
    EXPECT_GT(std::fabs(point_at(spans[4], 0.5).position.y() - 2.5), 0.01);
}

TEST(ThroughSpline, AkimaTurnsWithItsAxes) {
    const std::vector<Vec3> points = {{0, 0, 0},  {7, 3, 1},  {11, 9, -2}, {20, 8, 4},
                                      {26, 1, 5}, {30, 1, 5}, {37, 6, 0}};
    const Ends ends = {{Kind::Auto, {}}, {Kind::Natural, {}}};
    const Frame frame =
        rotation_rpy({0.2, -0.14, 0.52}) * mirroring(bit(Axis::Y)) * scaling(Vec3::Constant(2));
    std::vector<Vec3> turned;
    for (const Vec3& point : points) turned.push_back(frame(point));
    const auto plain = curve_through(ThroughKind::Akima, points, ends);
    const auto with = curve_through(ThroughKind::Akima, turned, ends, {}, unit_axes(frame));
    const auto without = curve_through(ThroughKind::Akima, turned, ends);
    double apart_with = 0;
    double apart_without = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        for (const double u : {0.25, 0.5, 0.75}) {
            const Vec3 at = frame(point_at(plain[i], u).position);
            apart_with = std::max(apart_with, (point_at(with[i], u).position - at).norm());
            apart_without = std::max(apart_without, (point_at(without[i], u).position - at).norm());
        }
    }
    EXPECT_LT(apart_with, 1e-12);
    EXPECT_GT(apart_without, 0.1);
}

TEST(ThroughSpline, LeavesOutAPointThatIsTheOneBefore) {
    ThroughSpline spline(ThroughKind::CubicSpline, {Kind::Natural, {}}, Vec3::Zero());
    EXPECT_FALSE(spline.add_point(Vec3::Zero()));
    EXPECT_TRUE(spline.add_point(Vec3(1, 0, 0)));
    EXPECT_FALSE(spline.add_point(Vec3(1, 5e-8, 0)));
    EXPECT_EQ(spline.points(), 2u);
}

TEST(ThroughSpline, KeepsFewPoints) {
    // A million points, of which a few dozen are known at any time: the spans come a window behind.
    ThroughSpline spline(ThroughKind::CubicSpline, {Kind::Auto, {}}, Vec3::Zero());
    std::size_t spans = 0;
    std::size_t most = 0;
    for (int i = 1; i <= 100000; ++i) {
        const double x = i * (i % 3 == 0 ? 1.0 : 1.1);
        ASSERT_TRUE(spline.add_point(Vec3(x, std::sin(0.3 * i), 0)));
        while (spline.next()) ++spans;
        most = std::max(most, spline.points() - spans);
    }
    EXPECT_LT(most, 40u);
}

// ------------------------------------------------------------------------------ degree five

TEST(QuinticSpan, PointsOfTheOracle) {
    std::ifstream file(KADR_ROOT "/tests/oracles/curves.json");
    const test::Json oracle = test::Json::parse(file);
    int curves = 0;
    for (const test::Json& entry : oracle["cases"]) {
        if (entry["id"] != "rational_bezier5") continue;
        ++curves;
        SplineShape shape{5};
        std::vector<Vec3> control_points;
        for (const test::Json& pole : entry["input"]["ctrl"])
            control_points.push_back(test::vec3(pole));
        for (std::size_t i = 0; i < 6; ++i) shape.weights[i] = entry["input"]["weights"][i];
        for (std::size_t i = 0; i < 4; ++i) shape.inner[i] = control_points[i + 1];
        const QuinticSpan span = make_quintic(control_points[0], control_points[5], shape);
        for (const test::Json& sample : entry["expect"]["samples"]) {
            const SplinePoint point = point_at(span, sample["u"]);
            const Vec3 first = test::vec3(sample["C1"]);
            const Vec3 second = test::vec3(sample["C2"]);
            EXPECT_LT((point.position - test::vec3(sample["C"])).norm(), 1e-9);
            EXPECT_LT((point.first - first).norm(), 1e-9 * (1 + first.norm()));
            EXPECT_LT((point.second - second).norm(), 1e-8 * (1 + second.norm()));
        }
        EXPECT_NEAR(span.length, entry["expect"]["length"].get<double>(), 1e-7);
        for (const test::Json& at : entry["expect"]["at_length"])
            EXPECT_NEAR(parameter_at(span, at["s"]), at["u"].get<double>(), 1e-7);
        // In parts, in bounds, from either side.
        const Box box = bounds(Curve(span));
        for (double s = 0; s <= span.length; s += span.length / 37) {
            const Vec3 here = position(span, s);
            for (int k = 0; k < 3; ++k) {
                EXPECT_GE(here[k], box.lower[k] - 1e-9);
                EXPECT_LE(here[k], box.upper[k] + 1e-9);
            }
            if (s == 0) continue;
            const QuinticSpan half = part(span, 0, s);
            EXPECT_NEAR(half.length, s, 1e-8);
            EXPECT_LT((position(half, s / 2) - position(span, s / 2)).norm(), 1e-8);
        }
    }
    EXPECT_EQ(curves, 1);
}

TEST(QuinticSpan, LowerDegreesAreRaised) {
    const SplineShape shape{2, {Vec3(10, 10, 0)}, {1, 0.7, 2}};
    const CubicSpan cubic = make_spline(Vec3(10, 0, 0), Vec3(0, 10, 0), shape);
    const QuinticSpan quintic = make_quintic(Vec3(10, 0, 0), Vec3(0, 10, 0), shape);
    EXPECT_NEAR(cubic.length, quintic.length, 1e-9);
    for (const double u : {0.0, 0.1, 0.5, 0.77, 1.0})
        EXPECT_LT((point_at(cubic, u).position - point_at(quintic, u).position).norm(), 1e-12);
}

}  // namespace
}  // namespace kadr::path::through_spline_test
