#include "interp/tool_offsets.h"

#include <algorithm>

namespace kadr::interp {

namespace {

using Column = ToolOffsets::Column;

std::size_t index_of(Column column) { return static_cast<std::size_t>(column); }

}  // namespace

ToolOffsets::ToolOffsets(const machine::Machine& machine, bool is_lathe) : is_lathe_(is_lathe) {
    for (const machine::ToolData& tool : machine.tools) {
        auto& offset = offsets_[of_edge(tool.number, tool.edge)];
        offset[index_of(is_lathe_ ? Column::Second : Column::First)] = tool.length;
        if (is_lathe_) offset[index_of(Column::First)] = tool.length_x;
        offset[index_of(Column::Radius)] = tool.radius;
        offset[index_of(Column::Tip)] = tool.tip;
    }
}

std::int64_t ToolOffsets::last_tool() const {
    std::int64_t last = 0;
    for (const auto& [number, offset] : offsets_) last = std::max(last, tool_of(number));
    return last;
}

std::int64_t ToolOffsets::edges(std::int64_t tool) const {
    std::int64_t count = 0;
    for (std::int64_t edge = 1; edge <= kMostEdges; ++edge) {
        if (is_known(of_edge(tool, edge))) ++count;
    }
    return count;
}

std::int64_t ToolOffsets::cutting_edge(std::int64_t tool, std::int64_t number) const {
    const auto found = cutting_edges_.find(of_edge(tool, number));
    return found == cutting_edges_.end() ? number : found->second;
}

std::int64_t ToolOffsets::number_of(std::int64_t tool, std::int64_t edge) const {
    for (std::int64_t number = 1; number <= kMostEdges; ++number) {
        if (is_known(of_edge(tool, number)) && cutting_edge(tool, number) == edge) return number;
    }
    return 0;
}

bool ToolOffsets::give_number(std::int64_t tool, std::int64_t edge, std::int64_t number) {
    const std::int64_t old = number_of(tool, edge);
    if (old == 0 || number < 1 || number > kMostEdges) return false;
    if (old == number) return true;
    if (is_known(of_edge(tool, number))) return false;
    const std::int64_t from = of_edge(tool, old);
    const std::int64_t to = of_edge(tool, number);
    offsets_[to] = offsets_[from];
    offsets_.erase(from);
    cutting_edges_.erase(from);
    cutting_edges_[to] = edge;
    std::map<std::pair<std::int64_t, std::int64_t>, double> moved;
    for (const auto& [key, value] : data_)
        moved[{key.first == from ? to : key.first, key.second}] = value;
    data_ = std::move(moved);
    return true;
}

std::int64_t ToolOffsets::tool_with(std::int64_t number, std::int64_t passed) const {
    if (number < 1 || number > kMostEdges) return 0;
    std::int64_t found = 0;
    for (const auto& [key, offset] : offsets_) {
        if (edge_of(key) == number && found++ == passed) return tool_of(key);
    }
    return 0;
}

bool ToolOffsets::is_turning(std::int64_t number) const {
    constexpr int kTurning = 5;  // types 500 to 599; S 5.1
    const int kind = type(number);
    return kind == 0 ? is_lathe_ : kind / 100 == kTurning;
}

std::optional<Column> ToolOffsets::column_of(nc::SystemQuantity quantity,
                                             std::int64_t number) const {
    using nc::SystemQuantity;
    const bool is_turned = is_turning(number);
    switch (quantity) {
        case SystemQuantity::LengthGeometry: return is_turned ? Column::Second : Column::First;
        case SystemQuantity::LengthWear: return is_turned ? Column::SecondWear : Column::FirstWear;
        case SystemQuantity::CrossGeometry:
        case SystemQuantity::FirstLength: return Column::First;
        case SystemQuantity::CrossWear:
        case SystemQuantity::FirstWear: return Column::FirstWear;
        case SystemQuantity::SecondLength: return Column::Second;
        case SystemQuantity::SecondWear: return Column::SecondWear;
        case SystemQuantity::ThirdLength: return Column::Third;
        case SystemQuantity::ThirdWear: return Column::ThirdWear;
        case SystemQuantity::RadiusGeometry: return Column::Radius;
        case SystemQuantity::RadiusWear: return Column::RadiusWear;
        case SystemQuantity::FirstBase: return Column::FirstBase;
        case SystemQuantity::SecondBase: return Column::SecondBase;
        case SystemQuantity::ThirdBase: return Column::ThirdBase;
        case SystemQuantity::ToolTip: return Column::Tip;
        case SystemQuantity::ToolType: return Column::Type;
        default: return std::nullopt;
    }
}

Column ToolOffsets::column_at(std::int64_t index, std::int64_t number) const {
    using nc::SystemQuantity;
    static constexpr std::array kPlaces = {
        SystemQuantity::LengthGeometry, SystemQuantity::LengthWear, SystemQuantity::RadiusGeometry,
        SystemQuantity::RadiusWear};
    return *column_of(kPlaces.at(static_cast<std::size_t>(index) - 1), number);
}

std::optional<Column> ToolOffsets::column_of_datum(std::int64_t datum) {
    switch (datum) {
        case 1: return Column::Type;
        case 2: return Column::Tip;
        case 3: return Column::First;
        case 4: return Column::Second;
        case 5: return Column::Third;
        case 6: return Column::Radius;
        case 12: return Column::FirstWear;
        case 13: return Column::SecondWear;
        case 14: return Column::ThirdWear;
        case 15: return Column::RadiusWear;
        case 21: return Column::FirstBase;
        case 22: return Column::SecondBase;
        case 23: return Column::ThirdBase;
        default: return std::nullopt;
    }
}

double ToolOffsets::value(Column column, std::int64_t number) const {
    const auto found = offsets_.find(number);
    return found == offsets_.end() ? 0 : found->second[index_of(column)];
}

void ToolOffsets::set(Column column, std::int64_t number, double value) {
    offsets_[number][index_of(column)] = value;
}

double ToolOffsets::datum(std::int64_t number, std::int64_t datum) const {
    const auto found = data_.find({number, datum});
    return found == data_.end() ? 0 : found->second;
}

void ToolOffsets::set_datum(std::int64_t number, std::int64_t datum, double value) {
    data_[{number, datum}] = value;
}

double ToolOffsets::length(std::size_t part, std::int64_t number) const {
    static constexpr std::array kLengths = {Column::First, Column::Second, Column::Third};
    static constexpr std::array kWears = {Column::FirstWear, Column::SecondWear, Column::ThirdWear};
    static constexpr std::array kBases = {Column::FirstBase, Column::SecondBase, Column::ThirdBase};
    return value(kLengths[part - 1], number) + value(kWears[part - 1], number) +
           value(kBases[part - 1], number);
}

double ToolOffsets::radius(std::int64_t number) const {
    return value(Column::Radius, number) + value(Column::RadiusWear, number);
}

int ToolOffsets::whole(Column column, std::int64_t number) const {
    constexpr double kMost = 1e9;
    return static_cast<int>(std::clamp(value(column, number), -kMost, kMost));
}

}  // namespace kadr::interp
