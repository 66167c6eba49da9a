// Motion under the transformation of a machine with rotary axes: the tip stays on its path at every
// tick, the tool turns as it was asked to, and every axis keeps its limits, through poles too.
#include "motion/transformed.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/units.h"
#include "machine/path_choice.h"
#include "path/curve_of.h"
#include "tests/motion/any_program.h"
#include "tests/motion/tick_limits.h"

namespace kadr::motion::test::transformed_test {
namespace {

using machine::Chain;
using machine::ChainSide;
using path::OrientKind;

constexpr double kMicrometre = 1e-3;

struct Joint {
    Axis axis;
    ChainSide side;
    Vec3 direction;
    Vec3 point;
};

machine::Machine five_axes(const Joint& first, const Joint& second, double jerk_time = 0) {
    Dynamics dynamics;
    if (jerk_time > 0) dynamics.jerk = dynamics.acceleration / jerk_time;
    machine::Machine machine = machine_of(dynamics);
    Chain chain;
    std::size_t k = 0;
    for (const Joint& joint : {first, second}) {
        chain.joints[k] = {true, joint.axis, joint.side, joint.direction, joint.point, 1};
        ++k;
        machine::MachineAxis axis;
        axis.name = std::string(kAxisNames[index(joint.axis)]);
        axis.axis = joint.axis;
        axis.is_rotary = true;
        axis.lower = -kUnlimited;
        axis.upper = kUnlimited;
        axis.velocity = 2;       // 19 rev/min
        axis.acceleration = 20;  // rad/s²
        axis.jerk = jerk_time > 0 ? axis.acceleration / jerk_time : kUnlimited;
        machine.axes.push_back(axis);
    }
    machine.kinematics.emplace();
    machine.kinematics->chain = machine::prepare(chain).value();
    return machine;
}

machine::Machine table_table(double jerk_time = 0) {
    return five_axes({Axis::C, ChainSide::Table, Vec3::UnitZ(), {12, -7, 3}},
                     {Axis::A, ChainSide::Table, Vec3::UnitX(), {3, 5, -60}}, jerk_time);
}
machine::Machine head_head() {
    return five_axes({Axis::C, ChainSide::Head, Vec3::UnitZ(), {0, 0, 200}},
                     {Axis::B, ChainSide::Head, Vec3::UnitY(), {0, 30, 150}});
}
machine::Machine mixed() {
    return five_axes({Axis::C, ChainSide::Table, Vec3::UnitZ(), {10, 20, 0}},
                     {Axis::B, ChainSide::Head, Vec3::UnitY(), {0, 0, 180}});
}
machine::Machine nutating() {
    const double s = std::sqrt(0.5);
    return five_axes({Axis::C, ChainSide::Head, Vec3::UnitZ(), {0, 0, 250}},
                     {Axis::B, ChainSide::Head, {0, s, s}, {0, 0, 120}});
}

std::vector<machine::Machine> every_class() {
    return {table_table(), table_table(0.02), head_head(), mixed(), nutating()};
}

Vec3 direction(double azimuth_deg, double tilt_deg) {
    const double a = rad_from_deg(azimuth_deg), t = rad_from_deg(tilt_deg);
    return {std::cos(a) * std::sin(t), std::sin(a) * std::sin(t), std::cos(t)};
}

/// Commands of a program that knows where tip and tool are, as the interpreter does.
class Program {
  public:
    explicit Program(const machine::Machine& machine)
        : machine_(machine), chain_(machine.kinematics->chain) {}

    /// To a tip and a direction on the great circle, or with the rotary axes in proportion.
    Program& go(const Vec3& tip, const Vec3& tool, double feed,
                OrientKind orient_kind = OrientKind::Cone) {
        machine::PathQuery query = machine::query_for(chain_, tool);
        query.start = joints_;
        query.mode =
            orient_kind == OrientKind::Cone ? machine::PathMode::Vector : machine::PathMode::Axis;
        query.pole_tolerance = std::max(machine_.kinematics->pole_tolerance, 1e-7);
        const auto chosen = machine::choose_path(chain_, query);
        RC_PRE(chosen.has_value());
        RC_PRE(chosen->mode == query.mode);
        Command command = line_to(tip, feed);
        command.motion().orient_kind = orient_kind;
        command.motion().direction = tool;
        const Vec3 from = machine::tool_vector(chain_, joints_);
        const Vec3 across = from.cross(tool);
        if (orient_kind == OrientKind::Cone && across.norm() > 0) {
            command.motion().orient_details.made().axis = across.normalized();
            command.motion().orient_details.made().angle =
                std::atan2(across.norm(), from.dot(tool));
        }
        joints_ = chosen->rotary;
        put_joints(command);
        commands.push_back(command);
        return *this;
    }
    Program& go_fast(const Vec3& tip, const Vec3& tool) {
        go(tip, tool, 0, OrientKind::Axes);
        commands.back().become(Op::Rapid);
        return *this;
    }
    /// To a tip along a line, or along an arc, with the tool led by a course from where it stands;
    /// `lay` says it: it is given where the tool stands and the curve, and fills the command in.
    template <typename Lay>
    Program& lead(const Command& along, const path::Curve& curve, Lay lay) {
        Command command = along;
        const Vec3 from = machine::tool_vector(chain_, joints_);
        lay(command, from);
        const double length = path::length(curve) > 0 ? path::length(curve) : 1;
        path::OrientLaw orientation{command.motion().orient_kind,
                                    length,
                                    command.motion().orientation().from,
                                    command.motion().orientation().axis,
                                    command.motion().orientation().angle / length,
                                    command.motion().orientation().lead_tilt};
        if (orientation.kind == OrientKind::Cone) orientation.start = from;
        if (orientation.kind == OrientKind::Point) orientation.axis /= length;
        RC_PRE((path::direction_at(orientation, curve, 0) - from).norm() < 1e-9);
        const auto end = machine::follow(chain_, {joints_, {}}, [&](double f) {
            return path::direction_at(orientation, curve, f * length);
        });
        RC_PRE(end.has_value());
        joints_ = end->rotary;
        command.motion().direction = machine::tool_vector(chain_, joints_);
        put_joints(command);
        commands.push_back(command);
        return *this;
    }
    Vec3 tool() const { return machine::tool_vector(chain_, joints_); }
    std::vector<Command> commands;

