#include <array>
#include <cmath>
#include <numbers>

#include "interp/answers.h"
#include "interp/carriers.h"
#include "interp/channel.h"
#include "interp/programmed_frames.h"
#include "interp/spindles.h"
#include "interp/tool_in_use.h"

namespace kadr::interp {

using nc::Quantity;
using Write = ControlAccess::Write;

Write Answers::set_quantity(Quantity quantity, std::int64_t first, std::int64_t second,
                            double value, bool acts_at_once) {
    switch (quantity) {
        case Quantity::WorkOffset: {
            const auto axis = axis_of(second);
            return axis ? channel_.frames.set_work_offset(first, *axis, value, acts_at_once)
                        : Write::NoSuchEntry;
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
        case Quantity::ThirdBase:
            return channel_.tool.set_edge_offset(quantity, first, second, value);
        case Quantity::CrossGeometry:
        case Quantity::CrossWear:
            return channel_.tool.set_tool_offset(*tool_offsets_.column_of(quantity, first), first,
                                                 value * axes_.word_scale[index(Axis::X)]);
        case Quantity::EdgeNumberOf: {
            const std::int64_t before = tool_offsets_.number_of(first, second);
            const auto number = static_cast<std::int64_t>(std::floor(value));
            if (!tool_offsets_.give_number(first, second, number)) return Write::NoSuchEntry;
            if (tool_.current == first && tool_.edge == before) tool_.edge = number;
            return Write::Done;
        }
        case Quantity::ToolDatum:
            return channel_.tool.set_tool_datum(first, second, value) ? Write::Done
                                                                      : Write::NoSuchEntry;
        case Quantity::ActiveToolDatum: return channel_.tool.set_active_datum(first, value);
        case Quantity::CarrierDatum:
        case Quantity::CarrierAxis:
            return channel_.carriers.set_carrier(quantity, first, second, value);
        case Quantity::FirstExtraLength:
            return channel_.tool.set_extra(Quantity::ExtraLength, 1, value);
        case Quantity::ExtraLength:
        case Quantity::ExtraAlong:
        case Quantity::ExtraRadius:
        case Quantity::ExtraBoth: return channel_.tool.set_extra(quantity, first, value);
        case Quantity::Timer: set_timer(first, value); return Write::Done;
        case Quantity::EdgeSpeed: return set_edge_speed(value);
        case Quantity::ChannelBaseMask:
        case Quantity::GlobalBaseMask: return channel_.frames.set_base_mask(quantity, value);
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
Write Answers::set_edge_speed(double value) {
    const double radius = tool_offsets_.radius(tool_.edge_number()) + extra_.radius;
    if (!(radius > 0) || !(value > 0)) return Write::NoSuchEntry;
    constexpr double kMmPerM = 1000;
    channel_.spindles.set_speed_later(kMmPerM * value / (2 * std::numbers::pi * radius));
    return Write::Done;
}

}  // namespace kadr::interp
