// carrier_words.cpp — tool carriers in a program: TCARR, TCOABS and TCOFR, their data, and what the
// program can ask of the one that acts. S 7.1.
//
// A carrier is part of the tool's length: what it makes of the lengths acts along each axis with
// that axis' next motion, as another tool does, and no rotary axis moves. What a table has done to
// the workpiece's zero is the frame of the tables; PAROT turns that frame along.
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "base/diagnostics/orienting.h"
#include "base/units.h"
#include "interp/carriers.h"
#include "interp/channel.h"
#include "interp/programmed_frames.h"
#include "interp/tilted_planes.h"
#include "interp/tool_in_use.h"
#include "interp/transformation.h"
#include "machine/tilted_plane.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::SystemQuantity;
using path::Vec3;
using Write = ControlAccess::Write;

namespace {

constexpr std::size_t kFirstAngle = 13;

bool is_carrier_number(std::int64_t number) {
    return number >= 1 && number <= ToolCarriers::kMostCarriers;
}

/// What can be read of a carrier; one that nobody has written has no vectors and no angles.
const CarrierData& data_or_none(const ToolCarriers& carriers, std::int64_t number) {
    static const CarrierData none;
    const CarrierData* const data = carriers.find(number);
    return data == nullptr ? none : *data;
}

/// Which of the three names of a carrier a system variable is.
std::size_t name_place(SystemQuantity quantity) {
    return quantity == SystemQuantity::CarrierName        ? 0
           : quantity == SystemQuantity::CarrierFirstName ? 1
                                                          : 2;
}

}  // namespace

Carriers::Carriers(Channel& channel)
    : channel_(channel),
      machine_(channel.state.machine),
      reporter_(channel.state.reporter),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      carriers_(channel.state.tool.carriers),
      carrier_(channel.state.tool.carrier),
      orienting_(channel.state.tool.orienting),
      tilted_plane_(channel.state.tool.tilted_plane),
      virtual_(channel.state.tool.virtual_axes),
      comp_(channel.state.stage.comp),
      axes_(channel.state.axes) {}

void Carriers::choose_carrier(const Block& block, const Invocation& invocation, Actions& actions) {
    switch (invocation.function) {
        case Function::ToolCarrier:
            carrier_.number = std::llround(
                block.argument(invocation, parameter_of<Function::ToolCarrier>("number")));
            break;
        case Function::CarrierByFrame:
            carrier_.frame_axis = static_cast<int>(std::clamp(
                block.argument(invocation, parameter_of<Function::CarrierByFrame>("axis")), 0.0,
                3.0));
            break;
        case Function::CarrierByData: carrier_.frame_axis = 0; break;
        default: break;  // no other is sent here
    }
    actions.programs_carrier = true;
}

bool Carriers::takes_carrier(const Block& block, const Actions& actions) const {
    if (actions.programs_carrier)
        return carrier_.number != 0 || carrier_.stand || block.find(Function::ToolCarrier);
    return carrier_.stand && (actions.tool_change || block.find(Function::ToolEdge) != nullptr);
}

void Carriers::take_carrier(const Block& block) {
    const Function word =
        block.find(Function::ToolCarrier) != nullptr ? Function::ToolCarrier : Function::None;
    if (carrier_.number == 0) {
        if (carrier_.stand) end_carrier();
        channel_.tilted_planes.drop_carry(block);
        return;
    }
    if (orienting_.is_on || virtual_.axes.is_on()) {
        reporter_.report(diag::IsoNotSupported, block, word)
            .arg("a tool carrier under a transformation");
        return;
    }
    const bool ends_comp = block.find(Function::RadiusCompOff) != nullptr;
    if (comp_.is_on() && word != Function::None && !ends_comp) {
        reporter_.report(diag::CarrierCompensated, block, word);
        return;
    }
    const CarrierData* const data = carriers_.find(carrier_.number);
    if (data == nullptr) {
        reporter_.report(diag::CarrierUnknown, block, word).arg(carrier_.number);
        return;
    }
    const std::optional<Carrier> stand = standing_carrier(block, *data);
    if (!stand) return;
    channel_.tilted_planes.drop_carry(block);
    carrier_.stand = stand;
    lay_on_carrier();
    channel_.tool.expect_length();
}

/// The carrier with the angles that its data, the axes or the frame give; nothing: it was reported.
std::optional<Carrier> Carriers::standing_carrier(const Block& block, const CarrierData& data) {
    std::optional<Carrier> carrier = carrier_of(data);
    if (!carrier) {
        reporter_.report(diag::CarrierKindUnknown, block).arg(data.kind);
        return std::nullopt;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& axis = data.axes[i];
        const bool is_led = axis && (axes_.present & bit(*axis)) != 0;
        carrier->angles[i] =
            rad_from_deg(is_led ? position_.base()[index(*axis)] : data.values[kFirstAngle + i]);
    }
    if (carrier_.frame_axis == 0) return carrier;
    CarrierQuery query;
    query.tool = Vec3::Unit(carrier_.frame_axis - 1);
    // As the frame lies on a table that is not rotated.
    query.frame =
        (frames_.tables().linear.transpose() * frames_.total().direction(query.tool)).normalized();
    query.near = carrier->angles;
    const auto aligned = laid_along(*carrier, data, query);
    if (aligned) return *aligned;
    reporter_.report(diag::CarrierUnreachable, block)
        .arg(carrier_.number)
        .arg(aligned.error() == CarrierFault::Limits ? "the limits of its axes forbid it"
                                                     : "its axes do not lead there");
    return std::nullopt;
}

