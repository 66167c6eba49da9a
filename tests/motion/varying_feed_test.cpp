// Of which axes F is the speed, and feeds that change along a motion.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/motion/support.h"

namespace kadr::motion::varying_feed_test {
namespace {

using namespace test;

constexpr double kPi = std::numbers::pi;

/// A program's dynamics with one thing said.
template <class Say>
Command under(Command command, Say say) {
    command.motion().dynamics.made();
    say(*command.motion().dynamics);
    return command;
}

/// The feed over the part of the way, in the unit of F.
Command with_feed(Command command, const std::array<double, 4>& feed) {
    return under(std::move(command), [&](path::Dynamics& d) { d.law.feed = feed; });
}

/// X, Y, Z and a rotary axis A of 20 rad/s and 100 rad/s².
machine::Machine with_rotary() {
    machine::Machine machine = machine_of();
    machine::MachineAxis axis;
    axis.name = "A";
    axis.axis = Axis::A;
    axis.is_rotary = true;
    axis.lower = -kUnlimited;
    axis.upper = kUnlimited;
    axis.velocity = 20;
    axis.acceleration = 100;
    axis.jerk = kUnlimited;
    machine.axes.push_back(axis);
    return machine;
}

Command turning(Command command, double degrees) {
    command.motion().to[index(Axis::A)] = degrees;
    command.motion().moved |= bit(Axis::A);
    return command;
}

/// A way at one speed, from rest to rest.
double time_of(double distance, double speed, double acceleration) {
    return distance / speed + speed / acceleration;
}

TEST(FeedAxes, TimesOfLines) {
    const auto group = [](AxisMask axes, double radius = path::kRadiusOfDegrees) {
        return [=](path::Dynamics& d) {
            d.feed_axes = axes;
            d.feed_radius[index(Axis::A)] = radius;
        };
    };
    constexpr AxisMask x = bit(Axis::X);
    constexpr AxisMask a = bit(Axis::A);
    // F6000 is 100 mm/s of the feed axes; X and Y have 5000 mm/s², A 100 rad/s².
    const Command diagonal = line_to({300, 400, 0}, 6000);
    const Command screw = turning(line_to({100, 0, 0}, 6000), 360);
    const Command turn = turning(line_to({0, 0, 0}, 6000), 360);
    Command inverse = under(diagonal, group(x));
    inverse.motion().feed_mode = path::FeedMode::InverseTime;
    inverse.motion().feed = 10;
    // 360 degrees are 360 mm beside the 100 of X.
    const double wide = std::hypot(100, 360);
    const double on_screw = 100 / (wide / 100);
    const double screw_ramp = 100 / (2 * kPi / 100);
    struct Row {
        const char* name;
        Command command;
        double time;
    };
    for (const Row& row : {
             Row{"of X and Y", diagonal, time_of(500, 100, 6250)},
             {"of X: it has 300 mm", under(diagonal, group(x)), time_of(500, 500 / 3.0, 6250)},
             {"the time of the block stays", inverse, time_of(500, 500 / 6.0, 6250)},
             {"A follows", screw, time_of(100, 100, screw_ramp)},
             {"A counts", under(screw, group(kLinearXYZ | a)), time_of(100, on_screw, screw_ramp)},
             {"of A alone, at 10 mm", under(screw, group(a, 10)),
              time_of(100, 100 * 100 / (2 * kPi * 10), screw_ramp)},
             {"A alone in deg/min", turn, time_of(360, 100, 18000 / kPi)},
             {"… at 20 mm", under(turn, group(0, 20)), time_of(2 * kPi, 100 / 20.0, 100)},
             {"no feed axis moves: 500 mm/s", under(line_to({0, 1000, 0}, 60), group(x)),
              time_of(1000, 500, 5000)},
             {"… but A, in deg/min", under(turn, group(x)), time_of(360, 100, 18000 / kPi)},
         }) {
        SCOPED_TRACE(row.name);
        EXPECT_NEAR(run(with_rotary(), {row.command}).totals.time, row.time, 1e-9);
    }
}

/// Over half a circle X goes 2·r and the path π·r: at its sides, where X stands, the axes alone
/// hold it.
TEST(FeedAxes, OnAnArcTheSpeedFollows) {
    const auto machine = machine_of();
    const Command arc = under(arc_to({0, 100, 0}, {0, 50, 0}, kPi, 600),
                              [](auto& d) { d.feed_axes = bit(Axis::X); });
    const auto points = sample(machine, {arc});
    std::size_t seen = 0;
    for (const Setpoint& point : points) {
        const double cosine = std::abs(point.tip[1] - 50) / 50;
        if (cosine < 0.2 || cosine > 0.95) continue;
        ++seen;
        EXPECT_NEAR(point.feed * cosine, 10, 0.02 * 10) << point.time;
    }
    EXPECT_GT(seen, 1000u);
}

TEST(AxisSpeed, OutsideOfTheFeedAxes) {
    const auto slow = [](path::Dynamics& d) { d.speed[index(Axis::A)] = 0.1; };
    const Command screw = turning(line_to({100, 0, 0}, 6000), 360);
    // A turns by 2π at 0.1 rad/s; it comes up to that at 100 rad/s².
    EXPECT_NEAR(run(with_rotary(), {under(screw, slow)}).totals.time, time_of(2 * kPi, 0.1, 100),
                1e-9);
    const Command fed =
        under(under(screw, slow), [](auto& d) { d.feed_axes = kLinearXYZ | bit(Axis::A); });
    EXPECT_LT(run(with_rotary(), {fed}).totals.time, 5);
}

// ------------------------------------------------------------------------------ courses

/// 100 mm at F1000, 100 mm on which it goes to F2000, 100 mm there.
std::vector<Command> rising() {
    return {line_to({100, 0, 0}, 1000), with_feed(line_to({200, 0, 0}, 2000), {1000, 1000, 0, 0}),
            line_to({300, 0, 0}, 2000)};
}

TEST(FeedCourse, TimeOfALine) {
    // ∫ ds/(v0 + (v1 − v0)·s/L) = L·ln(v1/v0)/(v1 − v0); the ramps cost v/2a each.
    const double v0 = 1000 / 60.0;
    const double v1 = 2000 / 60.0;
    const double expected =
        100 / v0 + v0 / 1e4 + 100 * std::log(v1 / v0) / (v1 - v0) + 100 / v1 + v1 / 1e4;
    EXPECT_NEAR(run(machine_of(), rising()).totals.time, expected, 1e-9);
    PlannerOptions half;
    half.feed_override = 0.5;
    const double slow =
        2 * (100 / v0 + 100 * std::log(v1 / v0) / (v1 - v0) + 100 / v1) + (v0 + v1) / 2e4;
    EXPECT_NEAR(run(machine_of(), rising(), half).totals.time, slow, 1e-9);
}

/// Of a block by the inverse of its time: 100 mm · F/60.
TEST(FeedCourse, InverseTime) {
    Command line = with_feed(line_to({100, 0, 0}, 20), {10, 10, 0, 0});
    line.motion().feed_mode = path::FeedMode::InverseTime;
    const double v0 = 100 * 10 / 60.0;
    const double v1 = 100 * 20 / 60.0;
    const double still = 100 * std::log(v1 / v0) / (v1 - v0);
    const double time = run(machine_of(), {line}).totals.time;
    EXPECT_GT(time, still);
    EXPECT_NEAR(time, still, 0.02);
}

struct Watched {
    std::size_t followed = 0;
    double farthest = 0;      // from the feed, in parts of it
    double acceleration = 0;  // greatest, of X and Y
    double jerk = 0;
};

/// What setpoints show of a feed over X, in mm/s, between two places.
template <class Feed>
Watched watch(const machine::Machine& machine, const std::vector<Setpoint>& points,
              const Feed& feed, double from, double to) {
    Watched seen;
    const double tick = machine.tick;
    for (std::size_t i = 3; i < points.size(); ++i) {
        const double x = points[i].tip[0];
        if (x > from && x < to) {
            ++seen.followed;
            seen.farthest = std::max(seen.farthest, std::abs(points[i].feed / feed(x) - 1));
        }
        // The last setpoint rests at the end, whatever is left of its tick.
        if (i + 1 == points.size()) continue;
        for (std::size_t a = 0; a < 2; ++a) {
            const auto at = [&](std::size_t back) { return points[i - back].axis[a]; };
            seen.acceleration =
                std::max(seen.acceleration, std::abs(at(0) - 2 * at(1) + at(2)) / (tick * tick));
            seen.jerk = std::max(
                seen.jerk, std::abs(at(0) - 3 * at(1) + 3 * at(2) - at(3)) / (tick * tick * tick));
        }
    }
    return seen;
}

TEST(FeedCourse, TheTipFollowsAtEveryTick) {
    struct Row {
        const char* name;
        std::array<double, 4> feed;
        double jerk;
    };
    for (const Row& row : {Row{"evenly", {1000, 1000, 0, 0}, kUnlimited},
                           {"falling", {3000, -2000, 0, 0}, kUnlimited},
                           {"cubic", {1000, 4000, -6000, 3000}, kUnlimited},
                           {"evenly, jerk", {1000, 1000, 0, 0}, 50000},
                           {"falling, jerk", {3000, -2000, 0, 0}, 50000},
                           {"cubic, jerk", {1000, 4000, -6000, 3000}, 50000}}) {
        SCOPED_TRACE(row.name);
        const auto machine = machine_of({.jerk = Vec3::Constant(row.jerk)});
        const double end = row.feed[0] + row.feed[1] + row.feed[2] + row.feed[3];
        const std::vector<Command> program = {line_to({100, 0, 0}, row.feed[0]),
                                              with_feed(line_to({200, 0, 0}, end), row.feed),
                                              line_to({300, 0, 0}, end)};
        const auto points = sample(machine, program);
        const auto feed = [&](double x) {
            const double p = (x - 100) / 100;
            return (row.feed[0] + p * (row.feed[1] + p * (row.feed[2] + p * row.feed[3]))) / 60;
        };
        // Where the acceleration begins and ends the jerk has its say.
        const double margin = std::isinf(row.jerk) ? 0 : 5;
        const Watched seen = watch(machine, points, feed, 100 + margin, 200 - margin);
        EXPECT_GT(seen.followed, 1000u);
        EXPECT_LE(seen.farthest, 1e-3);
        EXPECT_LE(seen.acceleration, 5000 * (1 + 1e-6));
        if (!std::isinf(row.jerk)) {
            EXPECT_LE(seen.jerk, row.jerk * (1 + 1e-3));
        }
    }
}

/// More than the axes can: they do what they can, and keep to what they may.
TEST(FeedCourse, TooSteep) {
    for (const double jerk : {kUnlimited, 50000.0}) {
        SCOPED_TRACE(jerk);
        const auto machine = machine_of({.jerk = Vec3::Constant(jerk)});
        const std::vector<Command> program = {
            line_to({50, 0, 0}, 1000), with_feed(line_to({51, 0, 0}, 30000), {1000, 29000, 0, 0}),
            line_to({300, 0, 0}, 30000),
            with_feed(line_to({301, 0, 0}, 500), {30000, -29500, 0, 0}), line_to({350, 0, 0}, 500)};
        const auto steep = [](double x) { return (1000 + 29000 * (x - 50)) / 60; };
        const Watched seen = watch(machine, sample(machine, program), steep, 1e9, 1e9);
        EXPECT_LE(seen.acceleration, 5000 * (1 + 1e-6));
        if (!std::isinf(jerk)) {
            EXPECT_LE(seen.jerk, jerk * (1 + 1e-3));
        }
        EXPECT_TRUE(run(machine, program).diagnostics.all().empty());
    }
}

/// From rest up to the feed, and down to a corner that is passed slowly: the ramps at both ends
/// differ, and neither of them jumps.
TEST(FeedCourse, BetweenRestAndASlowCorner) {
    for (const double jerk : {kUnlimited, 50000.0, 2000.0}) {
        for (const Vec3& aside : {Vec3(0, 100, 0), Vec3(100, 20, 0), Vec3(100, 3, 0)}) {
            SCOPED_TRACE(jerk);
            SCOPED_TRACE(aside.transpose());
            const auto machine = machine_of({.jerk = Vec3::Constant(jerk)});
            Command first = line_to({10, 0, 0}, 6000);
            first.motion().exact_stop = true;
            const Vec3 end = Vec3(110, 0, 0) + aside;
            const std::vector<Command> program = {
                first, with_feed(line_to({110, 0, 0}, 9000), {6000, 3000, 0, 0}),
                line_to({end[0], end[1], end[2]}, 9000)};
            const auto points = sample(machine, program);
            const Watched seen = watch(
                machine, points, [](double) { return 1.0; }, 1e9, 1e9);
            EXPECT_LE(seen.acceleration, 5000 * (1 + 1e-6));
            double fastest = 0;
            for (const Setpoint& point : points)
                if (point.tip[0] > 10 && point.tip[0] < 110)
                    fastest = std::max(fastest, point.feed);
            EXPECT_GT(fastest, 100);
        }
    }
}

/// Short blocks of one course are as one block with it.
TEST(FeedCourse, ShortBlocksGoOn) {
    for (const double jerk : {kUnlimited, 50000.0}) {
        SCOPED_TRACE(jerk);
        const auto machine = machine_of({.jerk = Vec3::Constant(jerk)});
        std::vector<Command> program = {line_to({100, 0, 0}, 1000)};
        for (int i = 0; i < 100; ++i) {
            program.push_back(
                with_feed(line_to({101.0 + i, 0, 0}, 1010 + 10 * i), {1000.0 + 10 * i, 10, 0, 0}));
        }
        program.push_back(line_to({300, 0, 0}, 2000));
        EXPECT_NEAR(run(machine, program).totals.time, run(machine, rising()).totals.time, 1e-4);
    }
}

OperatorEvent feed_to(double value, double time) {
    return {OperatorAct::FeedOverride, value, time, 0, -1};
}

PlannerOptions operated(std::vector<OperatorEvent> events) {
    PlannerOptions options;
    options.events = std::move(events);
    return options;
}

/// ∫ ds/f over the ramp of `rising` between two places, at 100 %.
double ramp_time(double from, double to) { return 6 * std::log(to / from); }

/// An operator who turns nothing changes nothing; who has turned the override before the start, and
/// whoever turns it far below 100 % and back, runs the same feed in parts of it.
TEST(FeedCourse, TimesUnderAnOperator) {
    const double plain = run(machine_of(), rising()).totals.time;
    EXPECT_NEAR(run(machine_of(), rising(), operated({feed_to(0.5, 1000)})).totals.time, plain,
                1e-9);
    PlannerOptions half;
    half.feed_override = 0.5;
    EXPECT_NEAR(run(machine_of(), rising(), operated({feed_to(0.5, 0)})).totals.time,
                run(machine_of(), rising(), half).totals.time, 1e-9);
    // The highest override of the run is not the programmed feed.
    EXPECT_NEAR(
        run(machine_of(), rising(), operated({feed_to(1.2, 0), feed_to(1, 1e-6)})).totals.time,
        plain, 1e-5);
    // Over 120 mm, where F would be 1200 (8.1 s), to half; at 160 mm back again. The ramps between,
    // of 0.002 s and 0.01 mm, cost as much before as they save behind.
    const double v = 1000 / 60.0;
    const double at_120 = 100 / v + v / 1e4 + ramp_time(1, 1.2);
    const double at_160 = at_120 + 2 * ramp_time(1.2, 1.6);
    const double changed =
        run(machine_of(), rising(), operated({feed_to(0.5, at_120), feed_to(1, at_160)}))
            .totals.time;
    EXPECT_NEAR(changed, plain + ramp_time(1.2, 1.6), 2e-3);
    // A hold costs its time; the ramps down and up lie half inside of it.
    const double held = run(machine_of(), rising(),
                            operated({{OperatorAct::FeedHold, 1, at_120, 0, -1},
                                      {OperatorAct::CycleStart, 1, at_120 + 3, 0, -1}}))
                            .totals.time;
    EXPECT_NEAR(held, plain + 3, 1e-3);
}

/// At every tick the tip has the feed of its place, times the override, but for the ramps between
/// two overrides; and the axes keep their limits.
TEST(FeedCourse, TheTipFollowsUnderAnOperator) {
    for (const double jerk : {kUnlimited, 50000.0}) {
        SCOPED_TRACE(jerk);
        const auto machine = machine_of({.jerk = Vec3::Constant(jerk)});
        std::vector<OperatorEvent> events;
        std::vector<std::pair<double, double>> dials = {{0, 1}};
        for (const auto& [value, time] :
             {std::pair(0.6, 6.5), {1.3, 7.4}, {0.1, 7.9}, {1.0, 8.6}, {0.85, 9.3}, {1.2, 13.0}}) {
            events.push_back(feed_to(value, time));
            dials.emplace_back(time, value);
        }
        const auto points = sample(machine, rising(), operated(events));
        const auto feed = [](double x) {
            return (1000 + 1000 * std::clamp((x - 100) / 100, 0.0, 1.0)) / 60;
        };
        std::size_t followed = 0;
        for (const Setpoint& point : points) {
            auto dial = dials.end() - 1;
            while (dial->first > point.time) --dial;
            const bool is_settled = point.time > dial->first + 0.08;
            const double x = point.tip[0];
            const bool is_inside =
                (x > 105 && x < 195) || (x > 10 && x < 95) || (x > 205 && x < 290);
            if (!is_settled || !is_inside) continue;
            ++followed;
            ASSERT_NEAR(point.feed, feed(x) * dial->second, 1e-6 * feed(x)) << point.time;
        }
        EXPECT_GT(followed, 8000u);
        const Watched seen = watch(machine, points, feed, 1e9, 1e9);
        EXPECT_LE(seen.acceleration, 5000 * (1 + 1e-6));
        if (!std::isinf(jerk)) {
            EXPECT_LE(seen.jerk, jerk * (1 + 1e-3));
        }
        EXPECT_EQ(points.back().tip[0], 300);
    }
}

/// Events that come one upon the other, in any place, leave a way without a gap.
TEST(FeedCourse, ManyEventsOnOneCourse) {
    for (const double jerk : {kUnlimited, 50000.0, 500.0}) {
        SCOPED_TRACE(jerk);
        const auto machine = machine_of({.jerk = Vec3::Constant(jerk)});
        std::vector<OperatorEvent> events;
        for (int i = 0; i < 400; ++i)
            events.push_back(feed_to(0.1 + 0.011 * ((i * 37) % 101), 5.5 + 0.0173 * i));
        const Motion motion = run(machine, rising(), operated(events));
        EXPECT_NEAR(motion.totals.length, 300, 1e-8);
        const auto points = sample(machine, rising(), operated(events));
        const Watched seen = watch(
            machine, points, [](double) { return 1.0; }, 1e9, 1e9);
        EXPECT_LE(seen.acceleration, 5000 * (1 + 1e-6));
        if (!std::isinf(jerk)) {
            EXPECT_LE(seen.jerk, jerk * (1 + 1e-3));
        }
    }
}

}  // namespace
}  // namespace kadr::motion::varying_feed_test
