#include "macro/machine_values.h"

#include <algorithm>

#include "macro/variable_names.h"

namespace kadr::macro {

using nc::VariableRange;

namespace {

/// Of `$MN_USER_DATA_INT[3]` what stands in front of the indices.
std::string_view front_of(std::string_view name, char open) {
    return name.substr(0, std::min(name.find(open), name.size()));
}

}  // namespace

void MachineValues::read(const VariableRange& range, const std::string& name, ControlValue& out,
                         std::string& text) {
    if (const Entry* const entry = find(name)) {
        out = entry->value;
        text = entry->text;
        return;
    }
    out = ControlValue::of(0, range.type);
    const bool is_first = reported_missing_.emplace(front_of(name, language_.index_open)).second;
    if (is_first && missing_listener_) missing_listener_(name, range.meaning);
}

void MachineValues::list(std::uint32_t form, std::vector<ControlVariable>& out) const {
    for (const auto& [name, value] : values_) {
        const auto& ranges = language_.variables[form].ranges;
        const bool is_shared = std::ranges::any_of(ranges, &VariableRange::is_shared);
        if (value.form == form && is_shared) out.push_back(shown(name, value.value, value.text));
    }
}

}  // namespace kadr::macro
