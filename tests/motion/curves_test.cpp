// Curves of programs in motion: polynomials of degree five, involutes, threads whose pitch changes.
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "tests/motion/support.h"
#include "tests/motion/tick_limits.h"

namespace kadr::motion::test::curves_test {
namespace {

Command quintic_to(const Vec3& to, double feed) {
    Command command = line_to(to, feed);
    command.become(Op::Spline);
    command.motion().spline().degree = 5;
    command.motion().spline().inner = {Vec3(20, 0, 0), Vec3(30, 40, 5), Vec3(50, -30, 0),
                                       Vec3(70, 10, 0)};
    return command;
}

/// Unwinding from t = 1 to t = 4 about the origin, base radius 10.
Vec3 drawn(double t) {
    return 10 * Vec3(std::cos(t) + t * std::sin(t), std::sin(t) - t * std::cos(t), 0);
}
Command involute_to(double t, double feed) {
    Command command = line_to(drawn(t), feed);
    command.become(Op::Involute);
    command.motion().involute().base_radius = 10;
    return command;
}

const Dynamics kJerky{{500, 500, 400}, {5000, 5000, 4000}, Vec3(1e5, 1e5, 8e4)};

TEST(CurveMotion, KeepsFeedPathAndLimits) {
    for (const Dynamics& dynamics : {Dynamics{}, kJerky}) {
        const auto machine = machine_of(dynamics);
        for (const double feed : {600.0, 30000.0}) {
            const std::vector<std::vector<Command>> programs = {
                {quintic_to(Vec3(90, 20, 0), feed)},
                {rapid_to(drawn(1)), involute_to(4, feed),
                 line_to(drawn(4) + Vec3(5, 5, 0), feed)}};
            for (const auto& program : programs) {
                const Motion result = run(machine, program);
                ASSERT_TRUE(result.diagnostics.all().empty());
                const auto setpoints = sample(machine, program);
                TickWatch watch(machine, result.segments);
                for (const Setpoint& setpoint : setpoints) watch.add(setpoint);
                EXPECT_LE(watch.shares().velocity, 1.001);
                EXPECT_LE(watch.shares().acceleration, 1.001);
                if (std::isfinite(dynamics.jerk[0])) {
                    EXPECT_LE(watch.shares().jerk, 1.001);
                }
                Vec3 end;
                for (int k = 0; k < 3; ++k)
                    end[k] = program.back().motion().to[static_cast<std::size_t>(k)];
                EXPECT_EQ(setpoints.back().tip, end);
            }
        }
    }
}

TEST(CurveMotion, InvoluteTakesItsLengthAtTheFeed) {
    // s = r·(16 − 1)/2 = 75 mm, at 10 mm/s.
    const auto machine = machine_of();
    const Motion result = run(machine, {rapid_to(drawn(1)), involute_to(4, 600)});
    EXPECT_NEAR(result.totals.cutting_length, 75, 1e-8);
    EXPECT_NEAR(result.totals.cutting_time, 7.5, 0.01);
    for (const Setpoint& setpoint : sample(machine, {rapid_to(drawn(1)), involute_to(4, 600)})) {
        if (setpoint.line != 2) continue;
        // On the curve: distance and angle about the centre belong together.
        const double t = std::sqrt(std::max(0.0, setpoint.tip.squaredNorm() / 100 - 1));
        EXPECT_LT((setpoint.tip - drawn(t)).norm(), 1e-8);
    }
}

/// A, without end; velocity, acceleration and jerk.
machine::MachineAxis rotary_axis(const Vec3& limits) {
    machine::MachineAxis axis;
    axis.name = "A";
    axis.axis = Axis::A;
    axis.is_rotary = true;
    axis.lower = -kUnlimited;
    axis.upper = kUnlimited;
    axis.velocity = limits[0];
    axis.acceleration = limits[1];
    axis.jerk = limits[2];
    return axis;
}

TEST(CurveMotion, FollowersGoOnFromStretchToStretch) {
    // An involute is planned in stretches; a rotary axis beside it turns evenly over all of them.
    auto machine = machine_of();
    machine.axes.push_back(rotary_axis({10, 100, kUnlimited}));
    Command bent = involute_to(4, 600);
    bent.motion().moved |= bit(Axis::A);
    bent.motion().to[index(Axis::A)] = 30;
    const std::vector<Command> program = {rapid_to(drawn(1)), bent};
    const double degree = std::numbers::pi / 180;
    const double rate = 30 * degree / 75;  // rad/mm, on s = r·(16 − 1)/2 = 75 mm
    double reached = 0;
    std::size_t stretches = 0;
    for (const Segment& segment : run(machine, program).segments) {
        if (segment.line != 2) continue;
        const double before = std::exchange(reached, reached + path::length(segment.curve));
        EXPECT_NEAR(segment.follower_start[0], before * rate, 1e-9);
        ++stretches;
    }
    EXPECT_GT(stretches, 1);
    const auto setpoints = sample(machine, program);
    EXPECT_NEAR(setpoints.back().axis[3], 30 * degree, 1e-12);
    for (std::size_t i = 1; i < setpoints.size(); ++i) {
        // 10 mm/s of feed in a tick of 1 ms, up to the rounding
        EXPECT_LT(std::abs(setpoints[i].axis[3] - setpoints[i - 1].axis[3]), 0.01 * rate + 1e-9);
    }
}

TEST(CurveMotion, FollowersKeepTheirLimits) {
    // Three turns of a rotary axis beside the involute: it sets the pace, with each of its limits.
    for (const double jerk : {kUnlimited, 300.0}) {
        auto machine = machine_of(std::isfinite(jerk) ? kJerky : Dynamics{});
        machine.axes.push_back(rotary_axis({4, 30, jerk}));
        Command bent = involute_to(4, 30000);
        bent.motion().moved |= bit(Axis::A);
        bent.motion().to[index(Axis::A)] = 1080;
        const std::vector<Command> program = {rapid_to(drawn(1)), bent};
        const Motion result = run(machine, program);
        // 6π rad at 4 rad/s at least
        EXPECT_GT(result.totals.cutting_time, 6 * std::numbers::pi / 4);
        TickWatch watch(machine, result.segments);
        for (const Setpoint& setpoint : sample(machine, program)) watch.add(setpoint);
        EXPECT_LE(watch.shares().velocity, 1.001);
        EXPECT_LE(watch.shares().acceleration, 1.001);
        if (std::isfinite(jerk)) {
            EXPECT_LE(watch.shares().jerk, 1.001);
        }
    }
}

// ------------------------------------------------------------------------------ threads

Command thread_to(double z, double pitch, double change) {
    Command command = line_to(Vec3(0, 0, z), pitch);
    command.become(Op::Thread);
    command.motion().feed_mode = path::FeedMode::PerRevolution;
    command.motion().thread().pitch_change = change;
    return command;
}

/// Greatest distance from where the spindle wants the axis, once it has caught up with it.
double gear_error(const machine::Machine& machine, double length, double pitch, double change) {
    constexpr double kTurns = 10;  // 1/s
    const std::vector<Command> program = {spindle_on(60 * kTurns),
                                          thread_to(-length, pitch, change)};
    double error = 0;
    double early = -1;
    for (const Setpoint& setpoint : sample(machine, program)) {
        const double s = -setpoint.tip.z();
        // Away from the ramps at both ends.
        if (setpoint.line != 2 || s < 0.05 * length || s > 0.95 * length) continue;
        // p² = p0² + 2·k·s, and (p − p0)/k turns are made.
        const double now = std::sqrt(pitch * pitch + 2 * change * s);
        const double turns = (now - pitch) / change;
        const double lead = turns - kTurns * setpoint.time;
        if (early == -1) early = lead;
        error = std::max(error, std::abs(lead - early) * now);
        EXPECT_NEAR(setpoint.feed, kTurns * now, 1e-6 * now);
    }
    EXPECT_NE(early, -1);
    return error;
}

TEST(VaryingThread, StaysGearedToTheSpindle) {
    for (const Dynamics& dynamics : {Dynamics{}, kJerky}) {
        const auto machine = machine_of(dynamics);
        EXPECT_LT(gear_error(machine, 30, 1, 0.2), 1e-6);
        EXPECT_LT(gear_error(machine, 30, 4, -0.2), 1e-6);
        EXPECT_LT(gear_error(machine, 200, 2, 0.01), 1e-6);
    }
}

TEST(VaryingThread, TakesTheTurnsOfItsPitches) {
    // From 1 to √(1 + 2·0.2·30) = 3.6056 by 0.2 a turn: 13.03 turns at 10 a second.
    const auto machine = machine_of(kJerky);
    const Motion result = run(machine, {spindle_on(600), thread_to(-30, 1, 0.2)});
    EXPECT_TRUE(result.diagnostics.all().empty());
    // Beside them half of a ramp at each end: from 36 mm/s 2·√(36/8e4) = 42 ms, from 10 mm/s 22 ms.
    EXPECT_NEAR(result.totals.time, (std::sqrt(13.0) - 1) / 0.2 / 10 + (0.042 + 0.022) / 2, 0.002);
    // What setpoints show of an acceleration of k·n² that begins at once.
    EXPECT_TRUE(std::isfinite(result.totals.max_jerk[2]));
    EXPECT_LE(result.totals.max_acceleration[2], 4000 * 1.001);
}

TEST(VaryingThread, TooFastForTheAxisAtItsEnd) {
    auto machine = machine_of(kJerky);
    machine.axes[2].velocity = 30;  // 3.6 mm/rev at 10 a second are 36 mm/s
    const Motion result = run(machine, {spindle_on(600), thread_to(-30, 1, 0.2)});
    ASSERT_EQ(result.diagnostics.all().size(), 1u);
    EXPECT_TRUE(result.alarmed);
}

TEST(VaryingThread, ShorterThanItsRamps) {
    const auto machine = machine_of(kJerky);
    const Motion result = run(machine, {spindle_on(3000), thread_to(-0.5, 3, 0.2)});
    EXPECT_TRUE(result.diagnostics.all().empty());
    EXPECT_NEAR(result.totals.cutting_length, 0.5, 1e-9);
}

}  // namespace
}  // namespace kadr::motion::test::curves_test
