#include "interp/tool_offsets.h"

namespace kadr::interp {

namespace {

std::size_t place_of(ToolOffsets::Column column) { return static_cast<std::size_t>(column) - 1; }

}  // namespace

ToolOffsets::ToolOffsets(const machine::Machine& machine) {
    for (const machine::ToolData& tool : machine.tools)
        offsets_.try_emplace(
            tool.number, std::array<double, kColumns>{tool.length, 0, tool.radius, 0, tool.length_x,
                                                      0, static_cast<double>(tool.tip)});
}

std::optional<ToolOffsets::Column> ToolOffsets::column_of(nc::Quantity quantity) {
    switch (quantity) {
        case nc::Quantity::LengthGeometry: return Column::Length;
        case nc::Quantity::LengthWear: return Column::LengthWear;
        case nc::Quantity::RadiusGeometry: return Column::Radius;
        case nc::Quantity::RadiusWear: return Column::RadiusWear;
        case nc::Quantity::CrossGeometry: return Column::Cross;
        case nc::Quantity::CrossWear: return Column::CrossWear;
        case nc::Quantity::ToolTip: return Column::Tip;
        default: return std::nullopt;
    }
}

double ToolOffsets::value(Column column, std::int64_t number) const {
    const auto found = offsets_.find(number);
    return found == offsets_.end() ? 0 : found->second[place_of(column)];
}

void ToolOffsets::set(Column column, std::int64_t number, double value) {
    offsets_[number][place_of(column)] = value;
}

double ToolOffsets::length(std::int64_t number) const {
    return value(Column::Length, number) + value(Column::LengthWear, number);
}

double ToolOffsets::radius(std::int64_t number) const {
    return value(Column::Radius, number) + value(Column::RadiusWear, number);
}

double ToolOffsets::cross(std::int64_t number) const {
    return value(Column::Cross, number) + value(Column::CrossWear, number);
}

int ToolOffsets::tip(std::int64_t number) const {
    return static_cast<int>(value(Column::Tip, number));
}

}  // namespace kadr::interp
