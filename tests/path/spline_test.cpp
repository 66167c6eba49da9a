// Splines: de Boor's scheme, spans and arc lengths against the oracle; lengths walked to within a
// thousandth of a micrometre; curves fitted with one B-spline within the tolerance.
#include "path/spline.h"

#include <cmath>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "path/casteljau.h"
#include "path/curve.h"
#include "path/nurbs.h"
#include "path/spline_fit.h"
#include "path/steady.h"
#include "tests/path/oracle_arcs.h"

namespace kadr::path::spline_test {
namespace {

constexpr double kPi = std::numbers::pi;

Nurbs nurbs_of(const test::Json& input) {
    Nurbs nurbs;
    nurbs.degree = input["degree"];
    nurbs.knots = input["knots"].get<std::vector<double>>();
    nurbs.weights = input["weights"].get<std::vector<double>>();
    for (const test::Json& pole : input["ctrl"]) nurbs.control_points.push_back(test::vec3(pole));
    return nurbs;
}

/// All spans of a spline of degree one to three.
std::vector<CubicSpan> spans_of(const Nurbs& nurbs) {
    SplineSpans cutting(nurbs.degree);
    std::vector<CubicSpan> spans;
    const auto take = [&] {
        while (const auto span = cutting.next())
            spans.push_back(make_spline(span->start, span->end, span->shape));
    };
    for (std::size_t i = 0; i < nurbs.knots.size(); ++i) {
        EXPECT_FALSE(cutting.add_knot(nurbs.knots[i]).has_value());
        if (i < nurbs.control_points.size())
            cutting.add_control_point(nurbs.control_points[i], nurbs.weight(i));
        take();
    }
    EXPECT_FALSE(cutting.end_fault().has_value());
    return spans;
}

TEST(Nurbs, PointsOfTheOracle) {
    std::ifstream file(KADR_ROOT "/tests/oracles/curves.json");
    const test::Json oracle = test::Json::parse(file);
    int splines = 0;
    for (const test::Json& entry : oracle["cases"]) {
        if (entry["type"] != "nurbs") continue;
        SCOPED_TRACE(entry["id"].get<std::string>());
        ++splines;
        const Nurbs nurbs = nurbs_of(entry["input"]);
        ASSERT_FALSE(fault_of(nurbs).has_value());
        for (const test::Json& sample : entry["expect"]["samples"]) {
            const SplinePoint point = point_at(nurbs, sample["u"]);
            EXPECT_LT((point.position - test::vec3(sample["C"])).norm(), 1e-9);
            const Vec3 first = test::vec3(sample["C1"]);
            const Vec3 second = test::vec3(sample["C2"]);
            EXPECT_LT((point.first - first).norm(), 1e-9 * (1 + first.norm()));
            EXPECT_LT((point.second - second).norm(), 1e-9 * (1 + second.norm()));
        }
        const double expected = entry["expect"]["length"];
        EXPECT_NEAR(length(nurbs), expected, 1e-7);
        if (nurbs.degree > 3) continue;
        double sum = 0;
        for (const CubicSpan& span : spans_of(nurbs)) sum += span.length;
        EXPECT_NEAR(sum, expected, 1e-7);
    }
    EXPECT_EQ(splines, 7);
}

TEST(Nurbs, SpansAreTheCurve) {
    std::ifstream file(KADR_ROOT "/tests/oracles/curves.json");
    const test::Json oracle = test::Json::parse(file);
    for (const test::Json& entry : oracle["cases"]) {
        if (entry["type"] != "nurbs" || entry["input"]["degree"] > 3) continue;
        SCOPED_TRACE(entry["id"].get<std::string>());
        const Nurbs nurbs = nurbs_of(entry["input"]);
        const std::vector<CubicSpan> spans = spans_of(nurbs);
        std::size_t at = 0;
        for (std::size_t k = 0; k + 1 < nurbs.knots.size(); ++k) {
            const double from = nurbs.knots[k];
            const double width = nurbs.knots[k + 1] - from;
            if (width == 0) continue;
            ASSERT_LT(at, spans.size());
            const CubicSpan& span = spans[at++];
            for (const double u : {0.0, 0.3, 0.5, 0.9, 1.0}) {
                const SplinePoint there = point_at(nurbs, from + u * width);
                EXPECT_LT((point_at(span, u).position - there.position).norm(), 1e-11);
            }
            for (const double u : {0.1, 0.5, 0.9}) {
                const SplinePoint there = point_at(nurbs, from + u * width);
                const SplinePoint here = point_at(span, u);
                EXPECT_LT((here.first - there.first * width).norm(), 1e-9 * there.first.norm());
            }
        }
        EXPECT_EQ(at, spans.size());
    }
}

TEST(Nurbs, SaysWhatIsWrong) {
    const Nurbs good{2, {0, 0, 0, 1, 2, 2, 2}, {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 1, 0}}, {}};
    EXPECT_FALSE(fault_of(good).has_value());
    const auto with_knots = [&](std::vector<double> knots) {
        Nurbs nurbs = good;
        nurbs.knots = std::move(knots);
        return fault_of(nurbs);
    };
    EXPECT_EQ(with_knots({0, 0, 0, 1, 2, 2}), NurbsFault::Counts);
    EXPECT_EQ(with_knots({0, 0, 0, 2, 1, 2, 2}), NurbsFault::Decreasing);
    EXPECT_EQ(with_knots({0, 0, 1, 1, 2, 2, 2}), NurbsFault::Unclamped);
    EXPECT_EQ(with_knots({0, 0, 0, 0, 2, 2, 2}), NurbsFault::Gap);
    Nurbs other = good;
    other.degree = 0;
    EXPECT_EQ(fault_of(other), NurbsFault::Degree);
    other = good;
    other.control_points.resize(2);
    EXPECT_EQ(fault_of(other), NurbsFault::ControlPoints);
    other = good;
    other.weights = {1, 1, 0, 1};
    EXPECT_EQ(fault_of(other), NurbsFault::Weight);
    SplineSpans spans(1);
    EXPECT_FALSE(spans.add_knot(0).has_value());
    EXPECT_EQ(spans.add_knot(1), NurbsFault::Unclamped);
    EXPECT_FALSE(spans.add_knot(0).has_value());
    EXPECT_FALSE(spans.add_knot(1).has_value());
    EXPECT_EQ(spans.add_knot(0.5), NurbsFault::Decreasing);
    EXPECT_FALSE(spans.add_knot(1).has_value());
    EXPECT_EQ(spans.add_knot(2), NurbsFault::Gap);
    EXPECT_EQ(spans.end_fault(), NurbsFault::ControlPoints);
}

/// The length to a point, by many chords: s³·κ²/24 short each.
double chords_to(const CubicSpan& spline, double u) {
    constexpr int kChords = 200000;
    double sum = 0;
    Vec3 last = point_at(spline, 0).position;
    for (int i = 1; i <= kChords; ++i) {
        const Vec3 next = point_at(spline, u * i / kChords).position;
        sum += (next - last).norm();
        last = next;
    }
    return sum;
}

TEST(Spline, IsWalkedByItsLength) {
    const SplineShape plain{3, {Vec3(5, 20, 0), Vec3(30, -10, 5)}, {1, 1, 1, 1}};
    const SplineShape heavy{3, {Vec3(5, 20, 0), Vec3(30, -10, 5)}, {1, 6, 0.2, 2}};
    const SplineShape conic{2, {Vec3(20, 20, 0), Vec3::Zero()}, {1, std::sqrt(0.5), 1, 0}};
    const SplineShape cusp{3, {Vec3(40, 30, 0), Vec3(0, 30, 0)}, {1, 1, 1, 1}};
    const SplineShape standing{3, {Vec3(0, 0, 0), Vec3(0, 0, 0)}, {1, 1, 1, 1}};
    for (const SplineShape& shape : {plain, heavy, conic, cusp, standing}) {
        const CubicSpan spline = make_spline(Vec3(0, 0, 0), Vec3(40, 0, 0), shape);
        EXPECT_NEAR(spline.length, chords_to(spline, 1), 1e-5);
        EXPECT_EQ(position(spline, 0), Vec3(0, 0, 0));
        EXPECT_EQ(position(spline, spline.length), Vec3(40, 0, 0));
        for (const double share : {1e-7, 0.01, 0.3, 0.5, 0.77, 0.999999}) {
            const double s = share * spline.length;
            EXPECT_NEAR(length(part(spline, 0, s)), s, 1e-8) << share;
            EXPECT_NEAR(length(part(spline, s, spline.length)), spline.length - s, 1e-8) << share;
            const auto [before, behind] = split(spline, parameter_at(spline, s));
            EXPECT_NEAR(before.length + behind.length, spline.length, 1e-8);
        }
    }
}

TEST(Spline, QuarterCircleByWeights) {
    const SplineShape shape{2, {Vec3(10, 10, 0), Vec3::Zero()}, {1, std::sqrt(0.5), 1, 0}};
    const CubicSpan spline = make_spline(Vec3(10, 0, 0), Vec3(0, 10, 0), shape);
    EXPECT_NEAR(spline.length, 5 * kPi, 1e-9);
    for (const double share : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        const double angle = share * kPi / 2;
        const CurvePoint point = evaluate(spline, 10 * angle);
        const Vec3 out(std::cos(angle), std::sin(angle), 0);
        EXPECT_LT((point.position - 10 * out).norm(), 2e-9);
        EXPECT_LT((point.curvature + out / 10).norm(), 1e-8);
        EXPECT_NEAR(point.tangent.dot(out), 0, 1e-8);
    }
    const Box box = bounds(spline);
    EXPECT_NEAR(box.upper.x(), 10, 1e-6);
    EXPECT_GE(box.upper.x(), 10);
    EXPECT_NEAR(box.upper.y(), 10, 1e-6);
    EXPECT_GE(box.upper.y(), 10);
    EXPECT_NEAR(box.lower.x(), 0, 1e-12);
}

/// Turns back at u = 0.99, behind the last of the places at which the speed is looked at first.
TEST(Spline, ItsLengthIsExactWhereItTurnsBackBesideItsEnd) {
    // x(u) = 100·u − 50/0.99·u²
    const double square = 50 / 0.99;
    const CubicSpan spline = make_spline(Vec3::Zero(), Vec3(100 - square, 0, 0),
                                         {2, {Vec3(50, 0, 0), Vec3::Zero()}, {1, 1, 1, 1}});
    const double turn = 49.5;  // 100·0.99 − 50·0.99
    EXPECT_NEAR(spline.length, 2 * turn - (100 - square), 1e-9);
    EXPECT_NEAR(position(spline, turn).x(), turn, 1e-9);
    EXPECT_NEAR(position(spline, turn - 1e-3).x(), turn - 1e-3, 1e-9);
    EXPECT_NEAR(position(spline, turn + 1e-3).x(), turn - 1e-3, 1e-9);
    ASSERT_TRUE(slow_parameter(spline).has_value());
    EXPECT_NEAR(*slow_parameter(spline), 0.99, 1e-9);
    const auto [before, behind] = split(spline, *slow_parameter(spline));
    EXPECT_FALSE(slow_parameter(before).has_value());
    EXPECT_FALSE(slow_parameter(behind).has_value());
}

/// Whose control points say that it goes on towards its end does, and is never slow.
RC_GTEST_PROP(Spline, SteadyOnesGoOn, ()) {
    const auto any = [](int reach) { return *rc::gen::inRange(-1000, 1001) * 0.001 * reach; };
    const Vec3 end(10, 0, 0);
    SplineShape shape{*rc::gen::inRange(3, 6), {}, {2, 2, 2, 2, 2, 2}};
    for (int i = 1; i < shape.degree; ++i)
        shape.inner[static_cast<std::size_t>(i - 1)] =
            Vec3(10.0 * i / shape.degree + any(2), any(5), any(5));
    const auto steady = steady_span(Vec3::Zero(), end, shape);
    RC_CLASSIFY(steady.has_value());
    if (!steady) return;
    const QuinticSpan span = make_quintic(Vec3::Zero(), end, shape);
    const auto told = [&](double u) {
        const auto at = [&]<std::size_t N>(const std::array<Vec3, N>& points) -> Vec3 {
            return Casteljau<Vec3, N>(points, u).at();
        };
        return std::visit(at, *steady);
    };
    double least = 1e9, sum = 0;
    constexpr int kPlaces = 1000;
    for (int i = 0; i <= kPlaces; ++i) {
        const double u = static_cast<double>(i) / kPlaces;
        const SplinePoint at = point_at(span, u);
        RC_ASSERT((told(u) - at.position).norm() < 1e-12);
        RC_ASSERT(at.first.x() > 0);
        least = std::min(least, at.first.norm());
        sum += at.first.norm() / (kPlaces + 1);
    }
    RC_ASSERT(least >= kNearlyStands * sum);
    RC_ASSERT(!slow_parameter(span).has_value());
}

// What lies close on a smooth curve is steady; weights and what turns back are not.
TEST(Spline, DenseSpansAreSteady) {
    const SplineShape quarter{2, {Vec3(10, 10, 0), Vec3::Zero()}, {1, 1, 1, 0}};
    EXPECT_TRUE(steady_span(Vec3(10, 0, 0), Vec3(0, 10, 0), quarter).has_value());
    SplineShape heavy = quarter;
    heavy.weights[1] = 2;
    EXPECT_FALSE(steady_span(Vec3(10, 0, 0), Vec3(0, 10, 0), heavy).has_value());
    const SplineShape line{1, {}, {1, 1, 0, 0}};
    EXPECT_TRUE(steady_span(Vec3(10, 0, 0), Vec3(0, 10, 0), line).has_value());
    EXPECT_FALSE(steady_span(Vec3(10, 0, 0), Vec3(10, 0, 0), line).has_value());
    const SplineShape back{2, {Vec3(50, 0, 0), Vec3::Zero()}, {1, 1, 1, 0}};
    EXPECT_FALSE(steady_span(Vec3::Zero(), Vec3(40, 0, 0), back).has_value());
    const SplineShape fourth{4, {Vec3(10, 1, 0), Vec3(20, 2, 0), Vec3(30, 1, 0)}, {}};
    EXPECT_TRUE(steady_span(Vec3::Zero(), Vec3(40, 0, 0), fourth).has_value());
    const SplineShape loop{5, {Vec3(50, 1, 0), Vec3(-10, 2, 0), Vec3(30, 1, 0)}, {}};
    EXPECT_FALSE(steady_span(Vec3::Zero(), Vec3(40, 0, 0), loop).has_value());
}

// x(u) = −150·u + 180·u², least −31.25 at u = 5/12; and a loop as high as 3/4 of its control
// points.
TEST(Spline, BoundsEndWhereTheCurveTurnsBack) {
    const CubicSpan back = make_spline(Vec3::Zero(), Vec3(30, 0, 0),
                                       {2, {Vec3(-75, 0, 0), Vec3::Zero()}, {1, 1, 1, 1}});
    EXPECT_NEAR(bounds(back).lower.x(), -31.25, 1e-6);
    EXPECT_LE(bounds(back).lower.x(), -31.25);
    EXPECT_EQ(bounds(back).upper.x(), 30);
    const CubicSpan loop = make_spline(Vec3::Zero(), Vec3(10, 0, 0),
                                       {3, {Vec3(30, 20, 0), Vec3(-20, 20, 0)}, {1, 1, 1, 1}});
    EXPECT_NEAR(bounds(loop).upper.y(), 15, 1e-6);
    EXPECT_GE(bounds(loop).upper.y(), 15);
}

TEST(Spline, OfDegreeOneIsALine) {
    const CubicSpan spline = make_spline(Vec3(0, 0, 0), Vec3(3, 4, 0), {1, {}, {1, 1, 0, 0}});
    EXPECT_NEAR(spline.length, 5, 1e-12);
    EXPECT_LT((position(spline, 2.5) - Vec3(1.5, 2, 0)).norm(), 1e-12);
    EXPECT_LT((evaluate(spline, 0).tangent - Vec3(0.6, 0.8, 0)).norm(), 1e-12);
}

// ------------------------------------------------------------------------------ fitting

/// Greatest distance at one parameter; the spline's knots run evenly with the curve's parameter
/// between its corners only, so the nearest of many points is taken.
double deviation(const ParametricCurve& curve, const FitOptions& options, const Nurbs& spline) {
    constexpr int kPoints = 3000;
    std::vector<Vec3> points;
    const double first = spline.knots.front();
    const double last = spline.knots.back();
    for (int i = 0; i <= 10 * kPoints; ++i)
        points.push_back(point_at(spline, first + (last - first) * i / (10 * kPoints)).position);
    double worst = 0;
    std::size_t from = 0;
    for (int i = 0; i <= kPoints; ++i) {
        const double t = options.from + (options.to - options.from) * i / kPoints;
        const Vec3 point = curve(t)->position;
        double best = (points[from] - point).norm();
        // The points come in the same order; a window behind the last nearest one holds the next.
        for (std::size_t k = from; k < std::min(points.size(), from + 600); ++k) {
            const Vec3& a = points[k];
            const Vec3 delta = k + 1 < points.size() ? Vec3(points[k + 1] - a) : Vec3(Vec3::Zero());
            const double square = delta.squaredNorm();
            const double share =
                square > 0 ? std::clamp((point - a).dot(delta) / square, 0.0, 1.0) : 0;
            const double apart = (a + delta * share - point).norm();
            if (apart < best) best = apart, from = k;
        }
        worst = std::max(worst, best);
    }
    return worst;
}

CurveSample at(double x, double y, double dx, double dy) {
    return {Vec3(x, y, 0), Vec3(dx, dy, 0)};
}

struct Row {
    const char* name;
    ParametricCurve curve;
    double from, to;
    std::size_t most_poles;  // at 5 µm
};

std::vector<Row> rows() {
    const auto ellipse = [](double t) {
        return at(30 * std::cos(t), 20 * std::sin(t), -30 * std::sin(t), 20 * std::cos(t));
    };
    const auto wave = [](double t) { return at(t, 3 * std::sin(t), 1, 3 * std::cos(t)); };
    const auto helix = [](double t) -> std::optional<CurveSample> {
        return CurveSample{Vec3(10 * std::cos(t), 10 * std::sin(t), t),
                           Vec3(-10 * std::sin(t), 10 * std::cos(t), 1)};
    };
    const auto line = [](double t) { return at(100 * t, 50 * t, 100, 50); };
    const auto cusp = [](double t) { return at(10 * t * t * t, 10 * t * t, 30 * t * t, 20 * t); };
    const auto corner = [](double t) {
        return at(10 * t, 10 * std::fabs(t - 0.3), 10, t < 0.3 ? -10 : 10);
    };
    const auto gear = [](double t) {
        const double r = 40 + 0.5 * std::cos(64 * t);
        const double dr = -32 * std::sin(64 * t);
        return at(r * std::cos(t), r * std::sin(t), dr * std::cos(t) - r * std::sin(t),
                  dr * std::sin(t) + r * std::cos(t));
    };
    return {
        {"ellipse", ellipse, 0, 2 * kPi, 36},
        {"clockwise", ellipse, 2 * kPi, 0, 36},
        {"wave", wave, -10, 10, 50},
        {"helix", helix, 0, 4 * kPi, 60},
        {"line", line, 0, 1, 11},
        {"cusp", cusp, -1, 1, 40},
        {"corner", corner, -1, 1.1, 40},
        {"gear", gear, 0, 2 * kPi, 64 * 16},
    };
}

TEST(SplineFit, KeepsTheTolerance) {
    for (const Row& row : rows()) {
        for (const double tolerance : {0.1, 0.005, 0.0005}) {
            SCOPED_TRACE(row.name);
            SCOPED_TRACE(tolerance);
            const FitOptions options{FitKind::Lines, tolerance, row.from, row.to};
            const SplineFitResult fitted = fit_spline(row.curve, options);
            ASSERT_FALSE(fitted.fault.has_value());
            ASSERT_FALSE(fault_of(fitted.spline).has_value());
            EXPECT_EQ(fitted.spline.control_points.front(), row.curve(row.from)->position);
            EXPECT_EQ(fitted.spline.control_points.back(), row.curve(row.to)->position);
            EXPECT_LE(deviation(row.curve, options, fitted.spline), tolerance * (1 + 1e-6));
            for (const double knot : fitted.spline.knots) EXPECT_EQ(knot * 8, std::round(knot * 8));
            if (tolerance == 0.005) {
                EXPECT_LE(fitted.spline.control_points.size(), row.most_poles);
            }
        }
    }
}

// y = |t|^p: the curvature has no end at 0, so a spline with one curvature everywhere swings beside
// it. Where adding points does not help, the curve's own slopes are taken, and measured as well.
TEST(SplineFit, KeepsTheToleranceWhereTheCurvatureHasNoEnd) {
    for (const double power : {1.05, 1.2, 1.5, 1.8}) {
        for (const double place : {0.0, 0.301, 0.5}) {
            for (const double tolerance : {0.01, 1e-3, 1e-5}) {
                SCOPED_TRACE(::testing::Message() << power << ' ' << place << ' ' << tolerance);
                const ParametricCurve curve = [&](double t) {
                    const double x = t - place;
                    const double slope = x == 0 ? 0 : power * std::pow(std::fabs(x), power) / x;
                    return at(20 * t, 20 * std::pow(std::fabs(x), power), 20, 20 * slope);
                };
                const FitOptions options{FitKind::Lines, tolerance, -1, 1};
                const SplineFitResult fitted = fit_spline(curve, options);
                ASSERT_FALSE(fitted.fault.has_value());
                ASSERT_FALSE(fault_of(fitted.spline).has_value());
                EXPECT_LE(deviation(curve, options, fitted.spline), tolerance * (1 + 1e-6));
            }
        }
    }
}

TEST(SplineFit, IsCurvatureContinuousBetweenCorners) {
    for (const Row& row : rows()) {
        if (std::string_view(row.name) == "corner") continue;
        SCOPED_TRACE(row.name);
        const SplineFitResult fitted =
            fit_spline(row.curve, {FitKind::Lines, 0.005, row.from, row.to});
        const std::vector<double>& knots = fitted.spline.knots;
        for (std::size_t i = 4; i + 4 < knots.size(); ++i) EXPECT_LT(knots[i - 1], knots[i]);
    }
    // One corner: a knot of three, where the pole is the corner.
    const Row corner = rows()[6];
    const SplineFitResult fitted =
        fit_spline(corner.curve, {FitKind::Lines, 0.005, corner.from, corner.to});
    const auto& [degree, knots, control_points, weights] = fitted.spline;
    int triples = 0;
    for (std::size_t i = 4; i + 6 < knots.size(); ++i) {
        if (knots[i] != knots[i + 2]) continue;
        ++triples;
        EXPECT_LT((control_points[i - 1] - Vec3(3, 0, 0)).norm(), 1e-6);
    }
    EXPECT_EQ(triples, 1);
}

TEST(SplineFit, SaysWhatIsWrong) {
    const auto jump = [](double t) -> std::optional<CurveSample> {
        return at(t, t < 0.5 ? 0 : 3, 1, 0);
    };
    const SplineFitResult jumping = fit_spline(jump, {FitKind::Lines, 0.01, 0, 1});
    ASSERT_TRUE(jumping.fault);
    EXPECT_EQ(*jumping.fault, FitFault::Jump);
    EXPECT_NEAR(jumping.parameter, 0.5, 1e-6);
    const auto half = [](double t) -> std::optional<CurveSample> {
        if (t > 0.5) return std::nullopt;
        return at(t, t * t, 1, 2 * t);
    };
    const SplineFitResult ending = fit_spline(half, {FitKind::Lines, 0.01, 0, 1});
    ASSERT_TRUE(ending.fault);
    EXPECT_EQ(*ending.fault, FitFault::NotEvaluated);
}

TEST(SplineFit, WindsManyTimes) {
    for (const int turns : {20, 50, 60, 75, 100, 150, 300}) {
        for (const double rise : {0.0, 0.01, 0.06, 1.0}) {  // mm a turn
            SCOPED_TRACE(::testing::Message() << turns << " turns, " << rise << " mm");
            const auto spiral = [&](double u) -> std::optional<CurveSample> {
                const double r = 5 + rise * u, w = 2 * kPi;
                const double c = std::cos(w * u), s = std::sin(w * u);
                return at(r * c, r * s, rise * c - r * w * s, rise * s + r * w * c);
            };
            const FitOptions options{FitKind::Lines, 0.01, 0, static_cast<double>(turns)};
            const SplineFitResult fitted = fit_spline(spiral, options);
            ASSERT_FALSE(fitted.fault.has_value());
            ASSERT_FALSE(fault_of(fitted.spline).has_value());
            const double last = fitted.spline.knots.back();
            double worst = 0;
            const int samples = 97 * turns;
            for (int i = 0; i <= samples; ++i) {
                const Vec3 on = point_at(fitted.spline, last * i / samples).position;
                const Vec3 point = spiral(options.to * i / samples)->position;
                worst = std::max(worst, (on - point).norm());
            }
            EXPECT_LE(worst, options.tolerance * (1 + 1e-6));
            EXPECT_LE(fitted.spline.control_points.size(), 40u * static_cast<std::size_t>(turns));
        }
    }
}

TEST(SplineFit, HasNoPolesWhereNothingMoves) {
    const auto point = [](double) { return at(6, 6, 0, 0); };
    const auto parabola = [](double u) { return at(u, u * u, 1, 2 * u); };
    for (const SplineFitResult& fitted : {fit_spline(point, {FitKind::Lines, 0.01, 0, 1}),
                                          fit_spline(parabola, {FitKind::Lines, 0.01, 1, 1})}) {
        EXPECT_FALSE(fitted.fault.has_value());
        EXPECT_TRUE(fitted.spline.control_points.empty());
        EXPECT_TRUE(fitted.spline.knots.empty());
    }
}

RC_GTEST_PROP(SplineFit, KeepsTheToleranceOnRandomCurves, ()) {
    double a[3][3], f[3][3], p[3][3];
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            a[i][k] = (*rc::gen::inRange(-1000, 1001)) / 50.0;
            f[i][k] = *rc::gen::inRange(0, 7);
            p[i][k] = (*rc::gen::inRange(0, 628)) / 100.0;
        }
    }
    const auto curve = [&](double t) -> std::optional<CurveSample> {
        CurveSample sample;
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                sample.position[i] += a[i][k] * std::cos(f[i][k] * t + p[i][k]);
                sample.derivative[i] -= a[i][k] * f[i][k] * std::sin(f[i][k] * t + p[i][k]);
            }
        }
        return sample;
    };
    const FitOptions options{FitKind::Lines, (*rc::gen::inRange(1, 200)) / 1000.0, 0, 3};
    const SplineFitResult fitted = fit_spline(curve, options);
    RC_ASSERT(!fitted.fault.has_value());
    if (fitted.spline.control_points.empty()) {
        for (int i = 0; i <= 100; ++i)
            RC_ASSERT((curve(3.0 * i / 100)->position - curve(0)->position).norm() < 1e-3);
        return;
    }
    RC_ASSERT(!fault_of(fitted.spline).has_value());
    // Smooth all over: the knots run evenly with the parameter.
    const double last = fitted.spline.knots.back();
    for (int i = 0; i <= 2000; ++i) {
        const Vec3 apart =
            point_at(fitted.spline, last * i / 2000).position - curve(3.0 * i / 2000)->position;
        RC_ASSERT(apart.norm() <= options.tolerance * (1 + 1e-9));
    }
}

}  // namespace
}  // namespace kadr::path::spline_test