  private:
    void put_joints(Command& command) const {
        for (const std::size_t k : {machine::kR1, machine::kR2}) {
            const Axis axis = chain_.joints[k].axis;
            command.motion().to[index(axis)] = deg_from_rad(joints_[static_cast<Eigen::Index>(k)]);
            command.motion().moved |= bit(axis);
        }
    }

    machine::Machine machine_;
    const Chain& chain_ = machine_.kinematics->chain;
    Vec3 joints_ = Vec3::Zero();
};

Command with_tool_length(double length) {
    Command command = simple(Op::ToolLength);
    command.tool_length().length = length;
    return command;
}

/// Where tip and tool are for the axes of a setpoint: the kinematics, not what the setpoint says.
machine::Pose pose_of(const machine::Machine& machine, const Setpoint& setpoint, double length) {
    const Chain& chain = machine.kinematics->chain;
    machine::ChainPosition position;
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const Axis axis = machine.axes[i].axis;
        if (index(axis) < 3)
            position.linear[static_cast<Eigen::Index>(index(axis))] = setpoint.axis[i];
        for (std::size_t k = 0; k < machine::kJoints; ++k) {
            if (chain.has(k) && chain.joints[k].axis == axis)
                position.rotary[static_cast<Eigen::Index>(k)] = setpoint.axis[i];
        }
    }
    return machine::forward(chain, position, machine::tip_of_length(chain, length));
}

TEST(Transformed, TipThatStandsStandsAtEveryTick) {
    for (const machine::Machine& machine : every_class()) {
        Program program(machine);
        const Vec3 tip(40, 25, -10);
        program.go_fast(tip, direction(30, 20));
        program.go(tip, direction(80, 55), 3000);  // deg/min
        program.go(tip, direction(-60, 10), 3000);
        program.go(tip, direction(90, 40), 3000, OrientKind::Axes);
        std::vector<Command> commands = program.commands;
        commands.insert(commands.begin(), with_tool_length(80));
        const auto setpoints = sample(machine, commands);
        ASSERT_GT(setpoints.size(), 500u);
        std::size_t standing = 0;
        for (const Setpoint& setpoint : setpoints) {
            const machine::Pose pose = pose_of(machine, setpoint, 80);
            EXPECT_LT((pose.tip - setpoint.tip).norm(), 1e-9);
            EXPECT_LT((pose.rotation * Vec3::UnitZ() - setpoint.tool).norm(), 1e-9);
            if (setpoint.line < 3) continue;
            ++standing;
            EXPECT_LT((pose.tip - tip).norm(), 1e-9);
        }
        EXPECT_GT(standing, 400u);
    }
}

TEST(Transformed, GreatCirclesThroughThePoleKeepTipAndLimits) {
    const std::vector<machine::Machine> machines = every_class();
    for (const machine::Machine& machine : machines) {
        const auto go_through = [&](double azimuth_in, double azimuth_out) {
            Program program(machine);
            program.go_fast({0, 0, 5}, direction(azimuth_in, 30));
            program.go({20, 10, 0}, direction(azimuth_out, 25), 2000);
            return program.commands;
        };
        // Exactly through, and past it at about a hundredth, a tenth and one degree.
        for (const double aside : {0.0, 0.02, 0.2, 2.0}) {
            const std::vector<Command> commands = go_through(40, 220 + aside);
            const Motion motion = run(machine, commands);
            EXPECT_FALSE(motion.alarmed);
            TickWatch watch(machine, motion.segments);
            const Vec3 from = direction(40, 30), to = direction(220 + aside, 25);
            const Vec3 normal = from.cross(to).normalized();
            for (const Setpoint& setpoint : sample(machine, commands)) {
                watch.add(setpoint);
                const machine::Pose pose = pose_of(machine, setpoint, 0);
                EXPECT_LT((pose.tip - setpoint.tip).norm(), 1e-9);
                if (setpoint.line < 2) continue;
                ASSERT_LT(std::abs((pose.rotation * Vec3::UnitZ()).dot(normal)), 1e-6)
                    << aside << " " << setpoint.time << " of machine "
                    << (&machine - machines.data());
                const Vec3 delta(20, 10, -5);
                EXPECT_LT((setpoint.tip - Vec3(0, 0, 5)).cross(delta).norm() / delta.norm(), 1e-9);
            }
            EXPECT_LT(watch.shares().velocity, 1.001)
                << aside << " of machine " << (&machine - machines.data()) << " "
                << motion.segments.size();
            EXPECT_LT(watch.shares().acceleration, 1.001)
                << aside << " of machine " << (&machine - machines.data());
        }
    }
}

/// Commands behind a tool length, the second one from point to point.
std::vector<Command> to_a_point(const machine::Machine& machine, double feed,
                                OrientKind orient_kind) {
    Program program(machine);
    program.go_fast({10, -5, 20}, direction(30, 20));
    program.go({60, 35, -8}, direction(125, 50), feed, orient_kind);
    if (feed == 0) program.commands.back().become(Op::Rapid);
    std::vector<Command> commands = program.commands;
    commands.insert(commands.begin(), with_tool_length(80));
    return commands;
}

TEST(Transformed, FromPointToPointAllAxesGoStraightAndTogether) {
    constexpr double kFeed = 3000;
    for (const machine::Machine& machine : every_class()) {
        for (const double feed : {0.0, kFeed}) {
            const auto commands = to_a_point(machine, feed, OrientKind::Straight);
            const auto start = sample(machine, {commands.begin(), commands.end() - 1}).back();
            const auto end = sample(machine, to_a_point(machine, feed, OrientKind::Axes)).back();
            const Motion motion = run(machine, commands);
            EXPECT_FALSE(motion.alarmed);
            TickWatch watch(machine, motion.segments);
            const auto setpoints = sample(machine, commands);
            double beside = 0;
            double fastest = 0;
            const Setpoint* before = nullptr;
            for (const Setpoint& setpoint : setpoints) {
                watch.add(setpoint);
                const machine::Pose pose = pose_of(machine, setpoint, 80);
                EXPECT_LT((pose.tip - setpoint.tip).norm(), 1e-9);
                EXPECT_LT((pose.rotation * Vec3::UnitZ() - setpoint.tool).norm(), 1e-9);
                if (setpoint.line < 3) continue;
                const double share =
                    (setpoint.axis[0] - start.axis[0]) / (end.axis[0] - start.axis[0]);
                EXPECT_GE(share, -1e-9);
                EXPECT_LE(share, 1 + 1e-9);
                for (std::size_t a = 0; a < machine.axes.size(); ++a)
                    EXPECT_NEAR(setpoint.axis[a],
                                start.axis[a] + share * (end.axis[a] - start.axis[a]), 1e-9);
                const Vec3 delta = end.tip - start.tip;
                beside =
                    std::max(beside, (setpoint.tip - start.tip).cross(delta.normalized()).norm());
                if (before != nullptr)
                    fastest = std::max(fastest, std::hypot(setpoint.axis[0] - before->axis[0],
                                                           setpoint.axis[1] - before->axis[1],
                                                           setpoint.axis[2] - before->axis[2]));
                before = &setpoint;
            }
            const Setpoint& last = setpoints.back();
            for (std::size_t a = 0; a < machine.axes.size(); ++a)
                EXPECT_NEAR(last.axis[a], end.axis[a], 1e-9);
            EXPECT_LT((last.tip - Vec3(60, 35, -8)).norm(), 1e-9);
            EXPECT_LT((last.tool - direction(125, 50)).norm(), 1e-9);
            EXPECT_GT(beside, 1) << "the tip is on no line";
            EXPECT_LT(watch.shares().velocity, 1.001);
            EXPECT_LT(watch.shares().acceleration, 1.001);
            // F is the speed of X, Y and Z on their straight way; at rapid an axis has all it can.
            if (feed > 0) EXPECT_LT(fastest, feed / 60 * machine.tick * (1 + 1e-9));
            else EXPECT_GT(std::max(watch.shares().velocity, watch.shares().acceleration), 0.9);
        }
    }
}

// Corners between two lines of the axes are rounded as without a transformation; beside a path they
// are corners.
TEST(Transformed, FromPointToPointCornersAreThoseOfTheAxes) {
    const machine::Machine machine = table_table();
    Program program(machine);
    const Vec3 tool = direction(30, 20);
    program.go_fast({0, 0, 0}, tool);
    program.go({40, 0, 0}, tool, 3000, OrientKind::Straight);
    program.go({40, 40, 0}, tool, 3000, OrientKind::Straight);
    program.go({0, 40, 0}, tool, 3000, OrientKind::Axes);
    for (Command& command : program.commands)
        std::copy(program.commands[0].motion().to.begin() + 3,
                  program.commands[0].motion().to.end(), command.motion().to.begin() + 3);
    const auto plain = run(machine, program.commands);
    const auto commands = rounded(program.commands, by_distance(2));
    const Motion motion = run(machine, commands);
    EXPECT_FALSE(motion.alarmed);
    EXPECT_LT(motion.segments.back().end_time(), plain.segments.back().end_time());
    double between = kUnlimited;
    double beside = kUnlimited;
    for (const Setpoint& setpoint : sample(machine, commands)) {
        between = std::min(between, (setpoint.tip - Vec3(40, 0, 0)).norm());
        beside = std::min(beside, (setpoint.tip - Vec3(40, 40, 0)).norm());
    }
    EXPECT_GT(between, 0.3);
    EXPECT_LT(beside, 0.3);
}

/// Five-axis programs: lines of all lengths with all kinds of turning.
std::vector<Command> any_turning_program(const machine::Machine& machine) {
    Program program(machine);
    Vec3 tip(0, 0, 0);
    double azimuth = any_number(-180, 180), tilt = any_number(2, 60);
    program.go_fast(tip, direction(azimuth, tilt));
    const int count = *rc::gen::inRange(1, 12);
    for (int i = 0; i < count; ++i) {
        const double reach = *rc::gen::element(0.0, 0.2, 5.0, 60.0);
        tip += reach * any_point(1);
        const double turn = *rc::gen::element(0.0, 0.5, 10.0, 70.0);
        azimuth += turn * any_number(-1, 1);
        tilt = std::clamp(tilt + turn * any_number(-1, 1), 1.0, 70.0);
        program.go(tip, direction(azimuth, tilt), any_number(500, 20000),
                   *rc::gen::element(OrientKind::Cone, OrientKind::Axes));
    }
    return program.commands;
}

RC_GTEST_PROP(Transformed, KeepsTheTipOnItsPathAndTheAxesWithinLimits, ()) {
    const std::vector<machine::Machine> machines = every_class();
    const machine::Machine& machine = machines[*rc::gen::inRange<std::size_t>(0, machines.size())];
    const double length = any_number(0, 150);
    std::vector<Command> commands = any_turning_program(machine);
    commands.insert(commands.begin(), with_tool_length(length));
    const Motion motion = run(machine, commands);
    RC_ASSERT(!motion.alarmed);
    TickWatch watch(machine, motion.segments);
    for (const Setpoint& setpoint : sample(machine, commands)) {
        watch.add(setpoint);
        const machine::Pose pose = pose_of(machine, setpoint, length);
        RC_ASSERT((pose.tip - setpoint.tip).norm() < 1e-6 * kMicrometre);
        RC_ASSERT((pose.rotation * Vec3::UnitZ() - setpoint.tool).norm() < 1e-9);
        // On the line between the two tips of its command.
        const std::size_t k = setpoint.line - 1;
        if (k < 2) continue;
        const auto tip_of = [&](std::size_t i) {
            return Vec3(commands[i].motion().to[0], commands[i].motion().to[1],
                        commands[i].motion().to[2]);
        };
        const Vec3 delta = tip_of(k) - tip_of(k - 1);
        const Vec3 from = setpoint.tip - tip_of(k - 1);
        const double aside =
            delta.norm() > 0 ? from.cross(delta).norm() / delta.norm() : from.norm();
        RC_ASSERT(aside < 1e-6 * kMicrometre);
    }
    RC_ASSERT(watch.shares().velocity < 1.001);
    RC_ASSERT(watch.shares().acceleration < 1.001);
    RC_ASSERT(watch.shares().jerk < 1.001);
}

/// Where the tool comes near the pole, C is faster at the end than a polynomial through five places
/// says: it stops with the acceleration that it has, and not with 1.0015 of it.
TEST(Transformed, AxesKeepTheirAccelerationWhereTheyStopNearThePole) {
    const machine::Machine machine = table_table();
    for (const OrientKind orient_kind : {OrientKind::Cone, OrientKind::Axes}) {
        for (double tilt = 1; tilt < 3; tilt += 0.25) {
            Program program(machine);
            program.go_fast({0, 0, 0}, direction(-177.769, 3.26));
            program.go({-58.62, -59.4, -58.74}, direction(-187.419, tilt), 500, orient_kind);
            const Motion motion = run(machine, program.commands);
            TickWatch watch(machine, motion.segments);
            for (const Setpoint& setpoint : sample(machine, program.commands)) watch.add(setpoint);
            EXPECT_LT(watch.shares().acceleration, 1.001) << tilt;
        }
    }
}

/// Case 7 (motion.md): so near to the pole that R1 is free, R2 still has the angle of the tool. It
/// stood there and then jumped, which fine ticks show as a jerk.
TEST(Transformed, TheSecondAxisHasItsAngleBesideThePole) {
    const machine::Machine machine = table_table();
    const Chain& chain = machine.kinematics->chain;
    for (const double tilt : {1e-10, 5e-10, 9e-10, 2e-9}) {
        for (const double sign : {1.0, -1.0}) {
            const Vec3 near(0.3, sign * 1e-8, 0);
            const Vec3 joints =
                machine::joints_for(chain, {std::sin(tilt), 0, std::cos(tilt)}, near);
            EXPECT_NEAR(std::abs(joints[1]), tilt, 1e-12) << tilt;
        }
    }
}

/// What a setpoint shows against a course along a line: the tip on it, the tool as the mathematics
/// say, by formulas of their own.
struct Led {
    Command command;
    Vec3 tip_from;
    std::function<Vec3(double)> tool;  // by the fraction of the way
    bool keeps_jerk = true;            // not where the pole is passed
};

void expect_led(const machine::Machine& machine, const std::vector<Command>& commands,
                const Led& led) {
    const Motion motion = run(machine, commands);
    ASSERT_FALSE(motion.alarmed);
    TickWatch watch(machine, motion.segments);
    const Vec3 to(led.command.motion().to[0], led.command.motion().to[1],
                  led.command.motion().to[2]);
    const Vec3 delta = to - led.tip_from;
    std::size_t count = 0;
    for (const Setpoint& setpoint : sample(machine, commands)) {
        watch.add(setpoint);
        const machine::Pose pose = pose_of(machine, setpoint, 0);
        ASSERT_LT((pose.tip - setpoint.tip).norm(), 1e-9);
        if (setpoint.line < commands.size()) continue;
        ++count;
        const double f = (setpoint.tip - led.tip_from).dot(delta) / delta.squaredNorm();
        ASSERT_LT((setpoint.tip - led.tip_from - f * delta).norm(), 1e-9);
        ASSERT_LT((pose.rotation * Vec3::UnitZ() - led.tool(f)).norm(), 1e-6) << f;
    }
    EXPECT_GT(count, 300u);
    EXPECT_LT(watch.shares().velocity, 1.001);
    EXPECT_LT(watch.shares().acceleration, 1.001);
    if (led.keeps_jerk) {
        EXPECT_LT(watch.shares().jerk, 1.001);
    }
}

TEST(Transformed, ConesKeepTheirAngleAtEveryTickThroughPolesToo) {
    const std::vector<machine::Machine> machines = every_class();
    for (const machine::Machine& machine : machines) {
        SCOPED_TRACE(&machine - machines.data());
        // About an axis that leans by as much as the cone is open: it passes the pole. And beside.
        for (const double half : {20.0, 20.3, 12.0}) {
            SCOPED_TRACE(half);
            const Vec3 axis = direction(25, 20);
            const Vec3 start = Eigen::AngleAxisd(rad_from_deg(half), axis.unitOrthogonal()) * axis;
            const double turn = rad_from_deg(250);
            Program program(machine);
            program.go_fast({0, 0, 5}, start);
            program.lead(line_to({90, 20, 0}, 2500), path::make_line({0, 0, 5}, {90, 20, 0}),
                         [&](Command& command, const Vec3&) {
                             command.motion().orient_kind = OrientKind::Cone;
                             command.motion().orient_details.made().axis = axis;
                             command.motion().orient_details.made().angle = turn;
                         });
            const Vec3 from = program.commands[0].motion().direction;
            expect_led(machine, program.commands,
                       {program.commands[1],
                        {0, 0, 5},
                        [&](double f) -> Vec3 {
                            const double c = std::cos(f * turn), s = std::sin(f * turn);
                            return c * from + s * axis.cross(from) +
                                   (1 - c) * axis.dot(from) * axis;
                        },
                        half != 20.0});
        }
    }
}

TEST(Transformed, ToolsLeanOnTheirSurfaceAtEveryTick) {
    for (const machine::Machine& machine : every_class()) {
        const Vec3 from(0, 0, 0), to(80, 0, 0);
        const double lead = rad_from_deg(25), tilt = rad_from_deg(10), whole = rad_from_deg(40);
        const auto tool = [&](double f) -> Vec3 {
            // The normal turns about X by f times the whole angle; the tangent is X.
            const double a = f * whole;
            const Vec3 normal(0, -std::sin(a), std::cos(a));
            const Vec3 leant = std::cos(lead) * normal + std::sin(lead) * Vec3::UnitX();
            return Eigen::AngleAxisd(tilt, Vec3::UnitX()) * leant;
        };
        Program program(machine);
        program.go_fast(from, tool(0));
        program.lead(line_to(to, 2500), path::make_line(from, to),
                     [&](Command& command, const Vec3&) {
                         command.motion().orient_kind = OrientKind::Surface;
                         command.motion().orient_details.made().from = Vec3::UnitZ();
                         command.motion().orient_details.made().axis = Vec3::UnitX();
                         command.motion().orient_details.made().angle = whole;
                         command.motion().orient_details.made().lead_tilt = {
                             lead, tilt, path::TiltAbout::Tangent};
                     });
        expect_led(machine, program.commands, {program.commands[1], from, tool});
    }
}

TEST(Transformed, SecondPointsLeadTheToolAtEveryTick) {
    for (const machine::Machine& machine : every_class()) {
        const Vec3 from(0, 0, 0), to(60, -30, 5);
        const Vec3 point(10, 15, 100), point_to(90, 20, 80);
        const auto tool = [&](double f) -> Vec3 {
            const Vec3 tip = from + f * (to - from);
            return (point + f * (point_to - point) - tip).normalized();
        };
        Program program(machine);
        program.go_fast(from, tool(0));
        program.lead(line_to(to, 2500), path::make_line(from, to),
                     [&](Command& command, const Vec3&) {
                         command.motion().orient_kind = OrientKind::Point;
                         command.motion().orient_details.made().from = point;
                         command.motion().orient_details.made().axis = point_to - point;
                     });
        expect_led(machine, program.commands, {program.commands[1], from, tool});
    }
}

/// A span that bends both ways and rises, of a rational and of a plain spline; X grows all along.
Command bent_span(double weight) {
    Command command = line_to({40, 12, 5}, 2500);
    command.become(Op::Spline);
    command.motion().spline().degree = 3;
    command.motion().spline().inner[0] = {10, 25, 0};
    command.motion().spline().inner[1] = {25, -20, 3};
    command.motion().spline().weights = {1, weight, 1 / weight, 1};
    return command;
}

/// The distance along the curve at which X is this: by halving.
double distance_at(const path::Curve& curve, double x) {
    double low = 0, high = path::length(curve);
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (path::position(curve, middle).x() < x ? low : high) = middle;
    }
    return (low + high) / 2;
}