void Carriers::lay_on_carrier() {
    path::Frame tables = path::translation(carrier_.stand->table_shift());
    if (tilted_plane_.on_tables) tables.linear = carrier_.stand->table();
    frames_.set_tables(tables);
    channel_.frames.frame_changed();
}

void Carriers::end_carrier() {
    carrier_.number = 0;
    carrier_.stand.reset();
    frames_.set_tables(
        tilted_plane_.on_tables && machine_.kinematics
            ? machine::table_frame(machine_.kinematics->chain,
                                   channel_.transformation.joints_of(position_.base()))
            : path::Frame{});
    channel_.frames.frame_changed();
    channel_.tool.expect_length();
}

bool Carriers::leave_carrier() {
    if (!carrier_.stand) return false;
    carrier_.number = 0;
    carrier_.stand.reset();
    channel_.tool.take_wanted_lengths();
    return true;
}

Done Carriers::require_no_carrier(const Block& block, Function function) {
    if (!carrier_.stand || function == Function::TcpOff) return kDone;
    reporter_.report(diag::IsoNotSupported, block, function)
        .arg("a transformation beside a tool carrier");
    return kFailed;
}

bool Carriers::is_turned_by_carrier() const {
    return carrier_.stand && !carrier_.stand->head().isApprox(path::Mat3::Identity(), 1e-12);
}

bool Carriers::is_plane_on_carrier() const {
    const Vec3 normal = path::unit(path::axes_of(modal_.plane).normal);
    const Vec3 tool = carrier_.stand->head() * normal;
    constexpr double kSame = 1e-6;  // rad: angles are written with some four decimals of a degree
    return tool.cross(frames_.total().direction(normal).normalized()).norm() < kSame;
}

// ------------------------------------------------------------------------------ data

std::optional<double> Carriers::carrier_quantity(SystemQuantity quantity, std::int64_t first,
                                                 std::int64_t second) const {
    const auto& stand = carrier_.stand;
    switch (quantity) {
        case SystemQuantity::ActiveCarrier: return static_cast<double>(stand ? carrier_.number : 0);
        case SystemQuantity::CarrierSolutions: return stand ? stand->solutions : 0;
        case SystemQuantity::CarrierAngle:
        case SystemQuantity::CarrierLeftOver: {
            if (first < 1 || first > 2) return std::nullopt;
            if (!stand) return 0;
            const auto i = static_cast<std::size_t>(first) - 1;
            return deg_from_rad(quantity == SystemQuantity::CarrierAngle ? stand->angles[i]
                                                                         : stand->left_over[i]);
        }
        default: break;
    }
    if (!is_carrier_number(first)) return std::nullopt;
    const CarrierData& data = data_or_none(carriers_, first);
    const auto datum = static_cast<std::size_t>(second / nc::kDatum);
    if (quantity == SystemQuantity::CarrierDatum) return data.values.at(datum);
    const auto& axis = data.axes.at(datum - 1);
    return axis ? -1.0 - static_cast<double>(index(*axis)) : 0.0;
}

Write Carriers::set_carrier(SystemQuantity quantity, std::int64_t first, std::int64_t second,
                            double value) {
    const auto datum = static_cast<std::size_t>(second / nc::kDatum);
    const bool forgets = quantity == SystemQuantity::CarrierDatum && datum == 1 && value == 0;
    if (first == 0 && forgets) {
        carriers_.clear();
        return Write::Done;
    }
    if (!is_carrier_number(first)) return Write::NoSuchEntry;
    CarrierData& data = carriers_.at(first);
    if (quantity == SystemQuantity::CarrierDatum) {
        data.values.at(datum) = value;
        return Write::Done;
    }
    auto& axis = data.axes.at(datum - 1);
    if (value == 0) axis.reset();
    else axis = static_cast<Axis>(static_cast<int>(-value) - 1);
    return Write::Done;
}

std::optional<std::string> Carriers::carrier_text(SystemQuantity quantity,
                                                  std::int64_t number) const {
    if (!is_carrier_number(number)) return std::nullopt;
    const CarrierData& data = data_or_none(carriers_, number);
    return quantity == SystemQuantity::CarrierKind ? data.kind : data.names[name_place(quantity)];
}

Write Carriers::set_carrier_text(SystemQuantity quantity, std::int64_t number,
                                 std::string_view text) {
    if (!is_carrier_number(number)) return Write::NoSuchEntry;
    CarrierData& data = carriers_.at(number);
    (quantity == SystemQuantity::CarrierKind ? data.kind : data.names[name_place(quantity)]) = text;
    return Write::Done;
}

}  // namespace kadr::interp
