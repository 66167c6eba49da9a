// Two motions beside each other: how they are cut into pieces does not count, where they go does.
#include "motion/comparison.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/motion/support.h"

namespace kadr::motion::test::comparison_test {
namespace {

using std::numbers::pi;

constexpr double kTolerance = 0.003;
constexpr double kFeed = 600;

Comparison compared(const std::vector<Command>& first, const std::vector<Command>& second) {
    const machine::Machine machine = machine_of();
    DiagnosticList sink;
    CommandList first_commands(first);
    CommandList second_commands(second);
    Planner first_planner(first_commands, machine, {}, sink);
    Planner second_planner(second_commands, machine, {}, sink);
    return compare(first_planner, second_planner, kTolerance);
}

std::vector<Command> with_spindle(std::vector<Command> commands) {
    commands.insert(commands.begin(), spindle_on(1000));
    return commands;
}

/// A quarter of a circle of 10 mm about the origin, to (0, 10).
std::vector<Command> quarter(double radius_error = 0) {
    const double r = 10 + radius_error;
    return with_spindle({rapid_to({r, 0, 0}), arc_to({0, r, 0}, {0, 0, 0}, pi / 2, kFeed)});
}

TEST(Comparison, AMotionIsItself) {
    const Comparison result = compared(quarter(), quarter());
    EXPECT_FALSE(result.parting);
    EXPECT_EQ(result.stretches, 2u);
    EXPECT_EQ(result.greatest_distance, 0);
    EXPECT_EQ(result.greatest_feed_share, 0);
}

TEST(Comparison, PiecesDoNotCount) {
    std::vector<Command> halves = with_spindle({rapid_to({10, 0, 0})});
    const double s = 10 / std::sqrt(2);
    halves.push_back(arc_to({s, s, 0}, {0, 0, 0}, pi / 4, kFeed));
    halves.push_back(arc_to({0, 10, 0}, {0, 0, 0}, pi / 4, kFeed));
    const Comparison result = compared(quarter(), halves);
    EXPECT_FALSE(result.parting);
    EXPECT_LT(result.greatest_distance, 1e-9);
}

// A stop that comes 2 um later on the same way is 2 um from the other.
TEST(Comparison, EndsOfTheSameWayCount) {
    const auto first = with_spindle({line_to({100, 0, 0}, kFeed)});
    const auto second = with_spindle({line_to({100.002, 0, 0}, kFeed)});
    for (const auto& [a, b] : {std::pair{first, second}, std::pair{second, first}}) {
        const Comparison result = compared(a, b);
        EXPECT_FALSE(result.parting);
        EXPECT_NEAR(result.greatest_distance, 0.002, 1e-9);
        EXPECT_EQ(result.widest.first_line, 2u);
        EXPECT_NEAR(std::abs(result.widest.second[0] - result.widest.first[0]), 0.002, 1e-9);
    }
}

// Chords of an arc are as far from it as their sagitta.
TEST(Comparison, FindsTheSagittaOfChords) {
    constexpr int kChords = 45;
    std::vector<Command> chords = with_spindle({rapid_to({10, 0, 0})});
    for (int i = 1; i <= kChords; ++i) {
        const double angle = pi / 2 * i / kChords;
        chords.push_back(line_to({10 * std::cos(angle), 10 * std::sin(angle), 0}, kFeed));
    }
    const Comparison result = compared(quarter(), chords);
    ASSERT_FALSE(result.parting);
    const double sagitta = 10 * (1 - std::cos(pi / 4 / kChords));
    EXPECT_NEAR(result.greatest_distance, sagitta, 0.05 * sagitta);
}

TEST(Comparison, PartsWhereTheWaysPart) {
    const std::vector<Command> square =
        with_spindle({line_to({10, 0, 0}, kFeed), line_to({10, 10, 0}, kFeed)});
    std::vector<Command> other = square;
    other.back() = line_to({10, -10, 0}, kFeed);
    const Comparison turned = compared(square, other);
    ASSERT_EQ(turned.parting, Parting::Path);
    EXPECT_NEAR(turned.parted.first.x(), 10, 0.01);
    EXPECT_NEAR(turned.parted.first.y(), 0, 0.2);
}

TEST(Comparison, TellsWhyTheyPart) {
    const std::vector<Command> base =
        with_spindle({line_to({10, 0, 0}, kFeed), line_to({20, 0, 0}, kFeed)});
    std::vector<Command> other = base;
    other[2] = rapid_to({20, 0, 0});
    EXPECT_EQ(compared(base, other).parting, Parting::Kind);
    other = base;
    other.pop_back();
    EXPECT_EQ(compared(base, other).parting, Parting::Length);
    other = base;
    other.push_back(rapid_to({30, 0, 0}));
    EXPECT_EQ(compared(base, other).parting, Parting::End);
    std::vector<Command> waits = base;
    Command dwell(Op::Dwell);
    dwell.dwell().time = 1;
    waits.push_back(dwell);
    EXPECT_EQ(compared(base, waits).parting, Parting::End);
    other = waits;
    other.back().dwell().time = 2;
    EXPECT_EQ(compared(waits, other).parting, Parting::Standing);
    other = base;
    other[0].spindle().speed *= 2;
    EXPECT_EQ(compared(base, other).parting, Parting::Spindle);
    other = base;
    other[0].spindle().mode = path::SpindleMode::Ccw;
    EXPECT_EQ(compared(base, other).parting, Parting::Spindle);
    std::vector<Command> thread = base;
    thread[1].become(Op::Thread);
    thread[1].motion().feed_mode = path::FeedMode::PerRevolution;
    thread[1].motion().feed = 1;
    EXPECT_FALSE(compared(thread, thread).parting);
    other = thread;
    other[1].motion().feed = 1.5;
    EXPECT_EQ(compared(thread, other).parting, Parting::Pitch);
    EXPECT_EQ(compared(base, thread).parting, Parting::Gear);
    other = thread;
    other[1].motion().thread().start_deg = 180;  // a thread of two starts is another workpiece
    EXPECT_EQ(compared(thread, other).parting, Parting::Start);
    other[1].motion().thread().start_deg = 360;
    EXPECT_FALSE(compared(thread, other).parting);
}

// S in whole revolutions: 239.5 is written 240. What is more than that parts, and both are told.
TEST(Comparison, RoundedSpeedsAreOne) {
    std::vector<Command> first = with_spindle({line_to({10, 0, 0}, kFeed)});
    std::vector<Command> second = first;
    first[0].spindle().speed = 239.5;
    second[0].spindle().speed = 240;
    EXPECT_FALSE(compared(first, second).parting);
    second[0].spindle().speed = 240.1;
    const Comparison result = compared(first, second);
    EXPECT_EQ(result.parting, Parting::Spindle);
    EXPECT_NEAR(result.first_spindle.speed * 60, 239.5, 1e-9);
    EXPECT_NEAR(result.second_spindle.speed * 60, 240.1, 1e-9);
    // Half a revolution is much of one and a half.
    first[0].spindle().speed = 1.5;
    second[0].spindle().speed = 2;
    EXPECT_EQ(compared(first, second).parting, Parting::Spindle);
}

// How long a thread waits for the spindle's mark hangs on the micrometres before it.
TEST(Comparison, WaitsForTheSpindlesMarkAreOne) {
    const auto with_thread = [](double x) {
        std::vector<Command> all =
            with_spindle({line_to({x, 0, 0}, kFeed), line_to({100, 0, 0}, kFeed)});
        all[2].become(Op::Thread);
        all[2].motion().feed_mode = path::FeedMode::PerRevolution;
        all[2].motion().feed = 1.5;
        return all;
    };
    const Comparison result = compared(with_thread(60), with_thread(60.001));
    EXPECT_FALSE(result.parting) << static_cast<int>(result.parting.value_or(Parting::Path));
    // A dwell there is one still.
    std::vector<Command> dwells = with_thread(60);
    Command dwell(Op::Dwell);
    dwell.dwell().time = 1;
    dwells.insert(dwells.begin() + 2, dwell);
    EXPECT_TRUE(compared(with_thread(60), dwells).parting);
}

// Where a piece ends a nanometre later, the next one's feed is not that of the same place.
TEST(Comparison, FeedsOfACommonEndAreThoseOfOnePiece) {
    const auto with_end = [](double x) {
        return with_spindle({line_to({x, 0, 0}, 100), line_to({40, 0, 0}, 400)});
    };
    for (const auto& [a, b] : {std::pair{20.0, 20.0000001}, std::pair{20.0000001, 20.0}}) {
        const Comparison result = compared(with_end(a), with_end(b));
        EXPECT_FALSE(result.parting);
        EXPECT_EQ(result.greatest_feed_share, 0);
    }
}

TEST(Comparison, FeedsAreToldAndDoNotPart) {
    std::vector<Command> slower = quarter();
    slower.back().motion().feed = 0.9 * kFeed;
    const Comparison result = compared(quarter(), slower);
    EXPECT_FALSE(result.parting);
    EXPECT_NEAR(result.greatest_feed_share, 0.1, 1e-9);
}

}  // namespace
}  // namespace kadr::motion::test::comparison_test