TEST(Transformed, ToolsTurnInProportionAlongSplines) {
    for (const machine::Machine& machine : every_class()) {
        for (const double weight : {1.0, 1.7}) {
            const Vec3 from = direction(30, 20), to = direction(140, 35);
            const Command span = bent_span(weight);
            const path::Curve curve = path::curve_of(span.motion(), {0, 0, 0}, {40, 12, 5});
            const double whole = std::atan2(from.cross(to).norm(), from.dot(to));
            const Vec3 axis = from.cross(to).normalized();
            Program program(machine);
            program.go_fast({0, 0, 0}, from);
            program.lead(span, curve, [&](Command& command, const Vec3&) {
                command.motion().orient_kind = OrientKind::Cone;
                command.motion().orient_details.made().axis = axis;
                command.motion().orient_details.made().angle = whole;
            });
            std::vector<Command> commands = program.commands;
            commands.insert(commands.begin(), with_tool_length(90));
            const Motion motion = run(machine, commands);
            ASSERT_FALSE(motion.alarmed);
            TickWatch watch(machine, motion.segments);
            std::size_t count = 0;
            for (const Setpoint& setpoint : sample(machine, commands)) {
                watch.add(setpoint);
                const machine::Pose pose = pose_of(machine, setpoint, 90);
                if (setpoint.line < commands.size()) continue;
                constexpr std::size_t kLookedAt =
                    5;  // one of so many: to find the place takes long
                if (++count % kLookedAt != 0) continue;
                const double distance = distance_at(curve, pose.tip.x());
                ASSERT_LT((path::position(curve, distance) - pose.tip).norm(), 1e-3 * kMicrometre);
                const double share = distance / path::length(curve);
                const Vec3 tool = Eigen::AngleAxisd(share * whole, axis) * from;
                ASSERT_LT((pose.rotation * Vec3::UnitZ() - tool).norm(), 1e-6) << share;
            }
            EXPECT_GT(count, 300u);
            EXPECT_LT(watch.shares().velocity, 1.001);
            EXPECT_LT(watch.shares().acceleration, 1.001);
            EXPECT_LT(watch.shares().jerk, 1.001);
        }
    }
}

