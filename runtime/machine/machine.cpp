#include "machine/machine.h"

#include <algorithm>

namespace kadr::machine {

const MachineAxis* Machine::find(Axis axis) const {
    const auto found = std::find_if(axes.begin(), axes.end(),
                                    [axis](const MachineAxis& a) { return a.axis == axis; });
    return found == axes.end() ? nullptr : &*found;
}

const ToolData* Machine::find_tool(std::int64_t number) const {
    const auto found = std::find_if(tools.begin(), tools.end(),
                                    [number](const ToolData& t) { return t.number == number && t.edge == 1; });
    return found == tools.end() ? nullptr : &*found;
}

const MachineFunction* Machine::find_function(std::int64_t code) const {
    const auto found = std::ranges::find(functions, code, &MachineFunction::code);
    return found == functions.end() ? nullptr : &*found;
}

}  // namespace kadr::machine
