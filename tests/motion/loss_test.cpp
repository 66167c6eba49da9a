// What keeps pieces below their feed, and what it costs, where the answer is known.
#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/motion/support.h"

namespace kadr::motion::test::loss_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAcceleration = 1000;  // mm/s²

machine::Machine machine_with(double jerk, const Vec3& velocity = {1000, 1000, 1000}) {
    return machine_of({velocity, Vec3::Constant(kAcceleration), Vec3::Constant(jerk)});
}

struct Losses {
    std::map<LossReason, double> by_reason;
    std::map<std::uint32_t, double> by_line;
    double all = 0;
    double time = 0;      // of the motion
    double at_feeds = 0;  // at the feeds that are asked for
};

Losses losses_of(const machine::Machine& machine, std::vector<Command> commands,
                 PlannerOptions options = {}) {
    std::uint32_t line = 0;
    for (Command& command : commands) command.line = ++line;
    Losses losses;
    options.report_loss = [&](const SpeedLoss& loss) {
        EXPECT_GT(loss.time, 0);
        losses.by_reason[loss.reason] += loss.time;
        losses.by_line[loss.line] += loss.time;
        losses.all += loss.time;
    };
    const Motion motion = run(machine, commands, options);
    for (const Segment& segment : motion.segments) {
        if (!is_motion(segment.kind)) continue;
        losses.time += segment.duration;
        losses.at_feeds += path::length(segment.curve) / segment.feed;
    }
    return losses;
}

/// Nothing but these.
void expect_only(const Losses& losses, std::map<LossReason, double> expected, double tolerance) {
    for (const auto& [reason, time] : losses.by_reason) {
        EXPECT_NEAR(time, expected[reason], tolerance) << reason_name(reason);
        expected.erase(reason);
    }
    for (const auto& [reason, time] : expected) EXPECT_EQ(time, 0) << reason_name(reason);
    EXPECT_NEAR(losses.all, losses.time - losses.at_feeds, 1e-9);
}

TEST(Losses, ALongLineLosesItsRamps) {
    // A ramp to v takes v/a over v²/2a, which at v takes half of that: 2 · v/2a.
    const double v = 100;
    expect_only(losses_of(machine_with(kUnlimited), {line_to({200, 0, 0}, v * 60)}),
                {{LossReason::Stop, v / kAcceleration}}, 1e-9);
}

TEST(Losses, AShortLineNeverReachesItsFeed) {
    // 2·√(L/a) instead of L/v.
    const double length = 2;
    expect_only(losses_of(machine_with(kUnlimited), {line_to({length, 0, 0}, 6000)}),
                {{LossReason::Stop, 2 * std::sqrt(length / kAcceleration) - length / 100}}, 1e-9);
}

TEST(Losses, AnAxisIsTooSlow) {
    // Along (3, 4)/5 with Y up to 40 mm/s the path goes at 50 instead of 100.
    const auto machine = machine_with(kUnlimited, {1000, 40, 1000});
    const double along = kAcceleration / 0.8;  // Y has the greater part
    expect_only(
        losses_of(machine, {line_to({60, 80, 0}, 6000)}),
        {{LossReason::AxisVelocity, 100.0 / 50 - 100.0 / 100}, {LossReason::Stop, 50 / along}},
        1e-9);
}

TEST(Losses, TheMachineHasAGreatestFeed) {
    machine::Machine machine = machine_with(kUnlimited);
    machine.max_feed = 25;
    const Losses losses = losses_of(machine, {line_to({100, 0, 0}, 6000)});
    EXPECT_NEAR(losses.by_reason.at(LossReason::MachineFeed), 100.0 / 25 - 100.0 / 100, 1e-9);
    EXPECT_NEAR(losses.by_reason.at(LossReason::Stop), 25 / kAcceleration, 1e-9);
    // An override that asks for less is no loss.
    PlannerOptions slow;
    slow.feed_override = 0.2;
    EXPECT_FALSE(losses_of(machine, {line_to({100, 0, 0}, 6000)}, slow)
                     .by_reason.contains(LossReason::MachineFeed));
}

TEST(Losses, ACornerCostsTheRampsOnBothSides) {
    const double v = 5;
    const machine::Machine machine = machine_with(kUnlimited);
    const std::vector<Command> corner = {line_to({100, 0, 0}, v * 60),
                                         line_to({100, 100, 0}, v * 60)};
    const Motion motion = run(machine, corner);
    // On both sides of the corner a piece of its own, the way of a tick of it, where the ramp has a
    // fiftieth of the acceleration.
    ASSERT_EQ(motion.segments.size(), 4u);
    const double slow = motion.segments[2].profile.entry_speed;
    const double near = motion.segments[2].profile.exit_speed;
    ASSERT_GT(slow, 0);
    ASSERT_LT(slow, 0.5 * v);
    const double a = motion.segments[0].profile.deceleration;
    // From v down to the speed w of that piece, and on to the corner's u: (v − w)/a + (w − u)/b
    // over (v² − w²)/2a + (w² − u²)/2b.
    const double b = motion.segments[2].profile.acceleration;
    const double ramp = (v - near) / a + (near - slow) / b -
                        ((v * v - near * near) / a + (near * near - slow * slow) / b) / (2 * v);
    const Losses losses = losses_of(machine, corner);
    expect_only(losses, {{LossReason::Corner, 2 * ramp}, {LossReason::Stop, v / a}}, 1e-6);
    EXPECT_NEAR(losses.by_line.at(1), ramp + v / (2 * a), 1e-6);
}

