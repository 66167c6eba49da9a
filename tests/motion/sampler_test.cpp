// Sampler: the ticks of known motions.
#include <gtest/gtest.h>

#include "tests/motion/support.h"

namespace kadr::motion::sampler_test {
namespace {

using namespace test;

TEST(Sampler, NothingFromNothing) { EXPECT_TRUE(sample(machine_of(), {}).empty()); }

TEST(Sampler, EveryTickFromRestToRest) {
    // 1 mm with 5000 mm/s²: 2·sqrt(1/5000) = 28.28 ms, so ticks 0 … 29; half way at 14.14 ms.
    const auto setpoints = sample(machine_of(), {line_to({1, 0, 0}, kFast)});
    ASSERT_EQ(setpoints.size(), 30u);
    EXPECT_EQ(setpoints[0].tip, Vec3(0, 0, 0));
    EXPECT_NEAR(setpoints[10].tip[0], 0.5 * 5000 * 0.01 * 0.01, 1e-12);
    EXPECT_NEAR(setpoints[10].feed, 50, 1e-9);
    const double left = 2 * std::sqrt(1.0 / 5000) - 0.02;
    EXPECT_NEAR(setpoints[20].tip[0], 1 - 0.5 * 5000 * left * left, 1e-12);
    EXPECT_EQ(setpoints[29].tip, Vec3(1, 0, 0));
    EXPECT_EQ(setpoints[29].feed, 0);
    EXPECT_EQ(setpoints[29].time, 29 * 0.001);
}

TEST(Sampler, ATickCrossesTheBoundary) {
    // 100 mm/s, so 0.1 mm a tick; blocks of 0.25 mm: every tick but the third of five is a
    // multiple.
    std::vector<Command> commands;
    for (int i = 1; i <= 100; ++i) commands.push_back(line_to({0.25 * i, 0, 0}, 6000));
    const auto setpoints = sample(machine_of(), commands);
    // After 20 ms up to speed (1 mm), equal steps.
    for (std::size_t k = 21; k + 22 < setpoints.size(); ++k) {
        EXPECT_NEAR(setpoints[k + 1].tip[0] - setpoints[k].tip[0], 0.1, 1e-12) << k;
    }
    EXPECT_EQ(setpoints.back().tip, Vec3(25, 0, 0));
}

TEST(Sampler, ManyBlocksInOneTick) {
    // 1 µm blocks at 100 mm/s: a hundred a tick.
    std::vector<Command> commands;
    for (int i = 1; i <= 20000; ++i) commands.push_back(line_to({0.001 * i, 0, 0}, 6000));
    const auto setpoints = sample(machine_of(), commands);
    const double time = 0.02 + 20.0 / 100;
    EXPECT_EQ(setpoints.size(), static_cast<std::size_t>(std::ceil(time / 0.001 - 1e-6)) + 1);
    EXPECT_NEAR(setpoints[100].tip[0] - setpoints[99].tip[0], 0.1, 1e-9);
    EXPECT_EQ(setpoints.back().tip, Vec3(20, 0, 0));
    EXPECT_EQ(setpoints.back().line, 20000u);
}

TEST(Sampler, StandsWhileItDwells) {
    Command dwell = simple(Op::Dwell);
    dwell.dwell().time = 0.01;
    const auto setpoints = sample(machine_of(), {line_to({0, 5, 0}, 6000), dwell});
    EXPECT_EQ(setpoints.back().tip, Vec3(0, 5, 0));
    EXPECT_EQ(setpoints[setpoints.size() - 5].tip, Vec3(0, 5, 0));
    EXPECT_EQ(setpoints[setpoints.size() - 5].line, 2u);
    EXPECT_EQ(setpoints.back().feed, 0);
}

TEST(Sampler, AxesCarryTheTool) {
    Command length = simple(Op::ToolLength);
    length.tool_length().length = 75;
    const auto setpoints = sample(machine_of(), {length, line_to({0, 0, 10}, 6000)});
    EXPECT_NEAR(setpoints.front().tip[2], -75, 1e-12);
    EXPECT_NEAR(setpoints.front().axis[2], 0, 1e-12);
    EXPECT_NEAR(setpoints.back().axis[2], 85, 1e-12);
    EXPECT_EQ(setpoints.back().tip[2], 10);
}

TEST(Sampler, ColumnsFollowTheMachine) {
    auto machine = machine_of();
    std::swap(machine.axes[0], machine.axes[2]);  // Z Y X
    machine.axes.erase(machine.axes.begin() + 1);
    const auto setpoints = sample(machine, {line_to({1, 0, 3}, 6000)});
    EXPECT_EQ(setpoints.back().axis[0], 3);
    EXPECT_EQ(setpoints.back().axis[1], 1);
    EXPECT_EQ(setpoints.back().axis[2], 0);
}

TEST(Sampler, TurnsARotaryAxis) {
    auto machine = machine_of();
    machine::MachineAxis axis;
    axis.name = "B";
    axis.axis = Axis::B;
    axis.is_rotary = true;
    axis.lower = -10;
    axis.upper = 10;
    axis.velocity = 3;
    axis.acceleration = 30;
    machine.axes.push_back(axis);
    Command turn = rapid_to({0, 0, 0});
    turn.motion().to[index(Axis::B)] = 90;
    const auto setpoints = sample(machine, {turn});
    EXPECT_NEAR(setpoints.back().axis[3], std::acos(0.0), 1e-14);
    // π/2 at 3 rad/s with 30 rad/s²: 0.5236 + 0.1 s.
    EXPECT_NEAR(setpoints.back().time, 0.624, 1e-9);
}

}  // namespace
}  // namespace kadr::motion::sampler_test
