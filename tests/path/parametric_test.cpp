// Curves of registered kinds: length, points at an arc length, parts, bounds, the registry.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "path/curve.h"
#include "tests/common/test_curves.h"

namespace kadr::path::parametric_test {
namespace {

using kadr::testing::kCycloid;
using kadr::testing::kUnevenCircle;
using kadr::testing::shape_of;

constexpr double kPi = std::numbers::pi;
const Vec3 kStart(3, -2, 5);

/// A half turn of radius 10: the parameter runs to π, and so does the angle.
Parametric half_circle() {
    const CurveShape shape = shape_of(kUnevenCircle, 10, kPi);
    return make_parametric(kStart, end_of(shape, kStart), shape);
}

TEST(Parametric, HasTheLengthOfItsArc) {
    const Parametric curve = half_circle();
    EXPECT_NEAR(curve.length, 10 * kPi, 1e-9);
    EXPECT_LT((curve.end - (kStart + Vec3(0, 20, 0))).norm(), 1e-12);
    // An arch of a cycloid is 8·r long; the second one begins with a cusp in the middle.
    const CurveShape shape = shape_of(kCycloid, 2, 2);
    EXPECT_NEAR(make_parametric(kStart, end_of(shape, kStart), shape).length, 32, 1e-7);
}

TEST(Parametric, IsWalkedByArcLength) {
    const Parametric curve = half_circle();
    const Vec3 center = kStart + Vec3(0, 10, 0);
    for (int i = 0; i <= 1000; ++i) {
        const double s = curve.length * i / 1000;
        const double angle = s / 10;
        const CurvePoint point = evaluate(curve, s);
        const Vec3 out(std::sin(angle), -std::cos(angle), 0);
        EXPECT_LT((point.position - (center + 10 * out)).norm(), 2e-9) << s;
        EXPECT_LT((point.tangent - Vec3(std::cos(angle), std::sin(angle), 0)).norm(), 1e-9);
        EXPECT_LT((point.curvature + 0.1 * out).norm(), 1e-9);
    }
    EXPECT_EQ(position(curve, -1), kStart);
    EXPECT_EQ(position(curve, curve.length), curve.end);
}

// The speed by the parameter has a kink in a cusp, which quadrature across it may look past: places
// a thousandth of a millimetre apart were up to 0.8 µm farther from each other.
TEST(Parametric, HasNoGapsBesideACusp) {
    const CurveShape shape = shape_of(kCycloid, 8, 3);
    const Parametric curve = make_parametric(kStart, end_of(shape, kStart), shape);
    constexpr double kStep = 1e-5;
    Vec3 before = position(curve, 63.9);
    for (int i = 1; i <= 20000; ++i) {
        const Vec3 here = position(curve, 63.9 + kStep * i);
        ASSERT_LT((here - before).norm(), kStep + 2e-9) << i;
        before = here;
    }
}

TEST(Parametric, PartsAreTheCurve) {
    const Curve whole = half_circle();
    const Curve middle = part(whole, 4, 20);
    EXPECT_NEAR(length(middle), 16, 1e-8);
    for (const double s : {0.0, 1.0, 7.5, 16.0})
        EXPECT_LT((position(middle, s) - position(whole, 4 + s)).norm(), 1e-8) << s;
    const auto [before, behind] = split(half_circle(), 0.3);
    EXPECT_NEAR(before.length + behind.length, length(whole), 1e-8);
    EXPECT_EQ(before.end, behind.start);
    EXPECT_LT((position(behind, 2) - position(whole, before.length + 2)).norm(), 1e-8);
}

TEST(Parametric, LiesWhereTheFrameSays) {
    // Mirrored in x and twice as large, in the plane Y-Z.
    CurveShape shape = shape_of(kUnevenCircle, 10, kPi);
    shape.linear << 0, 0, 2, -2, 0, 0, 0, 2, 0;
    const Parametric curve = make_parametric(kStart, end_of(shape, kStart), shape);
    EXPECT_NEAR(curve.length, 20 * kPi, 1e-8);
    EXPECT_LT((curve.end - (kStart + Vec3(0, 0, 40))).norm(), 1e-12);
    EXPECT_LT((evaluate(curve, 0).tangent - Vec3(0, -1, 0)).norm(), 1e-12);
}

TEST(Parametric, BoundsHoldIt) {
    const Parametric curve = half_circle();
    const Box box = bounds(Curve(curve));
    EXPECT_GE(box.upper.x(), 13.0);
    EXPECT_LT(box.upper.x(), 13.0 + 0.01);
    EXPECT_LE(box.lower.y(), -2.0);
    EXPECT_GT(box.lower.y(), -2.0 - 0.01);
    EXPECT_NEAR(box.upper.y(), 18, 0.01);
    EXPECT_EQ(box.lower.z(), 5.0);
}

TEST(Parametric, StandsInACuspAndGoesOn) {
    const CurveShape shape = shape_of(kCycloid, 1, 2);
    const Parametric curve = make_parametric(kStart, end_of(shape, kStart), shape);
    EXPECT_LT((position(curve, 8) - (kStart + Vec3(2 * kPi, 0, 0))).norm(), 1e-6);
    EXPECT_NEAR(curvature_at(curve, 0).tangent.y(), 1, 1e-3);
    EXPECT_NEAR(curvature_at(curve, 1).tangent.y(), -1, 1e-3);
}

TEST(CurveRegistry, FindsAKindByItsName) {
    EXPECT_EQ(find_curve("uneven_circle"), nullptr);
    const CurveRegistration first(kUnevenCircle);
    const CurveRegistration second(kCycloid);
    EXPECT_EQ(find_curve("uneven_circle"), &kUnevenCircle);
    EXPECT_EQ(find_curve("Cycloid"), nullptr);
    EXPECT_EQ(curve_names(), (std::vector<std::string_view>{"cycloid", "uneven_circle"}));
}

}  // namespace
}  // namespace kadr::path::parametric_test