TEST(Transformed, ToolsFollowTheTangentOfAnArc) {
    for (const machine::Machine& machine : every_class()) {
        const double lead = rad_from_deg(30), radius = 40;
        Program program(machine);
        program.go_fast({radius, 0, 0}, {0, std::sin(lead), std::cos(lead)});
        const Command arc = arc_to({-radius, 0, 0}, {0, 0, 0}, std::numbers::pi, 2500);
        program.lead(arc,
                     path::make_helix({radius, 0, 0}, {-radius, 0, 0}, {0, 0, 0}, Vec3::UnitZ(),
                                      std::numbers::pi),
                     [&](Command& command, const Vec3&) {
                         command.motion().orient_kind = OrientKind::Surface;
                         command.motion().orient_details.made().from = Vec3::UnitZ();
                         command.motion().orient_details.made().axis = Vec3::UnitX();
                         command.motion().orient_details.made().lead_tilt = {
                             lead, 0, path::TiltAbout::Tangent};
                     });
        const Motion motion = run(machine, program.commands);
        ASSERT_FALSE(motion.alarmed);
        TickWatch watch(machine, motion.segments);
        for (const Setpoint& setpoint : sample(machine, program.commands)) {
            watch.add(setpoint);
            if (setpoint.line < 2) continue;
            const machine::Pose pose = pose_of(machine, setpoint, 0);
            EXPECT_LT((pose.tip - setpoint.tip).norm(), 1e-9);
            EXPECT_NEAR(setpoint.tip.norm(), radius, 1e-9);
            const Vec3 travel = Vec3::UnitZ().cross(setpoint.tip) / radius;
            const Vec3 wanted = std::cos(lead) * Vec3::UnitZ() + std::sin(lead) * travel;
            ASSERT_LT((pose.rotation * Vec3::UnitZ() - wanted).norm(), 1e-6);
        }
        EXPECT_LT(watch.shares().velocity, 1.001);
        EXPECT_LT(watch.shares().acceleration, 1.001);
    }
}

