#include "driver/variables.h"

#include "base/render.h"
#include "driver/trace.h"

namespace kadr::driver {

std::string variables_json(std::span<const macro::ControlVariable> variables) {
    std::string out = "{";
    for (const macro::ControlVariable& variable : variables) {
        out += out.size() > 1 ? ",\n " : "\n ";
        out += json_string(variable.name) + ": " + json_value(variable);
    }
    return out + (out.size() > 1 ? "\n}\n" : "}\n");
}

}  // namespace kadr::driver
