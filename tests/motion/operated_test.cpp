// What an operator does while a program runs: overrides, feed hold, cycle start.
#include <algorithm>
#include <functional>
#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/motion/any_program.h"
#include "tests/motion/support.h"
#include "tests/motion/tick_limits.h"

namespace kadr::motion::operated_test {
namespace {

using namespace test;

OperatorEvent feed_to(double value, double time, std::uint32_t line = 0) {
    return {OperatorAct::FeedOverride, value, time, line, -1};
}
OperatorEvent rapid_to(double value, double time) {
    return {OperatorAct::RapidOverride, value, time, 0, -1};
}
OperatorEvent hold_at(double time, std::uint32_t line = 0) {
    return {OperatorAct::FeedHold, 1, time, line, -1};
}
OperatorEvent start_at(double time) { return {OperatorAct::CycleStart, 1, time, 0, -1}; }

PlannerOptions operated(std::vector<OperatorEvent> events) {
    PlannerOptions options;
    options.events = std::move(events);
    return options;
}

/// A line of 1000 mm at 100 mm/s.
std::vector<Command> long_line() { return {line_to({1000, 0, 0}, 6000)}; }

machine::Machine smooth_machine() { return machine_of({.jerk = Vec3(50000, 50000, 40000)}); }

TEST(Operated, TimesOfALine) {
    // 1000 mm at 100 mm/s; 5000 mm/s²: up and down in 0.02 s, which costs 0.02 s. A ramp between
    // two speeds costs nothing that lasting half as long at each of them would not.
    struct Row {
        const char* name;
        std::vector<OperatorEvent> events;
        double time;
    };
    const std::vector<Row> rows = {
        {"as programmed", {feed_to(1, 3)}, 10 + 0.02},
        // 1000/50, ramps of 0.01 s
        {"half from the start", {feed_to(0.5, 0)}, 20 + 0.01},
        // 5 s − 0.01 s make 499 mm; the ramp from 100 to 50 takes 0.01 s and 0.75 mm; the rest of
        // 500.25 mm at 50 mm/s, and 0.005 s for the ramp at the end
        {"half after 5 s", {feed_to(0.5, 5)}, 5 + 0.01 + (1000 - 499 - 0.75) / 50 + 0.005},
        // 499.75 mm after 10 s at 50, the ramp of 0.01 s and 0.75 mm, the rest at 100
        {"and back",
         {feed_to(0.5, 0), feed_to(1, 10)},
         10 + 0.01 + (1000 - 499.75 - 0.75) / 100 + 0.01},
        // A hold that lasts 2 s costs 2 s: the ramps down and up lie half inside and half outside.
        {"held", {hold_at(5), start_at(7)}, 10 + 0.02 + 2},
        {"held before it begins", {hold_at(0), start_at(2.5)}, 10 + 0.02 + 2.5},
        {"an override of 0 is a hold", {feed_to(0, 5), feed_to(1, 7)}, 10 + 0.02 + 2},
        {"the rapid override is for rapids", {rapid_to(0, 5)}, 10 + 0.02},
        {"3 s after the block begins", {hold_at(3, 1), start_at(5)}, 10 + 0.02 + 2},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.name);
        const Motion result = run(machine_of(), long_line(), operated(row.events));
        EXPECT_NEAR(result.totals.time, row.time, 1e-9);
        EXPECT_NEAR(result.totals.length, 1000, 1e-9);
        EXPECT_TRUE(result.diagnostics.all().empty());
    }
}

/// Corners, arcs and splines at 100 mm/s, on the machine's limits here and there.
std::vector<Command> bent_program() {
    return {spline_to({40, 0, 0}, {10, 25, 0}, {30, 25, 0}, 6000),
            spline_to({80, 0, 0}, {50, -25, 0}, {70, -25, 0}, 6000), line_to({80, 3, 0}, 6000),
            test::rapid_to({0, 0, 0})};
}

TEST(Operated, WhatChangesNothingShiftsNothing) {
    // A cycle start that follows no hold, and a hold that is taken back at once, are nothing too.
    const OperatorEvent fall = feed_to(0.5, 0.9);
    const std::vector<std::vector<OperatorEvent>> idle = {
        {feed_to(1, 0.1), rapid_to(1, 0.2), start_at(0.3)},
        {feed_to(1, 0.01, 2), feed_to(1, 0.3), feed_to(1, 1.1)},
        {rapid_to(1, 0), feed_to(1, 0.05, 4)},
    };
    for (const machine::Machine& machine : {machine_of(), smooth_machine()}) {
        const Motion plain = run(machine, bent_program(), {});
        const Motion changed = run(machine, bent_program(), operated({fall}));
        for (const auto& events : idle) {
            const Motion same = run(machine, bent_program(), operated(events));
            EXPECT_EQ(same.totals.time, plain.totals.time);
            EXPECT_EQ(same.segments.size(), plain.segments.size());
            auto more = events;
            more.push_back(fall);
            // … before 0.9 s; and what is as it stands then is nothing as well.
            std::erase_if(more, [](const OperatorEvent& e) { return e.time > 1 || e.line > 2; });
            more.push_back(feed_to(0.5, 0.95));
            const Motion beside = run(machine, bent_program(), operated(more));
            EXPECT_EQ(beside.totals.time, changed.totals.time);
            EXPECT_EQ(beside.segments.size(), changed.segments.size());
        }
        const Motion held_not =
            run(machine, bent_program(), operated({fall, hold_at(0.4), start_at(0.4)}));
        EXPECT_EQ(held_not.totals.time, changed.totals.time);
    }
}

TEST(Operated, SmoothRampsTakeTheirTime) {
    // 50000 mm/s³: from 100 to 0 in 2·sqrt(100/50000) s = 0.0894 s; from 100 to 50 in 0.0632 s.
    const double stop = 2 * std::sqrt(100.0 / 50000);
    const double half = 2 * std::sqrt(50.0 / 50000);
    const double whole = 10 + stop;
    const auto held = run(smooth_machine(), long_line(), operated({hold_at(5), start_at(7)}));
    EXPECT_NEAR(held.totals.time, whole + 2, 1e-9);
    EXPECT_NEAR(held.totals.hold_time, 2 - stop, 1e-9);
    // (5 − stop/2)·100 mm at 5 s; 75·half mm in the ramp, the rest at 50; and the ramp at the end.
    const auto slow = run(smooth_machine(), long_line(), operated({feed_to(0.5, 5)}));
    const double rest = 1000 - (5 - stop / 2) * 100 - 75 * half;
    EXPECT_NEAR(slow.totals.time, 5 + half + rest / 50 + half / 2, 1e-9);
}

TEST(Operated, TheEventActsAtOnce) {
    // From the event on the speed falls by 5000 mm/s² (5 mm/s in a tick), not before.
    const auto setpoints =
        sample(machine_of(), long_line(), operated({feed_to(0.5, 5), feed_to(1.2, 8)}));
    EXPECT_NEAR(setpoints[5000].feed, 100, 1e-9);
    EXPECT_NEAR(setpoints[5001].feed, 95, 1e-9);
    EXPECT_NEAR(setpoints[5009].feed, 55, 1e-9);
    EXPECT_NEAR(setpoints[5011].feed, 50, 1e-9);
    EXPECT_NEAR(setpoints[8000].feed, 50, 1e-9);
    EXPECT_NEAR(setpoints[8001].feed, 55, 1e-9);
    EXPECT_NEAR(setpoints[8015].feed, 120, 1e-9);
}

TEST(Operated, HeldAxesStand) {
    const auto setpoints =
        sample(smooth_machine(), long_line(), operated({hold_at(5), start_at(7)}));
    const double stop = 2 * std::sqrt(100.0 / 50000);
    // 100 mm/s for 5 s less half of the ramp, and half of the other ramp
    const double place = 100 * (5 - stop / 2) + 50 * stop;
    for (std::size_t i = 5090; i <= 7000; ++i) {
        ASSERT_NEAR(setpoints[i].axis[0], place, 1e-9);
        ASSERT_EQ(setpoints[i].feed, 0);
    }
    EXPECT_GT(setpoints[7002].axis[0], place);
}

TEST(Operated, OverriddenFeedIsShown) {
    const Motion result = run(machine_of(), long_line(), operated({feed_to(0.5, 5)}));
    EXPECT_EQ(result.segments.front().feed, 100);
    EXPECT_EQ(result.segments.back().feed, 50);
}

TEST(Operated, RapidsHaveAnOverrideOfTheirOwn) {
    // 500 mm/s, 5000 mm/s²: 0.1 s and 25 mm for a ramp; 1000 mm in 2.1 s. At 20 %: 10 + 0.02 s.
    const std::vector<Command> program = {test::rapid_to({1000, 0, 0})};
    EXPECT_NEAR(run(machine_of(), program, operated({feed_to(0.2, 0)})).totals.time, 2.1, 1e-9);
    EXPECT_NEAR(run(machine_of(), program, operated({rapid_to(0.2, 0)})).totals.time, 10.02, 1e-9);
    EXPECT_NEAR(run(machine_of(), program, operated({hold_at(1), start_at(4)})).totals.time,
                2.1 + 3, 1e-9);
}

TEST(Operated, AZeroOfTheFeedLetsRapidsRunToTheirEnd) {
    // The rapid comes to rest where the line begins, at 1000 mm after 2.1 s.
    const std::vector<Command> program = {test::rapid_to({1000, 0, 0}),
                                          line_to({2000, 0, 0}, 6000)};
    const auto result = run(machine_of(), program, operated({feed_to(0, 1), feed_to(1, 5)}));
    const auto held = std::ranges::find(result.segments, SegmentKind::Hold, &Segment::kind);
    ASSERT_NE(held, result.segments.end());
    EXPECT_NEAR(held->start_time, 2.1, 1e-9);
    EXPECT_NEAR(path::start(held->curve)[0], 1000, 1e-9);
    EXPECT_NEAR(result.totals.time, 5 + 10 + 0.02, 1e-9);
}

TEST(Operated, DwellsAreStoppedByAHoldOnly) {
    Command dwell = simple(Op::Dwell);
    dwell.dwell().time = 4;
    const std::vector<Command> program = {dwell};
    const auto time = [&](std::vector<OperatorEvent> events, bool stops) {
        PlannerOptions options = operated(std::move(events));
        options.hold_stops_dwell = stops;
        return run(machine_of(), program, options).totals.time;
    };
    EXPECT_EQ(time({feed_to(0, 1)}, true), 4);
    EXPECT_EQ(time({feed_to(0.5, 1), rapid_to(2, 3)}, true), 4);
    EXPECT_NEAR(time({hold_at(1), start_at(3)}, true), 6, 1e-9);
    EXPECT_NEAR(time({hold_at(1), start_at(3), hold_at(3.5), start_at(4)}, true), 6.5, 1e-9);
    EXPECT_EQ(time({hold_at(1), start_at(3)}, false), 4);
}

TEST(Operated, ThreadsAreRunToTheirEnd) {
    // 60 rpm, 10 mm pitch: 10 mm/s. Down 100 mm, a dwell of 1 s, to the spindle's mark, and up
    // again.
    Command thread = line_to({0, 0, -100}, 10);
    thread.become(Op::Thread);
    thread.motion().feed_mode = path::FeedMode::PerRevolution;
    Command back = thread;
    back.motion().to = {};
    back.motion().exact_stop = true;
    Command dwell = simple(Op::Dwell);
    dwell.dwell().time = 1;
    const std::vector<Command> program = {spindle_on(60), thread, dwell, back,
                                          line_to({100, 0, 0}, 6000)};
    const double tapped = 12 + 10 + 10.0 / 4000;
    const auto result =
        run(machine_of(), program,
            operated({feed_to(0.5, 0), hold_at(5), start_at(30), hold_at(30.5), start_at(31)}));
    const auto held = std::ranges::find(result.segments, SegmentKind::Hold, &Segment::kind);
    ASSERT_NE(held, result.segments.end());
    EXPECT_NEAR(held->start_time, tapped, 1e-9);
    // 100 mm at 50 mm/s and a ramp of 0.01 s; held for half a second
    EXPECT_NEAR(result.totals.time, 30 + 2 + 0.01 + 0.5, 1e-9);
    // A hold that comes before the thread keeps it from beginning.
    const auto before = run(machine_of(), program, operated({hold_at(0), start_at(3)}));
    EXPECT_EQ(before.segments.front().kind, SegmentKind::Hold);
    EXPECT_NEAR(before.totals.time, 3 + tapped + 1.02, 1e-9);
}

TEST(Operated, WhatTheProgramTakesFromThePanel) {
    // 300 mm at 100 mm/s, of which the middle third has no hold, or no override. A hold costs its
    // time wherever it acts; at half the feed every third takes a second more.
    const auto program = [](bool keeps_feed, bool ignores_hold) {
        std::vector<Command> lines = {line_to({100, 0, 0}, 6000), line_to({200, 0, 0}, 6000),
                                      line_to({300, 0, 0}, 6000)};
        lines[1].motion().keeps_feed = keeps_feed;
        lines[1].motion().ignores_hold = ignores_hold;
        return lines;
    };
    for (const machine::Machine& machine : {machine_of(), smooth_machine()}) {
        const double plain = run(machine, program(false, false), {}).totals.time;
        for (const bool keeps_feed : {false, true}) {
            for (const bool ignores_hold : {false, true}) {
                SCOPED_TRACE(std::to_string(keeps_feed) + std::to_string(ignores_hold));
                const auto lines = program(keeps_feed, ignores_hold);
                const auto slow = run(machine, lines, operated({feed_to(0.5, 0)}));
                EXPECT_NEAR(slow.totals.time, plain + (keeps_feed ? 2 : 3), 0.05);
                const auto held = run(machine, lines, operated({hold_at(1.5), start_at(9)}));
                const auto rest =
                    std::ranges::find(held.segments, SegmentKind::Hold, &Segment::kind);
                ASSERT_NE(rest, held.segments.end());
                const double place = path::start(rest->curve)[0];
                EXPECT_NEAR(place, ignores_hold ? 200 : 150, ignores_hold ? 5 : 6);
                EXPECT_GE(place, ignores_hold ? 200 - 1e-9 : 150);
                EXPECT_NEAR(held.totals.length, 300, 1e-9);
            }
        }
    }
}

TEST(Operated, AToolChangeIsFinishedBeforeAHoldActs) {
    auto machine = machine_of();
    machine.tool_change_time = 5;
    Command dwell = simple(Op::Dwell);
    dwell.dwell().time = 1;
    const auto result =
        run(machine, {simple(Op::Tool), dwell}, operated({hold_at(2), start_at(8)}));
    ASSERT_EQ(result.segments.size(), 3u);
    EXPECT_EQ(result.segments[1].kind, SegmentKind::Hold);
    EXPECT_EQ(result.segments[1].start_time, 5);
    EXPECT_EQ(result.totals.time, 9);
}

TEST(Operated, WhatNothingEndsIsAnAlarm) {
    for (const auto& [events, text] : {std::pair{std::vector{hold_at(5)}, "feed hold"},
                                       {std::vector{feed_to(0, 5)}, "a feed override of 0 %"}}) {
        const auto result = run(machine_of(), long_line(), operated(events));
        ASSERT_EQ(result.diagnostics.all().size(), 1u);
        EXPECT_EQ(result.diagnostics.all()[0].row->code, "K6210");
        EXPECT_NEAR(result.totals.time, 5.02, 1e-9);
        EXPECT_NE(result.diagnostics.all()[0].message().find(text), std::string::npos);
    }
}

TEST(Operated, ABlockThatIsNotBegunIsKnown) {
    CommandList list(long_line());
    DiagnosticList diagnostics;
    const machine::Machine machine = machine_of();
    const PlannerOptions options = operated({hold_at(1, 7), feed_to(0.5, 1, 1)});
    Planner planner(list, machine, options, diagnostics);
    std::vector<Segment> batch(10);
    while (planner.pull(batch) > 0) continue;
    ASSERT_EQ(planner.events_ahead().size(), 1u);
    EXPECT_EQ(planner.events_ahead()[0].line, 7u);
}

// ------------------------------------------------------------------------------ properties

std::vector<OperatorEvent> any_events(double until) {
    std::vector<OperatorEvent> events;
    double last = 0;
    const int count = *rc::gen::inRange(1, 8);
    for (int i = 0; i < count; ++i) {
        const double time = until * any_number(0, 1);
        const int kind = *rc::gen::inRange(0, 5);
        if (kind < 2) events.push_back(feed_to(*rc::gen::inRange(0, 41) / 20.0, time));
        if (kind == 2) events.push_back(rapid_to(*rc::gen::inRange(0, 11) / 10.0, time));
        if (kind > 2) {
            const double pause = any_number(0, 1) * *rc::gen::element(1.0, 0.1, 0.01);
            events.push_back(hold_at(time));
            events.push_back(start_at(time + pause));
            last = std::max(last, time + pause);
        }
    }
    // In the end everything goes on, not at a crawl.
    last = std::max(last, until) + any_number(0, 1);
    events.push_back(feed_to(any_number(10, 20) / 10, last));
    events.push_back(rapid_to(0.5, last));
    events.push_back(start_at(last));
    return events;
}

/// A run as a way: where the tool is after so much of the path.
class Way {
  public:
    explicit Way(const std::vector<Segment>& segments) {
        for (const Segment& segment : segments) {
            if (!is_motion(segment.kind)) continue;
            starts_.push_back(length_);
            segments_.push_back(segment);
            length_ += path::length(segment.curve);
        }
    }
    double length() const { return length_; }
    Vec3 at(double s) const {
        const auto behind = std::upper_bound(starts_.begin(), starts_.end(), s);
        const auto i =
            static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, behind - starts_.begin() - 1));
        return path::position(segments_[i].curve,
                              std::clamp(s - starts_[i], 0.0, path::length(segments_[i].curve)));
    }

  private:
    std::vector<Segment> segments_;
    std::vector<double> starts_;
    double length_ = 0;
};

