// Planner: what each command does to the motion, to the time, and what is said about mistakes.
#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/motion/support.h"

namespace kadr::motion::planner_test {
namespace {

using namespace test;
constexpr double kPi = std::numbers::pi;

Command with_line(Command command, std::uint32_t line) {
    command.line = line;
    return command;
}

TEST(Planner, LineFromRestToRest) {
    // 10 mm at 50 mm/s with 5000 mm/s²: 10 ms up, 10 ms down, 9.5 mm between at 50 mm/s: 0.21 s.
    const Motion result = run(machine_of(), {line_to({10, 0, 0}, 3000)});
    ASSERT_EQ(result.segments.size(), 1u);
    const Segment& segment = result.segments[0];
    EXPECT_EQ(segment.kind, SegmentKind::Feed);
    EXPECT_EQ(segment.line, 1u);
    EXPECT_NEAR(segment.duration, 0.21, 1e-12);
    EXPECT_NEAR(segment.feed, 50, 1e-12);
    EXPECT_NEAR(result.totals.time, 0.21, 1e-12);
    EXPECT_NEAR(result.totals.cutting_time, 0.21, 1e-12);
    EXPECT_EQ(result.totals.rapid_time, 0);
    EXPECT_NEAR(result.totals.cutting_length, 10, 1e-12);
    EXPECT_EQ(result.totals.commands, 1u);
    EXPECT_EQ(result.totals.travel_max[0], 10);
    EXPECT_NEAR(result.totals.max_velocity[0], 50, 1e-9);
    EXPECT_NEAR(result.totals.max_acceleration[0], 5000, 1e-9);
    EXPECT_EQ(result.totals.max_velocity[1], 0);
}

TEST(Planner, RapidIsAStraightLineAsFastAsTheSlowestAxis) {
    // Along (3, 4, 0): X would allow 500/0.6, Y 500/0.8 = 625 mm/s; acceleration 5000/0.8.
    const Motion result = run(machine_of(), {rapid_to({300, 400, 0})});
    EXPECT_NEAR(result.segments[0].profile.peak_speed, 625, 1e-9);
    EXPECT_NEAR(result.segments[0].profile.acceleration, 6250, 1e-9);
    EXPECT_NEAR(result.totals.rapid_time, 500 / 625.0 + 625 / 6250.0, 1e-12);
    EXPECT_NEAR(result.totals.max_velocity[1], 500, 1e-9);
}

TEST(Planner, Overrides) {
    PlannerOptions options;
    options.feed_override = 0.5;
    options.rapid_override = 0.1;
    const Motion result =
        run(machine_of(), {rapid_to({100, 0, 0}), line_to({200, 0, 0}, 6000)}, options);
    EXPECT_NEAR(result.segments[0].profile.peak_speed, 50, 1e-9);
    EXPECT_NEAR(result.segments[1].profile.peak_speed, 50, 1e-9);
    EXPECT_NEAR(result.segments[1].feed, 50, 1e-9);
    options.feed_override = 20;  // 2000 mm/s: the axis still moves at 500 at most
    const Motion fast = run(machine_of(), {line_to({500, 0, 0}, 6000)}, options);
    EXPECT_NEAR(fast.segments[0].profile.peak_speed, 500, 1e-9);
}

TEST(Planner, MachineLimitsTheFeed) {
    auto machine = machine_of();
    machine.max_feed = 100;
    EXPECT_NEAR(run(machine, {line_to({200, 0, 0}, 30000)}).segments[0].profile.peak_speed, 100,
                1e-9);
    EXPECT_NEAR(run(machine, {rapid_to({200, 0, 0})}).segments[0].profile.peak_speed, 500, 1e-9);
}

/// Speeds at the ends of the motions but the last one.
std::vector<double> corner_speeds(const Motion& motion) {
    std::vector<double> speeds;
    for (const Segment& segment : motion.segments)
        if (segment.ends_command) speeds.push_back(segment.profile.exit_speed);
    speeds.pop_back();
    return speeds;
}

TEST(Planner, CornersOfTheDefaultRule) {
    // A square corner: each axis jumps by the path speed v, and within a tick of it the ramp on one
    // side has a fiftieth of 5000 mm/s². From tick to tick the axis changes by j + 0.02/2 of its
    // acceleration, j = v / (5000 mm/s² · 1 ms); that is 1 for j = 0.99.
    const double corner = 5 * 0.99;
    const Motion result = run(machine_of(), {line_to({10, 0, 0}, 6000), line_to({10, 10, 0}, 6000),
                                             line_to({20, 10, 0}, 6000)});
    EXPECT_EQ(result.segments.front().profile.entry_speed, 0);
    EXPECT_EQ(result.segments.back().profile.exit_speed, 0);
    const std::vector<double> speeds = corner_speeds(result);
    ASSERT_EQ(speeds.size(), 2u);
    for (const double speed : speeds) EXPECT_NEAR(speed, corner, 1e-12);
    // The way of a tick on either side of it is a piece of its own; beyond, the ramps have all.
    const double zone = 0.001 * (corner + 0.02 * 5 / 2);
    ASSERT_EQ(result.segments.size(), 7u);
    EXPECT_NEAR(result.segments[1].profile.length, zone, 1e-12);
    EXPECT_NEAR(result.segments[1].profile.deceleration, 100, 1e-9);
    EXPECT_NEAR(result.segments[2].profile.length, zone, 1e-12);
    EXPECT_NEAR(result.segments[3].profile.acceleration, 5000, 1e-9);
    // The tick is that of the machine.
    machine::Machine slow = machine_of();
    slow.tick = 0.002;
    const Motion slow_tick = run(slow, {line_to({10, 0, 0}, 9000), line_to({10, 10, 0}, 9000)});
    EXPECT_NEAR(corner_speeds(slow_tick).at(0), 2 * corner, 1e-12);
}

TEST(Planner, ACornerAtWhichAStopIsQuicker) {
    // Turning back, an axis jumps by twice the speed of the path; to pass it with a tenth less of
    // the acceleration costs more than to rest, which is the least time there is.
    const Motion result =
        run(machine_of(), {rapid_to({20, 0, 0}), rapid_to({0, 0, 0}), rapid_to({20, 0, 0})});
    EXPECT_EQ(result.segments[1].profile.entry_speed, 0);
    EXPECT_NEAR(result.segments.back().end_time(), 3 * 2 * std::sqrt(20.0 / 5000), 1e-9);
}

TEST(Planner, ExactStopEndsAtRest) {
    Command first = line_to({10, 0, 0}, 6000);
    first.motion().exact_stop = true;
    const Motion stopped = run(machine_of(), {first, line_to({20, 0, 0}, 6000)});
    EXPECT_EQ(stopped.segments[0].profile.exit_speed, 0);
    const Motion continuous =
        run(machine_of(), {line_to({10, 0, 0}, 6000), line_to({20, 0, 0}, 6000)});
    EXPECT_NEAR(continuous.segments[0].profile.exit_speed, 100, 1e-12);
    // An exact stop without motion still stops the path.
    Command still = line_to({10, 0, 0}, 6000);
    still.motion().exact_stop = true;
    const Motion pause =
        run(machine_of(), {line_to({10, 0, 0}, 6000), still, line_to({20, 0, 0}, 6000)});
    ASSERT_EQ(pause.segments.size(), 2u);
    EXPECT_EQ(pause.segments[0].profile.exit_speed, 0);
}

TEST(Planner, WhatStopsThePathAndWhatDoesNot) {
    Command dwell = simple(Op::Dwell);
    dwell.dwell().time = 0.5;
    Command message = simple(Op::Message);
    struct Row {
        const char* name;
        Command between;
        double expected;
    };
    for (const Row& row :
         {Row{"coolant", simple(Op::Coolant), 100}, Row{"message", message, 100},
          Row{"spindle", spindle_on(1000), 100}, Row{"dwell", dwell, 0},
          Row{"stop", simple(Op::Stop), 0}, Row{"optional stop", simple(Op::OptionalStop), 0},
          Row{"tool", simple(Op::Tool), 0}}) {
        SCOPED_TRACE(row.name);
        const Motion result =
            run(machine_of(), {line_to({10, 0, 0}, 6000), row.between, line_to({20, 0, 0}, 6000)});
        EXPECT_NEAR(result.segments[0].profile.exit_speed, row.expected, 1e-12);
    }
}

TEST(Planner, StandstillsTakeTheirTime) {
    auto machine = machine_of();
    machine.tool_change_time = 4;
    machine.orient_time = 0.5;
    Command dwell = simple(Op::Dwell);
    dwell.dwell().time = 0.25;
    Command turns = simple(Op::Dwell);
    turns.dwell().revolutions = 10;  // at 1200 rpm: 0.5 s
    Command orient = simple(Op::Spindle);
    orient.spindle().mode = path::SpindleMode::Orient;
    const Motion result = run(machine, {simple(Op::Tool), dwell, spindle_on(1200), turns, orient});
    ASSERT_EQ(result.segments.size(), 4u);
    EXPECT_EQ(result.segments[0].kind, SegmentKind::ToolChange);
    EXPECT_EQ(result.segments[1].kind, SegmentKind::Dwell);
    EXPECT_NEAR(result.segments[1].start_time, 4, 1e-12);
    EXPECT_EQ(result.segments[3].kind, SegmentKind::Orient);
    EXPECT_NEAR(result.totals.tool_change_time, 4, 1e-12);
    EXPECT_NEAR(result.totals.dwell_time, 0.25 + 0.5 + 0.5, 1e-12);
    EXPECT_NEAR(result.totals.time, 5.25, 1e-12);
    EXPECT_EQ(result.totals.segments, 0u);
}

TEST(Planner, BlocksWithoutWayAreNothing) {
    const Motion result = run(machine_of(), {line_to({0, 0, 0}, 6000), line_to({10, 0, 0}, 6000),
                                             line_to({10, 0, 0}, 6000), line_to({20, 0, 0}, 6000)});
    ASSERT_EQ(result.segments.size(), 2u);
    // Straight on over the block between.
    EXPECT_NEAR(result.segments[0].profile.exit_speed, 100, 1e-12);
    EXPECT_EQ(result.totals.commands, 4u);
}

TEST(Planner, ArcKeepsItsCentripetalAcceleration) {
    // Radius 10: v² / 10 ≤ 0.866 · 5000 mm/s², so v ≤ 208.1 mm/s. (Where the feed follows the
    // spindle, arcs are not planned in cells.)
    Command way = line_to({10, 0, 0}, 60);
    way.motion().exact_stop = true;
    Command arc = arc_to({10, 0, 0}, {0, 0, 0}, 20 * kPi, 60);
    way.motion().feed_mode = arc.motion().feed_mode = path::FeedMode::PerRevolution;
    const Motion result = run(machine_of(), {spindle_on(1000), way, arc});
    const Profile& profile = result.segments[1].profile;
    EXPECT_NEAR(profile.peak_speed, std::sqrt(10 * 0.8660254037844386 * 5000), 1e-6);
    EXPECT_NEAR(profile.acceleration, 2500, 1e-6);
    EXPECT_NEAR(result.totals.max_acceleration[0], 5000, 1e-6);
    EXPECT_NEAR(result.totals.travel_min[0], -10, 1e-12);
    EXPECT_NEAR(result.totals.travel_max[1], 10, 1e-12);
    way.motion().feed_mode = path::FeedMode::PerMinute;
    // At a crawl almost everything is left for the way along the path.
    way.motion().feed = 60;
    const Motion slow = run(machine_of(), {way, arc_to({10, 0, 0}, {0, 0, 0}, -2 * kPi, 60)});
    EXPECT_NEAR(slow.segments[1].profile.acceleration, 5000, 1e-3);
}

TEST(Planner, AFastArcUsesWhatBothAxesHave) {
    // Radius 10: at 45 degrees both axes turn the path, and v² may be √2·A·r; where one axis alone
    // does, A·r. From rest to rest that takes less time than at 208.1 mm/s with fixed shares.
    const auto machine = machine_of();
    const Motion result = run(machine, {arc_to({0, 0, 0}, {10, 0, 0}, 4 * kPi, 60000)});
    ASSERT_GT(result.segments.size(), 60u);
    for (const Segment& segment : result.segments) {
        EXPECT_LE(segment.profile.peak_speed, std::sqrt(std::numbers::sqrt2 * 10 * 5000));
    }
    EXPECT_GT(result.segments[result.segments.size() / 2].profile.peak_speed, 220);
    EXPECT_LE(result.totals.max_acceleration[0], 5000 * (1 + 1e-9));
    EXPECT_GT(result.totals.max_acceleration[0], 4900);
    EXPECT_LT(result.totals.time, 40 * kPi / 208.1 + 208.1 / 5000);
    EXPECT_EQ(result.segments.back().profile.exit_speed, 0);
    EXPECT_TRUE(result.segments.back().ends_command);
    EXPECT_FALSE(result.segments.front().ends_command);
}

TEST(Planner, AFastArcKeepsItsLimitsAtEveryLookAhead) {
    const std::vector<Command> program = {
        line_to({20, 0, 0}, 60000), arc_to({20, 20, 0}, {20, 10, 0}, kPi, 60000),
        line_to({0, 20, 0}, 60000), arc_to({-3, 17, 0}, {0, 17, 0}, kPi / 2, 60000),
        spline_to({-3, -20, 0}, {-3, 0, 0}, {30, -20, 0}, 60000)};
    const auto machine = machine_of();
    for (const std::size_t depth : {1u, 2u, 5u, 30u, 1000u}) {
        SCOPED_TRACE(depth);
        PlannerOptions options;
        options.lookahead = depth;
        const Motion result = run(machine, program, options);
        double exit = 0;
        for (const Segment& segment : result.segments) {
            EXPECT_NEAR(segment.profile.entry_speed, exit, 1e-12);
            exit = segment.profile.exit_speed;
            EXPECT_NEAR(state_at(segment.profile, segment.profile.duration()).distance,
                        path::length(segment.curve), 1e-12);
        }
        EXPECT_EQ(exit, 0);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_LE(result.totals.max_acceleration[i], machine.axes[i].acceleration * (1 + 1e-6));
        }
    }
}

TEST(Planner, TangentialArcHasNoCorner) {
    const Motion result = run(
        machine_of(), {line_to({10, 0, 0}, 3000), arc_to({20, 10, 0}, {10, 10, 0}, kPi / 2, 3000),
                       line_to({20, 20, 0}, 3000)});
    EXPECT_NEAR(result.segments[0].profile.exit_speed, 50, 1e-9);
    EXPECT_NEAR(result.segments[1].profile.exit_speed, 50, 1e-9);
}

TEST(Planner, FeedPerRevolution) {
    Command move = line_to({100, 0, 0}, 0.2);
    move.motion().feed_mode = path::FeedMode::PerRevolution;
    auto machine = machine_of();
    machine.max_speed = 100;  // rev/s: 6000 rpm
    const Motion result = run(machine, {spindle_on(1500), move});
    EXPECT_NEAR(result.segments[0].feed, 0.2 * 25, 1e-12);
    const Motion limited = run(machine, {spindle_on(12000), move});
    EXPECT_NEAR(limited.segments[0].feed, 0.2 * 100, 1e-12);
    ASSERT_EQ(limited.diagnostics.all().size(), 1u);
    EXPECT_EQ(limited.diagnostics.all()[0].row->code, "K6106");
    EXPECT_EQ(limited.diagnostics.all()[0].message(),
              "the spindle speed 12000 rpm is above the 6000 rpm of the machine");
}

TEST(Planner, PathsFollowTheMasterSpindleAlone) {
    Command move = line_to({100, 0, 0}, 0.2);
    move.motion().feed_mode = path::FeedMode::PerRevolution;
    auto machine = machine_of();
    machine.max_speed = 50;  // rev/s: 3000 rpm
    machine.orient_time = 0.25;
    machine.spindles = {{.number = 2, .max_speed = 100, .orient_time = 0.5}};
    const auto numbered = [](Command command, std::uint8_t number, Op op) {
        command.spindle().is_master = op == Op::Spindle;
        command.spindle().number = number;
        return command;
    };
    // Spindle 2 turns faster beside the master and changes nothing.
    const Motion first = run(machine, {numbered(spindle_on(1500), 1, Op::Spindle),
                                       numbered(spindle_on(4500), 2, Op::OtherSpindle), move});
    EXPECT_NEAR(first.segments[0].feed, 0.2 * 25, 1e-12);
    EXPECT_TRUE(first.diagnostics.all().empty());
    // As the master it has its own limit.
    const Motion second = run(machine, {numbered(spindle_on(1500), 1, Op::Spindle),
                                        numbered(spindle_on(4500), 2, Op::Spindle), move});
    EXPECT_NEAR(second.segments[0].feed, 0.2 * 75, 1e-12);
    EXPECT_TRUE(second.diagnostics.all().empty());
    const Motion limited = run(machine, {numbered(spindle_on(9000), 2, Op::Spindle), move});
    EXPECT_NEAR(limited.segments[0].feed, 0.2 * 100, 1e-12);
    ASSERT_EQ(limited.diagnostics.all().size(), 1u);
    EXPECT_EQ(limited.diagnostics.all()[0].message(),
              "the spindle speed 9000 rpm is above the 6000 rpm of the machine");
    // One beside the master is told of as well, and stands for as long as it needs.
    Command beside = numbered(spindle_on(9000), 2, Op::OtherSpindle);
    EXPECT_EQ(run(machine, {beside}).diagnostics.all().size(), 1u);
    beside.spindle().mode = path::SpindleMode::Orient;
    EXPECT_NEAR(run(machine, {beside}).totals.time, 0.5, 1e-12);
}

TEST(Planner, FacingAtConstantCuttingSpeed) {
    // From radius 50 to 0, V = 120 m/min = 2000 mm/s, f = 0.2 mm/rev, at most 3000 rpm = 50 rev/s:
    // above R = 2000/(2π·50) = 6.366 mm the time is π(50² − R²)/(f·V), below R/(f·50).
    auto machine = machine_of();
    machine.axes[0].home = 50;
    Command speed = spindle_on(120);
    speed.spindle().has_cutting_speed = true;
    Command limit = simple(Op::SpeedLimit);
    limit.speed_limit().most = 3000;
    Command face = line_to({0, 0, 0}, 0.2);
    face.motion().feed_mode = path::FeedMode::PerRevolution;
    const Motion result = run(machine, {limit, speed, face});
    const double edge = 2000 / (2 * kPi * 50);
    const double time = kPi * (2500 - edge * edge) / (0.2 * 2000) + edge / (0.2 * 50);
    EXPECT_NEAR(result.totals.time, time, 1e-3 * time);
    EXPECT_GT(result.segments.size(), 10u);
    EXPECT_NEAR(result.totals.cutting_length, 50, 1e-9);
    for (const Segment& segment : result.segments) EXPECT_EQ(segment.line, 3u);
}

TEST(Planner, FeedPerRevolutionFollowsTheSpindle) {
    // v = f·n(R), n = V/(2πR) up to the limit: within a hundredth at every tick, behind the ramp at
    // the start and before the one at the end. On a face of 390 mm down to the axis, on the pass of
    // the paper (200 m/min, 3000 rpm, f 0.3), on a taper and through the centre.
    struct Row {
        const char* name;
        double from;
        Vec3 to;
    };
    const double cutting_speed = 200e3 / 60;  // mm/s
    for (const double jerk : {kUnlimited, 50000.0}) {
        for (const Row& row : {Row{"a face of 780 mm", 390, {0, 0, 0}},
                               {"the paper's", 100, {0, 0, 0}},
                               {"through the centre", 100, {-100, 0, 0}},
                               {"outwards", 20, {150, 0, 0}},
                               {"a taper", 100, {5, 0, -200}}}) {
            SCOPED_TRACE(row.name);
            auto machine = machine_of({.jerk = Vec3::Constant(jerk)});
            machine.axes[0].home = row.from;
            Command speed = spindle_on(200);
            speed.spindle().has_cutting_speed = true;
            Command limit = simple(Op::SpeedLimit);
            limit.speed_limit().most = 3000;
            Command face = line_to(row.to, 0.3);
            face.motion().feed_mode = path::FeedMode::PerRevolution;
            const auto setpoints = sample(machine, {limit, speed, face});
            ASSERT_GT(setpoints.size(), 1000u);
            double worst = 0;
            for (std::size_t i = 100; i + 100 < setpoints.size(); ++i) {
                const double radius = std::max(std::abs(setpoints[i].tip[0]), 1e-3);
                const double turns = std::min(cutting_speed / (2 * kPi * radius), 50.0);
                worst = std::max(worst, std::abs(setpoints[i].feed / (0.3 * turns) - 1));
            }
            EXPECT_LT(worst, 0.01);
        }
    }
}

TEST(Planner, InverseTimeIsTheTimeOfTheBlock) {
    Command move = line_to({30, 40, 0}, 12);  // 1/12 min = 5 s
    move.motion().feed_mode = path::FeedMode::InverseTime;
    const Motion result = run(machine_of(), {move});
    EXPECT_NEAR(result.segments[0].feed, 10, 1e-12);
    EXPECT_NEAR(result.totals.time, 5, 0.01);  // and the ramps
}

TEST(Planner, ToolLengthMovesTheAxesNotTheTip) {
    Command length = simple(Op::ToolLength);
    length.tool_length().length = 100;
    Command down = line_to({0, 0, 5}, 6000);
    const Motion result =
        run(machine_of(), {rapid_to({0, 0, 50}), length, down, rapid_to({10, 0, 5})});
    ASSERT_EQ(result.segments.size(), 3u);
    // The axis stands at 50, so the tip of the tool that is now known stands at −50.
    EXPECT_LT((path::start(result.segments[1].curve) - Vec3(0, 0, -50)).norm(), 1e-12);
    EXPECT_LT((path::end(result.segments[1].curve) - Vec3(0, 0, 5)).norm(), 1e-12);
    EXPECT_EQ(result.segments[1].carrier, path::Vec3(0, 0, 100));
    EXPECT_NEAR(result.totals.travel_max[2], 105, 1e-12);
    EXPECT_NEAR(result.totals.travel_min[2], 0, 1e-12);
}

TEST(Planner, AnAxisThatIsNotProgrammedStands) {
    // The length is known to the control, and X alone moves: Z must not make up for the length.
    Command length = simple(Op::ToolLength);
    length.tool_length().length = 100;
    Command across = rapid_to({10, 0, 50});
    across.motion().moved = bit(Axis::X);
    const Motion result = run(machine_of(), {rapid_to({0, 0, 50}), length, across});
    EXPECT_NEAR(result.segments.back().profile.length, 10, 1e-12);
    EXPECT_NEAR(result.totals.travel_max[2], 50, 1e-12);
}

TEST(Planner, ToolLengthFollowsThePlane) {
    Command length = simple(Op::ToolLength);
    length.tool_length().length = 10;
    length.tool_length().plane = path::Plane::Zx;
    const Motion result = run(machine_of(), {length, line_to({0, 20, 0}, 6000)});
    EXPECT_NEAR(result.totals.travel_max[1], 30, 1e-12);
    EXPECT_EQ(result.segments[0].tool, Vec3::UnitY());
}

TEST(Planner, MachineCoordinatesDoNotCountTheLength) {
    Command length = simple(Op::ToolLength);
    length.tool_length().length = 100;
    Command up = rapid_to({0, 0, 200});
    up.motion().machine_coordinates = true;
    up.motion().moved = bit(Axis::Z);
    const Motion result = run(machine_of(), {length, line_to({5, 5, 0}, 6000), up});
    EXPECT_LT((path::end(result.segments.back().curve) - Vec3(5, 5, 100)).norm(), 1e-12);
    EXPECT_NEAR(result.totals.travel_max[2], 200, 1e-12);
}

machine::Machine with_rotary() {
    auto machine = machine_of();
    machine::MachineAxis axis;
    axis.name = "C";
    axis.axis = Axis::C;
    axis.is_rotary = true;
    axis.lower = -kPi;
    axis.upper = kPi;
    axis.velocity = 2 * kPi;
    axis.acceleration = 20;
    machine.axes.push_back(axis);
    return machine;
}

TEST(Planner, RotaryAxesFollowOrMakeThePath) {
    Command both = line_to({100, 0, 0}, 600);
    both.motion().to[index(Axis::C)] = 90;
    Command turn = line_to({100, 0, 0}, 600);
    turn.motion().to[index(Axis::C)] = 0;
    const Motion result = run(with_rotary(), {both, turn});
    ASSERT_EQ(result.segments.size(), 2u);
    // 100 mm at 10 mm/s, and C comes along: π/2 in 100 mm.
    EXPECT_FALSE(result.segments[0].is_rotary_only);
    EXPECT_NEAR(result.segments[0].profile.length, 100, 1e-12);
    EXPECT_NEAR(result.segments[0].follower_rate[index(Axis::C) - 3], kPi / 200, 1e-15);
    // 90 degrees at 600 deg/min.
    EXPECT_TRUE(result.segments[1].is_rotary_only);
    EXPECT_NEAR(result.segments[1].profile.length, 90, 1e-12);
    EXPECT_NEAR(result.segments[1].duration, 9, 0.05);
    EXPECT_EQ(result.segments[0].profile.exit_speed, 0);  // mm/s and deg/s do not meet
    EXPECT_NEAR(result.totals.travel_max[3], kPi / 2, 1e-15);
    EXPECT_NEAR(result.totals.length, 100, 1e-12);
}

TEST(Planner, StraightLineInPiecesTakesTheSameTime) {
    const double whole = run(machine_of(), {line_to({123, 45, 6}, 12000)}).totals.time;
    for (const int pieces : {2, 3, 10, 1000}) {
        std::vector<Command> commands;
        for (int i = 1; i <= pieces; ++i) {
            commands.push_back(line_to(Vec3(123, 45, 6) * i / pieces, 12000));
        }
        EXPECT_NEAR(run(machine_of(), commands).totals.time, whole, 1e-9) << pieces;
    }
}

TEST(Planner, BlocksAtTheEdgeOfRounding) {
    // A nanometre and less at full speed: v² + 2·a·S is v² up to the last digits.
    std::vector<Command> commands = {line_to({100, 0, 0}, 30000)};
    double x = 100;
    for (int i = 0; i < 2000; ++i) {
        x += std::pow(10.0, -3 - i % 9);
        commands.push_back(line_to({x, 0, 0}, 30000));
    }
    commands.push_back(line_to({x + 100, 0, 0}, 30000));
    const double whole = run(machine_of(), {line_to({x + 100, 0, 0}, 30000)}).totals.time;
    PlannerOptions options;
    options.lookahead = 4096;  // more than the braking distance, which is full of blocks here
    EXPECT_NEAR(run(machine_of(), commands, options).totals.time, whole, 1e-7);
}

TEST(Planner, TotalsDoNotDependOnTheBatch) {
    std::vector<Command> commands;
    for (int i = 1; i <= 3000; ++i) {
        commands.push_back(
            line_to({std::sin(i * 0.01) * 50, std::cos(i * 0.013) * 50, i * 0.001}, 8000));
    }
    const Motion small = run(machine_of(), commands);
    DiagnosticList diagnostics;
    CommandList list(commands);
    const auto machine = machine_of();
    Planner planner(list, machine, {}, diagnostics);
    std::vector<Segment> large(5000);
    while (planner.pull(large) > 0) {
    }
    EXPECT_EQ(planner.totals().time, small.totals.time);
    EXPECT_EQ(planner.totals().commands, 3000u);
}

// --- mistakes -----------------------------------------------------------------------------------

TEST(PlannerMistakes, AxisBeyondItsLimit) {
    auto machine = machine_of();
    machine.axes[0].upper = 300;
    machine.axes[0].lower = -300;
    const Motion result =
        run(machine, {line_to({100, 0, 0}, 6000), with_line(line_to({350.5, 0, 0}, 6000), 12),
                      line_to({0, 0, 0}, 6000)});
    EXPECT_TRUE(result.alarmed);
    ASSERT_EQ(result.diagnostics.all().size(), 1u);
    const Diagnostic& said = result.diagnostics.all()[0];
    EXPECT_EQ(said.row->code, "K6101");
    EXPECT_EQ(said.message(), "axis X reaches 350.5 mm, its limit is 300 mm");
    EXPECT_EQ(said.line.value().line, 12u);
    // The motion ends before the block, at rest.
    ASSERT_EQ(result.segments.size(), 1u);
    EXPECT_EQ(result.segments[0].profile.exit_speed, 0);
    EXPECT_EQ(result.totals.travel_max[0], 100);
}

TEST(PlannerMistakes, ACrestBeyondTheLimit) {
    auto machine = machine_of();
    machine.axes[1].upper = 9;
    EXPECT_TRUE(run(machine, {line_to({10, 0, 0}, 6000), arc_to({-10, 0, 0}, {0, 0, 0}, kPi, 6000)})
                    .alarmed);
    machine.axes[1].upper = 10;  // touched, not passed
    EXPECT_FALSE(
        run(machine, {line_to({10, 0, 0}, 6000), arc_to({-10, 0, 0}, {0, 0, 0}, kPi, 6000)})
            .alarmed);
}

TEST(PlannerMistakes, TheToolLengthCounts) {
    auto machine = machine_of();
    machine.axes[2].upper = 100;
    Command length = simple(Op::ToolLength);
    length.tool_length().length = 80;
    const Motion result = run(machine, {length, line_to({0, 0, 30}, 6000)});
    ASSERT_EQ(result.diagnostics.all().size(), 1u);
    EXPECT_EQ(result.diagnostics.all()[0].message(), "axis Z reaches 110 mm, its limit is 100 mm");
}

TEST(PlannerMistakes, GoesOnIfAsked) {
    auto machine = machine_of();
    machine.axes[0].upper = 300;
    PlannerOptions options;
    options.stop_at_alarm = false;
    // Out, further out, in, and out again: two messages.
    const Motion result =
        run(machine,
            {line_to({350, 0, 0}, 6000), line_to({360, 0, 0}, 6000), line_to({0, 0, 0}, 6000),
             line_to({-5, 0, 0}, 6000), line_to({301, 0, 0}, 6000)},
            options);
    EXPECT_EQ(result.segments.size(), 5u);
    EXPECT_EQ(result.diagnostics.all().size(), 2u);
}

TEST(PlannerMistakes, AxisThatTheMachineHasNot) {
    Command turn = line_to({10, 0, 0}, 600);
    turn.motion().to[index(Axis::B)] = 30;
    const Motion result = run(machine_of(), {turn});
    ASSERT_EQ(result.diagnostics.all().size(), 1u);
    EXPECT_EQ(result.diagnostics.all()[0].row->code, "K6102");
    EXPECT_EQ(result.diagnostics.all()[0].message(), "the machine `test` has no axis B");
    EXPECT_TRUE(result.segments.empty());
}

TEST(PlannerMistakes, AnArcThroughAnAxisThatTheMachineHasNot) {
    auto machine = machine_of();
    machine.axes.erase(machine.axes.begin() + 1);  // X and Z
    const Motion result = run(machine, {arc_to({0, 0, 0}, {10, 0, 0}, 2 * kPi, 600)});
    ASSERT_EQ(result.diagnostics.all().size(), 1u);
    EXPECT_EQ(result.diagnostics.all()[0].message(), "the machine `test` has no axis Y");
}

TEST(PlannerMistakes, FeedMissing) {
    PlannerOptions options;
    options.stop_at_alarm = false;
    const Motion result =
        run(machine_of(), {line_to({10, 0, 0}, 0), line_to({20, 0, 0}, 0)}, options);
    ASSERT_EQ(result.diagnostics.all().size(), 1u) << "one mistake, one message";
    EXPECT_EQ(result.diagnostics.all()[0].row->code, "K6103");
    EXPECT_NEAR(result.totals.time, 20, 0.01);  // 1 mm/s
    EXPECT_TRUE(run(machine_of(), {line_to({10, 0, 0}, 0)}).segments.empty());
}

TEST(PlannerMistakes, ThreadFasterThanTheAxes) {
    // X reaches 500 mm/s = 30000 mm/min: 10 mm a turn at 3000 rpm, not at 3100.
    Command spindle = simple(Op::Spindle);
    spindle.spindle().mode = path::SpindleMode::Cw;
    spindle.spindle().speed = 3000;
    Command thread = line_to({300, 0, 0}, 10);
    thread.become(Op::Thread);
    thread.motion().feed_mode = path::FeedMode::PerRevolution;
    PlannerOptions slow;
    slow.feed_override = 0.1;
    auto machine = machine_of();
    machine.max_feed = 100;
    const Motion cut = run(machine, {spindle, thread}, slow);
    EXPECT_TRUE(cut.diagnostics.all().empty());
    ASSERT_EQ(cut.segments.size(), 1u);
    EXPECT_NEAR(cut.segments[0].feed, 500, 1e-9) << "no override and no limit of the feed acts";
    spindle.spindle().speed = 3100;
    const Motion fast = run(machine_of(), {spindle, thread});
    ASSERT_EQ(fast.diagnostics.all().size(), 1u);
    EXPECT_EQ(fast.diagnostics.all()[0].row->code, "K6107");
}

TEST(PlannerMistakes, SpindleStands) {
    Command move = line_to({10, 0, 0}, 0.2);
    move.motion().feed_mode = path::FeedMode::PerRevolution;
    const Motion feed = run(machine_of(), {move});
    ASSERT_EQ(feed.diagnostics.all().size(), 1u);
    EXPECT_EQ(feed.diagnostics.all()[0].row->code, "K6104");
    Command dwell = simple(Op::Dwell);
    dwell.dwell().revolutions = 3;
    const Motion wait = run(machine_of(), {dwell});
    ASSERT_EQ(wait.diagnostics.all().size(), 1u);
    EXPECT_EQ(wait.diagnostics.all()[0].row->code, "K6105");
    EXPECT_EQ(wait.diagnostics.all()[0].message(),
              "the dwell is 3 revolutions, and the spindle stands");
}

TEST(PlannerMistakes, PlaceComesFromTheCaller) {
    PlannerOptions options;
    options.locate_command = [](const CommandLocation& asked) {
        ShownLocation place;
        place.line.file = "part.mpf";
        place.line.line = asked.line + 100;
        place.calls.push_back({"main.mpf", 7, 1, 4, "PART"});
        return place;
    };
    const Motion result = run(machine_of(), {line_to({10, 0, 0}, 0)}, options);
    EXPECT_EQ(result.diagnostics.all().at(0).line.value().file, "part.mpf");
    EXPECT_EQ(result.diagnostics.all().at(0).line.value().line, 101u);
    ASSERT_EQ(result.diagnostics.all().at(0).notes.size(), 1u);
    EXPECT_EQ(result.diagnostics.all().at(0).notes[0].line.value().file, "main.mpf");
    EXPECT_EQ(result.diagnostics.all().at(0).notes[0].text, "called here");
}

}  // namespace
}  // namespace kadr::motion::planner_test
