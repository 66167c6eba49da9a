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

using nc::SystemQuantity;
using Write = ControlAccess::Write;

Write Answers::set_quantity(SystemQuantity quantity, std::int64_t first, std::int64_t second,
                            double value, bool acts_at_once) {
    switch (quantity) {
        case SystemQuantity::WorkOffset: {
            const auto axis = axis_of(second);
            return axis ? channel_.frames.set_work_offset(first, *axis, value, acts_at_once)
                        : Write::NoSuchEntry;
        }
        case SystemQuantity::LengthGeometry:
        case SystemQuantity::LengthWear:
        case SystemQuantity::RadiusGeometry:
        case SystemQuantity::RadiusWear:
        case SystemQuantity::ToolTip:
        case SystemQuantity::ToolType:
        case SystemQuantity::FirstLength:
        case SystemQuantity::FirstWear:
        case SystemQuantity::SecondLength:
        case SystemQuantity::SecondWear:
        case SystemQuantity::ThirdLength:
        case SystemQuantity::ThirdWear:
        case SystemQuantity::FirstBase:
        case SystemQuantity::SecondBase:
        case SystemQuantity::ThirdBase:
            return channel_.tool.set_edge_offset(quantity, first, second, value);
        case SystemQuantity::CrossGeometry:
        case SystemQuantity::CrossWear:
            return channel_.tool.set_tool_offset(*tool_offsets_.column_of(quantity, first), first,
                                                 value * axes_.word_scale[index(Axis::X)]);
        case SystemQuantity::EdgeNumberOf: {
            const std::int64_t before = tool_offsets_.number_of(first, second);
            const auto number = static_cast<std::int64_t>(std::floor(value));
            if (!tool_offsets_.give_number(first, second, number)) return Write::NoSuchEntry;
            if (tool_.current == first && tool_.edge == before) tool_.edge = number;
            return Write::Done;
        }
        case SystemQuantity::ToolDatum:
            return channel_.tool.set_tool_datum(first, second, value) ? Write::Done
                                                                      : Write::NoSuchEntry;
        case SystemQuantity::ActiveToolDatum: return channel_.tool.set_active_datum(first, value);
        case SystemQuantity::CarrierDatum:
        case SystemQuantity::CarrierAxis:
            return channel_.carriers.set_carrier(quantity, first, second, value);
        case SystemQuantity::FirstExtraLength:
            return channel_.tool.set_extra(SystemQuantity::ExtraLength, 1, value);
        case SystemQuantity::ExtraLength:
        case SystemQuantity::ExtraAlong:
        case SystemQuantity::ExtraRadius:
        case SystemQuantity::ExtraBoth: return channel_.tool.set_extra(quantity, first, value);
        case SystemQuantity::Timer: set_timer(first, value); return Write::Done;
        case SystemQuantity::EdgeSpeed: return set_edge_speed(value);
        case SystemQuantity::ChannelBaseMask:
        case SystemQuantity::GlobalBaseMask: return channel_.frames.set_base_mask(quantity, value);
        case SystemQuantity::SuppressedPanel: return dynamics_.suppress_panel(value);
        case SystemQuantity::Milliseconds:
            clocks_.milliseconds_from = value - run_time() * 1000;
            return Write::Done;
        case SystemQuantity::Hours:
            clocks_.hours_from = value - run_time() / 3600;
            return Write::Done;
        default: return Write::Refused;
    }
}

/// The spindle gets the speed at which the tool's radius moves so fast, m/min; it is commanded with
/// the next block.
Write Answers::set_edge_speed(double value) {
    const double radius = tool_offsets_.radius(tool_.edge_number()) + extra_.radius;
    if (!(radius > 0) || !(value > 0)) return Write::NoSuchEntry;
    constexpr double kMmPerM = 1000;
    channel_.spindles.set_speed_later(kMmPerM * value / (2 * std::numbers::pi * radius));
    return Write::Done;
}

}  // namespace kadr::interp
