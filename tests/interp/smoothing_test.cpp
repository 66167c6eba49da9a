// Rounded corners and compressed lines as the commands carry them.
#include <gtest/gtest.h>

#include "tests/interp/bench.h"

namespace kadr::interp::smoothing_test {
namespace {

using path::Blending;
using path::BlendKind;

TEST(Smoothing, CommandsCarryWhatIsAskedForBehindThem) {
    const Blending none;
    const Ran ran = run({
        line().x(1).f(100),
        fn(Function::BlendDistance).x(2),
        fn(Function::BlendFeedDistance, {{0, 0.5}}).x(3),
        fn(Function::BlendRapidDistance, {{0, 2}}).motion(Function::Rapid).x(4),
        fn(Function::BlendTolerance).motion(Function::Line).x(5),
        fn(Function::PathTolerance, {{0, 0.02}}).x(6),
        fn(Function::BlendSmooth).x(7),
        fn(Function::PathTolerance, {{0, -1}}).x(8),
        fn(Function::ContinuousPath).x(9),
        fn(Function::BlendDistance).x(10),
        fn(Function::ExactStop).x(11),
    });
    EXPECT_EQ(ran.codes(), "");
    const machine::Machine machine = mill();
    const double leant = machine.orientation_tolerance;
    const std::vector<Blending> expected = {
        none,
        {BlendKind::Distance, false, 0},
        {BlendKind::Distance, false, 0.5},
        {BlendKind::Distance, false, 2},
        {BlendKind::Tolerance, false, machine.corner_tolerance, leant},
        {BlendKind::Tolerance, false, 0.02, leant},
        {BlendKind::Tolerance, true, 0.02, leant},
        {BlendKind::Tolerance, true, machine.corner_tolerance, leant},
        none,
        {BlendKind::Distance, false, 0.5},
        none,
    };
    ASSERT_EQ(ran.commands.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(ran.commands[i].motion().blending, expected[i]) << i;
        EXPECT_EQ(ran.commands[i].motion().exact_stop, i == 0 || i == 10) << i;
    }
}

TEST(Smoothing, HowFarTheToolMayLeanIsSaidInDegrees) {
    const Ran ran = run({
        fn(Function::BlendTolerance).motion(Function::Line).x(1).f(100),
        fn(Function::OrientTolerance, {{0, 0.5}}).x(2),
        fn(Function::OrientTolerance, {{0, -1}}).x(3),
    });
    EXPECT_EQ(ran.codes(), "");
    const double leant = mill().orientation_tolerance;
    ASSERT_EQ(ran.commands.size(), 3u);
    EXPECT_EQ(ran.commands[0].motion().blending.orientation, leant);
    EXPECT_NEAR(ran.commands[1].motion().blending.orientation, rad_from_deg(0.5), 1e-15);
    EXPECT_EQ(ran.commands[2].motion().blending.orientation, leant);
}

/// S 10.4 CYCLE832: a kind whose tens are 1 says how far the tool may lean; kind 0 ends all of it.
TEST(Smoothing, ACycleSaysAllOfIt) {
    const machine::Machine machine = mill();
    const Ran ran = run({
        fn(Function::PathTolerance, {{0, 0.3}}).motion(Function::Line).x(1).f(100),
        fn(Function::HighSpeed, {{0, 0.02}, {1, 12}, {2, 0.5}}).x(2),
        fn(Function::HighSpeed, {{0, 0.1}, {1, 3}, {2, 0.5}}).x(3),
        fn(Function::HighSpeed, {{0, 0}, {1, 0}}).x(4),
        fn(Function::HighSpeed, {{0, 0.05}, {1, 1}}).x(5),
        fn(Function::HighSpeed).x(6),
        fn(Function::BlendTolerance).x(7),
    });
    EXPECT_EQ(ran.codes(), "");
    const double leant = machine.orientation_tolerance;
    const std::vector<Blending> blendings = {
        {},
        {BlendKind::Tolerance, true, 0.02, rad_from_deg(0.5)},
        {BlendKind::Tolerance, true, 0.1, leant},
        {},
        {BlendKind::Tolerance, true, 0.05, leant},
        {},
        {BlendKind::Tolerance, false, machine.corner_tolerance, leant},
    };
    const std::vector<double> compressed = {0, 0.02, 0.1, 0, 0.05, 0, 0};
    ASSERT_EQ(ran.commands.size(), blendings.size());
    for (std::size_t i = 0; i < blendings.size(); ++i) {
        EXPECT_EQ(ran.commands[i].motion().blending, blendings[i]) << i;
        EXPECT_EQ(ran.commands[i].motion().compress, compressed[i]) << i;
    }
}

TEST(Smoothing, LinesAtFeedAreCompressed) {
    const machine::Machine machine = mill();
    const Ran ran = run({
        line().x(1).f(100),
        fn(Function::CompressOn).x(2),
        rapid().x(3),
        line().x(4),
        ccw().x(6).i(1),
        fn(Function::PathTolerance, {{0, 0.1}}).motion(Function::Line).x(7),
        fn(Function::CompressOff).x(8),
    });
    EXPECT_EQ(ran.codes(), "");
    const std::vector<double> expected = {
        0, machine.compressor_tolerance, 0, machine.compressor_tolerance, 0, 0.1, 0};
    ASSERT_EQ(ran.commands.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(ran.commands[i].motion().compress, expected[i]) << i;
}

TEST(Smoothing, ADistanceBelowZeroIsAnAlarm) {
    const Ran ran = run({fn(Function::BlendFeedDistance, {{0, -0.5}}), line().x(1).f(100)});
    EXPECT_EQ(ran.codes(), "K5370");
    EXPECT_TRUE(ran.alarmed);
}

}  // namespace
}  // namespace kadr::interp::smoothing_test