struct AnyRun {
    machine::Machine machine = any_machine();
    std::vector<Command> program = any_program();
    PlannerOptions plain;
    PlannerOptions options;

    AnyRun() {
        plain.lookahead = *rc::gen::element<std::size_t>(1, 2, 5, 20, 1024);
        options = plain;
        options.events = any_events(run(machine, program, plain).totals.time);
        const OperatorPanel panel(options.events, {});
        plain.feed_override = panel.highest().feed;
        plain.rapid_override = panel.highest().rapid;
    }
};

RC_GTEST_PROP(OperatedProperty, LimitsHoldAtEveryTick, ()) {
    const AnyRun any;
    const Motion result = run(any.machine, any.program, any.options);
    RC_ASSERT(result.diagnostics.all().empty());
    TickWatch watch(any.machine, result.segments);
    for (const Setpoint& setpoint : sample(any.machine, any.program, any.options))
        watch.add(setpoint);
    RC_ASSERT(watch.shares().velocity <= 1 + 1e-3);
    RC_ASSERT(watch.shares().acceleration <= 1 + 1e-3);
    RC_ASSERT(watch.shares().jerk <= 1 + 1e-3);
}

RC_GTEST_PROP(OperatedProperty, ThePathIsTheSame, ()) {
    const AnyRun any;
    const Motion plain = run(any.machine, any.program, any.plain);
    const Motion result = run(any.machine, any.program, any.options);
    const Way way(plain.segments);
    const Way operated_way(result.segments);
    RC_ASSERT(std::abs(way.length() - operated_way.length()) < 1e-6);
    for (int i = 0; i <= 200 && way.length() > 0; ++i) {
        const double s = way.length() * i / 200;
        RC_ASSERT((way.at(s) - operated_way.at(s)).norm() < 1e-6);
    }
}

