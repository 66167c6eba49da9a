// What a program writes: work offsets and tool offsets.
#include <array>
#include <cmath>
#include <numbers>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/executor.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;
using nc::Quantity;
using Write = ControlAccess::Write;

/// Which offset of a tool is written.
static constexpr std::size_t kOffsetNumber =
    parameter_of_all<"number", Function::ToolOffsetData, Function::LatheOffsetData>();

/// Offsets that the machine file does not name are zero, as in a new control.
control::ControlFrame Executor::work_offset_frame(std::int64_t number) const {
    const auto of = [this](std::size_t i) {
        return i < work_offsets_.size() ? work_offsets_[i] : control::ControlFrame();
    };
    const control::ControlFrame own = of(static_cast<std::size_t>(number));
    return rules_.external_work_offset && number != 0 ? chain(of(0), own) : own;
}

control::ControlFrame& Executor::work_offset_at(std::int64_t number) {
    const auto i = static_cast<std::size_t>(number);
    if (i >= work_offsets_.size()) work_offsets_.resize(i + 1);
    return work_offsets_[i];
}

void Executor::work_offset_changed(std::int64_t number, bool acts_at_once) {
    const bool acts = number == work_offset_ || (rules_.external_work_offset && number == 0);
    if (!acts_at_once || !acts) return;
    frames_.select_work_offset(work_offset_frame(work_offset_));
    frame_changed();
}

Write Executor::set_quantity(Quantity quantity, std::int64_t first, std::int64_t second,
                             double value, bool acts_at_once) {
    switch (quantity) {
        case Quantity::WorkOffset: {
            const auto axis = axis_of(second);
            return axis ? set_work_offset(first, *axis, value, acts_at_once) : Write::NoSuchEntry;
        }
        case Quantity::LengthGeometry:
        case Quantity::LengthWear:
        case Quantity::RadiusGeometry:
        case Quantity::RadiusWear:
        case Quantity::ToolTip:
        case Quantity::ToolType:
        case Quantity::FirstLength:
        case Quantity::FirstWear:
        case Quantity::SecondLength:
        case Quantity::SecondWear:
        case Quantity::ThirdLength:
        case Quantity::ThirdWear:
        case Quantity::FirstBase:
        case Quantity::SecondBase:
        case Quantity::ThirdBase: return set_edge_offset(quantity, first, second, value);
        case Quantity::CrossGeometry:
        case Quantity::CrossWear:
            return set_tool_offset(*tool_offsets_.column_of(quantity, first), first,
                                   value * axes_.word_scale[index(Axis::X)]);
        case Quantity::EdgeNumberOf: {
            const std::int64_t before = tool_offsets_.number_of(first, second);
            const auto number = static_cast<std::int64_t>(std::floor(value));
            if (!tool_offsets_.give_number(first, second, number)) return Write::NoSuchEntry;
            if (tool_.current == first && tool_.edge == before) tool_.edge = number;
            return Write::Done;
        }
        case Quantity::ToolDatum:
            return set_tool_datum(first, second, value) ? Write::Done : Write::NoSuchEntry;
        case Quantity::ActiveToolDatum: return set_active_datum(first, value);
        case Quantity::CarrierDatum:
        case Quantity::CarrierAxis: return set_carrier(quantity, first, second, value);
        case Quantity::FirstExtraLength: return set_extra(Quantity::ExtraLength, 1, value);
        case Quantity::ExtraLength:
        case Quantity::ExtraAlong:
        case Quantity::ExtraRadius:
        case Quantity::ExtraBoth: return set_extra(quantity, first, value);
        case Quantity::Timer: set_timer(first, value); return Write::Done;
        case Quantity::EdgeSpeed: return set_edge_speed(value);
        case Quantity::ChannelBaseMask:
        case Quantity::GlobalBaseMask: return set_base_mask(quantity, value);
        case Quantity::SuppressedPanel: return dynamics_.suppress_panel(value);
        case Quantity::Milliseconds:
            clocks_.milliseconds_from = value - run_time() * 1000;
            return Write::Done;
        case Quantity::Hours: clocks_.hours_from = value - run_time() / 3600; return Write::Done;
        default: return Write::Refused;
    }
}

