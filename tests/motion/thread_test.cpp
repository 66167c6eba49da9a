// Threads and the spindle's mark: passes run in one groove.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/spindle_angle.h"
#include "tests/motion/support.h"

namespace kadr::motion::test::thread_test {
namespace {

Command thread_to(const Vec3& to, double lead, double start_deg = 0) {
    Command command = line_to(to, lead);
    command.become(Op::Thread);
    command.motion().feed_mode = path::FeedMode::PerRevolution;
    command.motion().thread().start_deg = start_deg;
    return command;
}

/// Of a turn, at the start of every thread that follows no other one.
std::vector<double> marks(const Motion& motion, double turns_a_second) {
    std::vector<double> found;
    bool is_threading = false;
    for (const Segment& segment : motion.segments) {
        const bool is_thread = segment.kind == SegmentKind::Feed && segment.feed_per_revolution > 0;
        if (is_thread && !is_threading) {
            const double turned = segment.start_time * turns_a_second;
            found.push_back(turned - std::floor(turned + 1e-9));
        }
        is_threading = is_thread;
    }
    return found;
}

TEST(Thread, PassesBeginAtTheMark) {
    for (const double rpm : {60.0, 613.0, 1500.0}) {
        SCOPED_TRACE(rpm);
        std::vector<Command> program = {spindle_on(rpm)};
        std::vector<double> expected;
        for (int pass = 0; pass < 7; ++pass) {
            const double start = 50 * pass % 360;
            program.push_back(rapid_to({0, 0, 0.37 * pass}));
            program.push_back(thread_to({0, 0, -20}, 2, start));
            program.push_back(rapid_to({10, 0, -20}));
            expected.push_back(start / 360);
        }
        const Motion motion = run(machine_of(), program);
        EXPECT_TRUE(motion.diagnostics.all().empty());
        const std::vector<double> found = marks(motion, rpm / 60);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-6);
        // Less than a turn is waited for each.
        EXPECT_LT(motion.totals.wait_time, 7 * 60 / rpm);
        EXPECT_GT(motion.totals.wait_time, 0);
    }
}

TEST(Thread, PassesKeepTheirMarkBehindHolds) {
    constexpr double kTurns = 1000.0 / 60;
    std::vector<Command> program = {spindle_on(1000)};
    for (int pass = 0; pass < 3; ++pass) {
        program.push_back(rapid_to({0, 0, 5}));
        program.push_back(thread_to({0, 0, -20}, 2, 36));
        program.push_back(rapid_to({10, 0, -20}));
    }
    const double usual = run(machine_of(), program).totals.time;
    for (double from = 0.01; from < usual; from += 0.037) {
        for (const double length : {0.004, 0.0217, 1.3}) {
            SCOPED_TRACE(::testing::Message() << from << " s, for " << length << " s");
            PlannerOptions options;
            options.events = {{OperatorAct::FeedHold, 1, from, 0, -1},
                              {OperatorAct::CycleStart, 1, from + length, 0, -1}};
            const Motion motion = run(machine_of(), program, options);
            EXPECT_TRUE(motion.diagnostics.all().empty());
            const std::vector<double> found = marks(motion, kTurns);
            ASSERT_EQ(found.size(), 3u);
            for (const double mark : found) EXPECT_NEAR(mark, 0.1, 1e-6);
        }
    }
}

TEST(Thread, AChainDoesNotWait) {
    const Motion motion =
        run(machine_of(), {spindle_on(600), rapid_to({0, 0, 5}), thread_to({0, 0, -10}, 2),
                           thread_to({0, 0, -30}, 2, 90)});
    EXPECT_TRUE(motion.diagnostics.all().empty());
    EXPECT_EQ(marks(motion, 10).size(), 1u);
    ASSERT_EQ(motion.segments.size(), 4u);  // rapid, wait, two threads
    EXPECT_EQ(motion.segments[1].kind, SegmentKind::Wait);
    EXPECT_NEAR(motion.segments[2].profile.exit_speed, 20, 1e-9);
}

TEST(Thread, TellsOfCornersThatLoseThePitch) {
    const auto told = [](const Vec3& second, double rpm, std::uint16_t cycle) {
        Command turned = thread_to(second, 2);
        turned.cycle = cycle;
        const Motion motion =
            run(machine_of(), {spindle_on(rpm), thread_to({0, 0, -30}, 2), turned});
        std::string codes;
        for (const Diagnostic& message : motion.diagnostics.all()) codes += message.row->code;
        return codes;
    };
    EXPECT_EQ(told({20, 0, -50}, 1500, 0), "K6109");
    EXPECT_EQ(told({0, 0, -50}, 1500, 0), "") << "straight on";
    EXPECT_EQ(told({20, 0, -50}, 20, 0), "") << "slow enough";
    EXPECT_EQ(told({20, 0, -50}, 1500, 3), "") << "the run-out of a cycle";
}

TEST(SpindleAngle, CountsTurns) {
    SpindleAngle angle;
    Segment segment;
    segment.duration = 0.3;
    segment.spindle.is_turning = true;
    segment.spindle.speed = 10;
    EXPECT_EQ(angle.time_to(0, 10), 0);
    EXPECT_NEAR(angle.time_to(0.25, 10), 0.025, 1e-12);
    angle.pass(segment);  // three whole turns
    EXPECT_EQ(angle.time_to(0, 10), 0);
    segment.duration = 0.31;
    angle.pass(segment);
    EXPECT_NEAR(angle.time_to(0, 10), 0.09, 1e-12);
    EXPECT_NEAR(angle.time_to(-0.5, 10), 0.04, 1e-12);
    segment.spindle.is_turning = false;
    angle.pass(segment);
    EXPECT_NEAR(angle.time_to(0, 10), 0.09, 1e-12);
}

}  // namespace
}  // namespace kadr::motion::test::thread_test
