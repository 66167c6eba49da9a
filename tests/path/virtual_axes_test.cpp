// Virtual coordinates: real places and back, the turns of the rotary axis, and where a path meets
// the centre of a face.
#include "path/virtual_axes.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "path/polar_passages.h"

namespace kadr::path::virtual_axes_test {
namespace {

constexpr double kPi = std::numbers::pi;

VirtualAxes face() {
    VirtualAxes axes;
    axes.kind = VirtualKind::Polar;
    return axes;
}

VirtualAxes any_axes() {
    const auto number = [](int most) { return *rc::gen::inRange(-most, most + 1) / 16.0; };
    VirtualAxes axes;
    axes.kind = *rc::gen::element(VirtualKind::Polar, VirtualKind::Cylinder, VirtualKind::Inclined);
    axes.side = *rc::gen::element<std::int8_t>(1, -1);
    axes.sign = *rc::gen::element<std::int8_t>(1, -1);
    axes.size = axes.kind == VirtualKind::Inclined ? number(20) : 0.5 + std::abs(number(800));
    axes.zero = number(100);
    axes.center_x = number(1000);
    axes.center_y = number(1000);
    axes.standing = number(1000);
    return axes;
}

RC_GTEST_PROP(VirtualPlaces, RealPlaceLeadsBack, ()) {
    const VirtualAxes axes = any_axes();
    const auto number = [] { return *rc::gen::inRange(-8000, 8001) / 16.0; };
    const double x = number(), y = axes.kind == VirtualKind::Inclined ? 0 : number();
    const Vec3 tip(x, y, number());
    const double near = number();
    const double rotary = rotary_at(axes, tip, near);
    if (axes.kind == VirtualKind::Polar) {
        RC_ASSERT(std::abs(rotary - near) <= kPi + 1e-9);
    }
    const Vec3 back = virtual_position(axes, real_position(axes, tip), rotary);
    RC_ASSERT((back - tip).norm() < 1e-9);
}

TEST(VirtualPlaces, FaceByHand) {
    // (3, 4): radius 5 at atan2(4, 3) = 53.13°; on the other side X is negative and C half a turn
    // on.
    const Vec3 tip(3, 4, -2);
    const double angle = std::atan2(4.0, 3.0);
    VirtualAxes axes = face();
    EXPECT_LT((real_position(axes, tip) - Vec3(5, 0, -2)).norm(), 1e-12);
    EXPECT_NEAR(rotary_at(axes, tip, 0), angle, 1e-12);
    EXPECT_NEAR(rotary_at(axes, tip, 7), angle + 2 * kPi, 1e-12);
    axes.side = -1;
    EXPECT_LT((real_position(axes, tip) - Vec3(-5, 0, -2)).norm(), 1e-12);
    EXPECT_NEAR(rotary_at(axes, tip, 0), angle - kPi, 1e-12);
    axes.side = 1;
    axes.sign = -1;
    axes.zero = 0.5;
    EXPECT_NEAR(rotary_at(axes, tip, 0), 0.5 - angle, 1e-12);
}

TEST(PolarPassages, CurvesThroughTheCentreAreFoundAndOthersNot) {
    const VirtualAxes axes = face();
    const Curve through = make_line({10, 20, 0}, {-5, -10, 3});
    const std::vector<double> found = pole_passages(axes, through);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0], length(through) * 2 / 3, 1e-9);
    EXPECT_TRUE(pole_passages(axes, make_line({10, 1e-4, 0}, {-10, 1e-4, 0})).empty());
    EXPECT_TRUE(pole_passages(axes, make_line({0, 0, 0}, {0, 0, -10})).empty());
    EXPECT_TRUE(pole_passages(axes, make_line({0, 0, 0}, {10, 0, 0})).empty());
    // A circle of 10 about (10, 0), begun opposite to the centre, goes through it after half a
    // turn.
    const Curve circle = make_helix({20, 0, 0}, {20, 0, 0}, {10, 0, 0}, Vec3::UnitZ(), 2 * kPi);
    const std::vector<double> on_circle = pole_passages(axes, circle);
    ASSERT_EQ(on_circle.size(), 1u);
    EXPECT_NEAR(on_circle[0], 10 * kPi, 1e-6);
}

TEST(PolarPassages, HalfATurnInTheCentreGoesBackTowardsZero) {
    const VirtualAxes axes = face();
    const Curve leg = make_line({0, 0, 0}, {-10, 0, 0});
    EXPECT_NEAR(rotary_to_leave(axes, leg, 0), kPi, 1e-12);
    EXPECT_NEAR(rotary_to_leave(axes, leg, 2 * kPi), kPi, 1e-12);
    EXPECT_NEAR(rotary_to_leave(axes, leg, -2 * kPi), -kPi, 1e-12);
    EXPECT_NEAR(rotary_to_leave(axes, make_line({0, 0, 0}, {0, 5, 0}), 0), kPi / 2, 1e-12);
    EXPECT_EQ(rotary_to_leave(axes, make_line({0, 0, 0}, {0, 0, 5}), 1.25), 1.25);
}

TEST(PolarPassages, RotaryAxisCountsTurns) {
    const VirtualAxes axes = face();
    const Curve around = make_helix({10, 0, 0}, {10, 0, -3}, {0, 0, 0}, Vec3::UnitZ(), 6 * kPi);
    EXPECT_NEAR(rotary_behind(axes, around, 0), 6 * kPi, 1e-9);
    // A circle that leaves the centre outside comes back to where it began.
    const Curve beside = make_helix({25, 0, 0}, {25, 0, 0}, {15, 0, 0}, -Vec3::UnitZ(), 2 * kPi);
    EXPECT_NEAR(rotary_behind(axes, beside, 0.0), 0, 1e-9);
    // One that passes it closely on the far side goes around it, the other way round.
    const Curve close = make_helix({20, 0, 0}, {20, 0, 0}, {9.999, 0, 0}, -Vec3::UnitZ(), 2 * kPi);
    EXPECT_NEAR(rotary_behind(axes, close, 0.0), -2 * kPi, 1e-9);
}

}  // namespace
}  // namespace kadr::path::virtual_axes_test
