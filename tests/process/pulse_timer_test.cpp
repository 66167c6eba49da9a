// The laser as the machine's motion module: programs as setpoints with their pulses.
#include "process/pulse_timer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/motion/support.h"
#include "tests/process/keep.h"

namespace kadr::process::pulse_timer_test {
namespace {

using motion::Segment;
using motion::SegmentKind;
using motion::Setpoint;
using motion::test::line_to;
using motion::test::rapid_to;
using path::Command;
using path::Vec3;

constexpr double kFeed = 1800;  // mm/min

machine::Machine laser_of(machine::PulseMode mode = machine::PulseMode::Synchronised) {
    machine::Machine machine = motion::test::machine_of({{100, 100, 100}, {300, 300, 300}});
    machine.tick = 0.001;
    machine.laser = machine::Laser{};
    machine.laser->pulse = 40;
    machine.laser->tolerance = 0.1;
    machine.laser->mode = mode;
    return machine;
}

struct Timed {
    std::vector<Segment> segments;
    std::vector<Setpoint> setpoints;
    motion::Totals totals;
    std::uint64_t pulses = 0;
};

Timed run(const machine::Machine& machine, std::vector<Command> commands) {
    Timed timed;
    DiagnosticList diagnostics;
    motion::test::CommandList list(std::move(commands));
    motion::Planner planner(list, machine, {}, diagnostics);
    PulseTimer timer(planner, machine);
    timed.setpoints = test::sampled(timer, machine, timed.segments);
    timed.totals = timer.totals(planner.totals());
    timed.pulses = timer.pulses();
    return timed;
}

/// Points along X at 0.125 mm.
std::vector<Command> straight(int count) {
    std::vector<Command> commands = {motion::test::spindle_on(100)};
    for (int i = 1; i <= count; ++i) commands.push_back(line_to({0.125 * i, 0, 0}, kFeed));
    return commands;
}

/// Ticks between the pulses of a run; the first counts from its start.
std::vector<int> intervals_of(const Timed& timed) {
    std::vector<int> intervals;
    int last = 0;
    for (std::size_t i = 0; i < timed.setpoints.size(); ++i) {
        EXPECT_LE(timed.setpoints[i].pulses, 1u);
        if (timed.setpoints[i].pulses == 0) continue;
        intervals.push_back(static_cast<int>(i) - last);
        last = static_cast<int>(i);
    }
    return intervals;
}

/// Whether a number of ticks is k intervals, of which one uses the tolerance.
bool is_in_a_window(int ticks) {
    const int off = (ticks + 12) % 25 - 12;
    return ticks >= 23 && std::abs(off) <= 2;
}

TEST(PulseTimer, EveryPointIsBurntWhereItIs) {
    const Timed timed = run(laser_of(), straight(40));
    EXPECT_EQ(timed.pulses, 40u);
    int point = 0;
    for (const Setpoint& setpoint : timed.setpoints) {
        if (setpoint.pulses > 0) {
            EXPECT_NEAR(setpoint.tip[0], 0.125 * ++point, 1e-7);
        }
    }
    EXPECT_EQ(point, 40);
    for (const int ticks : intervals_of(timed)) EXPECT_TRUE(is_in_a_window(ticks)) << ticks;
    // From rest 0.125 mm take 29 ms at 300 mm/s²: two intervals for the first point and for the
    // last one, one for each other.
    EXPECT_NEAR(timed.totals.time, 42 * 0.025, 0.012);
    EXPECT_NEAR(timed.setpoints.back().tip[0], 5, 1e-9);
}

TEST(PulseTimer, InTheMiddleOfAStrokeNothingStops) {
    const Timed timed = run(laser_of(), straight(40));
    for (const Setpoint& setpoint : timed.setpoints) {
        if (setpoint.tip[0] > 0.5 && setpoint.tip[0] < 4.5) {
            EXPECT_GT(setpoint.feed, 1.5);
        }
    }
}

TEST(PulseTimer, TheStopModeRestsAtEveryPoint) {
    const Timed timed = run(laser_of(machine::PulseMode::Stop), straight(40));
    EXPECT_EQ(timed.pulses, 40u);
    // 0.125 mm take 40.8 ms from rest to rest: the pulse after 48 is the first that can be hit.
    for (const int ticks : intervals_of(timed)) EXPECT_EQ(ticks, 48);
    for (const Setpoint& setpoint : timed.setpoints) {
        if (setpoint.pulses > 0) {
            EXPECT_EQ(setpoint.feed, 0);
        }
    }
}

/// Legs in which every point is a stop win nothing by being synchronised, and lose nothing.
TEST(PulseTimer, WhereEveryPointIsAStopBothModesTakeTheSame) {
    using machine::PulseMode;
    for (const double step : {0.03, 0.0468, 0.06, 0.125, 0.2, 0.9}) {
        SCOPED_TRACE(step);
        std::vector<Command> commands = {motion::test::spindle_on(100)};
        for (int i = 1; i <= 30; ++i) {
            commands.push_back(line_to({step * i, 0, 0}, kFeed));
            commands.back().motion().exact_stop = true;
        }
        const Timed synchronised = run(laser_of(), commands);
        const Timed stopping = run(laser_of(PulseMode::Stop), commands);
        EXPECT_EQ(intervals_of(synchronised), intervals_of(stopping));
        EXPECT_NEAR(synchronised.totals.time, stopping.totals.time, 1e-9);
    }
    // One interval is between two working pulses, which come at the frequency of the pump; a
    // second one begins with an empty pulse, which may come early.
    const auto interval_of = [](double step) {
        std::vector<Command> commands = {motion::test::spindle_on(100)};
        for (int i = 1; i <= 3; ++i) commands.push_back(line_to({step * i, 0, 0}, kFeed));
        return intervals_of(run(laser_of(PulseMode::Stop), commands)).back();
    };
    EXPECT_EQ(interval_of(0.03), 25);
    EXPECT_EQ(interval_of(0.06), 48);
}

/// Whatever the points: to be synchronised saves time on the whole. Where nearly all of them are
/// sharp corners a stop at each, whose ramps nothing shares, may be quicker by a tick or two a
/// point.
TEST(PulseTimer, SynchronisedSavesTime) {
    double with_stops = 0;
    double without = 0;
    std::uint64_t seed = 7;
    const auto chance = [&seed] {
        seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(seed >> 11) * 0x1p-53;
    };
    for (int set = 0; set < 60; ++set) {
        SCOPED_TRACE(set);
        const double longest = 0.03 + 0.2 * chance();
        const double turn = set % 3 == 0 ? 3 : 0.4 * chance();
        std::vector<Command> commands = {motion::test::spindle_on(100)};
        Vec3 at = Vec3::Zero();
        double angle = 0;
        for (int i = 0; i < 40; ++i) {
            angle += turn * (2 * chance() - 1);
            at += longest * (0.3 + 0.7 * chance()) * Vec3(std::cos(angle), std::sin(angle), 0);
            commands.push_back(line_to(at, kFeed));
            commands.back().motion().exact_stop = chance() < 0.1 * (set % 5);
        }
        const Timed synchronised = run(laser_of(), commands);
        const Timed stopping = run(laser_of(machine::PulseMode::Stop), commands);
        EXPECT_EQ(synchronised.pulses, 40u);
        EXPECT_LE(synchronised.totals.time, 1.05 * stopping.totals.time);
        with_stops += stopping.totals.time;
        without += synchronised.totals.time;
    }
    EXPECT_LT(without, 0.92 * with_stops);
}

TEST(PulseTimer, RapidsAndDwellsBurnNothingAndThePumpGoesOn) {
    std::vector<Command> commands = straight(3);
    commands.push_back(rapid_to({3, 2, 0}));
    Command dwell = motion::test::simple(path::Op::Dwell);
    dwell.dwell().time = 0.1234;
    commands.push_back(dwell);
    for (int i = 1; i <= 3; ++i) commands.push_back(line_to({3, 2 + 0.125 * i, 0}, kFeed));
    const Timed timed = run(laser_of(), commands);
    EXPECT_EQ(timed.pulses, 6u);
    for (const int ticks : intervals_of(timed)) EXPECT_TRUE(is_in_a_window(ticks)) << ticks;
}

TEST(PulseTimer, WithoutTheBeamNothingIsBurntAndNothingStops) {
    std::vector<Command> commands = straight(40);
    commands.erase(commands.begin());
    const machine::Machine machine = laser_of();
    const Timed timed = run(machine, commands);
    EXPECT_EQ(timed.pulses, 0u);
    // 5 mm at 30 mm/s and 300 mm/s², to the next tick.
    EXPECT_NEAR(timed.totals.time, 5.0 / 30 + 30.0 / 300, 0.001);
}

TEST(PulseTimer, ABlockOfSeveralPiecesIsOnePoint) {
    // A spline is planned in pieces of even bending.
    std::vector<Command> commands = straight(2);
    commands.push_back(motion::test::spline_to({6, 0, 0}, {1, 4, 0}, {5, -4, 0}, kFeed));
    commands.push_back(line_to({6.1, 0, 0}, kFeed));
    const Timed timed = run(laser_of(), commands);
    EXPECT_EQ(timed.pulses, 4u);
    for (const int ticks : intervals_of(timed)) EXPECT_TRUE(is_in_a_window(ticks)) << ticks;
}

TEST(PulseTimer, SegmentsFollowEachOtherAndKeepTheLimits) {
    // A circle of points, a corner, a jump.
    std::vector<Command> commands = {motion::test::spindle_on(100)};
    for (int i = 1; i <= 120; ++i) {
        const double a = 2 * std::numbers::pi * i / 120;
        commands.push_back(line_to({2.4 * std::sin(a), 2.4 - 2.4 * std::cos(a), 0}, kFeed));
    }
    commands.push_back(rapid_to({10, 10, 0}));
    for (int i = 1; i <= 20; ++i) commands.push_back(line_to({10 + 0.13 * i, 10, 0}, kFeed));
    for (int i = 1; i <= 20; ++i) commands.push_back(line_to({12.6, 10 + 0.11 * i, 0}, kFeed));
    const machine::Machine machine = laser_of();
    const Timed timed = run(machine, commands);
    EXPECT_EQ(timed.pulses, 160u);
    double time = 0;
    Vec3 at = Vec3::Zero();
    for (const Segment& segment : timed.segments) {
        EXPECT_NEAR(segment.start_time, time, 1e-9);
        EXPECT_LT((path::start(segment.curve) - at).norm(), 1e-9);
        time = segment.end_time();
        at = path::end(segment.curve);
    }
    EXPECT_NEAR(timed.totals.time, time, 1e-9);
    EXPECT_NEAR(timed.totals.time,
                timed.totals.cutting_time + timed.totals.rapid_time + timed.totals.dwell_time,
                1e-6);
    // From tick to tick, as the axes see it.
    const auto& points = timed.setpoints;
    for (std::size_t i = 2; i + 1 < points.size(); ++i) {
        for (std::size_t k = 0; k < 2; ++k) {
            const double v0 = (points[i - 1].axis[k] - points[i - 2].axis[k]) / 0.001;
            const double v1 = (points[i].axis[k] - points[i - 1].axis[k]) / 0.001;
            EXPECT_LE(std::abs(v1 - v0) / 0.001, 300 * 1.001) << "at " << points[i].time;
        }
    }
}

}  // namespace
}  // namespace kadr::process::pulse_timer_test