// ---------------------------------------------------------------- rounded corners

/// Lines of five millimetres along X while the tool goes round a cone in great circles: the tip has
/// no corner, the rotary axes have one at every end of a block.
std::vector<Command> turning_in_chords(const machine::Machine& machine,
                                       const path::Blending& blending) {
    Program program(machine);
    program.go_fast({0, 0, 0}, direction(20, 40));
    for (int i = 1; i <= 40; ++i) {
        program.go({5.0 * i, 0, 0}, direction(20 + 4 * i, 40), 5000);
        program.commands.back().motion().blending = blending;
    }
    return program.commands;
}

path::Blending within(double tolerance, double orientation_deg) {
    return {path::BlendKind::Tolerance, false, tolerance, rad_from_deg(orientation_deg)};
}

/// The tip stays on its path.
path::Blending of_the_tool(double orientation_deg) {
    return {path::BlendKind::None, false, 0, rad_from_deg(orientation_deg), true};
}

/// The angle between a tool and the great circle between two others, both ends included, rad.
double beside_circle(const Vec3& tool, const Vec3& from, const Vec3& to) {
    double least = std::min(path::angle_between(tool, from), path::angle_between(tool, to));
    const Vec3 across = from.cross(to);
    if (across.norm() == 0) return least;
    const Vec3 nearest = (tool - tool.dot(across) / across.squaredNorm() * across).normalized();
    const bool is_between =
        from.cross(nearest).dot(across) > 0 && nearest.cross(to).dot(across) > 0;
    return is_between ? std::min(least, path::angle_between(tool, nearest)) : least;
}

