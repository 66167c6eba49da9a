// Registered curves in motion: the plan is that of the same path as arcs or splines, and within the
// limits of the axes at every tick.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "motion/spline_pieces.h"
#include "tests/common/test_curves.h"
#include "tests/motion/support.h"
#include "tests/motion/tick_limits.h"

namespace kadr::motion::test::parametric_motion_test {
namespace {

using kadr::testing::kCycloid;
using kadr::testing::kUnevenCircle;
using kadr::testing::shape_of;

constexpr double kPi = std::numbers::pi;

Command curve_from(const Vec3& start, const path::CurveShape& shape, double feed_mm_min) {
    Command command = line_to(path::end_of(shape, start), feed_mm_min);
    command.become(Op::Parametric);
    command.motion().curve() = shape;
    return command;
}

TickShares shares_of(const machine::Machine& machine, const std::vector<Command>& commands) {
    TickWatch watch(machine, run(machine, commands).segments);
    for (const Setpoint& setpoint : sample(machine, commands)) watch.add(setpoint);
    return watch.shares();
}

TEST(ParametricMotion, FeedIsAlongTheCurve) {
    const auto machine = machine_of();
    const Command half =
        curve_from(Vec3::Zero(), shape_of(kUnevenCircle, 50, kPi), 1200);  // 20 mm/s
    const Motion result = run(machine, {half});
    ASSERT_TRUE(result.diagnostics.all().empty());
    EXPECT_NEAR(result.totals.cutting_length, 50 * kPi, 1e-6);
    EXPECT_NEAR(result.totals.time, 50 * kPi / 20, 0.02);
    const auto setpoints = sample(machine, {half});
    EXPECT_LT((setpoints.back().tip - Vec3(0, 100, 0)).norm(), 1e-9);
    for (const Setpoint& setpoint : setpoints)
        EXPECT_NEAR((setpoint.tip - Vec3(0, 50, 0)).norm(), 50, 1e-8);
}

TEST(ParametricMotion, IsAsFastAsTheSameArc) {
    // The axes limit both: 50 mm of radius at 5000 mm/s² leave some 500 mm/s. The arc has closed
    // forms, the curve samples.
    const Dynamics dynamics{{2000, 2000, 2000}, {5000, 5000, 5000}};
    for (const double jerk : {kUnlimited, 2e5}) {
        Dynamics limited = dynamics;
        limited.jerk = Vec3::Constant(jerk);
        const auto machine = machine_of(limited);
        const double arc = run(machine, {arc_to({0, 100, 0}, {0, 50, 0}, kPi, kFast)}).totals.time;
        const double curve =
            run(machine, {curve_from(Vec3::Zero(), shape_of(kUnevenCircle, 50, kPi), kFast)})
                .totals.time;
        EXPECT_GT(curve, 0.9 * arc) << jerk;
        EXPECT_LT(curve, 1.35 * arc) << jerk;
    }
}

TEST(ParametricMotion, KeepsTheLimitsOfTheAxes) {
    for (const double jerk : {kUnlimited, 1e5}) {
        Dynamics dynamics;
        dynamics.jerk = Vec3::Constant(jerk);
        const auto machine = machine_of(dynamics);
        const path::CurveShape arches = shape_of(kCycloid, 8, 3);
        const path::CurveShape turn = shape_of(kUnevenCircle, 12, 2 * kPi);
        const Command first = curve_from(Vec3::Zero(), arches, kFast);
        const Vec3 middle = path::end_of(arches, Vec3::Zero());
        const TickShares shares =
            shares_of(machine, {first, line_to(middle + Vec3(30, 0, 0), kFast),
                                curve_from(middle + Vec3(30, 0, 0), turn, kFast)});
        EXPECT_LT(shares.velocity, 1.001) << jerk;
        EXPECT_LT(shares.acceleration, 1.001) << jerk;
        if (jerk < kUnlimited) {
            EXPECT_LT(shares.jerk, 1.001);
        }
        EXPECT_GT(shares.acceleration, 0.45) << jerk;  // in the turn its fixed share
    }
}

TEST(ParametricMotion, PiecesAreTheCurve) {
    const path::CurveShape shape = shape_of(kCycloid, 5, 1);
    const path::Parametric whole =
        path::make_parametric(Vec3::Zero(), path::end_of(shape, Vec3::Zero()), shape);
    double at = 0;
    for (const path::Curve& piece : evenly_bent(whole)) {
        EXPECT_LT((path::start(piece) - path::position(whole, at)).norm(), 1e-4);
        at += path::length(piece);
    }
    EXPECT_NEAR(at, 40, 1e-4);  // straight pieces of a thousandth in the cusps
}

}  // namespace
}  // namespace kadr::motion::test::parametric_motion_test