TEST(Losses, ARestAtACornerIsTheCorners) {
    const double v = 100;
    const Losses losses = losses_of(machine_with(kUnlimited),
                                    {line_to({100, 0, 0}, v * 60), line_to({100, 100, 0}, v * 60)});
    const double ramp = v / (2 * kAcceleration);
    expect_only(losses, {{LossReason::Corner, 2 * ramp}, {LossReason::Stop, 2 * ramp}}, 1e-9);
}

TEST(Losses, ARampOverManyBlocksHasTheReasonOfItsEnd) {
    // A millimetre a block, straight on, then a corner: 100 mm/s are braked over five of them.
    std::vector<Command> commands;
    for (int i = 1; i <= 100; ++i) commands.push_back(line_to({double(i), 0, 0}, 6000));
    commands.push_back(line_to({100, 100, 0}, 6000));
    const Losses losses = losses_of(machine_with(kUnlimited), commands);
    EXPECT_EQ(losses.by_reason.size(), 2u);
    EXPECT_NEAR(losses.all, losses.time - losses.at_feeds, 1e-9);
    EXPECT_GT(losses.by_line.at(97), 0);
    EXPECT_GT(losses.by_line.at(100), losses.by_line.at(97));
    EXPECT_FALSE(losses.by_line.contains(50));
}

TEST(Losses, ABlockBesideASlowerOne) {
    const Losses losses = losses_of(machine_with(kUnlimited),
                                    {line_to({100, 0, 0}, 6000), line_to({200, 0, 0}, 1200)});
    // From 100 to 20 mm/s; at rest at both ends.
    const double a = kAcceleration;
    expect_only(losses,
                {{LossReason::SlowerPiece, 80 / a - (100 * 100 - 20 * 20) / (2 * a * 100)},
                 {LossReason::Stop, 100 / (2 * a) + 20 / (2 * a)}},
                1e-9);
}

TEST(Losses, ABendTakesTheAccelerationOfTheAxes) {
    const machine::Machine machine = machine_with(kUnlimited);
    const Losses losses =
        losses_of(machine, {line_to({50, 0, 0}, 6000), arc_to({50, 10, 0}, {50, 5, 0}, kPi, 6000),
                            line_to({0, 10, 0}, 6000)});
    // On a radius of 5 mm the axes turn at √(a·r) = 71 mm/s and a little more.
    const double length = 5 * kPi;
    const double most = length / std::sqrt(0.8 * kAcceleration * 5) - length / 100;
    EXPECT_GT(losses.by_reason.at(LossReason::Curvature), 0.5 * most);
    EXPECT_LT(losses.by_reason.at(LossReason::Curvature), 1.5 * most);
    EXPECT_FALSE(losses.by_reason.contains(LossReason::Corner));
    EXPECT_NEAR(losses.all, losses.time - losses.at_feeds, 1e-6);
}

TEST(Losses, TheJerkOfRampsIsTold) {
    // A ramp with jerk takes v/a + a/j over half of that way: it adds a/2j, at both ends.
    const double v = 100;
    const double jerk = 50000;
    expect_only(losses_of(machine_with(jerk), {line_to({200, 0, 0}, v * 60)}),
                {{LossReason::Stop, v / kAcceleration}, {LossReason::Jerk, kAcceleration / jerk}},
                1e-9);
}

TEST(Losses, TheJerkOfABend) {
    // v³/r² = 0.4·j on a radius of 5 mm: at 5000 mm/s³ slower than √(a·r).
    const double jerk = 5000;
    const Losses losses =
        losses_of(machine_with(jerk), {arc_to({0, 100, 0}, {0, 50, 0}, kPi, 12000)});
    const double on_arc = std::cbrt(0.4 * jerk * 50 * 50);
    const double length = 50 * kPi;
    EXPECT_NEAR(losses.by_reason.at(LossReason::CurveJerk), length / on_arc - length / 200, 1e-6);
    EXPECT_FALSE(losses.by_reason.contains(LossReason::Curvature));
    EXPECT_NEAR(losses.all, losses.time - losses.at_feeds, 1e-9);
}

TEST(Losses, RapidsAskForWhatTheAxesCan) {
    // Up to 1000 mm/s and down again, v/2a each; an axis' velocity is what a rapid asks for.
    expect_only(losses_of(machine_with(kUnlimited), {rapid_to({2000, 0, 0})}),
                {{LossReason::Stop, 1000 / kAcceleration}}, 1e-9);
}

}  // namespace
}  // namespace kadr::motion::test::loss_test
