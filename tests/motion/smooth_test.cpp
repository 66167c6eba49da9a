// Motion under a limit of the jerk: profiles cut at blocks, blocks gathered to stretches, and what
// comes out of a whole plan.
#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "motion/profile_cut.h"
#include "motion/smooth_profile.h"
#include "motion/stretch.h"
#include "tests/motion/support.h"

namespace kadr::motion::smooth_test {
namespace {

using namespace test;

Dynamics smooth(double jerk) {
    Dynamics dynamics;
    dynamics.jerk = Vec3::Constant(jerk);
    return dynamics;
}

double any_number(int low, int high) {
    return *rc::gen::inRange(low * 1000, high * 1000 + 1) / 1000.0;
}

// --- profiles -----------------------------------------------------------------------------------

/// The greatest step of speed and of acceleration between neighbours, and the sum of their times.
struct Seams {
    double speed = 0;
    double acceleration = 0;
    double duration = 0;
};

Seams seams_of(const std::vector<Profile>& parts) {
    Seams seams;
    ProfileState last;
    for (const Profile& part : parts) {
        const ProfileState first = state_at(part, 0);
        seams.speed = std::max(seams.speed, std::abs(first.speed - last.speed));
        if (part.duration() > 0) {
            seams.acceleration =
                std::max(seams.acceleration, std::abs(first.acceleration - last.acceleration));
            // Just before the end: at the end itself the profile is over.
            last = state_at(part, part.duration() * (1 - 1e-12));
        }
        seams.duration += part.duration();
    }
    return seams;
}

RC_GTEST_PROP(ProfileCut, PartsAreTheWhole, ()) {
    const double acceleration = any_number(100, 10000);
    const double jerk = acceleration * any_number(2, 200);
    const double entry = any_number(0, 100);
    const double length = any_number(1, 200);
    const RampLimits ramp{acceleration, jerk};
    const double exit = std::min(any_number(0, 300), steady_reach(entry, length, ramp));
    RC_PRE(entry <= steady_reach(exit, length, ramp));
    const double speed = std::max({entry, exit, any_number(10, 500)});
    const auto whole = seven_phases(length, entry, exit, {speed, acceleration, acceleration, jerk});
    RC_ASSERT(whole.has_value());
    ProfileCut cut(*whole);
    std::vector<Profile> parts;
    const int count = *rc::gen::inRange(1, 200);
    double left = length;
    for (int i = 1; i < count; ++i) {
        const double distance = left * any_number(0, 1) * 0.1;
        parts.push_back(cut.next(distance, false));
        left -= distance;
    }
    parts.push_back(cut.next(left, true));
    const Seams seams = seams_of(parts);
    RC_ASSERT(parts.front().entry_speed == entry);
    RC_ASSERT(parts.back().exit_speed == exit);
    RC_ASSERT(std::abs(seams.duration - whole->duration()) <= 1e-9 * whole->duration());
    RC_ASSERT(seams.speed - entry <= 1e-6 * speed);
    RC_ASSERT(seams.acceleration <= 1e-4 * acceleration);
    double from = 0;
    for (const Profile& part : parts) {
        // The phases of a part cover its length, and nothing more.
        double distance = 0;
        double at_speed = part.entry_speed;
        for_each_phase(part, [&](const Phase& phase) {
            const double t = phase.duration;
            distance += (at_speed + (phase.acceleration / 2 + phase.jerk / 6 * t) * t) * t;
            at_speed += (phase.acceleration + phase.jerk / 2 * t) * t;
            return true;
        });
        RC_ASSERT(std::abs(distance - part.length) <= 2e-8);
        RC_ASSERT(part.peak_speed <= whole->peak_speed);
        from += part.length;
    }
    RC_ASSERT(std::abs(from - length) <= 1e-9);
}

TEST(SevenPhases, AnInfiniteJerkIsTheTrapezoid) {
    const ProfileLimits hard{100, 1000, 1000, 1e12};
    const auto smooth_one = seven_phases(30, 5, 20, hard);
    const auto sharp_one = trapezoid(30, 5, 20, {100, 1000, 1000});
    ASSERT_TRUE(smooth_one && sharp_one);
    EXPECT_NEAR(smooth_one->duration(), sharp_one->duration(), 1e-8);
}

TEST(SevenPhases, WithoutRoomThereIsNone) {
    // From 100 to 0 mm/s with 20000 mm/s³: 2·sqrt(100/20000) s at 50 mm/s on average: 7.07 mm.
    EXPECT_FALSE(seven_phases(7, 100, 0, {100, 2000, 2000, 20000}));
    EXPECT_TRUE(seven_phases(7.08, 100, 0, {100, 2000, 2000, 20000}));
}

// --- stretches ----------------------------------------------------------------------------------

/// A piece at 50 mm/s, 5 m/s², 100 m/s³: its ramp takes 44.7 ms and 1.118 mm.
Stretch piece(double length, double corner = kUnlimited) {
    Stretch stretch{length, 50, 5000, corner, 100000};
    stretch.entry_acceleration = std::isinf(corner) ? kUnlimited : 5000;
    return stretch;
}

std::vector<std::size_t> counts(const std::vector<Stretch>& pieces, std::size_t most = 1000) {
    StretchBuilder builder(most);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        builder.add(pieces[i], i + 1 < pieces.size() ? pieces[i + 1].entry_limit : 0);
    }
    builder.finish();
    std::vector<std::size_t> result;
    for (const Stretch& stretch : builder.complete()) result.push_back(stretch.pieces);
    return result;
}

TEST(Stretches, WhatIsGathered) {
    using Counts = std::vector<std::size_t>;
    EXPECT_EQ(counts({piece(0.1, 0), piece(0.1), piece(0.1)}), Counts({3})) << "straight on";
    EXPECT_EQ(counts({piece(0.1, 0), piece(0.1, 49), piece(0.1, 49)}), Counts({3})) << "slight";
    EXPECT_EQ(counts({piece(1, 0), piece(1, 10), piece(1)}), Counts({1, 2})) << "a slow corner";
    EXPECT_EQ(counts({piece(0.1, 0), piece(0.1, 0)}), Counts({1, 1})) << "a stop";
    Stretch edge = piece(0.1, 60);
    edge.entry_acceleration = 1000;  // of the 2236 mm/s² that a ramp to 50 mm/s reaches
    EXPECT_EQ(counts({piece(0.1, 0), edge}), Counts({1, 1})) << "no acceleration passes the corner";
    Stretch slow = piece(20);
    slow.speed = 25;
    EXPECT_EQ(counts({piece(20, 0), slow}), Counts({1, 1})) << "another feed";
    Stretch sharp = piece(1);
    sharp.jerk = kUnlimited;
    EXPECT_EQ(counts({sharp, sharp}), Counts({1, 1})) << "no limit of the jerk";
}

TEST(Stretches, LongOnesAreSplitWhereTheSpeedIsReached) {
    // Both ramps take 2.236 mm: 23 pieces of 0.1 mm, and as many behind them.
    std::vector<Stretch> line(100, piece(0.1));
    line[0].entry_limit = 0;
    EXPECT_EQ(counts(line), (std::vector<std::size_t>{23, 23, 23, 31}));
    // Where the window is shorter than the ramps, half of it is let go.
    EXPECT_EQ(counts(line, 20), std::vector<std::size_t>(10, 10));
}

TEST(Stretches, AStretchHasTheLeastOfItsLimits) {
    Stretch weak = piece(0.2, 49);
    weak.acceleration = 4000;
    weak.jerk = 60000;
    StretchBuilder builder(1000);
    builder.add(piece(0.1, 7), 49);
    builder.add(weak, 0);
    builder.finish();
    ASSERT_EQ(builder.complete().size(), 1u);
    const Stretch& whole = builder.complete()[0];
    EXPECT_NEAR(whole.length, 0.3, 1e-15);
    EXPECT_EQ(whole.speed, 49);
    EXPECT_EQ(whole.acceleration, 4000);
    EXPECT_EQ(whole.jerk, 60000);
    EXPECT_EQ(whole.entry_limit, 7);
}

// --- whole plans --------------------------------------------------------------------------------

TEST(SmoothPlan, ALineTakesItsSevenPhases) {
    // 30 mm at 50 mm/s: ramps of 2·sqrt(50/100000) s, no plateau, and 30/50 s + one ramp's time.
    const Motion result = run(machine_of(smooth(100000)), {line_to({30, 0, 0}, 3000)});
    EXPECT_NEAR(result.totals.time, 30 / 50.0 + 2 * std::sqrt(50 / 1e5), 1e-9);
    EXPECT_NEAR(result.totals.max_jerk[0], 100000, 1e-6);
    EXPECT_NEAR(result.totals.max_acceleration[0], std::sqrt(50 * 1e5), 1e-6);
    EXPECT_EQ(result.totals.max_jerk[1], 0);
    const Motion sharp = run(machine_of(), {line_to({30, 0, 0}, 3000)});
    EXPECT_TRUE(std::isinf(sharp.totals.max_jerk[0]));
}

TEST(SmoothPlan, ASquareCornerCountsItsJump) {
    const auto machine = machine_of(smooth(100000));
    const Motion result = run(machine, {line_to({30, 0, 0}, 3000), line_to({30, 30, 0}, 3000)});
    const double corner = result.segments[0].profile.exit_speed;
    EXPECT_GT(corner, 1);
    // The velocity of X ends in one tick: a jump by the corner's speed, over the tick squared.
    EXPECT_NEAR(result.totals.max_jerk[0], corner / (machine.tick * machine.tick) + 100000, 1);
}

TEST(SmoothPlan, AnArcIsEnteredWithTheJerkOfATick) {
    // A line goes over into an arc of 10 mm: v²/10 mm at once. Half of the jerk is for it: 0.75·v²
    // / (10 mm · 1 ms) = 50000 mm/s³.
    const auto machine = machine_of(smooth(100000));
    const auto at_feed = [&](double feed) {
        return run(machine, {line_to({30, 0, 0}, feed),
                             arc_to({40, 10, 0}, {30, 10, 0}, std::numbers::pi / 2, feed)});
    };
    const Motion result = at_feed(1800);
    EXPECT_NEAR(result.segments[0].profile.exit_speed, std::sqrt(500 / 0.75), 1e-9);
    // And what the arc itself takes at this speed, v³ / (10 mm)²: 172 mm/s³.
    EXPECT_LE(result.totals.max_jerk[1], 100173);
    // A rest is quicker where the ramps need all of the jerk.
    EXPECT_EQ(at_feed(6000).segments[0].profile.exit_speed, 0);
    // As slow as 10 mm/s there is nothing to slow down for.
    const Motion slow = run(machine, {line_to({30, 0, 0}, 600),
                                      arc_to({40, 10, 0}, {30, 10, 0}, std::numbers::pi / 2, 600)});
    EXPECT_NEAR(slow.segments[0].profile.exit_speed, 10, 1e-9);
}

/// Where the curvature jumps, a motion is passed only where that is quicker than a stop: lines and
/// arcs, and arcs that turn the other way.
TEST(SmoothPlan, NoJumpOfTheCurvatureIsSlowerThanAStop) {
    for (const double jerk : {5e3, 1e5, 5e6}) {
        const auto machine = machine_of(smooth(jerk));
        for (const double radius : {2.0, 15.0, 60.0}) {
            for (const double feed : {1000.0, 6000.0, 11500.0, 20000.0}) {
                const double pi = std::numbers::pi;
                std::vector<Command> program = {
                    line_to({20, 0, 0}, feed),
                    arc_to({20, 2 * radius, 0}, {20, radius, 0}, pi, feed),
                    line_to({0, 2 * radius, 0}, feed),
                    arc_to({0, 4 * radius, 0}, {0, 3 * radius, 0}, -pi, feed),
                    arc_to({0, 6 * radius, 0}, {0, 5 * radius, 0}, pi, feed)};
                const double through = run(machine, program).totals.time;
                for (Command& command : program) command.motion().exact_stop = true;
                EXPECT_LE(through, 1.001 * run(machine, program).totals.time)
                    << "jerk " << jerk << ", radius " << radius << ", F" << feed;
            }
        }
    }
}

/// A circle and a line that leaves it at any angle: what the corner takes of the jerk both pieces
/// lack. Passing by was 11 % slower than a stop where the line goes on at 60 degrees.
TEST(SmoothPlan, NoCornerBesideAnArcIsSlowerThanAStop) {
    const auto machine = machine_of({.velocity = {500, 500, 400}, .jerk = {1e5, 1e5, 8e4}});
    for (const double radius : {2.0, 5.0, 20.0}) {
        for (int angle = 0; angle < 360; angle += 30) {
            for (const double length : {6.0, 60.0}) {
                const double turn = angle * std::numbers::pi / 180;
                const Vec3 end(2 * radius, 0, 0);
                const Vec3 out(std::cos(turn), std::sin(turn), 0);
                std::vector<Command> program = {
                    arc_to(end, {radius, 0, 0}, std::numbers::pi, 20000),
                    line_to(end + length * out, 20000)};
                const double through = run(machine, program).totals.time;
                for (Command& command : program) command.motion().exact_stop = true;
                EXPECT_LE(through, 1.001 * run(machine, program).totals.time)
                    << "radius " << radius << ", " << angle << " degrees, " << length << " mm";
            }
        }
    }
}

/// An arc and one that goes on in its direction with another radius: the ramps of both need the
/// jerk that the jump of the curvature takes. By passing it this took 10 % longer.
TEST(SmoothPlan, NoArcBehindAnArcIsSlowerThanAStop) {
    const auto machine = machine_of({.velocity = {500, 500, 400}, .jerk = {1e5, 1e5, 8e4}});
    for (const double first : {0.5, 1.5, 10.0}) {
        for (const double second : {0.5, 3.0, 30.0}) {
            for (const double sweep : {0.4, 1.5, 3.0}) {
                const auto on = [](const Vec3& center, double radius, double angle) {
                    return Vec3(center + radius * Vec3(std::cos(angle), std::sin(angle), 0));
                };
                const Vec3 one(-first, 0, 0);
                const Vec3 join = on(one, first, sweep);
                const Vec3 other = on(join, -second, sweep);
                std::vector<Command> program = {
                    arc_to(join, one, sweep, 20000),
                    arc_to(on(other, second, 2 * sweep), other, sweep, 20000)};
                const double through = run(machine, program).totals.time;
                for (Command& command : program) command.motion().exact_stop = true;
                EXPECT_LE(through, 1.001 * run(machine, program).totals.time)
                    << first << ' ' << second << ' ' << sweep;
            }
        }
    }
}

/// A short piece and a long one that go on in one direction: how fast the bend is says the short
/// one. By a bend as fast as the long one alone would have it this took 7 % longer.
TEST(SmoothPlan, NoShortArcBesideALongWayIsSlowerThanAStop) {
    const auto machine = machine_of({.velocity = {500, 500, 400}, .jerk = {1e5, 1e5, 8e4}});
    for (const double radius : {1.0, 6.0, 37.0}) {
        for (const double part : {0.35, 0.43, 0.9, 1.8}) {
            for (const double length : {2.0, 8.0, 30.0}) {
                for (const bool is_arc_first : {true, false}) {
                    const double sweep = part / radius;
                    const Vec3 end = radius * Vec3(std::sin(sweep), 1 - std::cos(sweep), 0);
                    const Vec3 out(std::cos(sweep), std::sin(sweep), 0);
                    std::vector<Command> program = {arc_to(end, {0, radius, 0}, sweep, 15000),
                                                    line_to(end + length * out, 15000)};
                    if (!is_arc_first) {
                        const Vec3 start(length, 0, 0);
                        program = {line_to(start, 15000),
                                   arc_to(start + end, start + Vec3(0, radius, 0), sweep, 15000)};
                    }
                    const double through = run(machine, program).totals.time;
                    for (Command& command : program) command.motion().exact_stop = true;
                    EXPECT_LE(through, 1.005 * run(machine, program).totals.time)
                        << "radius " << radius << ", " << part << " mm, " << length << " mm "
                        << is_arc_first;
                }
            }
        }
    }
}

/// A short line and a long one with a curve around their corner: the short one keeps the curve
/// slow, and the long one has the ramp of a stop all the same. This took up to 5 % longer.
TEST(SmoothPlan, NoCurveAroundACornerIsSlowerThanAStop) {
    const auto machine = machine_of({.velocity = {500, 500, 400}, .jerk = {1e5, 1e5, 8e4}});
    for (const path::Blending& wish : {by_distance(0.3), by_distance(1.5), within(0.05)}) {
        for (const double part : {0.3, 0.46, 0.7, 1.2, 4.0}) {
            for (const double length : {4.0, 12.0, 40.0}) {
                for (int angle = 20; angle < 180; angle += 20) {
                    for (const double feed : {2000.0, 8000.0, 15000.0}) {
                        const double turn = angle * std::numbers::pi / 180;
                        const Vec3 out(std::cos(turn), std::sin(turn), 0);
                        std::vector<Command> program =
                            rounded({line_to({part, 0, 0}, feed),
                                     line_to(Vec3(part, 0, 0) + length * out, feed)},
                                    wish);
                        const double around = run(machine, program).totals.time;
                        for (Command& command : program) command.motion().exact_stop = true;
                        EXPECT_LE(around, 1.0005 * run(machine, program).totals.time)
                            << part << " mm, " << length << " mm, " << angle << " degrees, F"
                            << feed;
                    }
                }
            }
        }
    }
}

TEST(SmoothPlan, EveryLookAheadEndsAtRestAndNoneIsFaster) {
    std::vector<Command> program;
    for (int i = 1; i <= 3000; ++i) {
        const double t = i * 0.004;
        program.push_back(line_to({30 * std::sin(t), 20 * std::cos(2 * t), 0}, 6000));
    }
    const auto machine = machine_of(smooth(50000));
    double slower = kUnlimited;
    for (const std::size_t depth : {1u, 2u, 10u, 50u, 300u, 5000u}) {
        SCOPED_TRACE(depth);
        PlannerOptions options;
        options.lookahead = depth;
        const Motion result = run(machine, program, options);
        ASSERT_EQ(result.segments.size(), 3000u);
        EXPECT_EQ(result.segments.back().profile.exit_speed, 0);
        EXPECT_LE(result.totals.time, slower * 1.02);
        slower = result.totals.time;
    }
}

}  // namespace
}  // namespace kadr::motion::smooth_test
