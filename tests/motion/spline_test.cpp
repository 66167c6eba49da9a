// Splines in motion: the feed along the curve, the way at every tick, sharp turns, limits of axes.
#include <cmath>

#include <gtest/gtest.h>

#include "motion/spline_pieces.h"
#include "tests/motion/support.h"
#include "tests/motion/tick_limits.h"

namespace kadr::motion::test::spline_test {
namespace {

const Vec3 kEnd(60, 0, 0);
const Vec3 kFirst(10, 40, 0);
const Vec3 kSecond(50, -40, 10);

path::CubicSpan wave() {
    return path::make_spline(Vec3::Zero(), kEnd, {3, {kFirst, kSecond}, {1, 1, 1, 1}});
}

TEST(SplineMotion, FeedIsAlongTheCurve) {
    const auto machine = machine_of();
    const Command command = spline_to(kEnd, kFirst, kSecond, 1200);  // 20 mm/s
    const Motion result = run(machine, {command});
    ASSERT_TRUE(result.diagnostics.all().empty());
    double sum = 0;
    for (const Segment& segment : result.segments) sum += path::length(segment.curve);
    const double length = path::length(wave());
    EXPECT_NEAR(sum, length, 1e-7);
    // At rest at both ends; 20 mm/s are reached in a fraction of a millimetre.
    EXPECT_NEAR(result.totals.time, length / 20, 0.02);
    EXPECT_NEAR(result.totals.cutting_length, length, 1e-7);
    // Between two ticks of one speed the way on the curve is the speed times the tick, to below a
    // thousandth of a micrometre: chords are shorter by what their bend says.
    const auto setpoints = sample(machine, {command});
    const double tick = machine.tick;
    std::size_t compared = 0;
    for (std::size_t i = 1; i < setpoints.size(); ++i) {
        if (setpoints[i].feed != setpoints[i - 1].feed) continue;
        const double chord = (setpoints[i].tip - setpoints[i - 1].tip).norm();
        const double distance = setpoints[i].feed * tick;
        EXPECT_LE(chord, distance + 3e-9);
        EXPECT_GE(chord,
                  distance - 3e-9 - 2 * distance * distance * distance);  // κ²/24 with κ below 7/mm
        ++compared;
    }
    EXPECT_GT(compared, 3000u);
    EXPECT_EQ(setpoints.back().tip, kEnd);
}

TEST(SplineMotion, PiecesAreTheCurve) {
    const path::CubicSpan whole = wave();
    const std::vector<path::Curve> pieces = evenly_bent(whole);
    EXPECT_GT(pieces.size(), 2u);
    EXPECT_LT(pieces.size(), 64u);
    double at = 0;
    for (const path::Curve& piece : pieces) {
        EXPECT_LT((path::start(piece) - path::position(whole, at)).norm(), 1e-8);
        const double length = path::length(piece);
        EXPECT_LT(
            (path::position(piece, length / 3) - path::position(whole, at + length / 3)).norm(),
            1e-8);
        at += length;
    }
    EXPECT_NEAR(at, whole.length, 1e-8);
    EXPECT_EQ(path::end(pieces.back()), kEnd);
    // A straight span is one piece.
    const path::CubicSpan straight = path::make_spline(
        Vec3::Zero(), Vec3(30, 0, 0), {3, {Vec3(10, 0, 0), Vec3(20, 0, 0)}, {1, 1, 1, 1}});
    EXPECT_EQ(evenly_bent(straight).size(), 1u);
}

TEST(SplineMotion, SlowsDownWhereItBends) {
    // An arc of radius 10 by weights: in its middle both axes turn it with all they have, so that
    // v² = √2·A·r.
    const double weight = std::sqrt(0.5);
    Command quarter = line_to(Vec3(10, 10, 0), kFast);
    quarter.become(Op::Spline);
    quarter.motion().spline() = {2, {Vec3(10, 0, 0), Vec3::Zero()}, {1, weight, 1, 1}};
    const Dynamics slow{{1e6, 1e6, 1e6}, {1000, 1000, 1000}};
    const Motion result = run(machine_of(slow), {quarter});
    const double on_arc = std::sqrt(std::numbers::sqrt2 * 1000 * 10);
    for (const Segment& segment : result.segments) {
        EXPECT_LE(segment.profile.peak_speed, on_arc * (1 + 1e-6));
    }
    EXPECT_GT(result.segments[result.segments.size() / 2].profile.peak_speed, 0.8 * on_arc);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_LE(result.totals.max_acceleration[i], 1000 * (1 + 1e-9));
}

TEST(SplineMotion, ACuspIsACorner) {
    // The curve stands in the middle and turns back sharply: it is taken at nearly no speed, and
    // the way is not lost.
    const Command command = spline_to(Vec3(40, 0, 0), Vec3(40, 30, 0), Vec3(0, 30, 0), 60000);
    const auto machine = machine_of();
    const Motion result = run(machine, {command});
    double sum = 0;
    for (const Segment& segment : result.segments) {
        sum += path::length(segment.curve);
        if (&segment == &result.segments.back()) continue;
        const bool is_cusp = (path::end(segment.curve) - Vec3(20, 22.5, 0)).norm() < 0.01;
        EXPECT_LT(segment.profile.exit_speed, is_cusp ? 15 : 1e9);
    }
    EXPECT_NEAR(sum, 61.25, 2e-3);  // x' and y' are linear in each half: by hand
    EXPECT_LT(result.totals.time, 3);
}

/// x(u) = −150·u + 180·u², which turns back at −31.25: no place of it is cut off, and the axis
/// stops there as at an end, within its jerk. A hundredth of a millimetre of height changes
/// neither.
TEST(SplineMotion, ComesToRestWhereItTurnsBack) {
    const auto machine = machine_of({.jerk = {1e5, 1e5, 8e4}});
    for (const double height : {0.0, 1e-5, 1e-2}) {
        const Command command =
            spline_to(Vec3(30, height, 0), Vec3(-50, 0, 0), Vec3(-40, 0, 0), 2000);
        const Motion result = run(machine, {command});
        double least = 0;
        for (const Segment& segment : result.segments)
            least = std::min(least, path::end(segment.curve).x());
        EXPECT_NEAR(least, -31.25, height == 0 ? 1e-9 : 1e-4 * height);
        TickWatch watch(machine, result.segments);
        const std::vector<Setpoint> setpoints = sample(machine, {command});
        for (const Setpoint& setpoint : setpoints) watch.add(setpoint);
        EXPECT_LE(watch.shares().jerk, 1.001) << height;
        for (std::size_t i = 0; i + 3 < setpoints.size(); ++i) {
            const double third = setpoints[i + 3].axis[0] - 3 * setpoints[i + 2].axis[0] +
                                 3 * setpoints[i + 1].axis[0] - setpoints[i].axis[0];
            EXPECT_LE(std::abs(third), 1.001 * 1e5 * std::pow(machine.tick, 3)) << height;
        }
    }
}

TEST(SplineMotion, InverseTimeIsTheTimeOfTheSpan) {
    Command command = spline_to(kEnd, kFirst, kSecond, 6);  // a sixth of a minute
    command.motion().feed_mode = path::FeedMode::InverseTime;
    EXPECT_NEAR(run(machine_of(), {command}).totals.time, 10, 0.02);
}

TEST(SplineMotion, LimitsOfTheMachine) {
    auto machine = machine_of();
    machine.axes[1].upper = 11;  // the wave rises to about 11.5
    const Motion result = run(machine, {spline_to(kEnd, kFirst, kSecond, 1200)});
    ASSERT_EQ(result.diagnostics.all().size(), 1u);
    EXPECT_NE(result.diagnostics.all()[0].message().find('Y'), std::string::npos);
    machine.axes[1].upper = 12;
    EXPECT_TRUE(run(machine, {spline_to(kEnd, kFirst, kSecond, 1200)}).diagnostics.all().empty());
}

}  // namespace
}  // namespace kadr::motion::test::spline_test
