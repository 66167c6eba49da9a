// How a corner and the ramps beside it share what the axes have: the ramps keep all that the corner
// does not need at the speed at which it is passed, and what it needs only within a tick of it.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "motion/corner.h"
#include "tests/motion/any_program.h"
#include "tests/motion/support.h"
#include "tests/motion/tick_limits.h"

namespace kadr::motion::corner_share_test {
namespace {

using namespace test;

/// The axes of `mill`: half a g, 100 m/s³.
machine::Machine smooth_machine() {
    return machine_of({.velocity = {500, 500, 400}, .jerk = {1e5, 1e5, 8e4}});
}

double time_of(const machine::Machine& machine, const std::vector<Command>& program) {
    return run(machine, program).totals.time;
}

RC_GTEST_PROP(CornerShare, RampsKeepAllThatTheJumpLeaves, ()) {
    const double before = any_number(0, 1);
    const double behind = any_number(0, 1);
    const double most = *rc::gen::element(1.0, 1.5, 4.0);
    const double jump = any_number(0, 1) * most;
    const double ramp = ramp_share(before, behind, jump, most);
    RC_ASSERT(ramp >= 0 && ramp <= 1);
    RC_ASSERT(corner_acceleration(ramp * before, ramp * behind, jump) <= most + 1e-9);
    if (ramp == 1 || jump > most - 1e-6) return;
    RC_ASSERT(corner_acceleration((ramp + 1e-6) * before, (ramp + 1e-6) * behind, jump) >=
              most - 1e-9);
}

/// cases/motion/corner.mpf: a corner of 0.0002° in the middle of 60 mm takes what the line does,
/// which is 2·0.03/(1/3) + … as for a line: with half of the acceleration it took 0.046 s more.
TEST(CornerShare, AVertexTenthsOfAMicrometreOffALineCostsNothing) {
    for (const machine::Machine& machine : {machine_of(), smooth_machine()}) {
        const auto through = [&](double y) {
            return std::vector<Command>{line_to({30, y, 0}, 20000), line_to({60, 0, 0}, 20000)};
        };
        const double line = time_of(machine, through(0));
        EXPECT_NEAR(time_of(machine, through(1e-4)), line, 1e-3 * line);
        EXPECT_NEAR(time_of(machine, through(1e-3)), line, 5e-3 * line);
    }
}

/// Wherever the vertices lie, near to each other or not.
RC_GTEST_PROP(CornerShare, VerticesTenthsOfAMicrometreOffALineCostNothing, ()) {
    const machine::Machine machine = *rc::gen::arbitrary<bool>() ? machine_of() : smooth_machine();
    const double feed = any_number(500, 20000);
    std::vector<Command> line;
    std::vector<Command> vertices;
    double x = 0;
    const int count = *rc::gen::inRange(2, 12);
    for (int i = 0; i < count; ++i) {
        // Below 0.2 mm a tenth of a micrometre is a corner of a thousandth and more.
        x += any_number(1, 30) * *rc::gen::element(1.0, 0.2);
        line.push_back(line_to({x, 0, 0}, feed));
        vertices.push_back(line_to({x, any_number(-1, 1) * 1e-4, 0}, feed));
    }
    const double straight = time_of(machine, line);
    // A way of 18 ms with a vertex at 1.0 mm and one every 0.2 mm takes 0.75 % more.
    RC_ASSERT(time_of(machine, vertices) <= straight * 1.01);
}

/// A corner that is a little sharper takes a little longer: nowhere does the way to share jump.
TEST(CornerShare, TheTimeGrowsSteadilyWithTheAngle) {
    for (const machine::Machine& machine : {machine_of(), smooth_machine()}) {
        double last = 0;
        for (double angle = 1e-7; angle < 3; angle *= 1.05) {
            const Vec3 corner{20, 0, 0};
            const Vec3 end = corner + 20 * Vec3(std::cos(angle), std::sin(angle), 0);
            const double time = time_of(machine, {line_to(corner, 12000), line_to(end, 12000)});
            if (last > 0) {
                EXPECT_LT(time, last * 1.02) << angle;
            }
            last = time;
        }
    }
}

/// Without a limit of the jerk a corner is passed with nearly all that an axis has in a tick, and
/// the ramps have all that they have beyond a tick of it: what the rule of reference motion §2.4
/// alone allows, which leaves both to the corner, is hardly faster.
TEST(CornerShare, RampsHaveLessWithinATickOfTheCornerOnly) {
    const machine::Machine machine = machine_of();
    std::vector<Command> steps;
    for (int i = 0; i < 20; ++i)
        steps.push_back(line_to({10.0 * (i / 2 + 1), 10.0 * ((i + 1) / 2), 0}, 12000));
    PlannerOptions jump_and_ramp;
    for (int i = 0; i < 3; ++i)
        jump_and_ramp.velocity_jump[static_cast<std::size_t>(i)] =
            machine.axes[static_cast<std::size_t>(i)].acceleration * machine.tick;
    const double least = run(machine, steps, jump_and_ramp).totals.time;
    EXPECT_LT(time_of(machine, steps), 1.03 * least);
}

/// The dissertation's Fig. 14: short blocks, 10 to 200 µm, that turn at every end. An acceleration
/// of 0.3 m/s² and a tick of 1 ms let an axis jump by 0.3 mm/s.
TEST(CornerShare, AChainOfTheShortestBlocks) {
    machine::Machine machine =
        machine_of({.velocity = {100, 100, 100}, .acceleration = {300, 300, 300}});
    std::vector<Command> chain;
    Vec3 at = Vec3::Zero();
    for (int i = 1; i <= 800; ++i) {
        const double size = 0.105 + 0.095 * std::sin(i * 47 * std::numbers::pi / 180);
        const double angle = (40 * std::sin(i * 7 * std::numbers::pi / 180) +
                              8 * std::sin(i * 101 * std::numbers::pi / 180)) *
                             std::numbers::pi / 180;
        at += size * Vec3(std::cos(angle), std::sin(angle), 0);
        chain.push_back(line_to(at, 1500));
    }
    PlannerOptions jump_and_ramp;
    for (double& jump : jump_and_ramp.velocity_jump) jump = 0.3;
    const double least = run(machine, chain, jump_and_ramp).totals.time;
    EXPECT_LT(time_of(machine, chain), 1.1 * least);
    TickWatch watch(machine, run(machine, chain).segments);
    for (const Setpoint& setpoint : sample(machine, chain)) watch.add(setpoint);
    EXPECT_LE(watch.shares().acceleration, 1 + 1e-3);
}

/// Steps with a corner of 90° between each two, on a machine whose axes have these jumps.
double time_of_steps(std::optional<double> corner_jump) {
    machine::Machine machine = machine_of();
    for (machine::MachineAxis& axis : machine.axes) axis.corner_jump = corner_jump;
    std::vector<Command> steps;
    for (int i = 0; i < 20; ++i)
        steps.push_back(line_to({2.0 * (i / 2 + 1), 2.0 * ((i + 1) / 2), 0}, 12000));
    return time_of(machine, steps);
}

/// What nothing is said of is acceleration · tick, 5 mm/s here.
TEST(CornerJump, IsTheAccelerationOfATickUnlessTheMachineSaysOtherwise) {
    EXPECT_DOUBLE_EQ(time_of_steps(5.0), time_of_steps(std::nullopt));
    EXPECT_LT(time_of_steps(20.0), time_of_steps(5.0));
    EXPECT_GT(time_of_steps(1.0), time_of_steps(5.0));
}

/// An axis changes its velocity from tick to tick by no more than that, ramps included.
TEST(CornerJump, HoldsWithTheRampsBesideIt) {
    for (const double given : {2.0, 5.0, 8.0, 20.0}) {
        machine::Machine machine = machine_of();
        for (machine::MachineAxis& axis : machine.axes) axis.corner_jump = given;
        const std::vector<Command> corner = {line_to({20, 0, 0}, 12000),
                                             line_to({40, 15, 0}, 12000)};
        TickWatch watch(machine, run(machine, corner).segments);
        for (const Setpoint& setpoint : sample(machine, corner)) watch.add(setpoint);
        EXPECT_LE(watch.shares().acceleration, std::max(1.0, given / 5) + 1e-3) << given;
    }
}

/// `ACC[X]=50` takes half of it, too.
TEST(CornerJump, IsAPartOfItWhereTheProgramLeavesAPartOfTheAcceleration) {
    machine::Machine machine = machine_of();
    path::Dynamics half;
    half.acceleration.fill(0.5);
    const auto entry_speed = [&](std::optional<double> jump, bool is_half) {
        for (machine::MachineAxis& axis : machine.axes) axis.corner_jump = jump;
        std::vector<Command> corner = {line_to({20, 0, 0}, 12000), line_to({20, 20, 0}, 12000)};
        if (is_half)
            for (Command& command : corner) command.motion().dynamics = half;
        double least = kUnlimited;
        const std::vector<Segment> segments = run(machine, corner).segments;
        for (std::size_t k = 1; k < segments.size(); ++k)
            least = std::min(least, segments[k].profile.entry_speed);
        return least;
    };
    EXPECT_NEAR(entry_speed(20, true), entry_speed(20, false) / 2, 0.1 * entry_speed(20, false));
}

/// Where the curvature jumps: the line and the arc of 5 mm are passed with v²/r = ⅔ · jump.
TEST(CurvatureJump, IsTheJerkOfATickUnlessTheMachineSaysOtherwise) {
    const std::vector<Command> way = {line_to({40, 0, 0}, 20000),
                                      arc_to({40, 10, 0}, {40, 5, 0}, std::numbers::pi, 20000),
                                      line_to({0, 10, 0}, 20000)};
    const auto slowest = [&](std::optional<double> jump) {
        machine::Machine machine = smooth_machine();
        for (machine::MachineAxis& axis : machine.axes) axis.curvature_jump = jump;
        const std::vector<Segment> segments = run(machine, way).segments;
        double speed = kUnlimited;
        for (const Segment& segment : segments) {
            if (segment.line == 2 && segment.profile.entry_speed > 0)
                speed = std::min(speed, segment.profile.entry_speed);
        }
        return speed;
    };
    EXPECT_DOUBLE_EQ(slowest(100), slowest(std::nullopt));
    for (const double jump : {30.0, 100.0, 300.0})
        EXPECT_NEAR(slowest(jump), std::sqrt(5 * jump * 2 / 3), 0.02 * slowest(jump)) << jump;
}

}  // namespace
}  // namespace kadr::motion::corner_share_test
