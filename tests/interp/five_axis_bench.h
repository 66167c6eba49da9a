// five_axis_bench.h — a machine with two rotary axes for interpreter tests, and what its commands
// say of the tool.
#pragma once

#include "base/units.h"
#include "machine/kinematics.h"
#include "tests/interp/text_bench.h"

namespace kadr::interp {

using path::Vec3;

/// A mill with a table that tilts about X and turns about Z in it.
inline machine::Machine trunnion() {
    machine::Machine machine = mill();
    machine::Chain chain;
    chain.joints[machine::kR1] = {true,          Axis::C,   machine::ChainSide::Table,
                                  Vec3::UnitZ(), {5, 3, 0}, 1};
    chain.joints[machine::kR2] = {true,          Axis::A,     machine::ChainSide::Table,
                                  Vec3::UnitX(), {0, 2, -50}, 1};
    for (const Axis axis : {Axis::A, Axis::C}) {
        machine::MachineAxis rotary;
        rotary.name = std::string(kAxisNames[index(axis)]);
        rotary.axis = axis;
        rotary.is_rotary = true;
        const double most = axis == Axis::A ? rad_from_deg(110) : rad_from_deg(3600);
        rotary.lower = -most;
        rotary.upper = most;
        rotary.velocity = 2;
        rotary.acceleration = 20;
        machine.axes.push_back(rotary);
    }
    machine.kinematics.emplace();
    machine.kinematics->chain = machine::prepare(chain).value();
    machine.kinematics->pole_tolerance = 1e-6;
    return machine;
}

inline std::vector<path::Command> motions(const Ran& ran) {
    std::vector<path::Command> found;
    for (const path::Command& command : ran.commands) {
        if (command.is_motion()) found.push_back(command);
    }
    return found;
}

/// Direction of the tool where a command ends, by the kinematics alone.
inline Vec3 tool_of(const path::Command& command) {
    const Vec3 joints(rad_from_deg(command.motion().to[index(Axis::C)]),
                      rad_from_deg(command.motion().to[index(Axis::A)]), 0);
    return machine::tool_vector(trunnion().kinematics->chain, joints);
}

/// A text that the control refuses with one message.
struct Refused {
    std::string text;
    std::string alarm;
    std::string code;
};

inline void expect_refused(const Ran& ran, const Refused& refused) {
    EXPECT_TRUE(ran.alarmed);
    EXPECT_EQ(alarms(ran), refused.alarm) << refused.text;
    ASSERT_EQ(ran.messages.size(), 1u);
    EXPECT_EQ(ran.messages[0].row->code, refused.code) << refused.text;
}

}  // namespace kadr::interp
