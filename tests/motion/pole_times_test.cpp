// How long the tool takes through the pole of a machine and past it, against times that were
// computed by other methods (tests/oracles/pole.json).
#include <cmath>

#include <gtest/gtest.h>

#include "motion/transformed.h"
#include "tests/machine/support.h"
#include "tests/motion/support.h"

namespace kadr::motion::test::pole_times_test {
namespace {

using machine::kR1;
using machine::kR2;
using machine::test::json;
using path::OrientKind;

/// The machine of a case with its limits, deg/s and deg/s²; without jerk, and with linear axes that
/// are never what limits.
machine::Machine machine_of_case(const json& input) {
    const Vec3 fast = Vec3::Constant(1e9);
    machine::Machine machine = machine_of({fast, fast, Vec3::Constant(kUnlimited)});
    machine.kinematics.emplace();
    machine.kinematics->chain = machine::test::chain_of(input["machine"]);
    for (const std::size_t k : {kR1, kR2}) {
        machine::MachineAxis axis;
        axis.axis = machine.kinematics->chain.joints[k].axis;
        axis.name = std::string(kAxisNames[index(axis.axis)]);
        axis.is_rotary = true;
        axis.lower = -kUnlimited;
        axis.upper = kUnlimited;
        axis.velocity = machine::test::rad(input[k == kR1 ? "V_R1" : "V_R2"]);
        axis.acceleration = machine::test::rad(input[k == kR1 ? "A_R1" : "A_R2"]);
        axis.jerk = kUnlimited;
        machine.axes.push_back(axis);
    }
    return machine;
}

/// The tool turns while its tip stands, to where the rotary axes are then; it stops before and
/// behind.
Command orient_to(const machine::Machine& machine, const Vec3& joints) {
    Command command = line_to(Vec3(40, 25, -10), kFast);
    for (const std::size_t k : {kR1, kR2}) {
        const Axis axis = machine.kinematics->chain.joints[k].axis;
        command.motion().to[index(axis)] = deg_from_rad(joints[static_cast<Eigen::Index>(k)]);
        command.motion().moved |= bit(axis);
    }
    command.motion().orient_kind = OrientKind::Axes;
    command.motion().direction = machine::tool_vector(machine.kinematics->chain, joints);
    command.motion().exact_stop = true;
    return command;
}

Command along_great_circle(const machine::Machine& machine, const Vec3& from, const Vec3& joints) {
    Command command = orient_to(machine, joints);
    command.motion().orient_kind = OrientKind::Cone;
    const Vec3 across = from.cross(command.motion().direction);
    command.motion().orient_details.made().axis = across.normalized();
    command.motion().orient_details.made().angle =
        std::atan2(across.norm(), from.dot(command.motion().direction));
    return command;
}

/// From rest to rest, s.
double time_of_turn(const machine::Machine& machine, const Vec3& start, const Vec3& end) {
    const Vec3 from = machine::tool_vector(machine.kinematics->chain, start);
    const Motion motion =
        run(machine, {orient_to(machine, start), along_great_circle(machine, from, end)});
    EXPECT_FALSE(motion.alarmed);
    double time = 0;
    for (const Segment& segment : motion.segments)
        if (segment.line == 2) time += segment.duration;
    return time;
}

/// Where the axes end on the great circle from `start` to the direction of the case, R2 kept on the
/// side of its start or not.
Vec3 end_of(const machine::Chain& chain, const json& input, const Vec3& start, bool keeps_side) {
    machine::PathQuery query =
        machine::query_for(chain, machine::test::vec(input["target_vector"]).normalized());
    query.start = start;
    query.mode = machine::PathMode::Vector;
    if (keeps_side) query.limits[kR2] = {0, std::numbers::pi};
    const auto end = machine::choose_path(chain, query);
    EXPECT_TRUE(end.has_value());
    return end ? end->rotary : start;
}

double tolerance(const char* name) {
    return machine::test::oracle("pole.json")["tolerance"][name].get<double>();
}

TEST(PoleTimes, ThroughThePoleByBothWays) {
    const double exact = tolerance("T_exact_rel");
    machine::test::for_each_case(
        "pole.json", "through_pole", 3, [&](const json& input, const json& expect) {
            const machine::Machine machine = machine_of_case(input);
            const machine::Chain& chain = machine.kinematics->chain;
            const Vec3 start(machine::test::rad(input["start_R1_R2"][0]),
                             machine::test::rad(input["start_R1_R2"][1]), 0);
            const auto expect_time = [&](double time, const json& wanted) {
                EXPECT_NEAR(time, wanted.get<double>(), exact * time);
            };
            expect_time(time_of_turn(machine, start, end_of(chain, input, start, false)),
                        expect["switch"]["T"]);
            const json& turned = expect["stop_and_turn"];
            const Vec3 end = end_of(chain, input, start, true);
            expect_time(time_of_turn(machine, start, end), turned["T"]);
            // To the pole, where R1 turns while R2 stands, and on.
            const Vec3 before(start[0], 0, 0);
            const Vec3 behind(end[0], 0, 0);
            expect_time(time_of_turn(machine, start, before), turned["T_to_pole"]);
            expect_time(time_of_turn(machine, behind, end), turned["T_from_pole"]);
            const Motion turn =
                run(machine, {orient_to(machine, before), orient_to(machine, behind)});
            double time = 0;
            for (const Segment& segment : turn.segments)
                if (segment.line == 2) time += segment.duration;
            // R1 alone, in proportion to itself: exactly.
            EXPECT_NEAR(time, turned["T_turn"].get<double>(), exact * time);
        });
}

TEST(PoleTimes, PastThePole) {
    const double rate = tolerance("largest_rate_rel");
    const double near = tolerance("near_miss_T_rel");
    machine::test::for_each_case(
        "pole.json", "near_miss_time", 3, [&](const json& input, const json& expect) {
            const machine::Machine machine = machine_of_case(input);
            const machine::Chain& chain = machine.kinematics->chain;
            const Vec3 from = machine::test::vec(input["start_vector"]).normalized();
            const Vec3 to = machine::test::vec(input["target_vector"]).normalized();
            EXPECT_NEAR(machine::pole_approach(chain, from, to).distance,
                        machine::test::rad(input["distance_from_pole_deg"]), 1e-9);
            const auto solved = machine::solve(chain, from);
            ASSERT_TRUE(solved);
            const int wanted = input["configuration"].get<int>();
            Vec3 start = Vec3::Zero();
            for (const machine::Solution& solution : *solved)
                if (solution.configuration == wanted) start = solution.rotary;
            const Vec3 end = end_of(chain, input, start, true);
            EXPECT_EQ(machine::configuration_of(chain, end), wanted);
            EXPECT_NEAR(std::abs(end[0] - start[0]), machine::test::rad(expect["R1_change"]),
                        machine::test::kAngleTolerance);
            // R1 turns fastest where the circle is nearest to the pole: 1/sin of the distance.
            const double fastest =
                1 / std::sin(machine::test::rad(input["distance_from_pole_deg"]));
            const double of_oracle = expect["largest_dR1_per_degree_of_vector"].get<double>();
            EXPECT_NEAR(fastest, of_oracle, rate * of_oracle);
            const double least = expect["T"].get<double>();
            const double time = time_of_turn(machine, start, end);
            EXPECT_GT(time, least - expect["T_uncertainty"].get<double>());
            EXPECT_LT(time, least * (1 + near));
        });
}

}  // namespace
}  // namespace kadr::motion::test::pole_times_test
