// Short lines that become spans of splines: how few, how far from the lines, how fast, and what
// ends a run.
#include "motion/compressor.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/motion/support.h"
#include "tests/motion/tick_limits.h"

namespace kadr::motion::compressor_test {
namespace {

using namespace test;

constexpr double pi = std::numbers::pi;

machine::Machine smooth_machine() {
    Dynamics dynamics;
    dynamics.jerk = {100'000, 100'000, 80'000};
    return machine_of(dynamics);
}

/// Points of a curve with three decimals, as a program has them, about so far from each other; the
/// first is where the machine stands.
std::vector<Vec3> points_of(const std::function<Vec3(double)>& curve, double spacing) {
    constexpr int kFine = 100'000;
    std::vector<Vec3> points;
    double distance = spacing;
    for (int i = 0; i <= kFine; ++i) {
        const Vec3 at = curve(i / double{kFine}) - curve(0);
        if (i > 0) distance += (at - (curve((i - 1) / double{kFine}) - curve(0))).norm();
        if (distance < spacing && i < kFine) continue;
        distance = 0;
        const Vec3 rounded = (at * 1000).array().round() / 1000;
        if (points.empty() || rounded != points.back()) points.push_back(rounded);
    }
    return points;
}

std::vector<Command> lines_over(const std::vector<Vec3>& points, double tolerance,
                                double feed = 6000) {
    std::vector<Command> lines;
    for (std::size_t i = 1; i < points.size(); ++i) {
        lines.push_back(line_to(points[i], feed));
        lines.back().motion().compress = tolerance;
    }
    return lines;
}

struct Shape {
    const char* name;
    std::function<Vec3(double)> curve;
};

std::vector<Shape> shapes() {
    return {
        {"circle",
         [](double u) { return Vec3(10 * std::cos(2 * pi * u), 10 * std::sin(2 * pi * u), 0); }},
        {"spiral in space",
         [](double u) {
             return Vec3((4 + 4 * u) * std::cos(9 * u), (4 + 4 * u) * std::sin(9 * u), 6 * u);
         }},
        {"wave", [](double u) { return Vec3(40 * u, 2 * std::sin(12 * u), std::cos(5 * u)); }},
        {"sum of sines",
         [](double u) {
             return Vec3(30 * u + std::sin(9 * u), 3 * std::sin(7 * u) + 0.6 * std::cos(23 * u),
                         0.5 * std::sin(31 * u));
         }},
    };
}

/// What comes out of a compressor, as a planner would take it.
std::vector<Command> compressed(const std::vector<Command>& commands) {
    const machine::Machine machine = machine_of();
    AxesPosition standing(machine);
    Compressor compressor;
    std::vector<Command> out;
    const auto drain = [&] {
        while (const Command* command = compressor.next()) {
            out.push_back(*command);
            if (command->is_motion())
                standing.arrive(command->motion(), standing.target_of(command->motion()));
        }
    };
    for (const Command& command : commands) {
        compressor.take(command, standing);
        drain();
    }
    compressor.finish();
    drain();
    return out;
}

std::vector<path::Curve> curves_of(const std::vector<Command>& commands) {
    const machine::Machine machine = machine_of();
    AxesPosition standing(machine);
    std::vector<path::Curve> curves;
    for (const Command& command : commands) {
        Segment segment = standing.still();
        const auto target = standing.target_of(command.motion());
        standing.lay_path(command.motion(), target, segment);
        curves.push_back(segment.curve);
        standing.arrive(command.motion(), target);
    }
    return curves;
}

double distance_to_polyline(const std::vector<Vec3>& points, const Vec3& point, std::size_t& near) {
    // Looked for around the line where the place before was.
    double least = kUnlimited;
    const std::size_t from = near > 60 ? near - 60 : 0;
    for (std::size_t i = from; i + 1 < points.size() && i < from + 120; ++i) {
        const Vec3 delta = points[i + 1] - points[i];
        const double along =
            std::clamp((point - points[i]).dot(delta) / delta.squaredNorm(), 0.0, 1.0);
        const double apart = (point - points[i] - along * delta).norm();
        if (apart < least) {
            least = apart;
            near = i;
        }
    }
    return least;
}

// Points that lie farther from a smooth course than the tolerance: curves through them would be
// waves, slower than the corners between the lines.
TEST(Compressor, LeavesWhatItCannotSmooth) {
    std::vector<Vec3> points = {Vec3::Zero()};
    for (int i = 1; i <= 300; ++i) points.emplace_back(0.5 * i, 0.02 * std::sin(7.3 * i * i), 0);
    const auto lines = lines_over(points, 0.01);
    EXPECT_EQ(compressed(lines).size(), lines.size());
    const auto machine = smooth_machine();
    auto plain = lines;
    for (Command& line : plain) line.motion().compress = 0;
    EXPECT_LE(run(machine, lines).totals.time, run(machine, plain).totals.time);
}

TEST(Compressor, FewSpansWithinTheTolerance) {
    for (const Shape& shape : shapes()) {
        for (const double spacing : {0.02, 0.2}) {
            for (const double tolerance : {0.01, 0.003}) {
                SCOPED_TRACE(shape.name);
                SCOPED_TRACE(spacing);
                SCOPED_TRACE(tolerance);
                const auto points = points_of(shape.curve, spacing);
                const auto spans = compressed(lines_over(points, tolerance));
                EXPECT_LT(static_cast<double>(spans.size()),
                          (spacing < 0.1 ? 0.1 : 0.4) * static_cast<double>(points.size()));
                // From the curve to the lines, and from their ends to the curve.
                std::size_t near = 0;
                std::vector<Vec3> samples;
                for (const path::Curve& curve : curves_of(spans)) {
                    const double length = path::length(curve);
                    const int steps = std::max(4, static_cast<int>(length / 0.02));
                    for (int i = 0; i <= steps; ++i) {
                        samples.push_back(path::position(curve, length * i / steps));
                        EXPECT_LE(distance_to_polyline(points, samples.back(), near), tolerance);
                    }
                }
                near = 0;
                for (const Vec3& point : points) {
                    double least = kUnlimited;
                    std::size_t best = near;
                    for (std::size_t i = near; i < samples.size() && i < near + 400; ++i) {
                        if ((samples[i] - point).norm() >= least) continue;
                        least = (samples[i] - point).norm();
                        best = i;
                    }
                    near = best > 100 ? best - 100 : 0;
                    EXPECT_LE(least, std::hypot(tolerance, 0.012));
                }
                EXPECT_LE((samples.back() - points.back()).norm(), 1e-9);
            }
        }
    }
}

TEST(Compressor, DirectionRunsOnFromSpanToSpan) {
    for (const Shape& shape : shapes()) {
        SCOPED_TRACE(shape.name);
        const auto curves = curves_of(compressed(lines_over(points_of(shape.curve, 0.02), 0.01)));
        for (std::size_t i = 1; i < curves.size(); ++i) {
            const auto in = path::evaluate(curves[i - 1], path::length(curves[i - 1]));
            const auto out = path::evaluate(curves[i], 0);
            EXPECT_EQ(in.position, out.position);
            EXPECT_LE((in.tangent - out.tangent).norm(), 1e-9) << i;
        }
    }
}

TEST(Compressor, IsQuickerAndNeverStops) {
    for (const machine::Machine& machine : {machine_of(), smooth_machine()}) {
        for (const Shape& shape : shapes()) {
            for (const double spacing : {0.01, 0.2}) {
                SCOPED_TRACE(shape.name);
                SCOPED_TRACE(spacing);
                const auto points = points_of(shape.curve, spacing);
                const Motion plain = run(machine, lines_over(points, 0));
                const auto commands = lines_over(points, 0.01);
                const Motion curved = run(machine, commands);
                // From line to line velocities jump by what a tick's acceleration makes; the curve
                // keeps to the jerk. So slight corners far apart may be quicker where it is
                // limited.
                const bool is_sure = std::isinf(machine.axes[0].jerk) || spacing < 0.1;
                EXPECT_LT(curved.totals.time, (is_sure ? 1 : 1.5) * plain.totals.time);
                EXPECT_EQ(curved.totals.commands, commands.size());
                for (std::size_t k = 1; k < curved.segments.size(); ++k)
                    EXPECT_GT(curved.segments[k].profile.entry_speed, 0);
                TickWatch watch(machine, curved.segments);
                for (const Setpoint& setpoint : sample(machine, commands)) watch.add(setpoint);
                EXPECT_LE(watch.shares().velocity, 1 + 1e-3);
                EXPECT_LE(watch.shares().acceleration, 1 + 1e-3);
                EXPECT_LE(watch.shares().jerk, 1 + 1e-3);
            }
        }
    }
}

TEST(Compressor, AStraightLineIsOneLine) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 100; ++i) points.push_back({0.1 * i, 0.2 * i, 0});
    const auto spans = compressed(lines_over(points, 0.01));
    ASSERT_EQ(spans.size(), 1u);
    EXPECT_EQ(spans[0].op(), Op::Line);
    EXPECT_EQ(spans[0].motion().to[0], points.back()[0]);
}

TEST(Compressor, WhatEndsARun) {
    const auto points = points_of(shapes()[0].curve, 0.1);
    const auto lines = lines_over(points, 0.01);
    const std::size_t half = lines.size() / 2;
    const std::size_t whole = compressed(lines).size();
    struct Row {
        const char* name;
        std::function<void(Command&)> change;
        bool stays;  // the changed line comes out as it is
    };
    for (const Row& row : {
             Row{"another feed", [](Command& c) { c.motion().feed = 1000; }, true},
             Row{"no tolerance", [](Command& c) { c.motion().compress = 0; }, true},
             Row{"another tolerance", [](Command& c) { c.motion().compress = 0.02; }, true},
             Row{"inverse time",
                 [](Command& c) { c.motion().feed_mode = path::FeedMode::InverseTime; }, true},
             Row{"a rotary axis", [](Command& c) { c.motion().moved |= bit(Axis::C); }, true},
             Row{"rapid", [](Command& c) { c.become(Op::Rapid); }, true},
             Row{"an exact stop", [](Command& c) { c.motion().exact_stop = true; }, false},
         }) {
        SCOPED_TRACE(row.name);
        auto changed = lines;
        row.change(changed[half]);
        const auto spans = compressed(changed);
        EXPECT_GE(spans.size(), whole);
        EXPECT_LT(spans.size(), 2 * whole + 4);
        const auto at = std::find_if(spans.begin(), spans.end(), [&](const Command& command) {
            return command.motion().to == changed[half].motion().to;
        });
        ASSERT_NE(at, spans.end());
        EXPECT_EQ(at->motion().exact_stop, changed[half].motion().exact_stop);
        if (!row.stays) continue;
        EXPECT_NE(at->op(), Op::Spline);
        EXPECT_EQ((at - 1)->motion().to, changed[half - 1].motion().to);
    }
    auto commands = lines;
    commands.insert(commands.begin() + static_cast<long>(half), simple(Op::Coolant));
    const auto spans = compressed(commands);
    const auto at = std::find_if(spans.begin(), spans.end(),
                                 [](const Command& c) { return c.op() == Op::Coolant; });
    ASSERT_NE(at, spans.end());
    EXPECT_EQ((at - 1)->motion().to, lines[half - 1].motion().to);
}

TEST(Compressor, CornersAndLongLinesStay) {
    // A square with rounded corners of points: four arcs, four straight sides of 30 mm.
    std::vector<Vec3> points = {Vec3::Zero()};
    for (int corner = 0; corner < 4; ++corner) {
        const double turn = corner * pi / 2;
        const Vec3 along(std::cos(turn), std::sin(turn), 0), left(-along[1], along[0], 0);
        points.push_back(points.back() + 30 * along);
        const Vec3 center = points.back() + 5 * left;
        for (int i = 1; i <= 50; ++i) {
            const double angle = i * pi / 100;
            points.push_back(center + 5 * (std::sin(angle) * along - std::cos(angle) * left));
        }
    }
    const auto spans = compressed(lines_over(points, 0.01));
    EXPECT_LT(spans.size(), 40u);
    EXPECT_EQ(std::count_if(spans.begin(), spans.end(),
                            [](const Command& command) { return command.op() == Op::Line; }),
              4);
    // A kink of 40 degrees in a run.
    std::vector<Vec3> kink = {Vec3::Zero()};
    for (int i = 0; i < 60; ++i) {
        const double angle = 0.01 * i + (i >= 30 ? 40 * pi / 180 : 0);
        kink.push_back(kink.back() + 0.1 * Vec3(std::cos(angle), std::sin(angle), 0));
    }
    const auto sharp = compressed(lines_over(kink, 0.01));
    EXPECT_TRUE(std::any_of(sharp.begin(), sharp.end(), [&](const Command& command) {
        return Vec3(command.motion().to[0], command.motion().to[1], command.motion().to[2]) ==
               kink[30];
    }));
}

TEST(Compressor, APulsedLaserKeepsItsPoints) {
    machine::Machine machine = machine_of();
    machine.laser.emplace();
    machine.laser->pulse = 0.025;
    const auto points = points_of(shapes()[0].curve, 0.1);
    EXPECT_EQ(run(machine, lines_over(points, 0.01)).segments.size(), points.size() - 1);
}

}  // namespace
}  // namespace kadr::motion::compressor_test
