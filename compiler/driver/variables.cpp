#include "driver/variables.h"

#include <cmath>

#include "base/numbers.h"
#include "base/render.h"

namespace kadr::driver {

namespace {

std::string value_text(const interp::ControlVariable& variable) {
    switch (variable.kind) {
        case interp::ControlVariable::Kind::Text: return json_string(variable.text);
        case interp::ControlVariable::Kind::Bool: return variable.number != 0 ? "true" : "false";
        case interp::ControlVariable::Kind::Int:
        case interp::ControlVariable::Kind::Real: break;
    }
    return std::isfinite(variable.number) ? format_shortest(variable.number) : "null";
}

}  // namespace

std::string variables_json(std::span<const interp::ControlVariable> variables) {
    std::string out = "{";
    for (const interp::ControlVariable& variable : variables) {
        out += out.size() > 1 ? ",\n " : "\n ";
        out += json_string(variable.name) + ": " + value_text(variable);
    }
    return out + (out.size() > 1 ? "\n}\n" : "}\n");
}

}  // namespace kadr::driver
