// Rounded corners: how far the path leaves the programmed one, where the curve begins, what it
// saves, and which corners stay.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "motion/axis_table.h"
#include "tests/motion/any_program.h"
#include "tests/motion/support.h"
#include "tests/motion/tick_limits.h"

namespace kadr::motion::corner_blend_test {
namespace {

using namespace test;

constexpr double pi = std::numbers::pi;

machine::Machine smooth_machine() {
    Dynamics dynamics;
    dynamics.jerk = {100'000, 100'000, 80'000};
    return machine_of(dynamics);
}

/// Distance of a point from a curve: the nearest of many points, then by thirds.
double distance_to(const path::Curve& curve, const Vec3& point) {
    const double length = path::length(curve);
    constexpr int kSteps = 64;
    int best = 0;
    const auto apart = [&](double s) { return (path::position(curve, s) - point).norm(); };
    for (int i = 1; i <= kSteps; ++i)
        if (apart(length * i / kSteps) < apart(length * best / kSteps)) best = i;
    double lower = length * std::max(0, best - 1) / kSteps;
    double upper = length * std::min(kSteps, best + 1) / kSteps;
    for (int pass = 0; pass < 60; ++pass) {
        const double a = lower + (upper - lower) / 3;
        const double b = upper - (upper - lower) / 3;
        (apart(a) < apart(b) ? upper : lower) = apart(a) < apart(b) ? b : a;
    }
    return std::min({apart(lower), apart(0), apart(length)});
}

/// … from what belongs to a line of the text and to its neighbours.
double distance_to(const std::vector<Segment>& motion, const Vec3& point, std::uint32_t line) {
    double least = kUnlimited;
    for (const Segment& segment : motion) {
        if (segment.line + 1 >= line && segment.line <= line + 1)
            least = std::min(least, distance_to(segment.curve, point));
    }
    return least;
}

/// By how much two ways are apart: points of the one from the other, and the other way round.
double apart(const std::vector<Segment>& a, const std::vector<Segment>& b) {
    double greatest = 0;
    for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
        for (const Segment& segment : *from) {
            const double length = path::length(segment.curve);
            for (int i = 0; i <= 8; ++i) {
                const Vec3 point = path::position(segment.curve, length * i / 8);
                greatest = std::max(greatest, distance_to(*to, point, segment.line));
            }
        }
    }
    return greatest;
}

struct Way {
    const char* name;
    std::vector<Command> commands;
};

/// Every pair of motions, with a corner between them.
std::vector<Way> pairs() {
    const double f = 6000;
    const Command square = line_to({20, 20, 0}, f);
    const Command along = line_to({20, 0, 0}, f);
    return {
        {"line, line", {along, square}},
        {"line, line in space", {along, line_to({25, 8, 15}, f)}},
        {"slight", {along, line_to({40, 3, 0}, f)}},
        {"sharp", {along, line_to({4, 6, 0}, f)}},
        {"line, arc", {along, arc_to({30, 10, 0}, {30, 0, 0}, -pi / 2, f)}},
        {"arc, line", {arc_to({20, 0, 0}, {10, 0, 0}, pi, f), line_to({40, 0, 0}, f)}},
        {"arc, arc",
         {arc_to({20, 0, 0}, {10, 0, 0}, pi, f), arc_to({30, 10, 0}, {20, 10, 0}, pi / 2, f)}},
        {"helix, line", {arc_to({20, 0, 5}, {10, 0, 0}, pi, f), line_to({40, 0, 5}, f)}},
        {"line, spline", {along, spline_to({30, 20, 0}, {20, 10, 0}, {30, 10, 0}, f)}},
        {"spline, line", {spline_to({20, 0, 0}, {5, 8, 0}, {15, 8, 0}, f), line_to({40, 0, 0}, f)}},
        {"arc, spline",
         {arc_to({20, 0, 0}, {10, 0, 0}, pi, f), spline_to({40, 9, 0}, {25, 3, 0}, {30, 9, 0}, f)}},
        {"rapids", {rapid_to({20, 0, 0}), rapid_to({20, 20, 10})}},
        {"rapid, line", {rapid_to({20, 0, 0}), line_to({20, 20, 0}, f)}},
    };
}

TEST(Rounding, StaysInsideTheToleranceAndIsQuicker) {
    for (const double tolerance : {0.1, 0.01}) {
        for (const Way& way : pairs()) {
            SCOPED_TRACE(way.name);
            SCOPED_TRACE(tolerance);
            const Motion sharp = run(machine_of(), way.commands);
            const Motion round = run(machine_of(), rounded(way.commands, within(tolerance)));
            EXPECT_LE(round.totals.time, sharp.totals.time);
            // What comes nearly back saves nothing within a hundredth.
            if (way.name == std::string("sharp")) continue;
            EXPECT_LT(round.totals.time, sharp.totals.time);
            EXPECT_LT(round.totals.length, sharp.totals.length);
            const double miss = apart(round.segments, sharp.segments);
            EXPECT_LE(miss, tolerance);
            EXPECT_GE(miss, 0.5 * tolerance);
        }
    }
}

TEST(Rounding, LeavesTheWayToTheProgram) {
    // Where a curve is worth it does not depend on what the operator does meanwhile.
    for (const Way& way : pairs()) {
        SCOPED_TRACE(way.name);
        for (double feed = 100; feed < 40000; feed *= 1.5) {
            std::vector<Command> commands = rounded(way.commands, within(0.1));
            for (Command& command : commands)
                if (command.op() != Op::Rapid) command.motion().feed = feed;
            const double usual = run(machine_of(), commands).totals.length;
            for (const double dial : {0.1, 0.5, 1.5, 3.0}) {
                PlannerOptions options;
                options.feed_override = dial;
                EXPECT_NEAR(run(machine_of(), commands, options).totals.length, usual, 1e-9)
                    << feed << " mm/min, " << dial;
            }
        }
    }
}

TEST(Rounding, KeepsTheJerkAndCostsNoTime) {
    // A corner as it is lets the velocity of an axis jump by what a tick's acceleration makes; the
    // curve keeps to the jerk. At the feeds of cutting it is quicker all the same, and where it
    // would not be the corner stays.
    const auto machine = smooth_machine();
    for (const Way& way : pairs()) {
        SCOPED_TRACE(way.name);
        for (const double feed : {1500.0, 6000.0, 24000.0}) {
            SCOPED_TRACE(feed);
            auto commands = way.commands;
            for (Command& command : commands) command.motion().feed = feed;
            const Motion sharp = run(machine, commands);
            for (const auto& wish : {within(0.1), within(0.01), by_distance(0.5), by_distance(3)}) {
                SCOPED_TRACE(wish.size);
                const Motion round = run(machine, rounded(commands, wish));
                EXPECT_LE(round.totals.time, 1.03 * sharp.totals.time);
                if (wish.kind != path::BlendKind::Tolerance) continue;
                EXPECT_LE(apart(round.segments, sharp.segments), wish.size);
            }
        }
        auto commands = way.commands;
        for (Command& command : commands) command.motion().feed = 1500;
        if (commands[0].op() == Op::Rapid) continue;
        EXPECT_LT(run(machine, rounded(commands, by_distance(0.5))).totals.time,
                  run(machine, commands).totals.time + 1e-6);
    }
}

/// Along a wave of lines as long as here, corners follow each other so closely that a path through
/// them is quick: curves around all of them would cost a quarter more.
TEST(Rounding, OfShortLinesCostsNoTime) {
    const auto machine = smooth_machine();
    double sharp = 0;
    double round = 0;
    for (const double step : {0.1, 0.3, 0.5, 1.0, 2.0, 5.0}) {
        for (const double height : {1.0, 3.0, 8.0}) {
            for (const double feed : {3000.0, 10000.0}) {
                SCOPED_TRACE(step);
                SCOPED_TRACE(height);
                SCOPED_TRACE(feed);
                std::vector<Command> wave;
                for (double x = step; x < 60; x += step)
                    wave.push_back(line_to({x, height * std::sin(0.3 * x), 0}, feed));
                const double as_is = run(machine, wave).totals.time;
                const double curved = run(machine, rounded(wave, within(0.05))).totals.time;
                EXPECT_LE(curved, 1.05 * as_is);
                sharp += as_is;
                round += curved;
            }
        }
    }
    EXPECT_LT(round, 0.98 * sharp);
}

/// How far the programmed path is kept: from its start, and to its end.
double kept_from(const std::vector<Segment>& sharp, const std::vector<Segment>& round) {
    double reach = 0;
    for (const Segment& segment : round) {
        const double length = path::length(segment.curve);
        for (int i = 0; i <= 16; ++i) {
            if (distance_to(sharp, path::position(segment.curve, length * i / 16), segment.line) >
                1e-9)
                return reach;
            if (i > 0) reach += length / 16;
        }
    }
    return reach;
}

TEST(Rounding, BeginsAndEndsAtTheDistance) {
    // A curve of which the second half mirrors the first: |C − corner| is `distance` at both ends.
    for (const double distance : {0.1, 0.3, 2.0}) {
        for (const Way& way : pairs()) {
            if (way.name == std::string("sharp")) continue;
            SCOPED_TRACE(way.name);
            SCOPED_TRACE(distance);
            const auto machine = machine_of();
            const Motion sharp = run(machine, way.commands);
            const Motion round = run(machine, rounded(way.commands, by_distance(distance)));
            double before = 0;
            for (const Segment& segment : sharp.segments)
                before += segment.line == 1 ? path::length(segment.curve) : 0;
            const double reach = kept_from(sharp.segments, round.segments);
            EXPECT_GE(reach, before - distance - 1e-9);
            // Near its ends the curve is still closer to the path than can be told.
            EXPECT_LE(reach, before - 0.5 * distance);
        }
    }
}

TEST(Rounding, VelocityAndAccelerationOfTheAxesRunOn) {
    const auto machine = machine_of();
    const AxisTable axes(machine);
    for (const Way& way : pairs()) {
        if (way.name == std::string("sharp")) continue;
        SCOPED_TRACE(way.name);
        const Motion round = run(machine, rounded(way.commands, within(0.05)));
        for (std::size_t k = 1; k < round.segments.size(); ++k) {
            const Segment& a = round.segments[k - 1];
            const Segment& b = round.segments[k];
            EXPECT_LE((path::end(a.curve) - path::start(b.curve)).norm(), 1e-12);
            EXPECT_GT(b.profile.entry_speed, 0);
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_NEAR(axes.end_rates(a)[i], axes.start_rates(b)[i], 1e-9);
                EXPECT_NEAR(axes.end_bends(a)[i], axes.start_bends(b)[i], 1e-6);
            }
        }
    }
}

TEST(Rounding, SetpointsKeepVelocityAccelerationAndJerk) {
    for (const machine::Machine& machine : {machine_of(), smooth_machine()}) {
        for (const auto& wish : {within(0.1), within(0.003), by_distance(1), by_distance(0.02)}) {
            for (const Way& way : pairs()) {
                SCOPED_TRACE(way.name);
                SCOPED_TRACE(wish.size);
                const auto commands = rounded(way.commands, wish);
                TickWatch watch(machine, run(machine, commands).segments);
                for (const Setpoint& setpoint : sample(machine, commands)) watch.add(setpoint);
                EXPECT_LE(watch.shares().velocity, 1 + 1e-3);
                EXPECT_LE(watch.shares().acceleration, 1 + 1e-3);
                EXPECT_LE(watch.shares().jerk, 1 + 1e-3);
            }
        }
    }
}

/// Lines that turn to and fro, of one length, or at random, of about that length or longer.
std::vector<Command> any_chain(double length) {
    const double feed = any_number(1000, 20000);
    const bool is_even = *rc::gen::arbitrary<bool>();
    const int count = *rc::gen::inRange(3, 41);
    std::vector<Command> chain;
    Vec3 at = Vec3::Zero();
    double turn = any_number(0, 180);
    double direction = 0;
    for (int i = 0; i < count; ++i) {
        at += (is_even ? length : length * any_number(1, 3)) *
              Vec3(std::cos(direction), std::sin(direction), 0);
        chain.push_back(line_to(at, feed));
        if (!is_even) turn = any_number(0, 180);
        direction += (i % 2 == 0 ? turn : -turn) * pi / 180;
    }
    return chain;
}

std::vector<Command> with_stops(std::vector<Command> commands) {
    for (Command& command : commands) command.motion().exact_stop = true;
    return commands;
}

/// Whatever becomes of the curves when they are planned: a rounded corner, or one that is passed,
/// never takes longer than a stop at it, but for a hundredth of a tick. Blocks that are all shorter
/// than 1 mm are run through under G64 in any case (docs/motion.md).
RC_GTEST_PROP(RoundingProperty, AChainTakesNoLongerThanWithStops, ()) {
    const machine::Machine machine =
        *rc::gen::element(machine_of(), smooth_machine(),
                          machine_of({.velocity = {1500, 1500, 1500}, .jerk = {1e6, 1e6, 1e6}}));
    const double size = *rc::gen::element(0.3, 0.999, 1.001, 2.0, 5.0, 20.0);
    const std::vector<Command> chain = any_chain(size);
    const double stops = run(machine, with_stops(chain)).totals.time + 0.01 * machine.tick;
    if (size > 1) RC_ASSERT(run(machine, chain).totals.time <= 1.001 * stops);
    for (const auto& wish : {by_distance(0.3), by_distance(1), within(0.05), within(0.3, true)})
        RC_ASSERT(run(machine, rounded(chain, wish)).totals.time <= 1.001 * stops);
}

/// 40 lines of 2 mm at F10000 under G641 ADIS=0.3 took 3.5 % more than with stops.
TEST(Rounding, AZigzagTakesNoLongerThanWithStops) {
    for (const machine::Machine& machine : {machine_of(), smooth_machine()}) {
        for (const double turn : {30.0, 60.0, 90.0, 120.0, 150.0}) {
            const double half = turn / 2 * pi / 180;
            std::vector<Command> zigzag;
            for (int i = 1; i <= 40; ++i)
                zigzag.push_back(
                    line_to({2 * i * std::cos(half), 2 * (i % 2) * std::sin(half), 0}, 10000));
            const double most = run(machine, with_stops(zigzag)).totals.time;
            EXPECT_LE(run(machine, rounded(zigzag, by_distance(0.3))).totals.time, most) << turn;
        }
    }
}

TEST(Rounding, ShortBlocksAreShared) {
    // Steps of 0.1 mm to the right and up: every corner has half of both neighbours, and the way
    // goes through their middles.
    std::vector<Command> steps;
    for (int i = 1; i <= 200; ++i) {
        const double x = 0.1 * ((i + 1) / 2);
        const double y = 0.1 * (i / 2);
        steps.push_back(line_to({x, y, 0}, 3000));
    }
    const auto machine = machine_of();
    const Motion sharp = run(machine, steps);
    const Motion round = run(machine, rounded(steps, by_distance(5)));
    EXPECT_LT(round.totals.time, 0.8 * sharp.totals.time);
    EXPECT_LE(apart(round.segments, sharp.segments), 0.05);
    for (std::uint32_t i = 1; i + 1 < 200; ++i) {
        const double x = 0.1 * ((i + 1) / 2);
        const double y = 0.1 * (i / 2);
        const Vec3 middle = i % 2 == 0 ? Vec3(x + 0.05, y, 0) : Vec3(x, y + 0.05, 0);
        EXPECT_LE(distance_to(round.segments, middle, i), 1e-9);
    }
    for (std::size_t k = 1; k < round.segments.size(); ++k)
        EXPECT_GT(round.segments[k].profile.entry_speed, 0);
}

TEST(Rounding, PiecesBelongToTheirBlocks) {
    const auto machine = machine_of();
    const std::vector<Command> commands = {line_to({20, 0, 0}, 6000), line_to({20, 20, 0}, 3000),
                                           line_to({40, 20, 0}, 6000)};
    const Motion round = run(machine, rounded(commands, within(0.05)));
    std::uint32_t line = 1;
    std::size_t ends = 0;
    for (std::size_t k = 0; k < round.segments.size(); ++k) {
        const Segment& segment = round.segments[k];
        EXPECT_GE(segment.line, line);
        line = segment.line;
        EXPECT_NEAR(segment.feed, line == 2 ? 50 : 100, 1e-9);
        const bool is_last =
            k + 1 == round.segments.size() || round.segments[k + 1].line != segment.line;
        EXPECT_EQ(segment.ends_command, is_last) << k;
        ends += segment.ends_command ? 1 : 0;
    }
    EXPECT_EQ(ends, 3u);
    EXPECT_EQ(round.totals.commands, 3u);
}

TEST(Rounding, CornersThatStay) {
    const Command a = line_to({20, 0, 0}, 6000);
    const Command b = line_to({20, 20, 0}, 6000);
    Command stops = a;
    stops.motion().exact_stop = true;
    Command dwell = simple(Op::Dwell);
    dwell.dwell().time = 0.1;
    Command coolant = simple(Op::Coolant);
    Command turns = b;
    turns.motion().to[index(Axis::C)] = 90;
    turns.motion().moved |= bit(Axis::C);
    Command probes = b;
    probes.become(Op::Probe);
    machine::Machine machine = smooth_machine();
    machine::MachineAxis table;
    table.name = "C";
    table.axis = Axis::C;
    table.is_rotary = true;
    table.lower = -kUnlimited;
    table.upper = kUnlimited;
    table.velocity = 10;
    table.acceleration = 100;
    table.jerk = kUnlimited;
    machine.axes.push_back(table);
    for (const Way& way :
         {Way{"exact stop", {stops, b}}, Way{"dwell", {a, dwell, b}},
          Way{"coolant", {a, coolant, b}}, Way{"end", {a, simple(Op::OptionalStop), b}},
          Way{"a rotary axis", {a, turns}}, Way{"a probe", {a, probes}},
          Way{"straight on", {a, line_to({40, 0, 0}, 6000)}},
          Way{"back", {a, line_to({0, 0, 0}, 6000)}}, Way{"nothing behind it", {a}},
          Way{"tangent", {a, arc_to({30, 10, 0}, {20, 10, 0}, pi / 2, 6000)}}}) {
        SCOPED_TRACE(way.name);
        const Motion sharp = run(machine, way.commands);
        const Motion round = run(machine, rounded(way.commands, within(0.1)));
        EXPECT_EQ(round.totals.time, sharp.totals.time);
        EXPECT_LE(apart(round.segments, sharp.segments), 1e-9);
    }
}

TEST(Rounding, TangentsWhereOnlyTheCurvatureJumps) {
    // A jump of 1/5 mm between a line and an arc takes half of the jerk of an axis at once; a curve
    // on which the curvature grows does not.
    const auto machine = smooth_machine();
    for (const auto& [name, commands] :
         {Way{"line, arc, line",
              {line_to({20, 0, 0}, 12000), arc_to({25, 5, 0}, {20, 5, 0}, pi / 2, 12000),
               line_to({25, 25, 0}, 12000)}},
          Way{"arc, arc",
              {arc_to({10, 10, 0}, {0, 10, 0}, pi / 2, 12000),
               arc_to({20, 20, 0}, {20, 10, 0}, -pi / 2, 12000)}}}) {
        SCOPED_TRACE(name);
        const Motion sharp = run(machine, commands);
        const Motion round = run(machine, rounded(commands, within(0.02, true)));
        EXPECT_LT(round.totals.time, sharp.totals.time);
        const double miss = apart(round.segments, sharp.segments);
        EXPECT_LE(miss, 0.02);
        EXPECT_GT(miss, 0.005);
        const Motion plain = run(machine, rounded(commands, within(0.02)));
        EXPECT_EQ(plain.totals.time, sharp.totals.time);
    }
}

TEST(Rounding, RapidAndFeedHaveTheirOwnDistances) {
    const auto machine = machine_of();
    std::vector<Command> commands = {rapid_to({20, 0, 0}), rapid_to({20, 20, 0}),
                                     line_to({40, 20, 0}, 6000), line_to({40, 40, 0}, 6000)};
    for (Command& command : commands)
        command.motion().blending = by_distance(command.op() == Op::Rapid ? 4 : 1);
    const Motion round = run(machine, commands);
    // Of a square corner the middle is 31/180·√2 of the way from it; where rapid and feed meet, the
    // lesser distance holds.
    struct Row {
        std::uint32_t line;
        Vec3 corner;
        double distance;
    };
    for (const Row& row : {Row{1, {20, 0, 0}, 4}, Row{2, {20, 20, 0}, 1}, Row{3, {40, 20, 0}, 1}}) {
        EXPECT_NEAR(distance_to(round.segments, row.corner, row.line),
                    31.0 / 180 * std::sqrt(2.0) * row.distance, 1e-6);
    }
}

TEST(Rounding, InverseTimeIsSharedOut) {
    // Both blocks take a tenth of a second at their speed; the curve is a little shorter.
    std::vector<Command> commands = {line_to({20, 0, 0}, 600), line_to({20, 20, 0}, 600)};
    for (Command& command : commands) command.motion().feed_mode = path::FeedMode::InverseTime;
    const auto machine = machine_of();
    const Motion round = run(machine, rounded(commands, within(0.05)));
    for (const Segment& segment : round.segments) EXPECT_NEAR(segment.feed, 200, 1e-6);
}

TEST(Rounding, AnAlarmBehindTheCornerComesAfterTheMotionBefore) {
    machine::Machine machine = smooth_machine();
    machine.axes[0].upper = 30;
    const Motion round = run(
        machine,
        rounded({line_to({20, 0, 0}, 6000), line_to({20, 20, 0}, 6000), line_to({40, 20, 0}, 6000)},
                within(0.05)));
    EXPECT_TRUE(round.alarmed);
    ASSERT_FALSE(round.segments.empty());
    EXPECT_EQ(path::end(round.segments.back().curve), Vec3(20, 20, 0));
    EXPECT_EQ(round.segments.back().profile.exit_speed, 0);
}

}  // namespace
}  // namespace kadr::motion::corner_blend_test