void expect_even_turns(const path::Blending& blending) {
    const std::vector<machine::Machine> machines = every_class();
    for (const machine::Machine& machine : machines) {
        SCOPED_TRACE(&machine - machines.data());
        const std::vector<Command> sharp = turning_in_chords(machine, {});
        const double tolerance = rad_from_deg(0.1);
        const std::vector<Command> commands = turning_in_chords(machine, blending);
        const Motion before = run(machine, sharp);
        const Motion motion = run(machine, commands);
        ASSERT_FALSE(motion.alarmed);
        EXPECT_LT(motion.segments.back().end_time(), 0.9 * before.segments.back().end_time());
        TickWatch watch(machine, motion.segments);
        double most = 0;
        for (const Setpoint& setpoint : sample(machine, commands)) {
            watch.add(setpoint);
            const machine::Pose pose = pose_of(machine, setpoint, 0);
            ASSERT_LT((pose.tip - setpoint.tip).norm(), 1e-9);
            if (setpoint.line < 2) continue;
            ASSERT_LT(std::hypot(setpoint.tip.y(), setpoint.tip.z()), 1e-9);
            const Vec3 tool = pose.rotation * Vec3::UnitZ();
            double least = 1;
            for (std::size_t k = setpoint.line - 1; k <= setpoint.line + 1 && k <= 40; ++k) {
                least = std::min(least, beside_circle(tool, direction(20 + 4 * double(k - 1), 40),
                                                      direction(20 + 4 * double(k), 40)));
            }
            most = std::max(most, least);
        }
        EXPECT_LT(most, tolerance);
        EXPECT_GT(most, tolerance / 20);
        EXPECT_LT(watch.shares().velocity, 1.001);
        EXPECT_LT(watch.shares().acceleration, 1.001);
        EXPECT_LT(watch.shares().jerk, 1.001);
    }
}

TEST(OrientationCorner, TheToolTurnsEvenlyWithinItsTolerance) {
    expect_even_turns(within(0.05, 0.1));
}

TEST(OrientationCorner, TheToolAloneTurnsEvenlyWithinItsTolerance) {
    expect_even_turns(of_the_tool(0.1));
}

// Around a corner of the tip the tool goes on evenly by the path; the tip does not leave it, and
// passes the corner as without.
TEST(OrientationCorner, TheToolAloneIsLedAroundACornerOfTheTip) {
    for (const machine::Machine& machine : every_class()) {
        Program program(machine);
        program.go_fast({0, 0, 0}, direction(30, 30));
        program.go({40, 0, 0}, direction(40, 35), 3000);
        program.commands.back().motion().blending = of_the_tool(1);
        program.go({40, 40, 0}, direction(60, 30), 3000);
        const Motion motion = run(machine, program.commands);
        TickWatch watch(machine, motion.segments);
        double most = 0;
        for (const Setpoint& setpoint : sample(machine, program.commands)) {
            watch.add(setpoint);
            if (setpoint.line < 2) continue;
            const Vec3& tip = setpoint.tip;
            const double beside =
                std::min(std::hypot(tip.y(), tip.z()), std::hypot(tip.x() - 40, tip.z()));
            ASSERT_LT(beside, 1e-9);
            // The programmed direction at this place of the path.
            const bool is_behind = tip.y() > 0;
            const Vec3 from = is_behind ? direction(40, 35) : direction(30, 30);
            const Vec3 to = is_behind ? direction(60, 30) : direction(40, 35);
            const double share = (is_behind ? tip.y() : tip.x()) / 40;
            const double angle = path::angle_between(from, to);
            const Vec3 programmed =
                (std::sin((1 - share) * angle) * from + std::sin(share * angle) * to) /
                std::sin(angle);
            most = std::max(most, path::angle_between(setpoint.tool, programmed));
        }
        EXPECT_LT(most, rad_from_deg(1));
        EXPECT_GT(most, rad_from_deg(0.5));
        EXPECT_LT(watch.shares().velocity, 1.001);
        EXPECT_LT(watch.shares().acceleration, 1.001);
        // By the path no axis changes its rate at once where the ways of the tool meet.
        const AxisTable axes(machine);
        double jump = 0;
        for (std::size_t k = 1; k < motion.segments.size(); ++k) {
            if (motion.segments[k - 1].line < 2 || motion.segments[k].kind != SegmentKind::Feed)
                continue;
            const AxisRates in = axes.end_rates(motion.segments[k - 1]);
            const AxisRates out = axes.start_rates(motion.segments[k]);
            for (std::size_t a = 3; a < machine.axes.size(); ++a)
                jump = std::max(jump, std::abs(out[a] - in[a]));
        }
        EXPECT_LT(jump, 1e-6);
    }
}

