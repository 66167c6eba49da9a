// The scanner as a motion module beside the axes: programs as segments, setpoints and lists.
#include "process/scanner.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "process/planned_motion.h"
#include "tests/motion/support.h"
#include "tests/process/keep.h"

namespace kadr::process::scanner_test {
namespace {

using motion::Segment;
using motion::SegmentKind;
using motion::Setpoint;
using motion::test::arc_to;
using motion::test::line_to;
using motion::test::rapid_to;
using motion::test::simple;
using path::Command;
using path::Op;
using path::Vec3;

constexpr double kFeed = 60000;  // mm/min: 1 m/s

machine::Machine scanner_of() {
    machine::Machine machine = motion::test::machine_of({{500, 500, 500}, {3000, 3000, 3000}});
    machine.tick = 0.001;
    machine.scanner = machine::Scanner{};
    machine::Scanner& scanner = *machine.scanner;
    scanner.half_field = 50;
    scanner.jump_speed = 8000;
    scanner.delays = {.jump = 300e-6,
                      .mark = 200e-6,
                      .polygon = 100e-6,
                      .polygon_turning = false,
                      .laser_on = 80e-6,
                      .laser_off = 120e-6};
    scanner.pulse = 20000;
    return machine;
}

struct Scanned {
    std::vector<Segment> segments;
    std::vector<Setpoint> setpoints;
    std::vector<ScanList> lists;
    std::vector<double> starts;
    ScanFigures figures;
    motion::Totals totals;
    std::uint64_t executed = 0;
    DiagnosticList diagnostics;
};

/// Gives so many commands a pull at most.
class Portions final : public Stream<Command> {
  public:
    Portions(Stream<Command>& from, std::size_t most) : from_(from), most_(most) {}
    std::size_t pull(std::span<Command> out) override {
        return from_.pull(out.first(std::min(most_, out.size())));
    }

