#include "interp/tool_offsets.h"

namespace kadr::interp {

namespace {

std::size_t place_of(ToolOffsets::Column column) { return static_cast<std::size_t>(column) - 1; }

}  // namespace

ToolOffsets::ToolOffsets(const machine::Machine& machine) {
    for (const machine::ToolData& tool : machine.tools)
        offsets_.try_emplace(tool.number,
                             std::array<double, kColumns>{tool.length, 0, tool.radius, 0, 0});
}

std::optional<ToolOffsets::Column> ToolOffsets::column_of(nc::Quantity quantity) {
    switch (quantity) {
        case nc::Quantity::LengthGeometry:
        case nc::Quantity::EdgeLength: return Column::Length;
        case nc::Quantity::LengthWear:
        case nc::Quantity::EdgeLengthWear: return Column::LengthWear;
        case nc::Quantity::RadiusGeometry:
        case nc::Quantity::EdgeRadius: return Column::Radius;
        case nc::Quantity::RadiusWear:
        case nc::Quantity::EdgeRadiusWear: return Column::RadiusWear;
        case nc::Quantity::EdgeType: return Column::Type;
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

}  // namespace kadr::interp
