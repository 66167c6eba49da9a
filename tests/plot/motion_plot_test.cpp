// Curves over time: nothing that the axes are told is lost on its way to the paper.
#include "plot/motion_plot.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace motion_plot_test {

namespace {

using namespace kadr;
using namespace kadr::plot;

constexpr double kTick = 0.001;

machine::Machine one_axis() {
    machine::Machine machine;
    machine.axes.push_back({.name = "X", .axis = Axis::X, .is_rotary = false});
    machine.axes[0].velocity = 100;
    machine.axes[0].acceleration = 2000;
    return machine;
}

motion::Setpoint at(std::size_t tick, double x, std::uint32_t line = 1) {
    motion::Setpoint setpoint;
    setpoint.time = static_cast<double>(tick) * kTick;
    setpoint.axis[0] = x;
    setpoint.line = line;
    return setpoint;
}

double greatest(const MotionTrace& trace, MotionTrace::Quantity quantity) {
    double most = 0;
    for (const MotionTrace::Bin& bin : trace.bins())
        most = std::max(most, bin.axes[quantity][0].greatest);
    return most;
}

TEST(MotionTrace, DerivativesAreDifferencesOfTicks) {
    const machine::Machine machine = one_axis();
    MotionTrace trace(machine, kTick, {});
    // x = t³: 3t², 6t, 6 but for what a difference lags behind.
    for (std::size_t i = 0; i <= 1000; ++i) trace.add(at(i, std::pow(kTick * double(i), 3)));
    const MotionTrace::Bin& last = trace.bins().back();
    EXPECT_NEAR(last.axes[MotionTrace::Position][0].last, 1, 1e-12);
    EXPECT_NEAR(last.axes[MotionTrace::Velocity][0].last, 3, 0.005);
    EXPECT_NEAR(last.axes[MotionTrace::Acceleration][0].last, 6, 0.01);
    EXPECT_NEAR(last.axes[MotionTrace::Jerk][0].last, 6, 0.01);
}

TEST(MotionTrace, KeepsThePeakOfALongRun) {
    const machine::Machine machine = one_axis();
    MotionTrace trace(machine, kTick, {});
    for (std::size_t i = 0; i < 100000; ++i) trace.add(at(i, i < 77777 ? 0 : 0.05));
    EXPECT_LE(trace.bins().size(), 8192u);
    EXPECT_NEAR(greatest(trace, MotionTrace::Velocity), 50, 1e-9);
    EXPECT_NEAR(trace.bins().back().axes[MotionTrace::Position][0].last, 0.05, 1e-12);
}

TEST(MotionTrace, ShowsItsWindowAndItsBlocks) {
    const machine::Machine machine = one_axis();
    MotionTrace trace(machine, kTick, {0.1, 0.2});
    for (std::size_t i = 0; i < 1000; ++i)
        trace.add(at(i, 0, static_cast<std::uint32_t>(1 + i / 60)));
    EXPECT_NEAR(trace.bins().front().time, 0.1, 1e-9);
    EXPECT_NEAR(trace.bins().back().time, 0.2, 1e-9);
    ASSERT_EQ(trace.blocks().size(), 3u);
    EXPECT_EQ(trace.blocks()[0].line, 2u);
    EXPECT_EQ(trace.blocks()[2].line, 4u);
    EXPECT_FALSE(trace.has_too_many_blocks());
    const std::string svg = motion_svg(trace, {"a part", "a control", {}});
    EXPECT_NE(svg.find("X (limit 2000)"), std::string::npos);
    EXPECT_NE(svg.find(">3</text>"), std::string::npos) << "the block's line";
}

/// C on the table below A, as on a trunnion.
machine::Machine trunnion() {
    machine::Machine machine = one_axis();
    for (const Axis axis : {Axis::A, Axis::C})
        machine.axes.push_back(
            {.name = axis == Axis::A ? "A" : "C", .axis = axis, .is_rotary = true});
    for (machine::MachineAxis& axis : machine.axes) {
        axis.lower = -1;
        axis.upper = 2;
        axis.velocity = axis.acceleration = axis.jerk = 1e9;
    }
    machine::Chain chain;
    chain.joints[machine::kR1] = {.is_present = true, .axis = Axis::C};
    chain.joints[machine::kR2] = {
        .is_present = true, .axis = Axis::A, .direction = path::Vec3::UnitX()};
    machine.kinematics = machine::Kinematics{.chain = *machine::prepare(chain)};
    return machine;
}

TEST(MotionTrace, ShowsWhereTheToolIsAtThePole) {
    const machine::Machine machine = trunnion();
    MotionTrace trace(machine, kTick, {});
    // A from -0.1 to 0.1 rad: 0.5 degrees on either side of 0 are 0.0873 of the way.
    for (std::size_t i = 0; i <= 1000; ++i) {
        motion::Setpoint setpoint = at(i, 0.001 * double(i));
        setpoint.axis[1] = -0.1 + 0.0002 * double(i);
        setpoint.axis[2] = 2 * kTick * double(i);  // to its limit
        trace.add(setpoint);
    }
    ASSERT_EQ(trace.poles().size(), 1u);
    EXPECT_NEAR(trace.poles()[0].from, 0.457, 0.001);
    EXPECT_NEAR(trace.poles()[0].to, 0.543, 0.001);
    const std::string svg = motion_svg(trace, {"a part", "a control", {}});
    EXPECT_NE(svg.find("#f9dcd9"), std::string::npos) << "the ground of the pole";
    EXPECT_NE(svg.find("(pole)"), std::string::npos);
    EXPECT_NE(svg.find("Position, mm"), std::string::npos);
    EXPECT_NE(svg.find("Position, deg"), std::string::npos);
    EXPECT_NE(svg.find("Velocity, deg/min"), std::string::npos);
    // Two charts of the speed, and linear and rotary of four quantities; the limit of C is dashed.
    EXPECT_NE(svg.find("stroke-dasharray=\"5 3\""), std::string::npos);
}

TEST(MotionTrace, AMachineWithoutRotaryAxesHasNoPole) {
    const machine::Machine machine = one_axis();
    MotionTrace trace(machine, kTick, {});
    for (std::size_t i = 0; i < 10; ++i) trace.add(at(i, double(i)));
    EXPECT_TRUE(trace.poles().empty());
    const std::string svg = motion_svg(trace, {"a part", "a control", {}});
    EXPECT_EQ(svg.find("deg"), std::string::npos);
    EXPECT_EQ(svg.find("#f9dcd9"), std::string::npos);
}

TEST(MotionTrace, TooManyBlocksAreNotMarked) {
    const machine::Machine machine = one_axis();
    MotionTrace trace(machine, kTick, {});
    for (std::size_t i = 0; i < 5000; ++i) trace.add(at(i, 0, static_cast<std::uint32_t>(i)));
    EXPECT_TRUE(trace.has_too_many_blocks());
    EXPECT_LE(trace.blocks().size(), 400u);
}

}  // namespace

}  // namespace motion_plot_test
