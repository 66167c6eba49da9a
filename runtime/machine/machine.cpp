#include "machine/machine.h"

#include <algorithm>

namespace kadr::machine {

namespace {

/// Null: it is the first one, or there is none.
const MachineSpindle* find_spindle(const Machine& machine, std::int64_t number) {
    const auto found = std::ranges::find(machine.spindles, number, &MachineSpindle::number);
    return found == machine.spindles.end() ? nullptr : &*found;
}

}  // namespace

const MachineAxis* Machine::find(Axis axis) const {
    const auto found = std::find_if(axes.begin(), axes.end(),
                                    [axis](const MachineAxis& a) { return a.axis == axis; });
    return found == axes.end() ? nullptr : &*found;
}

const ToolData* Machine::find_tool(std::int64_t number) const {
    const auto found = std::find_if(tools.begin(), tools.end(), [number](const ToolData& t) {
        return t.number == number && t.edge == 1;
    });
    return found == tools.end() ? nullptr : &*found;
}

bool Machine::has_spindle(std::int64_t number) const {
    return number == 1 || find_spindle(*this, number) != nullptr;
}

double Machine::max_speed_of(std::int64_t number) const {
    const MachineSpindle* const other = find_spindle(*this, number);
    return other == nullptr ? max_speed : other->max_speed;
}

double Machine::orient_time_of(std::int64_t number) const {
    const MachineSpindle* const other = find_spindle(*this, number);
    return other == nullptr ? orient_time : other->orient_time;
}

const MachineFunction* Machine::find_function(std::int64_t code) const {
    const auto found = std::ranges::find(functions, code, &MachineFunction::code);
    return found == functions.end() ? nullptr : &*found;
}

}  // namespace kadr::machine
