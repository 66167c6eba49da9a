#include "driver/variables.h"

#include "base/json_writer.h"
#include "driver/trace.h"

namespace kadr::driver {

std::string variables_json(std::span<const macro::ControlVariable> variables) {
    std::string out;
    JsonWriter json(out, JsonStyle::Lines);
    json.object([&] {
        for (const macro::ControlVariable& variable : variables)
            put_value(json.key_of(variable.name), variable);
    });
    json.end_line();
    return out;
}

}  // namespace kadr::driver
