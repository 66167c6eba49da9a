// What a program writes: work offsets and tool offsets.
#include <array>
#include <cmath>
#include <numbers>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/answers.h"
#include "interp/channel.h"
#include "interp/radius_compensation.h"
#include "interp/tool_in_use.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;
using nc::SystemQuantity;
using Write = ControlAccess::Write;

/// Which offset of a tool is written.
static constexpr std::size_t kOffsetNumber =
    parameter_of_all<"number", Function::ToolOffsetData, Function::LatheOffsetData>();

bool ToolInUse::has_edge(std::int64_t tool, std::int64_t edge) const {
    return tool >= 1 && tool <= rules_.tool_offsets && edge >= 0 && edge <= ToolOffsets::kMostEdges;
}

Write ToolInUse::set_edge_offset(SystemQuantity quantity, std::int64_t tool, std::int64_t edge,
                                 double value) {
    if (!has_edge(tool, edge)) return Write::NoSuchEntry;
    const std::int64_t number = ToolOffsets::of_edge(tool, edge);
    return set_tool_offset(*tool_offsets_.column_of(quantity, number), number, value);
}

Write ToolInUse::set_tool_offset(ToolOffsets::Column column, std::int64_t number, double value) {
    if (number < 1 || ToolOffsets::tool_of(number) > rules_.tool_offsets) return Write::NoSuchEntry;
    const double mm_per_unit = units_ == ProgrammedUnits::Inch ? kMmPerInch / 10 : 1;
    constexpr double kRounding = 1e-9;  // of a value that was worked out in inches
    if (rules_.most_tool_offset > 0 &&
        std::abs(value) > rules_.most_tool_offset * mm_per_unit + kRounding)
        return Write::TooLarge;
    constexpr double kMostTip = 9;
    const bool is_tip = value >= 0 && value <= kMostTip && value == std::floor(value);
    if (column == ToolOffsets::Column::Tip && !is_tip) return Write::TooLarge;
    tool_offsets_.set(column, number, value);
    if (rules_.tool_offsets_act_at_once) expect_length();
    return Write::Done;
}

bool ToolInUse::set_tool_datum(std::int64_t number, std::int64_t datum_and_edge, double value) {
    const std::int64_t edge = datum_and_edge % nc::kDatum;
    if (!has_edge(number, edge)) return false;
    tool_offsets_.set_datum(ToolOffsets::of_edge(number, edge), datum_and_edge / nc::kDatum, value);
    return true;
}

Write ToolInUse::set_active_datum(std::int64_t datum, double value) {
    const std::int64_t number = tool_.edge_number();
    if (const auto column = ToolOffsets::column_of_datum(datum))
        return set_tool_offset(*column, number, value);
    if (number < 1 || datum < 1 || datum > ToolOffsets::kMostNumberedDatum)
        return Write::NoSuchEntry;
    tool_offsets_.set_datum(number, datum, value);
    return Write::Done;
}

Write ToolInUse::set_extra(SystemQuantity quantity, std::int64_t first, double value) {
    if (quantity == SystemQuantity::ExtraLength && (first < 1 || first > 3))
        return Write::NoSuchEntry;
    if (quantity == SystemQuantity::ExtraAlong) {
        const auto axis = channel_.answers.axis_of(first);
        if (!axis || index(*axis) > 2) return Write::NoSuchEntry;
        extra_.lengths.setZero();
        extra_.along[static_cast<Eigen::Index>(index(*axis))] = value;
    } else if (quantity != SystemQuantity::ExtraRadius) {
        extra_.along.setZero();
        extra_.lengths[quantity == SystemQuantity::ExtraBoth ? 0 : first - 1] = value;
    }
    const bool is_of_radius =
        quantity == SystemQuantity::ExtraRadius || quantity == SystemQuantity::ExtraBoth;
    if (is_of_radius) extra_.radius = value;
    expect_length();
    if (is_of_radius && comp_.is_on())
        channel_.compensation.send_comp(
            channel_.compensation.comp_change({}, CompChange::Kind::Set));
    return Write::Done;
}

void ToolInUse::write_tool_offset(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kColumn = parameter_of<Function::ToolOffsetData>("column");
    constexpr std::size_t kValue = parameter_of<Function::ToolOffsetData>("value");
    const std::int64_t number = std::llround(block.argument(invocation, kOffsetNumber));
    const ToolOffsets::Column column =
        tool_offsets_.column_at(std::llround(block.argument(invocation, kColumn)), number);
    double value = block.argument(invocation, kValue);
    if (modal_.is_incremental) value += tool_offsets_.value(column, number);
    put_tool_offset(block, invocation, column, value);
}

void ToolInUse::write_lathe_offset(const Block& block, const Invocation& invocation) {
    struct Word {
        std::size_t parameter;
        SystemQuantity geometry;
        SystemQuantity wear;
        bool is_added = false;
    };
    static constexpr std::array kWords = {
        Word{parameter_of<Function::LatheOffsetData>("x"), SystemQuantity::CrossGeometry,
             SystemQuantity::CrossWear},
        Word{parameter_of<Function::LatheOffsetData>("z"), SystemQuantity::LengthGeometry,
             SystemQuantity::LengthWear},
        Word{parameter_of<Function::LatheOffsetData>("radius"), SystemQuantity::RadiusGeometry,
             SystemQuantity::RadiusWear},
        Word{parameter_of<Function::LatheOffsetData>("tip"), SystemQuantity::ToolTip,
             SystemQuantity::ToolTip},
        Word{parameter_of<Function::LatheOffsetData>("dx"), SystemQuantity::CrossGeometry,
             SystemQuantity::CrossWear, true},
        Word{parameter_of<Function::LatheOffsetData>("dz"), SystemQuantity::LengthGeometry,
             SystemQuantity::LengthWear, true},
        Word{parameter_of<Function::LatheOffsetData>("dradius"), SystemQuantity::RadiusGeometry,
             SystemQuantity::RadiusWear, true},
    };
    const bool is_geometry =
        block.argument(invocation, parameter_of<Function::LatheOffsetData>("geometry")) != 0;
    const std::int64_t number = std::llround(block.argument(invocation, kOffsetNumber));
    for (const Word& word : kWords) {
        if (!invocation.has(word.parameter)) continue;
        const auto column =
            *tool_offsets_.column_of(is_geometry ? word.geometry : word.wear, number);
        double value = block.argument(invocation, word.parameter);
        if (word.geometry == SystemQuantity::CrossGeometry)
            value *= axes_.word_scale[index(Axis::X)];
        if (word.is_added) value += tool_offsets_.value(column, number);
        put_tool_offset(block, invocation, column, value);
        if (reporter_.has_ended()) return;
    }
}

void ToolInUse::put_tool_offset(const Block& block, const Invocation& invocation,
                                ToolOffsets::Column column, double value) {
    const std::int64_t number = std::llround(block.argument(invocation, kOffsetNumber));
    switch (set_tool_offset(column, number, value)) {
        case Write::NoSuchEntry:
            reporter_.report(diag::OffsetDataNumber, block, invocation.function).arg(number);
            return;
        case Write::TooLarge:
            reporter_.report(diag::OffsetDataValue, block, invocation.function).arg(value);
            return;
        case Write::Done:
        case Write::Refused: return;
    }
}

}  // namespace kadr::interp