  private:
    Stream<Command>& from_;
    std::size_t most_;
};

void run(const machine::Machine& machine, std::vector<Command> commands, Scanned& out,
         std::size_t batch_size = 13, std::size_t portion = 1000) {
    motion::test::CommandList list(std::move(commands));
    Portions portions(list, portion);
    PlannedMotion::Onlookers onlookers;
    onlookers.list = [&](const StartedList& started) {
        out.lists.push_back(started.list);
        out.starts.push_back(started.start_time);
    };
    PlannedMotion motion(portions, machine, {}, out.diagnostics, onlookers);
    out.setpoints = test::sampled(motion, machine, out.segments, batch_size);
    out.figures = *motion.scan();
    out.totals = motion.totals();
    out.executed = motion.executed();
}

std::vector<Command> with_scanner(const Vec3& stage, std::vector<Command> inside) {
    std::vector<Command> commands = {rapid_to(stage), simple(Op::ScannerOn)};
    commands.insert(commands.end(), inside.begin(), inside.end());
    commands.push_back(rapid_to(stage));
    commands.push_back(simple(Op::ScannerOff));
    return commands;
}

std::vector<ScanCommand::Kind> kinds_of(const ScanList& list) {
    std::vector<ScanCommand::Kind> kinds;
    for (const ScanCommand& command : list.commands) kinds.push_back(command.kind);
    return kinds;
}

/// One corner: a jump of 40 mm at 8 m/s, two marks of 10 mm at 1 m/s, a jump of 50 mm back.
///   40/8000 = 5 ms, + 0.3; 10 ms, + 0.1; 10 ms, + 0.2; √(40² + 30²) = 50: 6.25 ms, + 0.3
TEST(Scanner, TimesOfAList) {
    Scanned done;
    run(scanner_of(),
        with_scanner({100, 50, 0}, {rapid_to({140, 50, 0}), line_to({140, 60, 0}, kFeed),
                                    line_to({140, 80, 0}, 2 * kFeed)}),
        done);
    ASSERT_TRUE(done.diagnostics.all().empty());
    ASSERT_EQ(done.lists.size(), 1u);
    const ScanList& list = done.lists.front();
    EXPECT_NEAR(list.duration, 5e-3 + 0.3e-3 + 10e-3 + 0.1e-3 + 10e-3 + 0.2e-3 + 6.25e-3 + 0.3e-3,
                1e-9);
    using Kind = ScanCommand::Kind;
    EXPECT_EQ(kinds_of(list), (std::vector<Kind>{Kind::Jump, Kind::MarkSpeed, Kind::Mark,
                                                 Kind::MarkSpeed, Kind::Mark, Kind::Jump}));
    EXPECT_TRUE(list.commands[0].to.isApprox(Vec2(40, 0)));
    EXPECT_TRUE(list.commands[2].to.isApprox(Vec2(40, 10)));
    EXPECT_NEAR(list.commands[2].value, 10e-3, 1e-12);
    EXPECT_NEAR(list.commands[3].value, 2000, 1e-9);
    EXPECT_NEAR(list.commands[5].to.norm(), 0, 1e-9);
    EXPECT_EQ(done.figures.marks, 2u);
    EXPECT_EQ(done.figures.jumps, 2u);
    EXPECT_NEAR(done.figures.mark_length, 30, 1e-9);
    EXPECT_NEAR(done.figures.mark_time, 20e-3, 1e-9);
    EXPECT_NEAR(done.totals.external_time, list.duration, 1e-9);
    EXPECT_EQ(done.executed, 7u);
    // The beam is on from 80 us behind the first mark's start to 120 us behind the last one's end:
    // 20 ms + 0.1 ms + 0.04 ms, at 20 kHz 402.8 periods: 403 pulses with the one at its start.
    EXPECT_EQ(done.figures.pulses, 403u);
}

TEST(Scanner, TheStageStandsAndTheTipGoes) {
    Scanned done;
    run(scanner_of(),
        with_scanner({100, 50, 5}, {rapid_to({110, 50, 5}), arc_to({110, 50, 5}, {100, 50, 5},
                                                                   2 * std::numbers::pi, kFeed)}),
        done);
    ASSERT_TRUE(done.diagnostics.all().empty());
    const double begin = done.starts.at(0);
    const double end = begin + done.lists[0].duration;
    std::uint64_t pulses = 0;
    int inside = 0;
    for (const Setpoint& setpoint : done.setpoints) {
        pulses += setpoint.pulses;
        if (setpoint.time < begin) continue;
        EXPECT_NEAR(setpoint.axis[0], 100, 1e-9);
        EXPECT_NEAR(setpoint.axis[1], 50, 1e-9);
        EXPECT_NEAR(setpoint.axis[2], 5, 1e-9);
        if (setpoint.time > end || setpoint.feed < 900 || setpoint.feed > 1100) continue;
        EXPECT_NEAR((setpoint.tip - Vec3(100, 50, 5)).norm(), 10, 1e-9);
        ++inside;
    }
    EXPECT_EQ(pulses, done.figures.pulses);
    EXPECT_NEAR(inside, 2 * std::numbers::pi * 10, 2);
    // Short vectors: c² ≤ 8·r·e gives at least 2π·10/√(8·10·0.002) = 157 of them.
    EXPECT_GE(done.lists[0].commands.size(), 157u);
    EXPECT_LE(done.lists[0].commands.size(), 600u);
    for (const ScanCommand& command : done.lists[0].commands) {
        if (command.kind == ScanCommand::Kind::Micro) {
            EXPECT_NEAR(command.to.norm(), 10, 1e-9);
        }
    }
}

TEST(Scanner, ThePolygonDelayTurns) {
    machine::Machine machine = scanner_of();
    machine.scanner->delays.polygon_turning = true;
    // Straight on: nothing; square: half; back: all of it. Jumps of nothing are none.
    const struct {
        Vec3 behind;
        double delay;
    } rows[] = {{{20, 0, 0}, 0}, {{10, 10, 0}, 50e-6}, {{0, 0, 0}, 100e-6}};
    for (const auto& row : rows) {
        Scanned done;
        run(machine,
            {simple(Op::ScannerOn), line_to({10, 0, 0}, kFeed), line_to(row.behind, kFeed)}, done);
        ASSERT_EQ(done.lists.size(), 1u);
        EXPECT_NEAR(done.lists[0].duration, 20e-3 + row.delay + 200e-6, 1e-9);
    }
}

/// A beam that comes early comes during the jump delay: 60 us more than the mark and 120 us behind.
TEST(Scanner, ABeamMayComeBeforeTheMark) {
    machine::Machine machine = scanner_of();
    machine.scanner->delays.laser_on = -60e-6;
    Scanned done;
    run(machine, {simple(Op::ScannerOn), rapid_to({8, 0, 0}), line_to({9, 0, 0}, kFeed)}, done);
    // 1 ms + 0.06 ms + 0.12 ms, at 20 kHz 23.6 periods
    EXPECT_EQ(done.figures.pulses, 24u);
    ASSERT_EQ(done.segments.size(), 4u);
    EXPECT_EQ(done.segments[1].kind, SegmentKind::External);
    EXPECT_NEAR(done.segments[1].train.first, 240e-6, 1e-12);
    EXPECT_EQ(done.segments[1].train.count, 2u);
}

TEST(Scanner, ADwellWaitsOrExposes) {
    Command dwell = simple(Op::Dwell);
    dwell.dwell().time = 0.0015;
    Command off = simple(Op::Spindle);
    Scanned done;
    run(scanner_of(),
        {simple(Op::ScannerOn), rapid_to({8, 0, 0}), dwell, motion::test::spindle_on(100), dwell,
         off, dwell},
        done);
    ASSERT_TRUE(done.diagnostics.all().empty());
    EXPECT_EQ(done.figures.pulses, 30u);  // 1.5 ms at 20 kHz
    ASSERT_EQ(done.lists.size(), 3u);
    EXPECT_EQ(done.lists[0].commands.back().kind, ScanCommand::Kind::Wait);
    EXPECT_EQ(done.lists[1].commands.back().kind, ScanCommand::Kind::Expose);
    EXPECT_EQ(done.lists[2].commands.back().kind, ScanCommand::Kind::Wait);
}

TEST(Scanner, TheMatrixLeadsBack) {
    machine::Machine machine = scanner_of();
    // A quarter turn and twice the size: field x goes to workpiece y.
    machine.scanner->matrix = {0, -2, 2, 0};
    Scanned done;
    run(machine, with_scanner({0, 0, 0}, {rapid_to({0, 20, 0}), line_to({-20, 20, 0}, kFeed)}),
        done);
    ASSERT_EQ(done.lists.size(), 1u);
    EXPECT_TRUE(done.lists[0].commands[0].to.isApprox(Vec2(10, 0)));
    EXPECT_TRUE(done.lists[0].commands[2].to.isApprox(Vec2(10, 10)));
    // Jumps are as fast as the mirrors: 10 mm of field. Marks are at F on the workpiece.
    EXPECT_NEAR(done.lists[0].commands[0].value, 10.0 / 8000, 1e-9);
    EXPECT_NEAR(done.lists[0].commands[2].value, 20e-3, 1e-9);
}

/// A field that is 1 % too large at one corner of the table: bilinear in between.
TEST(Scanner, TheTableCorrects) {
    machine::Machine machine = scanner_of();
    machine.scanner->correction = {.x = {-50, 0, 50},
                                   .y = {-50, 0, 50},
                                   .dx = {0, 0, 0, 0, 0, 0, 0, 0, -0.5},
                                   .dy = {0, 0, 0, 0, 0, 0, 0, 0, 0.25}};
    const ScanField field(*machine.scanner);
    EXPECT_TRUE(field.corrected({-10, 30}).isApprox(Vec2(-10, 30)));
    EXPECT_TRUE(field.corrected({25, 25}).isApprox(Vec2(25 - 0.125, 25 + 0.0625)));
    EXPECT_TRUE(field.corrected({50, 50}).isApprox(Vec2(49.5, 50.25)));
    // A straight line across the distorted corner is bent for the mirrors: a parabola whose middle
    // is (0.5 + 0.25)/√2/4 = 0.133 mm beside its chord. Halved until 4^n ≥ 0.133/0.002: 16 vectors.
    Scanned done;
    run(machine, with_scanner({0, 0, 0}, {line_to({50, 50, 0}, kFeed)}), done);
    ASSERT_EQ(done.lists.size(), 1u);
    std::size_t vectors = 0;
    Vec2 from = Vec2::Zero();
    for (const ScanCommand& command : done.lists[0].commands) {
        if (command.kind != ScanCommand::Kind::Micro && command.kind != ScanCommand::Kind::Mark)
            continue;
        ++vectors;
        // The middle of each vector against the table's own middle.
        const Vec2 share = (command.to + from) / 2;
        Vec2 point = share;
        for (int i = 0; i < 50; ++i) point += share - field.corrected(point);
        EXPECT_NEAR(point.x(), point.y(), 2 * machine.scanner->chord_tolerance);
        from = command.to;
    }
    EXPECT_EQ(vectors, 16u);
}

// A table of rough steps bends a straight mark at every line that it crosses: no place of the mark
// is farther from its vectors than the tolerance.
TEST(Scanner, MarksKeepTheToleranceAtTheLinesOfTheTable) {
    machine::Machine machine = scanner_of();
    machine::FieldGrid& grid = machine.scanner->correction;
    constexpr int kLines = 11;
    for (int i = 0; i < kLines; ++i) grid.x.push_back(-50 + 10 * i);
    grid.y = grid.x;
    for (int i = 0; i < kLines * kLines; ++i) {
        grid.dx.push_back(0.02 * ((i * 7) % 5 - 2));
        grid.dy.push_back(0.02 * ((i * 11) % 7 - 3));
    }
    const ScanField field(*machine.scanner);
    const double tolerance = machine.scanner->chord_tolerance;
    for (int k = 0; k < 40; ++k) {
        SCOPED_TRACE(k);
        const Vec3 from(-45 + k, 40 - 1.7 * k, 0);
        const Vec3 to(47 - 1.3 * k, -44 + 0.9 * k, 0);
        const path::Curve mark = path::make_line(from, to);
        const std::vector<FieldStep> steps = field.vectors(mark, Vec3::Zero());
        Vec2 begin = field.corrected(from.head<2>());
        double done = 0;
        double farthest = 0;
        for (const FieldStep& step : steps) {
            constexpr int kPlaces = 50;
            for (int i = 1; i < kPlaces; ++i) {
                const double share = std::lerp(done, step.share, i / double{kPlaces});
                const Vec2 point = field.corrected((from + share * (to - from)).head<2>());
                const Vec2 chord = step.to - begin;
                const double along =
                    std::clamp((point - begin).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
                farthest = std::max(farthest, (point - begin - along * chord).norm());
            }
            begin = step.to;
            done = step.share;
        }
        EXPECT_LE(farthest, tolerance);
    }
}

TEST(Scanner, LongListsAreCut) {
    machine::Machine machine = scanner_of();
    machine.scanner->list_size = 10;
    std::vector<Command> marks;
    for (int i = 0; i < 100; ++i)
        marks.push_back(line_to({i % 2 == 0 ? 1.0 : 0.0, 0.1 * i, 0}, kFeed));
    Scanned whole;
    run(scanner_of(), with_scanner({0, 0, 0}, marks), whole);
    Scanned cut;
    run(machine, with_scanner({0, 0, 0}, marks), cut);
    EXPECT_EQ(whole.lists.size(), 1u);
    EXPECT_GT(cut.lists.size(), 9u);
    EXPECT_NEAR(cut.figures.time, whole.figures.time, 1e-9);
    EXPECT_EQ(cut.figures.pulses, whole.figures.pulses);
    EXPECT_EQ(cut.figures.marks, 100u);
    EXPECT_NEAR(cut.totals.time, whole.totals.time, 1e-9);
}

/// Whatever the batches are, the setpoints are the same.
TEST(Scanner, BatchesDoNotShow) {
    std::vector<Command> commands;
    for (int field = 0; field < 4; ++field) {
        const double x = 60.0 * field;
        const auto part =
            with_scanner({x, 0, 0}, {rapid_to({x + 9, 3, 0}), line_to({x - 9, -3, 0}, kFeed),
                                     line_to({x - 9, 5, 0}, kFeed)});
        commands.insert(commands.end(), part.begin(), part.end());
    }
    Scanned first;
    run(scanner_of(), commands, first);
    for (const std::size_t size : {1u, 2u, 7u, 64u, 999u}) {
        Scanned other;
        run(scanner_of(), commands, other, size, size);
        ASSERT_EQ(other.setpoints.size(), first.setpoints.size());
        for (std::size_t i = 0; i < first.setpoints.size(); ++i) {
            EXPECT_EQ(other.setpoints[i].tip, first.setpoints[i].tip);
            EXPECT_EQ(other.setpoints[i].axis, first.setpoints[i].axis);
            EXPECT_EQ(other.setpoints[i].pulses, first.setpoints[i].pulses);
        }
        EXPECT_EQ(other.executed, first.executed);
    }
}

TEST(Scanner, WhatItCannotDoIsAnAlarm) {
    Command tool = simple(Op::Tool);
    Command machine_place = rapid_to({1, 1, 0});
    machine_place.motion().machine_coordinates = true;
    Command thread = line_to({1, 0, 0}, 1);
    thread.become(Op::Thread);
    Command no_feed = line_to({1, 0, 0}, 0);
    Command turns = simple(Op::Dwell);
    turns.dwell().revolutions = 2;
    Command rotary = line_to({1, 0, 0}, kFeed);
    rotary.motion().to[index(Axis::C)] = 5;
    rotary.motion().moved |= bit(Axis::C);
    const struct {
        const char* name;
        Command command;
        const char* code;
    } rows[] = {
        {"outside", line_to({50.5, 0, 0}, kFeed), "K6227"},
        {"a bulge outside", arc_to({49, 12, 0}, {49, 0, 0}, std::numbers::pi, kFeed), "K6227"},
        {"height", line_to({1, 0, 2}, kFeed), "K6228"},
        {"rotary", rotary, "K6228"},
        {"away", simple(Op::ScannerOff), "K6229"},
        {"tool", tool, "K6230"},
        {"machine coordinates", machine_place, "K6230"},
        {"thread", thread, "K6230"},
        {"feed", no_feed, "K6103"},
        {"revolutions", turns, "K6105"}};
    for (const auto& row : rows) {
        SCOPED_TRACE(row.name);
        Scanned done;
        run(scanner_of(),
            {simple(Op::ScannerOn), rapid_to({49, -12, 0}), row.command, rapid_to({0, 0, 0}),
             rapid_to({90, 0, 0})},
            done);
        ASSERT_EQ(done.diagnostics.all().size(), 1u);
        EXPECT_EQ(done.diagnostics.all()[0].row->code, row.code);
        EXPECT_EQ(done.executed, 2u);
        EXPECT_EQ(done.figures.jumps, 1u) << "what came before it was done";
        EXPECT_NEAR(done.setpoints.back().tip[0], 49, 1e-9);
    }
}

/// An alarm of the axes in front of one of the scanner is the one that counts.
TEST(Scanner, AlarmsComeInTheirOrder) {
    machine::Machine machine = scanner_of();
    machine.axes[0].upper = 200;
    Scanned done;
    run(machine,
        {rapid_to({10, 0, 0}), rapid_to({300, 0, 0}), simple(Op::ScannerOn),
         line_to({400, 0, 0}, kFeed)},
        done);
    ASSERT_EQ(done.diagnostics.all().size(), 1u);
    EXPECT_EQ(done.diagnostics.all()[0].row->code, "K6101");
    EXPECT_EQ(done.executed, 1u);
}

}  // namespace
}  // namespace kadr::process::scanner_test