RC_GTEST_PROP(OperatedProperty, SegmentsFollowEachOther, ()) {
    const AnyRun any;
    const Motion result = run(any.machine, any.program, any.options);
    double time = 0;
    double speed = 0;
    double acceleration = 0;
    for (const Segment& segment : result.segments) {
        RC_ASSERT(segment.start_time == time);
        RC_ASSERT(std::abs(segment.profile.entry_speed - speed) < 1e-6);
        RC_ASSERT(segment.duration > 0);
        if (segment.kind == SegmentKind::Hold) RC_ASSERT(speed == 0);
        const Profile& profile = segment.profile;
        const ProfileState begin = state_at(profile, 0);
        const ProfileState end = state_at(profile, segment.duration);
        if (profile.is_smooth)
            RC_ASSERT(std::abs(begin.acceleration - acceleration) <
                      1e-4 * any.machine.axes[0].jerk);
        time += segment.duration;
        speed = profile.exit_speed;
        acceleration = profile.is_smooth ? end.acceleration : 0;
    }
    RC_ASSERT(speed < 1e-6);
    RC_ASSERT(std::abs(result.totals.time - time) < 1e-9);
    RC_ASSERT(result.totals.hold_time <= result.totals.time);
}

RC_GTEST_PROP(OperatedProperty, BatchesDoNotMatter, ()) {
    const AnyRun any;
    const Motion result = run(any.machine, any.program, any.options);
    CommandList list(any.program);
    DiagnosticList diagnostics;
    Planner planner(list, any.machine, any.options, diagnostics);
    std::vector<Segment> batch(static_cast<std::size_t>(*rc::gen::inRange(1, 100)));
    std::size_t i = 0;
    while (const std::size_t count = planner.pull(batch)) {
        for (const Segment& segment : std::span(batch).first(count)) {
            RC_ASSERT(i < result.segments.size());
            RC_ASSERT(segment.start_time == result.segments[i].start_time);
            RC_ASSERT(segment.duration == result.segments[i].duration);
            ++i;
        }
    }
    RC_ASSERT(i == result.segments.size());
}

}  // namespace
}  // namespace kadr::motion::operated_test