// Where the way of the tool alone would take longer than the corner as it is, the corner stays: on
// it the rotary axes are slower on all of its way. Some took 16 % longer. What the ramps between
// its parts take is estimated, to some percent.
TEST(OrientationCorner, TheToolAloneTakesNoMoreTimeThanTheCorner) {
    for (const machine::Machine& machine : every_class()) {
        for (const double length : {3.0, 25.0}) {
            for (const double turn : {0.0, 0.7, 2.0}) {
                for (const double azimuth_deg : {60.0, 150.0, 260.0}) {
                    for (const double orientation_deg : {0.05, 2.0}) {
                        const Vec3 corner(20, 0, 0);
                        const Vec3 out(std::cos(turn), std::sin(turn), 0.1);
                        Program program(machine);
                        program.go_fast({0, 0, 0}, direction(30, 25));
                        program.go(corner, direction(50, 15), 5000);
                        program.go(corner + length * out, direction(azimuth_deg, 20), 5000);
                        program.go(corner + Vec3(30, 30, 0), direction(40, 30), 5000);
                        const double as_it_is = run(machine, program.commands).totals.time;
                        for (Command& command : program.commands)
                            command.motion().blending = of_the_tool(orientation_deg);
                        EXPECT_LE(run(machine, program.commands).totals.time, 1.06 * as_it_is)
                            << length << " mm, " << turn << " rad, " << azimuth_deg << " and "
                            << orientation_deg << " degrees";
                    }
                }
            }
        }
    }
}

TEST(OrientationCorner, CornersOfTheTipAreRoundedToo) {
    const machine::Machine machine = table_table();
    Program program(machine);
    program.go_fast({0, 0, 0}, direction(30, 30));
    program.go({40, 0, 0}, direction(40, 35), 6000);
    program.commands.back().motion().blending = within(0.1, 1);
    program.go({40, 40, 0}, direction(60, 30), 6000);
    const Motion motion = run(machine, program.commands);
    double nearest = 100;
    TickWatch watch(machine, motion.segments);
    for (const Setpoint& setpoint : sample(machine, program.commands)) {
        watch.add(setpoint);
        nearest = std::min(nearest, (setpoint.tip - Vec3(40, 0, 0)).norm());
    }
    EXPECT_GT(nearest, 0.05);
    EXPECT_LT(nearest, 0.1);
    EXPECT_LT(watch.shares().acceleration, 1.001);
}

/// A line to the start of a spiral up a dome on which the tool stands square, as examples/dome.mpf:
/// between all motions there is a curve or a rest. The corner behind the line stayed as it was, and
/// C jumped there; near the pole, too, where C turns far from block to block.
TEST(OrientationCorner, UnderALimitOfTheJerkNoRotaryAxisJumps) {
    for (const double feed : {1000.0, 3000.0, 10000.0}) {
        const machine::Machine machine = table_table(0.02);
        Program program(machine);
        const auto on_dome = [](double azimuth_deg, double tilt_deg) -> Vec3 {
            return 60 * (direction(azimuth_deg, tilt_deg) - Vec3::UnitZ());
        };
        program.go_fast(on_dome(0, 55) + Vec3(30, 0, 20), direction(0, 55));
        program.go(on_dome(0, 55), direction(0, 55), feed);
        for (int turned = 6; turned < 360; turned += 6) {
            const double tilt = 55 * (1 - turned / 360.0);
            program.go(on_dome(turned, tilt), direction(turned, tilt), feed);
        }
        for (Command& command : program.commands) command.motion().blending = within(0.05, 0.05);
        const Motion motion = run(machine, program.commands);
        const AxisTable axes(machine);
        for (std::size_t k = 1; k < motion.segments.size(); ++k) {
            const double speed = motion.segments[k].profile.entry_speed;
            const AxisRates in = axes.end_rates(motion.segments[k - 1]);
            const AxisRates out = axes.start_rates(motion.segments[k]);
            for (std::size_t a = 3; a < machine.axes.size(); ++a)
                EXPECT_LT(std::abs(out[a] - in[a]) * speed, 1e-3 * machine.axes[a].velocity)
                    << motion.segments[k].line;
        }
        TickWatch watch(machine, motion.segments);
        for (const Setpoint& setpoint : sample(machine, program.commands)) watch.add(setpoint);
        EXPECT_LT(watch.shares().acceleration, 1.001);
        EXPECT_LT(watch.shares().jerk, 1.001);
    }
}

RC_GTEST_PROP(OrientationCorner, KeepsTolerancesAndLimits, ()) {
    const std::vector<machine::Machine> machines = every_class();
    const machine::Machine& machine = machines[*rc::gen::inRange<std::size_t>(0, machines.size())];
    std::vector<Command> commands = any_turning_program(machine);
    const double tolerance = *rc::gen::element(0.01, 0.1, 2.0);
    const int kind = *rc::gen::inRange(0, 4);
    path::Blending blending = of_the_tool(*rc::gen::element(0.02, 0.5));
    if (kind == 0) blending = {path::BlendKind::Distance, false, tolerance};
    if (kind == 1) blending = within(tolerance, *rc::gen::element(0.02, 0.5));
    if (kind == 2) {  // both
        blending.kind = path::BlendKind::Tolerance;
        blending.size = tolerance;
    }
    for (Command& command : commands) command.motion().blending = blending;
    const Motion motion = run(machine, commands);
    RC_ASSERT(!motion.alarmed);
    TickWatch watch(machine, motion.segments);
    const auto tip_of = [&](std::size_t i) {
        return Vec3(commands[i].motion().to[0], commands[i].motion().to[1],
                    commands[i].motion().to[2]);
    };
    Vec3 last = tip_of(0);
    for (const Setpoint& setpoint : sample(machine, commands)) {
        watch.add(setpoint);
        last = setpoint.tip;
        const machine::Pose pose = pose_of(machine, setpoint, 0);
        RC_ASSERT((pose.tip - setpoint.tip).norm() < 1e-6 * kMicrometre);
        RC_ASSERT((pose.rotation * Vec3::UnitZ() - setpoint.tool).norm() < 1e-9);
        const std::size_t line = setpoint.line - 1;
        if (line < 1) continue;
        double least = 1e9;
        for (std::size_t k = std::max<std::size_t>(line, 2) - 1;
             k < std::min(line + 2, commands.size()); ++k) {
            const Vec3 delta = tip_of(k) - tip_of(k - 1);
            const double f =
                delta.norm() > 0
                    ? std::clamp((setpoint.tip - tip_of(k - 1)).dot(delta) / delta.squaredNorm(),
                                 0.0, 1.0)
                    : 0;
            least = std::min(least, (setpoint.tip - tip_of(k - 1) - f * delta).norm());
        }
        RC_ASSERT(least < (kind == 3 ? 0 : tolerance) + 1e-9);
    }
    RC_ASSERT(watch.shares().velocity < 1.001);
    RC_ASSERT(watch.shares().acceleration < 1.001);
    RC_ASSERT(watch.shares().jerk < 1.001);
    RC_ASSERT((last - tip_of(commands.size() - 1)).norm() < 1e-9);
}