/// The spindle gets the speed at which the tool's radius moves so fast, m/min; the motion side is
/// told with the next block.
Write Executor::set_edge_speed(double value) {
    const double radius = tool_offsets_.radius(tool_.edge_number()) + extra_.radius;
    if (!(radius > 0) || !(value > 0)) return Write::NoSuchEntry;
    constexpr double kMmPerM = 1000;
    spindle_.speed = kMmPerM * value / (2 * std::numbers::pi * radius);
    owes_speed_ = true;
    return Write::Done;
}

Write Executor::set_work_offset(std::int64_t number, Axis axis, double value, bool acts_at_once) {
    if (number < 0 || number > rules_.work_offsets) return Write::NoSuchEntry;
    finish_open_spline();
    work_offset_at(number).shift[index(axis)] = value;
    work_offset_changed(number, acts_at_once);
    return Write::Done;
}

/// Whether there may be such a tool and such an edge of it; an edge that is not said is 0.
bool Executor::has_edge(std::int64_t tool, std::int64_t edge) const {
    return tool >= 1 && tool <= rules_.tool_offsets && edge >= 0 && edge <= ToolOffsets::kMostEdges;
}

Write Executor::set_edge_offset(Quantity quantity, std::int64_t tool, std::int64_t edge,
                                double value) {
    if (!has_edge(tool, edge)) return Write::NoSuchEntry;
    const std::int64_t number = ToolOffsets::of_edge(tool, edge);
    return set_tool_offset(*tool_offsets_.column_of(quantity, number), number, value);
}

Write Executor::set_tool_offset(ToolOffsets::Column column, std::int64_t number, double value) {
    if (number < 1 || ToolOffsets::tool_of(number) > rules_.tool_offsets) return Write::NoSuchEntry;
    const double mm_per_unit = units_ == Units::Inch ? kMmPerInch / 10 : 1;
    constexpr double kRounding = 1e-9;  // of a value that was worked out in inches
    if (rules_.most_tool_offset > 0 &&
        std::abs(value) > rules_.most_tool_offset * mm_per_unit + kRounding)
        return Write::TooLarge;
    constexpr double kMostTip = 9;
    const bool is_tip = value >= 0 && value <= kMostTip && value == std::floor(value);
    if (column == ToolOffsets::Column::Tip && !is_tip) return Write::TooLarge;
    tool_offsets_.set(column, number, value);
    if (rules_.tool_offsets_act_at_once) tool_.has_changed = true;
    return Write::Done;
}

/// `datum_and_edge`: the number of the datum a thousand times, and the cutting edge.
bool Executor::set_tool_datum(std::int64_t number, std::int64_t datum_and_edge, double value) {
    const std::int64_t edge = datum_and_edge % nc::kDatum;
    if (!has_edge(number, edge)) return false;
    tool_offsets_.set_datum(ToolOffsets::of_edge(number, edge), datum_and_edge / nc::kDatum, value);
    return true;
}

/// Of the edge that acts, whose data are the same by its number, $TC_DPx[T,D].
Write Executor::set_active_datum(std::int64_t datum, double value) {
    const std::int64_t number = tool_.edge_number();
    if (const auto column = ToolOffsets::column_of_datum(datum))
        return set_tool_offset(*column, number, value);
    if (number < 1 || datum < 1 || datum > ToolOffsets::kMostNumberedDatum)
        return Write::NoSuchEntry;
    tool_offsets_.set_datum(number, datum, value);
    return Write::Done;
}

/// Acts with the next motion; S 5.1. Whether the two kinds of lengths end each other is not told
/// (unsure).
Write Executor::set_extra(Quantity quantity, std::int64_t first, double value) {
    if (quantity == Quantity::ExtraLength && (first < 1 || first > 3)) return Write::NoSuchEntry;
    if (quantity == Quantity::ExtraAlong) {
        const auto axis = axis_of(first);
        if (!axis || index(*axis) > 2) return Write::NoSuchEntry;
        extra_.lengths.setZero();
        extra_.along[static_cast<Eigen::Index>(index(*axis))] = value;
    } else if (quantity != Quantity::ExtraRadius) {
        extra_.along.setZero();
        extra_.lengths[quantity == Quantity::ExtraBoth ? 0 : first - 1] = value;
    }
    const bool is_of_radius = quantity == Quantity::ExtraRadius || quantity == Quantity::ExtraBoth;
    if (is_of_radius) extra_.radius = value;
    tool_.has_changed = true;
    if (is_of_radius && comp_.is_on()) send_comp(comp_change({}, CompChange::Kind::Set));
    return Write::Done;
}

