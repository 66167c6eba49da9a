// Motion on a face, on a cylinder and across an inclined slide: at every tick the real axes hold
// the tip on its path, and each keeps its limits, near the centre and through it too.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/units.h"
#include "tests/motion/any_program.h"
#include "tests/motion/tick_limits.h"

namespace kadr::motion::test::virtual_test {
namespace {

using path::OrientKind;
using path::VirtualAxes;
using path::VirtualKind;

constexpr double kMicrometre = 1e-3;

/// X, Z and C; no Y.
machine::Machine turning_centre(double jerk_time = 0) {
    Dynamics dynamics;
    if (jerk_time > 0) dynamics.jerk = dynamics.acceleration / jerk_time;
    machine::Machine machine = machine_of(dynamics);
    std::erase_if(machine.axes, [](const auto& axis) { return axis.axis == Axis::Y; });
    machine::MachineAxis axis;
    axis.name = "C";
    axis.axis = Axis::C;
    axis.is_rotary = true;
    axis.lower = -kUnlimited;
    axis.upper = kUnlimited;
    axis.velocity = 10;      // rad/s, 95 rev/min
    axis.acceleration = 35;  // rad/s²
    axis.jerk = jerk_time > 0 ? axis.acceleration / jerk_time : kUnlimited;
    machine.axes.push_back(axis);
    return machine;
}

VirtualAxes face() {
    VirtualAxes axes;
    axes.kind = VirtualKind::Polar;
    return axes;
}
VirtualAxes cylinder(double radius) {
    VirtualAxes axes;
    axes.kind = VirtualKind::Cylinder;
    axes.size = radius;
    return axes;
}
VirtualAxes inclined(double angle_deg) {
    VirtualAxes axes;
    axes.kind = VirtualKind::Inclined;
    axes.size = rad_from_deg(angle_deg);
    return axes;
}

std::vector<Command> within_axes(const VirtualAxes& axes, std::vector<Command> commands) {
    for (Command& command : commands) {
        command.motion().orient_kind = OrientKind::Axes;
        command.motion().virtual_system = axes;
        // Where C ends is worked out on the way.
        command.motion().moved = static_cast<AxisMask>(command.motion().moved & ~bit(Axis::C));
    }
    return commands;
}

struct RealAxes {
    double x = 0, z = 0, c = 0;
};
RealAxes axes_of(const Setpoint& setpoint) {
    return {setpoint.axis[0], setpoint.axis[1], setpoint.axis[2]};
}

/// Where the tip is on the part, by the machine's axes alone.
Vec3 tip_of(const VirtualAxes& axes, const RealAxes& at) {
    switch (axes.kind) {
        case VirtualKind::None: break;
        case VirtualKind::Polar: return {at.x * std::cos(at.c), at.x * std::sin(at.c), at.z};
        case VirtualKind::Cylinder: return {at.x, axes.size * at.c, at.z};
        case VirtualKind::Inclined:
            return {at.x * std::cos(axes.size), 0, at.z + at.x * std::sin(axes.size)};
    }
    return {at.x, 0, at.z};
}

/// How far a point is from the way of a command.
double distance_from(const Command& command, const Vec3& from, const Vec3& point) {
    const Vec3 to(command.motion().to[0], command.motion().to[1], command.motion().to[2]);
    if (command.op() == Op::Arc) {
        const Vec3 out = point - command.motion().arc().center,
                   first = from - command.motion().arc().center;
        return std::abs(std::hypot(out.x(), out.y()) - std::hypot(first.x(), first.y()));
    }
    const Vec3 delta = to - from;
    if (delta.norm() == 0) return (point - from).norm();
    const double along = std::clamp((point - from).dot(delta) / delta.squaredNorm(), 0.0, 1.0);
    return (point - from - along * delta).norm();
}

struct Watched {
    double beside = 0;  // greatest distance from the path, mm
    TickShares shares;
    bool alarmed = false;
    std::vector<Setpoint> setpoints;
    std::vector<Segment> segments;
};

/// The first command is where the tip begins.
Watched watch(const machine::Machine& machine, const VirtualAxes& axes,
              const std::vector<Command>& program) {
    const std::vector<Command> commands = within_axes(axes, program);
    const Motion motion = run(machine, commands);
    Watched watched;
    watched.alarmed = motion.alarmed;
    watched.segments = motion.segments;
    TickWatch ticks(machine, motion.segments);
    watched.setpoints = sample(machine, commands);
    for (const Setpoint& setpoint : watched.setpoints) {
        ticks.add(setpoint);
        const std::size_t k = setpoint.line - 1;
        if (k < 1) continue;
        const Command& before = commands[k - 1];
        const Vec3 from(before.motion().to[0], before.motion().to[1], before.motion().to[2]);
        const Vec3 tip = tip_of(axes, axes_of(setpoint));
        watched.beside = std::max(
            {watched.beside, distance_from(commands[k], from, tip), (tip - setpoint.tip).norm()});
    }
    watched.shares = ticks.shares();
    return watched;
}

void expect_kept(const Watched& watched) {
    EXPECT_FALSE(watched.alarmed);
    EXPECT_LT(watched.beside, kMicrometre);
    EXPECT_LT(watched.shares.velocity, 1.001);
    EXPECT_LT(watched.shares.acceleration, 1.001);
    EXPECT_LT(watched.shares.jerk, 1.001);
}

TEST(VirtualAxes, SquareOnAFaceIsMadeByXAndC) {
    const std::vector<Command> square = {rapid_to({20, 0, 0}),        line_to({20, 20, 0}, 3000),
                                         line_to({-20, 20, 0}, 3000), line_to({-20, -20, 0}, 3000),
                                         line_to({20, -20, 0}, 3000), line_to({20, 0, 0}, 3000)};
    for (const double jerk_time : {0.0, 0.02}) {
        const Watched watched = watch(turning_centre(jerk_time), face(), square);
        expect_kept(watched);
        // Once around: C counts on, and X goes between the side and the corner.
        const RealAxes end = axes_of(watched.setpoints.back());
        EXPECT_NEAR(end.c, 2 * std::numbers::pi, 1e-9);
        EXPECT_NEAR(end.x, 20, 1e-9);
        double least = 100, most = 0;
        for (const Setpoint& setpoint : watched.setpoints) {
            if (setpoint.line < 2) continue;
            least = std::min(least, axes_of(setpoint).x);
            most = std::max(most, axes_of(setpoint).x);
        }
        EXPECT_NEAR(least, 20, 1e-6);
        EXPECT_NEAR(most, 20 * std::sqrt(2.0), 1e-3);
    }
}

TEST(VirtualAxes, PathsBesideAndThroughTheCentreKeepLimits) {
    for (const double jerk_time : {0.0, 0.02}) {
        double before = 0;
        for (const double aside : {5.0, 0.5, 0.05, 0.005, 0.0}) {
            const Watched watched = watch(turning_centre(jerk_time), face(),
                                          {rapid_to({30, aside, 0}), line_to({-30, aside, 0}, 6000),
                                           line_to({-30, 10, -2}, 6000)});
            SCOPED_TRACE(aside);
            expect_kept(watched);
            // The nearer, the slower; through the centre itself C turns while the tool stands.
            const double time = watched.segments.back().end_time();
            if (aside > 0) {
                EXPECT_GT(time, before);
            }
            before = time;
        }
    }
}

TEST(VirtualAxes, InTheCentreTheToolStandsWhileCTurns) {
    const Watched watched = watch(turning_centre(), face(),
                                  {rapid_to({10, 0, 0}), line_to({0, 0, 0}, 3000),
                                   line_to({0, 0, -5}, 3000), line_to({0, 10, -5}, 3000)});
    expect_kept(watched);
    EXPECT_NEAR(axes_of(watched.setpoints.back()).c, std::numbers::pi / 2, 1e-9);
    for (const Setpoint& setpoint : watched.setpoints) {
        const RealAxes at = axes_of(setpoint);
        if (setpoint.line > 1 && at.c > 1e-9 && at.c < std::numbers::pi / 2 - 1e-9) {
            EXPECT_LT(at.x, 1e-9);
        }
    }
}

TEST(VirtualAxes, ArcThroughTheCentreIsTwoLegs) {
    // Radius 10 about (10, 0): from (20, 0) through the centre of the face and on.
    const Watched watched = watch(
        turning_centre(), face(),
        {rapid_to({20, 0, 0}), arc_to({10, -10, 0}, {10, 0, 0}, 1.5 * std::numbers::pi, 3000)});
    expect_kept(watched);
}

TEST(VirtualAxes, CylinderTurnsByItsLength) {
    // 1 rad of 25 mm is 25 mm around; 20 mm aside.
    const Watched watched = watch(turning_centre(0.02), cylinder(25),
                                  {rapid_to({25, 0, 0}), line_to({25, 25, 20}, 3000)});
    expect_kept(watched);
    const RealAxes end = axes_of(watched.setpoints.back());
    EXPECT_NEAR(end.c, 1, 1e-12);
    EXPECT_NEAR(end.z, 20, 1e-12);
    EXPECT_NEAR(end.x, 25, 1e-12);
}

TEST(VirtualAxes, InclinedSlideGoesFartherThanX) {
    const Watched watched = watch(turning_centre(0.02), inclined(30),
                                  {rapid_to({10, 0, 0}), line_to({20, 0, 0}, 3000)});
    expect_kept(watched);
    const RealAxes end = axes_of(watched.setpoints.back());
    EXPECT_NEAR(end.x, 20 / std::cos(std::numbers::pi / 6), 1e-12);
    EXPECT_NEAR(end.z, -20 * std::tan(std::numbers::pi / 6), 1e-12);
}

/// Lines and arcs of all lengths about the centre.
std::vector<Command> any_contour() {
    Vec3 at(any_number(5, 40), any_number(-20, 20), 0);
    std::vector<Command> program{rapid_to(at)};
    const int count = *rc::gen::inRange(1, 15);
    for (int i = 0; i < count; ++i) {
        const int reach = *rc::gen::element(1, 5, 40);
        Command command =
            *rc::gen::inRange(0, 3) > 0
                ? line_to(*rc::gen::inRange(0, 8) == 0
                              ? Vec3(-at)
                              : Vec3(at + any_point(reach) * *rc::gen::element(1.0, 0.01)),
                          any_number(200, 20000))
                : any_arc(at);
        command.motion().exact_stop = *rc::gen::inRange(0, 5) == 0;
        at = Vec3(command.motion().to[0], command.motion().to[1], command.motion().to[2]);
        program.push_back(command);
    }
    return program;
}

RC_GTEST_PROP(VirtualAxes, KeepTheTipOnItsPathAndTheAxesWithinLimits, ()) {
    const machine::Machine machine = turning_centre(*rc::gen::element(0.0, 0.02));
    const VirtualAxes axes = *rc::gen::inRange(0, 3) > 0 ? face() : cylinder(any_number(5, 60));
    const Watched watched = watch(machine, axes, any_contour());
    RC_ASSERT(!watched.alarmed);
    RC_ASSERT(watched.beside < kMicrometre);
    RC_ASSERT(watched.shares.velocity < 1.001);
    RC_ASSERT(watched.shares.acceleration < 1.001);
    RC_ASSERT(watched.shares.jerk < 1.001);
}

}  // namespace
}  // namespace kadr::motion::test::virtual_test
