// Curves by arc length: against tests/oracles/curves.json, and what must hold for every curve.
#include "path/curve.h"

#include <cmath>
#include <fstream>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "path/curve_of.h"
#include "tests/path/oracle_arcs.h"

namespace kadr::path::curve_test {
namespace {

constexpr double kPi = std::numbers::pi;
using test::Json;

Helix helix_of(const Arc& arc) {
    return make_helix(arc.start, arc.end, arc.center, arc.normal, arc.sweep);
}

TEST(Helix, ArcsOfTheOracle) {
    std::ifstream file(KADR_ROOT "/tests/oracles/curves.json");
    const Json oracle = Json::parse(file);
    int arcs = 0;
    for (const Json& entry : oracle["cases"]) {
        if (entry["type"] != "arc" || entry["expect"].contains("alarm")) continue;
        SCOPED_TRACE(entry["id"].get<std::string>());
        ++arcs;
        const auto arc = test::arc_of(entry["input"]);
        ASSERT_TRUE(arc);
        const Helix helix = helix_of(*arc);
        const Json& expected = entry["expect"];
        EXPECT_NEAR(helix.length, expected["length"].get<double>(), 1e-7);
        for (const Json& sample : expected["samples"]) {
            const double angle = sample["u"];
            EXPECT_LT((position_at_angle(helix, angle) - test::vec3(sample["C"])).norm(), 1e-9);
        }
        for (const Json& point : expected["at_length"]) {
            EXPECT_NEAR(angle_at(helix, point["s"]), point["u"].get<double>(),
                        1e-7 * point["u"].get<double>());
        }
        for (const Json& sample : expected["samples"]) {
            // The arc length of the sample, from the other direction: the root of angle_at.
            double low = 0, high = helix.length;
            for (int i = 0; i < 60; ++i) {
                const double middle = 0.5 * (low + high);
                (angle_at(helix, middle) < sample["u"].get<double>() ? low : high) = middle;
            }
            const CurvePoint point = evaluate(helix, low);
            const Vec3 first = test::vec3(sample["C1"]);
            EXPECT_LT((point.tangent - first.normalized()).norm(), 1e-8);
            EXPECT_NEAR(point.curvature.norm(), sample["curvature"].get<double>(),
                        1e-7 * point.curvature.norm());
        }
    }
    EXPECT_EQ(arcs, 19);
}

TEST(Curve, EndsAreAsProgrammed) {
    const Vec3 start(1.234, -5.678, 9), end(0.1 + 0.2, 17.001, -3);
    const Curve curves[] = {make_line(start, end),
                            make_helix(start, end, Vec3(3, 2, 0), Vec3::UnitZ(), 2.5),
                            Point{start}};
    for (const Curve& curve : curves) {
        EXPECT_EQ(position(curve, 0), start);
        EXPECT_EQ(position(curve, -1e-9), start);
        if (std::holds_alternative<Point>(curve)) continue;
        EXPECT_EQ(position(curve, length(curve)), end);
        EXPECT_EQ(position(curve, length(curve) + 1), end);
    }
}

TEST(Curve, PointHasNoLength) {
    const Curve point = Point{Vec3(1, 2, 3)};
    EXPECT_EQ(length(point), 0);
    EXPECT_EQ(evaluate(point, 5).position, Vec3(1, 2, 3));
    EXPECT_EQ(evaluate(point, 5).tangent, Vec3::Zero());
    EXPECT_EQ(end(part(point, 0, 0)), Vec3(1, 2, 3));
}

TEST(Curve, QuarterCircle) {
    // Radius 10 about the origin, from (10, 0) to (0, 10): length 5π, in the middle at 45°.
    const Curve arc = make_helix({10, 0, 0}, {0, 10, 0}, {0, 0, 0}, Vec3::UnitZ(), kPi / 2);
    EXPECT_NEAR(length(arc), 5 * kPi, 1e-14);
    const CurvePoint middle = evaluate(arc, 2.5 * kPi);
    const double half = 10 * std::sqrt(0.5);
    EXPECT_LT((middle.position - Vec3(half, half, 0)).norm(), 1e-12);
    EXPECT_LT((middle.tangent - Vec3(-half, half, 0) / 10).norm(), 1e-12);
    EXPECT_LT((middle.curvature + Vec3(half, half, 0) / 100).norm(), 1e-12);
}

TEST(Curve, BoundsTouchTheCrests) {
    struct Row {
        const char* name;
        Vec3 start, end;
        double sweep;
        Vec3 lower, upper;
    };
    for (const Row& row :
         {Row{"quarter", {10, 0, 0}, {0, 10, 0}, kPi / 2, {0, 0, 0}, {10, 10, 0}},
          Row{"three quarters", {10, 0, 0}, {0, -10, 0}, 1.5 * kPi, {-10, -10, 0}, {10, 10, 0}},
          Row{"full turn and height", {10, 0, 0}, {10, 0, 5}, 2 * kPi, {-10, -10, 0}, {10, 10, 5}},
          Row{"over the top", {6, 8, 0}, {-6, 8, 0}, 2 * std::asin(0.6), {-6, 8, 0}, {6, 10, 0}}}) {
        SCOPED_TRACE(row.name);
        const Box box = bounds(make_helix(row.start, row.end, {0, 0, 7}, Vec3::UnitZ(), row.sweep));
        EXPECT_LT((box.lower - row.lower).norm(), 1e-12);
        EXPECT_LT((box.upper - row.upper).norm(), 1e-12);
    }
}

/// A circle of radius 20 in X and in a direction of Y and Z turned by 60 degrees, and a way
/// along its axis: what a fine polygon shows.
TEST(Curve, BoundsOfAHelixInATurnedFrameAreThoseOfItsPoints) {
    const double c = std::cos(kPi / 3), s = std::sin(kPi / 3);
    const Vec3 normal(0, -s, c);
    const Vec3 start(-20, 0, 0);
    for (const double height : {-400.0, -40.0, -1.0, 7.0}) {
        const Helix helix =
            make_helix(start, start + height * normal, Vec3::Zero(), normal, 5 * kPi);
        const Box box = bounds(helix);
        Box seen{start, start};
        constexpr int kPoints = 200000;
        for (int i = 0; i <= kPoints; ++i) {
            const Vec3 point = position_at_angle(helix, helix.sweep * i / kPoints);
            seen.lower = seen.lower.cwiseMin(point);
            seen.upper = seen.upper.cwiseMax(point);
        }
        EXPECT_LT((box.lower - seen.lower).norm(), 1e-6) << height;
        EXPECT_LT((box.upper - seen.upper).norm(), 1e-6) << height;
    }
}

/// A coordinate from -100 to 100 with three decimals, as programs have them.
double any_coordinate() { return *rc::gen::inRange(-100000, 100001) / 1000.0; }
Vec3 any_point() {
    const double x = any_coordinate(), y = any_coordinate(), z = any_coordinate();
    return {x, y, z};
}

/// Arcs and helices in space whose ends lie on radii that differ by at most `spread` of the larger.
Helix any_helix(double spread) {
    Vec3 normal = any_point();
    RC_PRE(normal.norm() > 1);
    normal.normalize();
    const Vec3 e1 = normal.unitOrthogonal();
    const Vec3 e2 = normal.cross(e1);
    const double radius = *rc::gen::inRange(10, 100000) / 1000.0;
    const double other = radius * (1 - spread * *rc::gen::inRange(0, 1001) / 1000.0);
    const double sweep = *rc::gen::inRange(1, 20000) / 1000.0;
    const double height = any_coordinate();
    const Vec3 center = any_point();
    return make_helix(
        center + radius * e1,
        center + other * (std::cos(sweep) * e1 + std::sin(sweep) * e2) + height * normal,
        center - 3 * normal, normal, sweep);
}

/// Length of the chords of n pieces, and the Richardson step to smooth chords: error of order n⁻⁴.
double polygon_length(const Helix& helix, double to, int n) {
    const auto chords = [&](int count) {
        double sum = 0;
        Vec3 last = position_at_angle(helix, 0);
        for (int i = 1; i <= count; ++i) {
            const Vec3 next = position_at_angle(helix, to * i / count);
            sum += (next - last).norm();
            last = next;
        }
        return sum;
    };
    return (4 * chords(2 * n) - chords(n)) / 3;
}

RC_GTEST_PROP(Helix, WalksByArcLength, ()) {
    const double spread = *rc::gen::element(0.0, 1e-4, 1e-2, 0.5, 0.99);
    const Helix helix = any_helix(spread);
    const double s = helix.length * *rc::gen::inRange(0, 1001) / 1000.0;
    const double walked = polygon_length(helix, angle_at(helix, s), 4000);
    RC_ASSERT(std::abs(walked - s) <= 1e-8 + 1e-10 * helix.length);
}

RC_GTEST_PROP(Helix, PartsLieOnTheWhole, ()) {
    const Helix helix = any_helix(*rc::gen::element(0.0, 1e-3, 0.2));
    const double from = helix.length * *rc::gen::inRange(0, 500) / 1000.0;
    const double to = helix.length * *rc::gen::inRange(500, 1001) / 1000.0;
    RC_PRE(from < to);
    const Helix piece = part(helix, from, to);
    RC_ASSERT(std::abs(piece.length - (to - from)) <= 1e-8);
    const double s = piece.length * *rc::gen::inRange(0, 1001) / 1000.0;
    RC_ASSERT((position(piece, s) - position(helix, from + s)).norm() <= 1e-7);
    RC_ASSERT((evaluate(piece, s).tangent - evaluate(helix, from + s).tangent).norm() <= 1e-7);
}

RC_GTEST_PROP(Helix, StaysInsideItsBounds, ()) {
    const Helix helix = any_helix(*rc::gen::element(0.0, 1e-3, 0.5));
    const Box box = bounds(helix);
    for (int i = 0; i <= 100; ++i) {
        const Vec3 point = position(helix, helix.length * i / 100);
        RC_ASSERT((point - box.lower).minCoeff() >= -1e-9);
        RC_ASSERT((box.upper - point).minCoeff() >= -1e-9);
    }
}

RC_GTEST_PROP(Line, PartsKeepTheDirection, ()) {
    const Vec3 start = any_point(), end = any_point();
    RC_PRE((end - start).norm() > 1);
    const Line line = make_line(start, end);
    const double from = line.length * *rc::gen::inRange(0, 500) / 1000.0;
    const double to = line.length * *rc::gen::inRange(501, 1001) / 1000.0;
    const Line piece = part(line, from, to);
    RC_ASSERT(piece.direction == line.direction);
    RC_ASSERT((piece.end - position(line, to)).norm() == 0);
}

/// A tip that is a little beside the start of its arc, as controls forgive it, comes to its end all
/// the same: the last point that is worked out by the angle lies beside the end that is programmed.
TEST(CurveOf, AnArcEndsAtItsEndWhereverTheTipIs) {
    Motion motion;
    motion.shape = ArcShape{.sweep = kPi / 2};
    for (const Vec3& from : {Vec3(10, 0, 0), Vec3(10, 0.01, 0), Vec3(10.01, -0.01, 3)}) {
        const Vec3 to{0, 10, 0};
        const Curve curve = curve_of(motion, from, to);
        EXPECT_EQ(start(curve), from);
        EXPECT_EQ(end(curve), to);
        const Helix& helix = std::get<Helix>(curve);
        EXPECT_LT((position_at_angle(helix, helix.sweep) - to).norm(), 1e-12);
        EXPECT_NEAR(helix.sweep, kPi / 2, 0.0011);  // 0.01 of 10 mm, rad
    }
    // A start that another turn would belong to keeps the sweep that is programmed.
    EXPECT_EQ(std::get<Helix>(curve_of(motion, {0, -10, 0}, {0, 10, 0})).sweep, kPi / 2);
}

}  // namespace
}  // namespace kadr::path::curve_test
