// CYCLE800 as a text of the control, on the machines of the oracles: the axes go where
// tests/oracles/swivel_modes.json has them, at the swivel and at places in the plane.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/interp/five_axis_bench.h"
#include "tests/machine/support.h"

namespace kadr::interp::swivel_oracle_test {
namespace {

using machine::kR1;
using machine::kR2;
using machine::test::json;

/// A machine of the oracles with the limits of its rotary axes and one tool of this length; R1 is
/// its axis C and R2 its axis B.
machine::Machine machine_of_case(const std::string& name, double length) {
    machine::Machine machine = trunnion();
    machine.kinematics->chain = machine::test::chain_of(name);
    const json machines = machine::test::oracle("kinematics.json")["machines"];
    for (machine::MachineAxis& axis : machine.axes) {
        axis.lower = -1e5;
        axis.upper = 1e5;
        if (axis.axis == Axis::A) axis.axis = Axis::B, axis.name = "B";
        for (const json& item : machines) {
            if (!axis.is_rotary || item["name"] != name) continue;
            const machine::AxisRange limits =
                machine::test::limits(item[axis.axis == Axis::C ? "R1" : "R2"]["limits"]);
            axis.lower = limits.lower;
            axis.upper = limits.upper;
        }
    }
    for (machine::ToolData& tool : machine.tools) tool.length = length;
    return machine;
}

std::string number_text(const json& number) {
    char text[40];
    std::snprintf(text, sizeof text, "%.12f", number.get<double>());
    return text;
}

std::string list_text(const json& numbers) {
    return number_text(numbers[0]) + "," + number_text(numbers[1]) + "," + number_text(numbers[2]);
}

std::string program_of(const json& input, int direction) {
    std::string text = "T1 D1 M6\nS1000 M3\nG500\nG0 X0 Y0 Z0\nCYCLE800(0,\"\",0," +
                       std::to_string(input["_MODE"].get<int>()) + "," +
                       list_text(input["X0Y0Z0"]) + "," + number_text(input["_A"]) + "," +
                       number_text(input["_B"]) + "," + number_text(input["_C"]) + "," +
                       list_text(input["X1Y1Z1"]) + "," + std::to_string(direction) + ")\n";
    for (const json& point : input["points"])
        text += "G1 X" + number_text(point[0]) + " Y" + number_text(point[1]) + " Z" +
                number_text(point[2]) + " F1000\n";
    return text + "M30";
}

/// Where the linear axes stand at the end of each motion: the tip and what is carried from it.
std::vector<Vec3> linear_axes(const Ran& ran) {
    std::vector<Vec3> found;
    Vec3 carried = Vec3::Zero();
    for (const path::Command& command : ran.commands) {
        if (command.op() == path::Op::ToolLength)
            carried = command.tool_length().length *
                          path::unit(path::axes_of(command.tool_length().plane).normal) +
                      command.tool_length().aside;
        if (command.is_motion())
            found.push_back(
                Vec3(command.motion().to[0], command.motion().to[1], command.motion().to[2]) +
                carried);
    }
    return found;
}

/// The solution of the case in which the axes stand; nullptr if it is none of them.
const json* solution_at(const json& solutions, double first_deg, double second_deg) {
    for (const json& solution : solutions) {
        const bool is_it =
            machine::test::apart(rad_from_deg(first_deg), machine::test::rad(solution["R1"])) <
                machine::test::kAngleTolerance &&
            machine::test::apart(rad_from_deg(second_deg), machine::test::rad(solution["R2"])) <
                machine::test::kAngleTolerance;
        if (is_it) return &solution;
    }
    return nullptr;
}

TEST(SwivelOracle, TextsBringTheAxesToTheirPlaces) {
    const double place =
        machine::test::oracle("swivel_modes.json")["tolerance"]["linear_axes_abs"].get<double>();
    int seen = 0;
    machine::test::for_each_case(
        "swivel_modes.json", "CYCLE800", 17, [&](const json& input, const json& expect) {
            // Its angles are those of the control's swivel data, see tilted_plane_test.cpp.
            if (input["mode"] == "direct") return;
            const double length = input["tool"][2].get<double>();
            const machine::Machine machine = machine_of_case(input["machine"], length);
            for (const int direction : {-1, 1}) {
                SCOPED_TRACE(direction);
                const Ran ran = read("sinumerik", program_of(input, direction), machine);
                ASSERT_EQ(alarms(ran), "") << program_of(input, direction);
                const auto all = motions(ran);
                const std::size_t points = input["points"].size();
                ASSERT_GT(all.size(), points);
                const path::Command& last = all.back();
                const double first_deg = last.motion().to[index(Axis::C)];
                const double second_deg = last.motion().to[index(Axis::B)];
                const json* solution =
                    solution_at(expect["rotary_solutions"], first_deg, second_deg);
                ASSERT_NE(solution, nullptr) << first_deg << " " << second_deg;
                EXPECT_TRUE((*solution)["within_limits"].get<bool>());
                const Vec3 joints(rad_from_deg(first_deg), rad_from_deg(second_deg), 0);
                EXPECT_EQ(machine::configuration_of(machine.kinematics->chain, joints),
                          (*solution)["config"].get<int>());
                if (input["reference_axis"] == "R2") {
                    const json& wanted = expect["selected"][std::to_string(direction)];
                    EXPECT_NEAR(second_deg, wanted["R2"].get<double>(), 1e-5);
                }
                const std::vector<Vec3> axes = linear_axes(ran);
                for (std::size_t i = 0; i < points; ++i) {
                    const Vec3 wanted = machine::test::vec((*solution)["XYZ_of_points"][i]);
                    EXPECT_LT((axes[axes.size() - points + i] - wanted).norm(), place) << i;
                }
                ++seen;
            }
        });
    EXPECT_EQ(seen, 26);
}

}  // namespace
}  // namespace kadr::interp::swivel_oracle_test