/// The greatest velocity of an axis lies between the places where its course is looked at.
TEST(Transformed, AxesKeepTheirVelocityOnLongTurns) {
    for (const double height : {0.0, 47.0, 150.0}) {
        machine::Machine machine = table_table(0.02);
        for (machine::MachineAxis& axis : machine.axes) {
            if (axis.is_rotary) axis.velocity = 20;
        }
        Program program(machine);
        program.go_fast({0, 0, 400 - height}, Vec3::UnitZ());
        program.go({-20, -10, 47}, Vec3(0.514, 0.246, 0.822).normalized(), 1e6);
        program.go({60, -10, 400}, direction(-40, 20), 1e6);
        const Motion motion = run(machine, program.commands);
        TickWatch watch(machine, motion.segments);
        for (const Setpoint& setpoint : sample(machine, program.commands)) watch.add(setpoint);
        EXPECT_LT(watch.shares().velocity, 1.0002) << height;
        EXPECT_GT(watch.shares().velocity, 0.99) << height;
    }
}

/// A table whose C axis is out of square with A by so much, rad: directions nearer to C than that
/// no axes reach.
machine::Machine out_of_square(double gap) {
    return five_axes({Axis::C, ChainSide::Table, Vec3(gap, 0, 1).normalized(), {12, -7, 3}},
                     {Axis::A, ChainSide::Table, Vec3::UnitX(), {3, 5, -60}}, 0.02);
}

/// A direction as programs have them that lead the tool upright and past it.
Vec3 near_upright(const Vec3& before) {
    // Nearer to the pole the rounding of a double would be seen in R1.
    const double small = std::pow(10.0, any_number(-50, -5) / 10.0);
    const double azimuth = any_number(-180, 180);
    const Vec3 aside = small * Vec3(std::cos(azimuth), std::sin(azimuth), 0);
    switch (*rc::gen::inRange(0, 5)) {
        case 0: return Vec3::UnitZ();
        case 1: return (Vec3::UnitZ() + aside).normalized();
        case 2: {  // to the other side of the pole
            const double share = any_number(2, 10) / 10.0;
            return Vec3(-share * before.x(), -share * before.y(), before.z()).normalized();
        }
        case 3: return (Vec3(-before.x(), -before.y(), before.z()) + aside).normalized();
        default: return direction(any_number(-180, 180), any_number(1, 50));
    }
}

/// Through the pole, past it, from it and to it, also where the axes are not square to each other:
/// the tool stands as the block says at its end, no farther beside the great circle in between than
/// the tolerance of the pole or the gap round it asks for, and no axis jumps.
RC_GTEST_PROP(NearThePole, ToolAndAxesGoOn, ()) {
    std::vector<machine::Machine> machines = every_class();
    for (const double gap : {1e-5, 2e-4, 8e-4}) machines.push_back(out_of_square(gap));
    machine::Machine machine = machines[*rc::gen::inRange<std::size_t>(0, machines.size())];
    const double tolerance = rad_from_deg(0.05);
    machine.kinematics->pole_tolerance = tolerance;
    const bool is_rounded = *rc::gen::element(true, false);
    Program program(machine);
    Vec3 tip(0, 0, 0);
    Vec3 tool = near_upright(direction(20, 30));
    program.go_fast(tip, tool);
    const int count = *rc::gen::inRange(1, 8);
    std::vector<Vec3> tools = {tool};
    for (int i = 0; i < count; ++i) {
        tool = near_upright(tool);
        RC_PRE(tool.cross(tools.back()).norm() > 1e-6);
        tip += *rc::gen::element(0.0, 0.3, 20.0) * any_point(1);
        program.go(tip, tool, any_number(500, 10000));
        if (is_rounded) program.commands.back().motion().blending = within(0.05, 0.02);
        tools.push_back(tool);
    }
    const Motion motion = run(machine, program.commands);
    RC_ASSERT(!motion.alarmed);
    TickWatch watch(machine, motion.segments);
    const double gap = machine::pole_angle_reach(machine.kinematics->chain).lower;
    const double most = 2 * std::max(tolerance, 1.5 * gap) + (is_rounded ? rad_from_deg(0.02) : 0);
    Vec3 last = Vec3::Zero();
    for (const Setpoint& setpoint : sample(machine, program.commands)) {
        watch.add(setpoint);
        const machine::Pose pose = pose_of(machine, setpoint, 0);
        RC_ASSERT((pose.tip - setpoint.tip).norm() < 1e-6 * kMicrometre);
        last = pose.rotation * Vec3::UnitZ();
        const std::size_t k = setpoint.line - 1;
        if (k < 1 || is_rounded) continue;
        const Vec3 normal = tools[k - 1].cross(tools[k]).normalized();
        RC_ASSERT(std::abs(last.dot(normal)) < most);
    }
    RC_ASSERT((last - tools.back()).norm() < 1e-7);
    RC_ASSERT(watch.shares().velocity < 1.001);
    RC_ASSERT(watch.shares().acceleration < 1.001);
}

}  // namespace
}  // namespace kadr::motion::test::transformed_test
