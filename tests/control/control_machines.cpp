#include "tests/control/control_machines.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "tests/interp/five_axis_bench.h"

namespace kadr::interp {
namespace {

/// No Y, and a C that turns without end.
void drive_tools(machine::Machine& machine) {
    std::erase_if(machine.axes, [](const auto& axis) { return axis.axis == Axis::Y; });
    machine::MachineAxis& turning = machine.axes.back();
    turning.lower = -std::numeric_limits<double>::infinity();
    turning.upper = std::numeric_limits<double>::infinity();
    machine.is_lathe = true;
    for (machine::ToolData& tool : machine.tools) tool.length = 0;
}

/// Noses of 0 and 0.4 mm, a groove tool of 4 mm.
void clamp_turning_tools(machine::Machine& machine) {
    machine.is_lathe = true;
    machine.tools = {{.number = 1, .length = 0, .radius = 0, .name = "POINT"},
                     {.number = 2, .length = 0, .radius = 0.4, .name = "NOSE"},
                     {.number = 3, .length = 0, .radius = 2, .name = "GROOVE"}};
}

/// A drill with two further edges.
void grind_edges(machine::Machine& machine) {
    machine.tools.push_back({.number = 2, .edge = 2, .length = 70, .radius = 2.5, .name = ""});
    machine.tools.push_back({.number = 2, .edge = 12, .length = 60, .radius = 2, .name = ""});
}

/// A second and a third spindle, or a fourth one as well.
void add_spindles(machine::Machine& machine, bool has_all) {
    machine.orient_time = 0.25;
    machine.spindles = {{.number = 2, .max_speed = 100, .orient_time = 0.5},
                        {.number = 3, .max_speed = 0, .orient_time = 0}};
    if (has_all) machine.spindles.push_back({.number = 4, .max_speed = 0, .orient_time = 0});
}

machine::Machine stock(const std::string& name) {
    Sources sources;
    DiagnosticList messages;
    auto machine = machine::load_machine(name, {KADR_ROOT "/runtime/machines"}, sources, messages);
    EXPECT_TRUE(machine.has_value()) << name;
    return machine ? std::move(*machine) : mill();
}

}  // namespace

machine::Machine machine_named(const std::string& name, bool control_is_of_lathe) {
    const bool is_own = name.empty() || name == "lathe" || name == "driven" || name == "edges" ||
                        name == "spindles" || name == "four-spindles" || name == "five-axis-by-c";
    machine::Machine machine = is_own ? mill() : name == "five-axis" ? trunnion() : stock(name);
    if (name == "five-axis-by-c") {
        machine = trunnion();
        machine.kinematics->swivel_reference = machine::kR1;
    }
    machine.work_offsets = {{}, {}, {10, 20, 30}};
    machine.tools[0].length = 0;
    machine.is_lathe = control_is_of_lathe;
    if (name == "lathe") clamp_turning_tools(machine);
    if (name == "driven") drive_tools(machine);
    if (name == "edges") grind_edges(machine);
    if (name.ends_with("spindles")) add_spindles(machine, name.starts_with("four"));
    return machine;
}

}  // namespace kadr::interp
