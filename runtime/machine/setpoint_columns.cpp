#include "machine/setpoint_columns.h"

#include <algorithm>
#include <numeric>

namespace kadr::machine {

bool has_pulses(const Machine& machine) {
    return (machine.laser && machine.laser->pulse > 0) ||
           (machine.scanner && machine.scanner->pulse > 0);
}

std::vector<std::string> setpoint_columns(const Machine& machine) {
    std::vector<std::string> columns = {"t"};
    for (const MachineAxis& axis : machine.axes) columns.push_back(axis.name);
    for (const char* name :
         {"tip_x", "tip_y", "tip_z", "tool_i", "tool_j", "tool_k", "feed", "iso"})
        columns.emplace_back(name);
    if (has_pulses(machine)) columns.emplace_back("pulse");
    if (machine.laser && machine.laser->power > 0) columns.emplace_back("power");
    return columns;
}

std::vector<std::size_t> columns_of_word(std::string_view word, const Machine& machine) {
    const std::size_t first_axis = 1;
    const std::size_t tip = first_axis + machine.axes.size();
    const auto run = [](std::size_t first, std::size_t count) {
        std::vector<std::size_t> columns(count);
        std::iota(columns.begin(), columns.end(), first);
        return columns;
    };
    if (word == "axes") return run(first_axis, machine.axes.size());
    if (word == "tip") return run(tip, 3);
    if (word == "tool") return run(tip + 3, 3);
    const std::vector<std::string> names = setpoint_columns(machine);
    const auto found = std::find(names.begin(), names.end(), word);
    if (found == names.end()) return {};
    return {static_cast<std::size_t>(found - names.begin())};
}

std::vector<std::size_t> chosen_columns(const Machine& machine) {
    std::vector<std::size_t> chosen;
    for (const std::string& word : machine.pipeline.setpoints.columns) {
        for (const std::size_t column : columns_of_word(word, machine)) chosen.push_back(column);
    }
    if (!chosen.empty()) return chosen;
    chosen.resize(setpoint_columns(machine).size());
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
    return chosen;
}

}  // namespace kadr::machine
