#include "expand/cutters.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/danger_limits.h"

namespace kadr::expand {

namespace {

/// How a cycle of the library gives the size of its tool.
struct Role {
    std::string_view name;
    double radii = 1;  // of the tool that it is
};
constexpr std::array kRoles = {Role{"tool_d", 2}, Role{"nose", 1}};

const Role* role_of(const sema::ParameterInfo& parameter) {
    const auto role = std::ranges::find(kRoles, parameter.name, &Role::name);
    return role != kRoles.end() && parameter.quantity == sema::kLength ? &*role : nullptr;
}

double rounded(double value) { return std::round(value * 1e4) / 1e4; }

}  // namespace

bool has_cutter(const sema::FunctionCode& cycle) {
    return std::ranges::any_of(cycle.parameters,
                               [](const auto& each) { return role_of(each) != nullptr; });
}

std::optional<CutterMismatch> cutter_mismatch(const sema::FunctionCode& cycle,
                                              const sema::Slot* registers,
                                              const machine::Machine& machine, std::int64_t tool) {
    const auto own = std::ranges::find_if(
        machine.tools, [&](const auto& each) { return each.number == tool && each.edge == 1; });
    if (own == machine.tools.end() || !(own->radius > 0)) return std::nullopt;
    for (const sema::ParameterInfo& parameter : cycle.parameters) {
        const Role* role = role_of(parameter);
        if (role == nullptr) continue;
        const double programmed = registers[parameter.slot].number;
        const double size = role->radii * own->radius;
        if (programmed > 0 && std::abs(programmed - size) > danger::kCutterSlack)
            return CutterMismatch{role->name, rounded(programmed), rounded(size)};
    }
    return std::nullopt;
}

}  // namespace kadr::expand
