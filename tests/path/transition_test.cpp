// The curve around a corner: its ends, its continuity, and how far it is from the path.
#include "path/transition.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace kadr::path::transition_test {
namespace {

constexpr double pi = std::numbers::pi;

Curve line(const Vec3& from, const Vec3& to) { return make_line(from, to); }

/// Counter-clockwise about `normal`.
Curve helix(const Vec3& from, const Vec3& to, const Vec3& center, const Vec3& normal,
            double sweep) {
    return make_helix(from, to, center, normal, sweep);
}

struct Corner {
    const char* name;
    Curve before;
    Curve behind;
    double distance;
};

std::vector<Corner> corners() {
    const Curve along_x = line({-10, 0, 0}, {0, 0, 0});
    const Vec3 up = Vec3::UnitZ();
    return {
        {"square", along_x, line({0, 0, 0}, {0, 10, 0}), 1},
        {"slight", along_x, line({0, 0, 0}, {10, 0.5, 0}), 3},
        {"nearly back", along_x, line({0, 0, 0}, {-9, 2, 0}), 1},
        {"in space", along_x, line({0, 0, 0}, {2, 3, 6}), 2},
        {"line and arc", along_x, helix({0, 0, 0}, {5, 5, 0}, {5, 0, 0}, -up, pi / 2), 1.5},
        {"tangent arc", along_x, helix({0, 0, 0}, {5, 5, 0}, {0, 5, 0}, up, pi / 2), 1},
        {"arc and line", helix({0, -8, 0}, {0, 0, 0}, {0, -4, 0}, up, pi),
         line({0, 0, 0}, {0, 9, 0}), 1},
        {"turning the other way", helix({-4, -4, 0}, {0, 0, 0}, {-4, 0, 0}, up, pi / 2),
         helix({0, 0, 0}, {4, 4, 0}, {4, 0, 0}, -up, pi / 2), 1},
        {"helix and line", helix({-4, -4, -3}, {0, 0, 0}, {-4, 0, -3}, up, pi / 2),
         line({0, 0, 0}, {5, 0, 0}), 1},
    };
}

double length_before(const Corner& corner) { return length(corner.before); }

Transition around(const Corner& corner) {
    return transition_between(evaluate(corner.before, length_before(corner) - corner.distance),
                              evaluate(corner.behind, corner.distance), corner.distance);
}

TEST(Transition, BeginsAndEndsOnThePathWithItsDirectionAndCurvature) {
    for (const Corner& corner : corners()) {
        SCOPED_TRACE(corner.name);
        const Transition curve = around(corner);
        const CurvePoint from = evaluate(corner.before, length_before(corner) - corner.distance);
        const CurvePoint to = evaluate(corner.behind, corner.distance);
        const CurvePoint first = evaluate(curve[0], 0);
        const CurvePoint last = evaluate(curve[3], curve[3].length);
        EXPECT_LE((first.position - from.position).norm(), 1e-12);
        EXPECT_LE((last.position - to.position).norm(), 1e-12);
        // Of unit length: the curve is joined at the speed of the path.
        EXPECT_LE((first.tangent - from.tangent).norm(), 1e-12);
        EXPECT_LE((last.tangent - to.tangent).norm(), 1e-12);
        // … and without acceleration along it.
        EXPECT_LE((first.curvature - from.curvature).norm(), 1e-9);
        EXPECT_LE((last.curvature - to.curvature).norm(), 1e-9);
        double length = 0;
        for (const Glide& piece : curve) length += piece.length;
        EXPECT_NEAR(length, 2 * corner.distance, 1e-12);
    }
}

TEST(Transition, DerivativesRunOnInside) {
    for (const Corner& corner : corners()) {
        SCOPED_TRACE(corner.name);
        const Transition curve = around(corner);
        for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
            const CurvePoint in = evaluate(curve[i], curve[i].length);
            const CurvePoint out = evaluate(curve[i + 1], 0);
            EXPECT_EQ(in.position, out.position);
            EXPECT_LE((in.tangent - out.tangent).norm(), 1e-12);
            EXPECT_LE((in.curvature - out.curvature).norm(), 1e-9);
        }
    }
}

TEST(Transition, AlongAStraightLineNothingChanges) {
    const Curve before = line({-10, 0, 0}, {0, 0, 0});
    const Curve behind = line({0, 0, 0}, {0.5, 0, 0});
    const Transition curve = transition_between(evaluate(before, 9.5), evaluate(behind, 0.5), 0.5);
    for (const Glide& piece : curve) {
        for (const double share : {0.0, 0.3, 1.0}) {
            const CurvePoint at = evaluate(piece, share * piece.length);
            EXPECT_LE((at.tangent - Vec3::UnitX()).norm(), 1e-12);
            EXPECT_LE(at.curvature.norm(), 1e-12);
        }
    }
}

