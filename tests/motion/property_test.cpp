// What must hold for every program on every machine.
#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "motion/axis_table.h"
#include "motion/lookahead.h"
#include "motion/smooth_profile.h"
#include "tests/motion/any_program.h"
#include "tests/motion/support.h"
#include "tests/motion/tick_limits.h"

namespace kadr::motion::property_test {
namespace {

using namespace test;

// Limits hold up to the rounding of v² − v² over short pieces.
constexpr double kRelative = 1e-6;

PlannerOptions any_options() {
    PlannerOptions options;
    options.lookahead = *rc::gen::element<std::size_t>(1, 2, 5, 20, 100, 1024);
    return options;
}

RC_GTEST_PROP(MotionProperty, JunctionsMeetAndLimitsHold, ()) {
    const auto machine = any_machine();
    const Motion result = run(machine, any_program(), any_options());
    RC_ASSERT(result.diagnostics.all().empty());
    double time = 0;
    double speed = 0;
    for (const Segment& segment : result.segments) {
        RC_ASSERT(segment.start_time == time);
        RC_ASSERT(segment.duration >= 0);
        RC_ASSERT(segment.profile.entry_speed == speed);
        RC_ASSERT(segment.profile.peak_speed <= segment.feed * (1 + kRelative) ||
                  !is_motion(segment.kind));
        time += segment.duration;
        speed = segment.profile.exit_speed;
    }
    RC_ASSERT(speed == 0);
    RC_ASSERT(result.totals.time == time);
    for (std::size_t i = 0; i < 3; ++i) {
        RC_ASSERT(result.totals.max_velocity[i] <= machine.axes[i].velocity * (1 + kRelative));
        RC_ASSERT(result.totals.max_acceleration[i] <=
                  machine.axes[i].acceleration * (1 + kRelative));
    }
}

/// What the setpoints of a program show, in parts of what the axes may do.
TickShares shares_of(const machine::Machine& machine, const std::vector<Command>& program) {
    TickWatch watch(machine, run(machine, program).segments);
    for (const Setpoint& setpoint : sample(machine, program)) watch.add(setpoint);
    return watch.shares();
}

RC_GTEST_PROP(MotionProperty, SampledAxesKeepTheirJerk, ()) {
    const auto machine = any_machine();
    const TickShares shares = shares_of(machine, any_program());
    RC_CLASSIFY(shares.jerk > 0.9, "close to the limit");
    RC_ASSERT(shares.velocity <= 1 + 1e-3);
    RC_ASSERT(shares.acceleration <= 1 + 1e-3);
    RC_ASSERT(shares.jerk <= 1 + 1e-3);
}

/// A chain without corners: lines, spans of splines and arcs that go on in one direction.
std::vector<Command> any_smooth_chain() {
    std::vector<Command> program;
    Vec3 at = Vec3::Zero();
    double direction = 0;
    const int count = *rc::gen::inRange(1, 40);
    const double feed = any_number(500, 30000);
    for (int i = 0; i < count; ++i) {
        const double size = any_number(0, 20) * *rc::gen::element(1.0, 0.1, 0.01);
        if (size == 0) continue;
        if (*rc::gen::inRange(0, 2) == 0) {
            at += size * Vec3(std::cos(direction), std::sin(direction), 0);
            program.push_back(line_to(at, feed));
            continue;
        }
        if (*rc::gen::inRange(0, 3) == 0) {
            // A span that leaves in the direction of the path and turns by up to a radian.
            const Vec3 along(std::cos(direction), std::sin(direction), 0);
            direction += any_number(-1, 1);
            const Vec3 behind(std::cos(direction), std::sin(direction), 0);
            const Vec3 to = at + size * (along + behind);
            program.push_back(
                spline_to(to, at + size * 2 / 3 * along, to - size * 2 / 3 * behind, feed));
            at = to;
            continue;
        }
        const double sweep = any_number(0, 3) * *rc::gen::element(1.0, -1.0, 0.1);
        if (sweep == 0) continue;
        const double side = sweep > 0 ? 1 : -1;
        const Vec3 center = at + size * side * Vec3(-std::sin(direction), std::cos(direction), 0);
        direction += sweep;
        at = center + size * side * Vec3(std::sin(direction), -std::cos(direction), 0);
        program.push_back(arc_to(at, center, sweep, feed));
    }
    return program;
}

RC_GTEST_PROP(MotionProperty, SmoothChainsKeepJerkAndSpeedIsContinuous, ()) {
    const auto machine = any_machine();
    const auto program = any_smooth_chain();
    const TickShares shares = shares_of(machine, program);
    RC_ASSERT(shares.velocity <= 1 + 1e-3);
    RC_ASSERT(shares.acceleration <= 1 + 1e-3);
    RC_ASSERT(shares.jerk <= 1 + 1e-3);
    // Nowhere a speed that a tick cannot explain.
    const auto setpoints = sample(machine, program);
    double fastest = 0;
    for (const auto& axis : machine.axes) fastest += axis.acceleration * axis.acceleration;
    fastest = std::sqrt(fastest) * machine.tick;
    for (std::size_t i = 1; i < setpoints.size(); ++i) {
        RC_ASSERT(std::abs(setpoints[i].feed - setpoints[i - 1].feed) <=
                  fastest * (1 + kRelative) + 1e-9);
    }
}

/// How far a point is from the curve of a segment, by another way than the curve's own evaluation.
double miss(const Segment& segment, const Vec3& point) {
    if (const auto* line = std::get_if<path::Line>(&segment.curve)) {
        const double along =
            std::clamp((point - line->start).dot(line->direction), 0.0, line->length);
        return (point - line->start - along * line->direction).norm();
    }
    if (const auto* helix = std::get_if<path::Helix>(&segment.curve)) {
        const Vec3 out = point - helix->base;
        const double height = out.dot(helix->normal);
        return std::abs((out - height * helix->normal).norm() - helix->radius);
    }
    if (const auto* glide = std::get_if<path::Glide>(&segment.curve)) {
        double best = 0;
        const auto away = [&](double s) { return (path::position(*glide, s) - point).norm(); };
        for (int i = 0; i <= 40; ++i)
            if (away(glide->length * i / 40) < away(best)) best = glide->length * i / 40;
        for (int pass = 0; pass < 20; ++pass) {
            const path::CurvePoint near = path::evaluate(*glide, best);
            best += (point - near.position).dot(near.tangent) / near.tangent.squaredNorm();
            best = std::clamp(best, 0.0, glide->length);
        }
        return away(best);
    }
    if (const auto* spline = std::get_if<path::CubicSpan>(&segment.curve)) {
        // The nearest of many points, then closer: the distance has one least value there.
        double best = 0;
        for (int i = 0; i <= 200; ++i) {
            const double u = i / 200.0;
            if ((path::point_at(*spline, u).position - point).norm() <
                (path::point_at(*spline, best).position - point).norm())
                best = u;
        }
        for (int pass = 0; pass < 20; ++pass) {
            const path::SplinePoint near = path::point_at(*spline, best);
            best += (point - near.position).dot(near.first) / near.first.squaredNorm();
            best = std::clamp(best, 0.0, 1.0);
        }
        return (path::point_at(*spline, best).position - point).norm();
    }
    return (point - path::start(segment.curve)).norm();
}

RC_GTEST_PROP(MotionProperty, SetpointsLieOnThePathAtEveryTick, ()) {
    const auto machine = any_machine();
    const auto program = any_program();
    const Motion planned = run(machine, program);
    const auto setpoints = sample(machine, program);
    RC_PRE(!planned.segments.empty());
    const auto ticks =
        static_cast<std::size_t>(std::ceil(planned.totals.time / machine.tick - 1e-9));
    RC_ASSERT(setpoints.size() == ticks + 1);
    std::size_t k = 0;
    for (std::size_t i = 0; i < setpoints.size(); ++i) {
        const Setpoint& setpoint = setpoints[i];
        RC_ASSERT(setpoint.time == static_cast<double>(i) * machine.tick);
        while (k + 1 < planned.segments.size() &&
               setpoint.time >= planned.segments[k].end_time() - 1e-9 * machine.tick) {
            ++k;
        }
        const Segment& segment = planned.segments[k];
        RC_ASSERT(setpoint.line == segment.line);
        RC_ASSERT(miss(segment, setpoint.tip) <= 1e-9);
        RC_ASSERT(
            (Vec3(setpoint.axis[0], setpoint.axis[1], setpoint.axis[2]) - setpoint.tip).norm() ==
            0);
    }
    RC_ASSERT(setpoints.front().tip == Vec3(0, 0, 0));
    RC_ASSERT(setpoints.back().tip == path::end(planned.segments.back().curve));
    RC_ASSERT(setpoints.back().feed == 0);
}

RC_GTEST_PROP(MotionProperty, SampledAxesKeepTheirLimits, ()) {
    const auto machine = any_machine();
    const auto setpoints = sample(machine, any_program());
    for (std::size_t i = 2; i < setpoints.size(); ++i) {
        for (std::size_t a = 0; a < 3; ++a) {
            const double v1 = (setpoints[i - 1].axis[a] - setpoints[i - 2].axis[a]) / machine.tick;
            const double v2 = (setpoints[i].axis[a] - setpoints[i - 1].axis[a]) / machine.tick;
            // A difference of positions of some hundred mm has 1e-13 mm of rounding.
            RC_ASSERT(std::abs(v2) <= machine.axes[a].velocity * (1 + kRelative) + 1e-9);
            // Two ticks average over what lies in them, corners and ramps.
            RC_ASSERT(std::abs(v2 - v1) / machine.tick <=
                      machine.axes[a].acceleration * (1 + kRelative) + 1e-3);
        }
    }
}

/// Greatest second difference of an axis, as a part of its acceleration.
double greatest_share(const machine::Machine& machine, const std::vector<Command>& program) {
    const auto setpoints = sample(machine, program);
    double greatest = 0;
    for (std::size_t i = 2; i < setpoints.size(); ++i) {
        for (std::size_t a = 0; a < 3; ++a) {
            const double change =
                setpoints[i].axis[a] - 2 * setpoints[i - 1].axis[a] + setpoints[i - 2].axis[a];
            greatest = std::max(greatest, std::abs(change) / (machine.tick * machine.tick) /
                                              machine.axes[a].acceleration);
        }
    }
    return greatest;
}

TEST(Corners, JumpAndRampsTogetherKeepTheAcceleration) {
    std::vector<Command> wave;
    for (int i = 1; i <= 600; ++i) {
        const double x = 0.1 * i;
        wave.push_back(line_to({x, 5 * std::sin(x), 0}, 20000));
    }
    struct Row {
        const char* name;
        std::vector<Command> program;
    };
    for (const Row& row : {Row{"square", {line_to({50, 0, 0}, 6000), line_to({50, 50, 0}, 6000)}},
                           {"reversal", {line_to({50, 0, 0}, 6000), line_to({0, 0, 0}, 6000)}},
                           {"rapid", {rapid_to({50, 0, 0}), rapid_to({50, 50, 40})}},
                           {"blunt", {line_to({50, 0, 0}, 9000), line_to({99, 9, 0}, 9000)}},
                           {"wave", wave}}) {
        SCOPED_TRACE(row.name);
        const machine::Machine machine = machine_of();
        const double share = greatest_share(machine, row.program);
        EXPECT_LE(share, 1 + kRelative);
        EXPECT_GE(share, 0.5);
        // The summary's figure is not below what the setpoints show.
        const Motion planned = run(machine, row.program);
        double told = 0;
        for (std::size_t a = 0; a < 3; ++a) {
            told =
                std::max(told, planned.totals.max_acceleration[a] / machine.axes[a].acceleration);
        }
        EXPECT_GE(told, share * (1 - 1e-3));
        EXPECT_LE(told, 1 + kRelative);
    }
}

RC_GTEST_PROP(MotionProperty, RoundingStaysInsideItsTolerance, ()) {
    const auto machine = any_machine();
    auto program = any_program();
    for (Command& command : program)
        if (command.is_motion()) command.motion().blending = {};
    const Motion sharp = run(machine, program);
    RC_PRE(!sharp.segments.empty());
    const double tolerance = any_number(1, 100) / 1000;
    for (Command& command : program) {
        if (command.is_motion()) command.motion().blending = within(tolerance, true);
    }
    const Motion round = run(machine, program);
    RC_CLASSIFY(round.totals.time < sharp.totals.time, "quicker");
    RC_CLASSIFY(round.totals.time > sharp.totals.time, "slower");
    for (const Segment& segment : round.segments) {
        if (!is_motion(segment.kind)) continue;
        const double length = path::length(segment.curve);
        for (int i = 0; i <= 2; ++i) {
            const Vec3 point = path::position(segment.curve, length * i / 2);
            double least = kUnlimited;
            for (const Segment& motion : sharp.segments) {
                if (is_motion(motion.kind) && motion.line + 1 >= segment.line &&
                    motion.line <= segment.line + 1)
                    least = std::min(least, miss(motion, point));
            }
            RC_ASSERT(least <= tolerance);
        }
    }
}

RC_GTEST_PROP(MotionProperty, TicksOfAStraightChainAddUpToThePath, ()) {
    const auto machine = any_machine();
    const Vec3 direction = any_point(10);
    RC_PRE(direction.norm() > 0.1);
    std::vector<Command> program;
    const int count = *rc::gen::inRange(1, 200);
    double reach = 0;
    for (int i = 0; i < count; ++i) {
        reach += any_number(0, 1) * *rc::gen::element(1.0, 0.001);
        program.push_back(line_to(direction * reach, any_number(10, 60000)));
    }
    const auto setpoints = sample(machine, program);
    double sum = 0;
    for (std::size_t i = 1; i < setpoints.size(); ++i) {
        sum += (setpoints[i].tip - setpoints[i - 1].tip).norm();
    }
    const double length =
        setpoints.empty() ? 0 : (setpoints.back().tip - setpoints.front().tip).norm();
    RC_ASSERT(std::abs(sum - length) <= 1e-9 * std::max(1.0, length));
}

RC_GTEST_PROP(MotionProperty, CuttingALineCostsNoTime, ()) {
    const auto machine = any_machine();
    const Vec3 end = any_point(100);
    RC_PRE(end.norm() > 0.1);
    const double feed = any_number(10, 60000);
    const int pieces = *rc::gen::inRange(2, 400);
    std::vector<Command> program;
    for (int i = 1; i <= pieces; ++i) program.push_back(line_to(end * (double(i) / pieces), feed));
    const double whole = run(machine, {line_to(end, feed)}).totals.time;
    const double cut = run(machine, program).totals.time;
    RC_ASSERT(std::abs(cut - whole) <= 1e-7 * whole);
}

/// A closed contour of waves, in blocks of one length from 10 to 200 µm.
std::vector<Command> any_short_blocks() {
    const double step = any_number(10, 200) / 1000;
    const double radius = any_number(3, 20);
    const double wave = any_number(0, 1) * radius / 10;
    const int waves = *rc::gen::inRange(2, 6);
    const double feed = any_number(500, 6000);
    std::vector<Command> program;
    for (double s = 0; s < 20; s += step) {
        const double angle = s / radius;
        const double r = radius + wave * std::cos(waves * angle);
        program.push_back(line_to(
            {r * std::cos(angle) - radius - wave, r * std::sin(angle), wave * std::sin(angle)},
            feed));
    }
    return program;
}

RC_GTEST_PROP(ShortBlocks, KeepTheLimitsAndNeverStop, ()) {
    const auto machine = any_machine();
    const auto program = any_short_blocks();
    const Motion motion = run(machine, program);
    for (std::size_t i = 1; i < motion.segments.size(); ++i) {
        RC_ASSERT(motion.segments[i].profile.entry_speed > 0);
    }
    TickWatch watch(machine, motion.segments);
    const auto setpoints = sample(machine, program);
    for (const Setpoint& setpoint : setpoints) watch.add(setpoint);
    RC_ASSERT(watch.shares().velocity <= 1 + 1e-3);
    RC_ASSERT(watch.shares().acceleration <= 1 + 1e-3);
    RC_ASSERT(watch.shares().jerk <= 1 + 1e-3);
    RC_ASSERT(setpoints.back().tip == path::end(motion.segments.back().curve));
}

TEST(ShortBlocks, PassWithoutStopping) {
    // A closed contour of blocks of 10 to 200 µm: with a limit of the jerk they pass as fast as
    // without one but for the start and the stop.
    for (const double step : {0.01, 0.05, 0.2}) {
        SCOPED_TRACE(step);
        std::vector<Command> program;
        for (double s = step; s < 100; s += step) {
            const double angle = s / 20;
            program.push_back(line_to(
                {20 * std::sin(angle), 20 - 20 * std::cos(angle) + std::sin(2 * angle), 0}, 3000));
        }
        Dynamics dynamics;
        dynamics.jerk = Vec3::Constant(100000);
        const Motion sharp = run(machine_of(), program);
        const Motion smooth = run(machine_of(dynamics), program);
        for (const Segment& segment : smooth.segments) {
            const bool is_inside =
                segment.start_time > 0.1 && segment.end_time() < smooth.totals.time - 0.1;
            if (!is_inside) continue;
            EXPECT_GE(segment.profile.entry_speed, 45);
        }
        EXPECT_LE(smooth.totals.time, sharp.totals.time + 0.06);
    }
}

// --- look-ahead against its definition ----------------------------------------------------------

struct Chain {
    std::vector<Stretch> stretches;
};

Chain any_chain() {
    Chain chain;
    const int count = *rc::gen::inRange(1, 120);
    for (int i = 0; i < count; ++i) {
        chain.stretches.push_back({any_number(0, 3), any_number(1, 200), any_number(100, 2000),
                                   *rc::gen::element(0.0, 5.0, 50.0, 1e9),
                                   *rc::gen::element(kUnlimited, 5e3, 2e5)});
    }
    return chain;
}

/// Junction speeds squared by the definition: at every junction plan the known pieces anew.
std::vector<double> by_definition(const std::vector<Stretch>& path, std::size_t depth) {
    const auto limit = [&](std::size_t k) {  // of the junction before piece k
        const double corner = path[k].entry_limit;
        const double before = k > 0 ? path[k - 1].speed : 0.0;
        const double v = std::min({corner, before, path[k].speed});
        return v * v;
    };
    const auto reach = [&](double square, std::size_t k) {
        const Stretch& s = path[k];
        if (std::isinf(s.jerk)) return square + 2 * s.acceleration * s.length;
        const double v = steady_reach(std::sqrt(square), s.length, {s.acceleration, s.jerk});
        return v * v;
    };
    std::vector<double> speeds = {0};
    for (std::size_t k = 0; k < path.size(); ++k) {
        const std::size_t known = std::min(path.size(), k + depth);
        double after = 0;
        for (std::size_t i = known; i-- > k + 1;) after = std::min(limit(i), reach(after, i));
        speeds.push_back(std::min(after, reach(speeds[k], k)));
    }
    return speeds;
}

std::vector<double> by_streaming(const std::vector<Stretch>& path, std::size_t depth) {
    LookAhead lookahead(depth);
    std::vector<double> speeds = {0};
    std::size_t next = 0;
    while (speeds.size() <= path.size()) {
        while (next < path.size() && !lookahead.is_full()) lookahead.append(path[next++]);
        if (next == path.size()) lookahead.finish();
        speeds.push_back(std::pow(lookahead.take().exit, 2));
    }
    return speeds;
}

RC_GTEST_PROP(LookAhead, IsItsDefinitionAtSmallDepths, ()) {
    const Chain chain = any_chain();
    const std::size_t depth = *rc::gen::inRange<std::size_t>(1, 31);
    const auto expected = by_definition(chain.stretches, depth);
    const auto got = by_streaming(chain.stretches, depth);
    for (std::size_t k = 0; k < expected.size(); ++k) {
        RC_ASSERT(std::abs(got[k] - expected[k]) <= 1e-9 * std::max(1.0, expected[k]));
    }
}

RC_GTEST_PROP(LookAhead, LiesBetweenItsDepthAndTheWholePath, ()) {
    const Chain chain = any_chain();
    const std::size_t depth = *rc::gen::inRange<std::size_t>(32, 100);
    const auto least = by_definition(chain.stretches, depth);
    const auto most = by_definition(chain.stretches, chain.stretches.size());
    const auto got = by_streaming(chain.stretches, depth);
    for (std::size_t k = 0; k < got.size(); ++k) {
        RC_ASSERT(got[k] >= least[k] * (1 - 1e-12) - 1e-12);
        RC_ASSERT(got[k] <= most[k] * (1 + 1e-12) + 1e-12);
    }
}

TEST(LookAhead, LargeWindowEqualsTheWholePath) {
    // 20000 blocks of a hundredth to a tenth of a millimetre: the braking distance from 200 mm/s is
    // 4 mm, some 80 blocks, far inside the window.
    std::vector<Command> program;
    for (int i = 1; i <= 20000; ++i) {
        const double t = i * 0.001;
        program.push_back(
            line_to({40 * std::cos(t), 25 * std::sin(2 * t), 5 * std::sin(t / 3)}, 12000));
    }
    PlannerOptions whole;
    whole.lookahead = 100000;
    PlannerOptions window;
    window.lookahead = 500;
    const Motion a = run(machine_of(), program, whole);
    const Motion b = run(machine_of(), program, window);
    ASSERT_EQ(a.segments.size(), b.segments.size());
    for (std::size_t i = 0; i < a.segments.size(); ++i) {
        ASSERT_EQ(a.segments[i].profile.exit_speed, b.segments[i].profile.exit_speed) << i;
    }
    EXPECT_EQ(a.totals.time, b.totals.time);
}

TEST(LookAhead, TakesBackNothingThatIsFixed) {
    LookAhead lookahead(1);
    EXPECT_TRUE(lookahead.is_empty());
    lookahead.append({1, 100, 1000, 0});
    EXPECT_TRUE(lookahead.is_full());
    const JunctionSpeeds first = lookahead.take();
    EXPECT_EQ(first.entry, 0);
    EXPECT_EQ(first.exit, 0);  // nothing is known behind it
}

}  // namespace
}  // namespace kadr::motion::property_test