void Executor::write_data(const Block& block, const Invocation& invocation) {
    switch (invocation.function) {
        case Function::WorkOffsetData: write_work_offset(block, invocation); break;
        case Function::LatheOffsetData: write_lathe_offset(block, invocation); break;
        case Function::ToolOffsetData: write_tool_offset(block, invocation); break;
        default: break;  // no other is sent here
    }
}

void Executor::write_work_offset(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kNumber = parameter_of<Function::WorkOffsetData>("number");
    constexpr std::size_t kX = parameter_of<Function::WorkOffsetData>("x");
    const std::int64_t number = std::llround(block.argument(invocation, kNumber));
    if (number < 0 || number > rules_.work_offsets) {
        reporter_.report(diag::OffsetDataNumber, block, invocation.function).arg(number);
        return;
    }
    for (std::size_t i = 0; i < kAxes; ++i) {
        if (!invocation.has(kX + i)) continue;
        const auto axis = static_cast<Axis>(i);
        if ((axes_.present & bit(axis)) == 0) {
            reporter_.report(diag::AxisMissing, block, invocation.function).arg(kAxisNames[i]);
            return;
        }
        double value = block.argument(invocation, kX + i) * axes_.word_scale[i];
        const auto n = static_cast<std::size_t>(number);
        if (modal_.is_incremental && n < work_offsets_.size()) value += work_offsets_[n].shift[i];
        set_work_offset(number, axis, value, true);
    }
}

void Executor::write_tool_offset(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kColumn = parameter_of<Function::ToolOffsetData>("column");
    constexpr std::size_t kValue = parameter_of<Function::ToolOffsetData>("value");
    const std::int64_t number = std::llround(block.argument(invocation, kOffsetNumber));
    const ToolOffsets::Column column =
        tool_offsets_.column_at(std::llround(block.argument(invocation, kColumn)), number);
    double value = block.argument(invocation, kValue);
    if (modal_.is_incremental) value += tool_offsets_.value(column, number);
    put_tool_offset(block, invocation, column, value);
}

/// Which columns of the offset the parameters are. The place of the tip is no wear.
void Executor::write_lathe_offset(const Block& block, const Invocation& invocation) {
    struct Word {
        std::size_t parameter;
        Quantity geometry;
        Quantity wear;
        bool is_added = false;
    };
    static constexpr std::array kWords = {
        Word{parameter_of<Function::LatheOffsetData>("x"), Quantity::CrossGeometry,
             Quantity::CrossWear},
        Word{parameter_of<Function::LatheOffsetData>("z"), Quantity::LengthGeometry,
             Quantity::LengthWear},
        Word{parameter_of<Function::LatheOffsetData>("radius"), Quantity::RadiusGeometry,
             Quantity::RadiusWear},
        Word{parameter_of<Function::LatheOffsetData>("tip"), Quantity::ToolTip, Quantity::ToolTip},
        Word{parameter_of<Function::LatheOffsetData>("dx"), Quantity::CrossGeometry,
             Quantity::CrossWear, true},
        Word{parameter_of<Function::LatheOffsetData>("dz"), Quantity::LengthGeometry,
             Quantity::LengthWear, true},
        Word{parameter_of<Function::LatheOffsetData>("dradius"), Quantity::RadiusGeometry,
             Quantity::RadiusWear, true},
    };
    const bool is_geometry =
        block.argument(invocation, parameter_of<Function::LatheOffsetData>("geometry")) != 0;
    const std::int64_t number = std::llround(block.argument(invocation, kOffsetNumber));
    for (const Word& word : kWords) {
        if (!invocation.has(word.parameter)) continue;
        const auto column =
            *tool_offsets_.column_of(is_geometry ? word.geometry : word.wear, number);
        double value = block.argument(invocation, word.parameter);
        if (word.geometry == Quantity::CrossGeometry) value *= axes_.word_scale[index(Axis::X)];
        if (word.is_added) value += tool_offsets_.value(column, number);
        put_tool_offset(block, invocation, column, value);
        if (has_ended()) return;
    }
}

void Executor::put_tool_offset(const Block& block, const Invocation& invocation,
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
