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

namespace kadr::motion {
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
    RC_ASSERT(time_of(machine, vertices) <= straight * 1.005);
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

}  // namespace
}  // namespace kadr::motion
