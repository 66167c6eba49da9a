// The check of setpoints against the programmed path: nothing that the planner makes is refused,
// whatever the program, and everything that leaves the path is found.
#include "motion/path_check.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "motion/plain_motion.h"
#include "path/steady.h"
#include "tests/common/test_curves.h"
#include "tests/motion/any_program.h"
#include "tests/motion/support.h"

namespace kadr::motion::path_check_test {
namespace {

using namespace test;

/// What the check says of setpoints, given in batches that are no divisor of anything.
std::optional<PathDeviation> deviation_of(const machine::Machine& machine,
                                          const std::vector<Command>& program,
                                          const std::vector<Setpoint>& setpoints) {
    PathCheck check(machine);
    for (const Command& command : program) check.read(command);
    constexpr std::size_t kBatch = 17;
    const std::span<const Setpoint> all(setpoints);
    for (std::size_t i = 0; i < all.size(); i += kBatch) {
        if (!check.follow(all.subspan(i, std::min(kBatch, all.size() - i)))) break;
    }
    if (!check.deviation()) check.finish();
    return check.deviation();
}

/// Commands with the numbers that a text gives them.
std::vector<Command> numbered(std::vector<Command> program) {
    std::uint32_t line = 0;
    for (Command& command : program) command.line = ++line;
    return program;
}

TEST(PathCheck, TakesEveryTolerance) {
    machine::Machine machine = machine_of();
    for (const path::Blending& wish :
         {path::Blending{}, by_distance(0.5), within(0.05), within(0.05, true), within(2, true)}) {
        for (const double compress : {0.0, 0.02, 0.5}) {
            std::vector<Command> program;
            for (int i = 0; i <= 200; ++i) {
                const double angle = 0.05 * i;
                const double radius = 5 + 0.02 * i;
                program.push_back(
                    line_to({radius * std::cos(angle), radius * std::sin(angle), 0.01 * i}, 3000));
                program.back().motion().compress = compress;
                if (i % 50 == 49) program.push_back(line_to({radius, -radius, 0}, 3000));
            }
            program = numbered(rounded(program, wish));
            EXPECT_FALSE(deviation_of(machine, program, sample(machine, program)).has_value());
        }
    }
}

/// All of the way lies within the tolerance of its first line, on which the check sees the tip
/// stay.
TEST(PathCheck, FollowsAWayForthAndBackWithinItsTolerance) {
    const machine::Machine machine = machine_of();
    for (const int turns : {2, 5, 20, 200}) {
        for (const path::Blending& wish : {within(0.1), within(0.1, true), by_distance(0.1)}) {
            std::vector<Command> program = {rapid_to({0, 5, 0}), line_to({0, 0, 0}, 5000)};
            for (int i = 1; i <= turns; ++i) program.push_back(line_to({i % 2 * 0.25, 0, 0}, 5000));
            program.push_back(line_to({0, 0, -0.5}, 5000));
            program.push_back(line_to({5, 0, -0.5}, 5000));
            program = numbered(rounded(program, wish));
            std::vector<Setpoint> setpoints = sample(machine, program);
            EXPECT_FALSE(deviation_of(machine, program, setpoints).has_value()) << turns;
            // What lies behind is held to the way as well as ever.
            setpoints[setpoints.size() - 20].axis[1] += 0.2;
            EXPECT_TRUE(deviation_of(machine, program, setpoints).has_value()) << turns;
        }
    }
}

RC_GTEST_PROP(PathCheck, RefusesNothingThatIsPlanned, ()) {
    const auto machine = any_machine();
    std::vector<Command> program = any_program();
    if (*rc::gen::arbitrary<bool>())
        for (Command& command : program)
            if (command.op() == Op::Line) command.motion().compress = any_number(0, 1) * 0.1;
    const auto deviation = deviation_of(machine, program, sample(machine, program));
    if (deviation)
        RC_FAIL("line " + std::to_string(deviation->motion.line) + " fault " +
                std::to_string(static_cast<int>(deviation->fault)) + " by " +
                std::to_string(deviation->distance) + " of " + std::to_string(deviation->allowed));
}

// A zigzag and an arc, so that every kind of mistake has something to show at.
std::vector<Command> workpiece() {
    std::vector<Command> program = {rapid_to({10, 0, 0})};
    for (int i = 1; i <= 10; ++i) program.push_back(line_to({10.0 + i, i % 2 * 2.0, 0}, 3000));
    program.push_back(arc_to({30, 0, 0}, {25, 0, 0}, -std::numbers::pi, 3000));
    program.push_back(line_to({30, -20, 0}, 3000));
    return numbered(program);
}

struct Mistake {
    const char* name;
    std::function<void(std::vector<Setpoint>&)> make;
    DeviationKind fault;
    std::uint32_t line;  // that it is found in; 0: any
    double distance;     // mm, about; 0: any
};

/// The setpoints of a line.
std::pair<std::size_t, std::size_t> range_of(const std::vector<Setpoint>& setpoints,
                                             std::uint32_t line) {
    std::size_t first = 0;
    while (setpoints[first].line != line) ++first;
    std::size_t last = first;
    while (last < setpoints.size() && setpoints[last].line == line) ++last;
    return {first, last};
}

TEST(PathCheck, FindsEveryMistake) {
    const machine::Machine machine = machine_of();
    const std::vector<Command> program = workpiece();
    const std::vector<Setpoint> right = sample(machine, program);
    EXPECT_FALSE(deviation_of(machine, program, right).has_value());
    const auto shift = [](Setpoint& setpoint, const Vec3& delta) {
        setpoint.tip += delta;
        for (std::size_t i = 0; i < 3; ++i) setpoint.axis[i] += delta[static_cast<long>(i)];
    };
    for (const Mistake& mistake : {
             Mistake{"one setpoint beside an arc",
                     [&](auto& all) {
                         const auto [from, to] = range_of(all, 12);
                         shift(all[(from + to) / 2], {0, 0, 0.01});
                     },
                     DeviationKind::Tip, 12, 0.01},
             Mistake{"a thousandth of a millimetre",
                     [&](auto& all) {
                         shift(all[range_of(all, 5).second - 9], {0, 0, 0.001});
                     },
                     DeviationKind::Tip, 5, 0.001},
             Mistake{"only the axes are wrong",
                     [&](auto& all) { all[range_of(all, 7).second - 9].axis[2] += 0.02; },
                     DeviationKind::Tip, 7, 0.02},
             Mistake{"a corner left out by a straight line",
                     [&](auto& all) {
                         // From the middle of one line to the middle of the next.
                         const auto [from, corner] = range_of(all, 4);
                         const auto [next, to] = range_of(all, 5);
                         const std::size_t begin = (from + corner) / 2;
                         const std::size_t end = (next + to) / 2;
                         const Vec3 start = all[begin].tip;
                         const Vec3 delta = all[end].tip - start;
                         for (std::size_t i = begin; i < end; ++i) {
                             const double share =
                                 static_cast<double>(i - begin) / static_cast<double>(end - begin);
                             shift(all[i], start + share * delta - all[i].tip);
                         }
                     },
                     DeviationKind::Tip, 0, 0},
             Mistake{"two lines are not gone at all",
                     [](auto& all) {
                         const auto [from, to] = range_of(all, 4);
                         const auto [next, end] = range_of(all, 5);
                         all.erase(all.begin() + static_cast<long>(from),
                                   all.begin() + static_cast<long>(end));
                     },
                     DeviationKind::Tip, 0, 0},
             Mistake{"back along the line",
                     [](auto& all) {
                         const auto [from, to] = range_of(all, 13);
                         all[to - 20] = all[from + 20];
                     },
                     DeviationKind::Tip, 13, 0},
             Mistake{"an end that is not reached", [](auto& all) { all.resize(all.size() - 30); },
                     DeviationKind::End, 13, 0},
         }) {
        SCOPED_TRACE(mistake.name);
        std::vector<Setpoint> wrong = right;
        mistake.make(wrong);
        const auto found = deviation_of(machine, program, wrong);
        ASSERT_TRUE(found.has_value());
        EXPECT_EQ(static_cast<int>(found->fault), static_cast<int>(mistake.fault));
        if (mistake.line > 0) {
            EXPECT_EQ(found->motion.line, mistake.line);
        }
        if (mistake.distance > 0) {
            EXPECT_NEAR(found->distance, mistake.distance, 1e-6);
        }
        EXPECT_GT(found->distance, found->allowed);
    }
}

// In a cusp a curve comes back beside itself: the tip is followed round it, and whatever is beside
// the curve or behind it is found.
TEST(PathCheck, FollowsCurvesRoundTheirCusps) {
    const machine::Machine machine = machine_of();
    const path::CurveShape arches = kadr::testing::shape_of(kadr::testing::kCycloid, 8, 3);
    Command curve = line_to(path::end_of(arches, Vec3::Zero()), 3000);
    curve.become(Op::Parametric);
    curve.motion().curve() = arches;
    const std::vector<Command> program =
        numbered({curve, line_to(path::end_of(arches, Vec3::Zero()) + Vec3(0, 20, 0), 3000)});
    const std::vector<Setpoint> right = sample(machine, program);
    EXPECT_FALSE(deviation_of(machine, program, right).has_value());
    for (const std::uint32_t line : {1u, 2u}) {
        std::vector<Setpoint> wrong = right;
        Setpoint& off = wrong[range_of(wrong, line).second - 30];
        off.tip[2] = off.axis[2] = 0.001;
        const auto found = deviation_of(machine, program, wrong);
        ASSERT_TRUE(found.has_value());
        EXPECT_EQ(found->motion.line, line);
        EXPECT_NEAR(found->distance, 0.001, 1e-6);
    }
}

/// A spline between points that lie nearly on a line, which turns back as it likes.
Command any_flat_spline(const path::Blending& wish) {
    const double height = *rc::gen::element(0.0, 1e-4, 1e-2, 1.0);
    const auto point = [&] { return Vec3(any_number(-50, 50), height * any_number(-1, 1), 0); };
    Command command = spline_to(point(), point(), point(), *rc::gen::element(500.0, 2e3, 1e4));
    command.motion().blending = wish;
    return command;
}

RC_GTEST_PROP(PathCheck, FollowsSplinesThatTurnBack, ()) {
    const machine::Machine machine = machine_of({.jerk = {1e5, 1e5, 8e4}});
    const path::Blending wish = *rc::gen::element(path::Blending{}, by_distance(0.5), within(0.05));
    std::vector<Command> program;
    const int count = *rc::gen::inRange(1, 5);
    for (int i = 0; i < count; ++i) program.push_back(any_flat_spline(wish));
    program = numbered(program);
    std::vector<Setpoint> setpoints = sample(machine, program);
    RC_ASSERT(!deviation_of(machine, program, setpoints).has_value());
    if (setpoints.size() < 100) return;
    // What is beside it is found in front of a turn and behind it.
    Setpoint& off = setpoints[*rc::gen::inRange<std::size_t>(50, setpoints.size() - 50)];
    off.tip[2] = off.axis[2] = wish.size + 0.01;
    RC_ASSERT(deviation_of(machine, program, setpoints).has_value());
}

/// A wavy curve by cubics of half a millimetre, with the slopes of the wave.
std::vector<Command> dense_spline(int count, const path::Blending& wish) {
    const auto point = [](double x) { return Vec3(x, 3 * std::sin(x / 2), 0.2 * std::cos(x)); };
    const auto slope = [](double x) { return Vec3(1, 1.5 * std::cos(x / 2), -0.2 * std::sin(x)); };
    constexpr double kStep = 0.5;
    std::vector<Command> program = {rapid_to(point(0))};
    for (int i = 0; i < count; ++i) {
        const double from = kStep * i, to = from + kStep;
        program.push_back(spline_to(point(to), point(from) + kStep / 3 * slope(from),
                                    point(to) - kStep / 3 * slope(to), 3000));
        program.back().motion().blending = wish;
    }
    return numbered(program);
}

// Spans that go on towards their end are judged as plain motions, to the same tolerance as others.
TEST(PathCheck, HoldsDenseSplinesToTheirTolerance) {
    const machine::Machine machine = machine_of({.jerk = {1e5, 1e5, 8e4}});
    for (const path::Blending& wish : {path::Blending{}, by_distance(0.2), within(0.01)}) {
        const std::vector<Command> program = dense_spline(200, wish);
        const std::vector<Setpoint> right = sample(machine, program);
        for (const double part : {0.1, 0.3, 0.5, 0.77}) {
            const auto index = static_cast<std::size_t>(part * static_cast<double>(right.size()));
            const Vec3 delta = right[index + 1].tip - right[index - 1].tip;
            const Vec3 aside = delta.cross(Vec3::UnitX()).normalized();
            for (const double beyond : {-5e-7, 5e-7}) {
                std::vector<Setpoint> moved = right;
                for (std::size_t i = 0; i < 3; ++i)
                    moved[index].axis[i] +=
                        (wish.size + 1e-6 + beyond) * aside[static_cast<long>(i)];
                const auto found = deviation_of(machine, program, moved);
                EXPECT_EQ(found.has_value(), beyond > 0) << part;
            }
        }
    }
}

// … and none of them may be cut short, or be missing at the end.
TEST(PathCheck, FindsDenseSpansThatAreLeftOut) {
    const machine::Machine machine = machine_of({.jerk = {1e5, 1e5, 8e4}});
    const std::vector<Command> program = dense_spline(200, {});
    const std::vector<Setpoint> right = sample(machine, program);
    const auto fault_of = [&](const std::vector<Setpoint>& wrong) {
        const auto found = deviation_of(machine, program, wrong);
        return found ? std::optional(found->fault) : std::nullopt;
    };
    std::vector<Setpoint> cut = right;
    const auto [from, to] = range_of(cut, 50);
    for (std::size_t i = from; i < to; ++i) {
        const double share = static_cast<double>(i - from + 1) / static_cast<double>(to - from + 1);
        for (std::size_t k = 0; k < 3; ++k)
            cut[i].axis[k] = right[from - 1].axis[k] * (1 - share) + right[to].axis[k] * share;
    }
    EXPECT_EQ(fault_of(cut), DeviationKind::Tip);
    std::vector<Setpoint> too_short = right;
    too_short.resize(range_of(right, 180).first);
    EXPECT_EQ(fault_of(too_short), DeviationKind::End);
}

// What a plain span says of a tip is what looking everywhere says; where it knows nothing it says
// so.
RC_GTEST_PROP(PathCheck, SaysOfPlainSpansWhatIsSure, ()) {
    const auto any = [](double reach) { return *rc::gen::inRange(-1000, 1001) * 0.001 * reach; };
    const Vec3 end(3, 0, 0);
    path::SplineShape shape;
    shape.degree = *rc::gen::inRange(3, 6);
    for (int i = 1; i < shape.degree; ++i)
        shape.inner[static_cast<std::size_t>(i - 1)] =
            Vec3(3.0 * i / shape.degree + any(0.8), any(1.5), any(1.5));
    const auto steady = path::steady_span(Vec3::Zero(), end, shape);
    if (!steady) return;
    const path::QuinticSpan span = path::make_quintic(Vec3::Zero(), end, shape);
    const auto position = [&](double u) -> Vec3 { return path::point_at(span, u).position; };
    const PlainMotion plain = plain_motion_of(*steady);
    RC_ASSERT((end_of(plain) - end).norm() == 0);
    const double tolerance = *rc::gen::element(1e-6, 1e-3, 0.1);
    const double u = *rc::gen::inRange(0, 1001) * 0.001;
    const double from = std::max(0.0, u - *rc::gen::inRange(0, 300) * 0.001);
    const double aside = tolerance * *rc::gen::inRange(0, 3000) * 0.001;
    const Vec3 tip = position(u) + aside * Vec3(any(1), any(1), 1).normalized();
    const PlainLook look = look_at(plain, tip, tolerance, from);
    double least = (position(u) - tip).norm();
    for (int i = 0; i <= 20000; ++i) least = std::min(least, (position(i / 20000.0) - tip).norm());
    if (look.side == PlainLook::LookResult::On) {
        RC_ASSERT((position(look.parameter) - tip).norm() <= tolerance * (1 + 1e-9) + 1e-12);
        RC_ASSERT(look.parameter >= from - 2 * tolerance / plain.length && look.parameter <= 1);
    }
    if (look.side == PlainLook::LookResult::Beside) RC_ASSERT(least > tolerance * (1 - 1e-9));
    if (aside == 0) RC_ASSERT(look.side == PlainLook::LookResult::On);
    RC_ASSERT(travel_bound(plain, u) >= position(u).norm() - 1e-12);
    RC_ASSERT((path::position(curve_of(plain), path::length(curve_of(plain)) / 2) -
               path::position(path::Curve(span), span.length / 2))
                  .norm() < 1e-9);
}

// One tick is as long as three lines: the corners between two setpoints are held against the way
// between both, of which they may be beside by half.
TEST(PathCheck, FindsAnEndThatIsPassedBy) {
    machine::Machine machine = machine_of();
    machine.tick = 0.001;
    const std::vector<Command> program =
        numbered({line_to({10, 0, 0}, 1000), line_to({10, 5, 0}, 1000), line_to({10, 0, 0}, 1000),
                  line_to({20, 0, 0}, 1000)});
    std::vector<Setpoint> setpoints;
    for (int i = 0; i <= 2000; ++i) {
        Setpoint& setpoint = setpoints.emplace_back();
        setpoint.time = 0.001 * i;
        setpoint.feed = 10;
        setpoint.tip = {0.01 * i, 0, 0};
        setpoint.axis = {0.01 * i, 0, 0};
    }
    const auto found = deviation_of(machine, program, setpoints);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->motion.line, 2u);
}

// A compressor that leaves the lines by more than its tolerance.
TEST(PathCheck, HoldsCurvesToTheToleranceOfTheCompressor) {
    const machine::Machine machine = machine_of();
    std::vector<Command> program;
    for (int i = 1; i <= 100; ++i) program.push_back(line_to({0.2 * i, 0, 0}, 3000));
    for (Command& line : program) line.motion().compress = 0.02;
    program = numbered(program);
    for (const auto& [height, is_found] : {std::pair(0.0199, false), std::pair(0.0201, true)}) {
        std::vector<Setpoint> setpoints = sample(machine, program);
        for (Setpoint& setpoint : setpoints) {
            const double bow = height * std::sin(std::numbers::pi * setpoint.tip[0] / 20);
            setpoint.tip[1] = setpoint.axis[1] = bow;
        }
        const auto found = deviation_of(machine, program, setpoints);
        EXPECT_EQ(found.has_value(), is_found);
        if (found) {
            EXPECT_NEAR(found->allowed, 0.02, 1e-5);
        }
    }
}

TEST(PathCheck, HoldsRotaryAxesToTheirPlaces) {
    machine::Machine machine = machine_of();
    machine::MachineAxis axis;
    axis.name = "C";
    axis.axis = Axis::C;
    axis.is_rotary = true;
    axis.lower = -kUnlimited;
    axis.upper = kUnlimited;
    axis.velocity = 2;
    axis.acceleration = 20;
    axis.jerk = kUnlimited;
    machine.axes.push_back(axis);
    std::vector<Command> program = {line_to({10, 0, 0}, 1000), line_to({20, 0, 0}, 1000),
                                    line_to({20, 0, 0}, 3000), line_to({20, 5, 0}, 1000)};
    const double angles[] = {0, 90, 180, 180};
    for (std::size_t i = 0; i < program.size(); ++i) {
        program[i].motion().to[index(Axis::C)] = angles[i];
        program[i].motion().moved |= bit(Axis::C);
    }
    program = numbered(program);
    const std::vector<Setpoint> right = sample(machine, program);
    EXPECT_FALSE(deviation_of(machine, program, right).has_value());
    for (const std::uint32_t line : {2u, 4u}) {
        std::vector<Setpoint> wrong = right;
        const auto [from, to] = range_of(wrong, line);
        wrong[(from + to) / 2].axis[3] += 1e-4;
        const auto found = deviation_of(machine, program, wrong);
        ASSERT_TRUE(found.has_value());
        EXPECT_EQ(static_cast<int>(found->fault), static_cast<int>(DeviationKind::Followers));
        EXPECT_EQ(found->motion.line, line);
    }
}

}  // namespace
}  // namespace kadr::motion::path_check_test