TEST(Transition, LinesAreTwoRampsAtTheSameTime) {
    // A ramp of seven phases from 1 to rest over the way w takes the time 2·w: 4/5·w of jerk j,
    // 2/5·w without, 4/5·w of jerk. j·(4/5·w)·(6/5·w) = 1 gives j = 25/(24·w²), and the
    // acceleration j·4/5·w = 5/(6·w).
    const double w = 2;
    const Curve before = line({-10, 0, 0}, {0, 0, 0});
    const Curve behind = line({0, 0, 0}, {0, 10, 0});
    const Transition curve = transition_between(evaluate(before, 8), evaluate(behind, 2), w);
    const Vec3 first = third_derivative(curve[0]);
    EXPECT_LE((first - Vec3(-1, 1, 0) * 25 / (24 * w * w)).norm(), 1e-12);
    EXPECT_LE(third_derivative(curve[1]).norm(), 1e-12);
    EXPECT_LE((third_derivative(curve[3]) + first).norm(), 1e-12);
    const Vec3 bend = evaluate(curve[1], 0).curvature;
    EXPECT_LE((bend - Vec3(-1, 1, 0) * 5 / (6 * w)).norm(), 1e-12);
    const Vec3 middle = evaluate(curve[2], 0).tangent;
    EXPECT_LE((middle - Vec3(0.5, 0.5, 0)).norm(), 1e-12);
}

TEST(Glide, PartsAndLengths) {
    const Glide whole{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 1, 0), Vec3(2, 3, 1)}, 3.5};
    for (const auto& [from, to] :
         {std::pair(0.0, 3.5), std::pair(0.0, 1.0), std::pair(1.2, 3.5), std::pair(0.4, 2.9)}) {
        const Glide piece = part(whole, from, to);
        EXPECT_NEAR(piece.length, to - from, 1e-15);
        for (const double share : {0.0, 0.25, 0.8, 1.0}) {
            const CurvePoint a = evaluate(piece, share * piece.length);
            const CurvePoint b = evaluate(whole, from + share * (to - from));
            EXPECT_LE((a.position - b.position).norm(), 1e-12);
            EXPECT_LE((a.tangent - b.tangent).norm(), 1e-12);
            EXPECT_LE((a.curvature - b.curvature).norm(), 1e-12);
        }
        EXPECT_LE((third_derivative(piece) - third_derivative(whole)).norm(), 1e-12);
    }
    double polygon = 0;
    for (int i = 0; i < 10000; ++i) {
        polygon +=
            (position(whole, 3.5 * (i + 1) / 10000.0) - position(whole, 3.5 * i / 10000.0)).norm();
    }
    EXPECT_NEAR(arc_length(whole), polygon, 1e-6);
    EXPECT_EQ(path::length(Curve(whole)), 3.5);
    EXPECT_EQ(arc_length(Curve(whole)), arc_length(whole));
}

TEST(Transition, DeviationIsTheGreatestOfManyPoints) {
    for (const Corner& corner : corners()) {
        SCOPED_TRACE(corner.name);
        const Transition curve = around(corner);
        // Both as 2000 points; the nearest pairs are known to the square of their distance.
        std::vector<Vec3> path;
        for (int i = 0; i <= 2000; ++i) {
            const double s = corner.distance * (i / 1000.0 - 1);
            path.push_back(s < 0 ? position(corner.before, length_before(corner) + s)
                                 : position(corner.behind, s));
        }
        const Vec3 tip = position(corner.behind, 0);
        double greatest = 0;
        double nearest = (start(curve[0]) - tip).norm();
        for (int i = 0; i <= 400; ++i) {
            const auto k = static_cast<std::size_t>(std::min(3, i / 100));
            const double u = i / 100.0 - static_cast<double>(k);
            const Vec3 point = position(curve[k], u * curve[k].length);
            double best = (path[0] - point).norm();
            for (const Vec3& at : path) best = std::min(best, (at - point).norm());
            greatest = std::max(greatest, best);
            nearest = std::min(nearest, (tip - point).norm());
        }
        const double expected = std::max(greatest, nearest);
        const double length = length_before(corner);
        const double found = deviation(curve, {corner.before, length - corner.distance, length},
                                       {corner.behind, 0, corner.distance});
        EXPECT_NEAR(found, expected, 0.02 * expected + 2e-6);
        EXPECT_GT(expected, 0);
    }
}

TEST(Transition, CornersOfLinesGrowWithTheWay) {
    // From the middle of the ramp to its end, 5/4 of its first phase τ: (1/6 + 1/8 + 1/32)·j·τ³ of
    // 15/8·j·τ³ = w, along both lines; 31/180·√2 of the way.
    const Curve before = line({-10, 0, 0}, {0, 0, 0});
    const Curve behind = line({0, 0, 0}, {0, 10, 0});
    double first = 0;
    for (const double distance : {0.001, 0.1, 1.0, 5.0}) {
        const Transition curve = transition_between(evaluate(before, 10 - distance),
                                                    evaluate(behind, distance), distance);
        const Vec3 middle = end(curve[1]);
        EXPECT_NEAR(middle[0], -middle[1], 1e-12);
        const double share =
            deviation(curve, {before, 10 - distance, 10}, {behind, 0, distance}) / distance;
        if (first == 0) first = share;
        EXPECT_NEAR(share, first, 1e-9);
        EXPECT_NEAR(share, middle.norm() / distance, 1e-9);
    }
    EXPECT_NEAR(first, 31.0 / 180 * std::sqrt(2.0), 1e-12);
}

}  // namespace
}  // namespace kadr::path::transition_test
