// tool_length.cpp — the length of the tool: along which axis it acts, and when it moves the axes.
#include "base/diagnostics/iso.h"
#include "base/diagnostics/orienting.h"
#include "base/numbers.h"
#include "interp/channel.h"
#include "interp/danger_watch.h"
#include "interp/motions.h"
#include "interp/path_smoothing.h"
#include "interp/stages.h"
#include "interp/tool_in_use.h"
#include "interp/tool_motion.h"
#include "interp/transformation.h"
#include "machine/kinematics.h"
#include "machine/tilted_plane.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using path::Command;
using path::Op;
using path::Vec3;

namespace {

path::Plane plane_with_normal(Axis axis) {
    switch (axis) {
        case Axis::X: return path::Plane::Yz;
        case Axis::Y: return path::Plane::Zx;
        default: return path::Plane::Xy;
    }
}

}  // namespace

/// The axis along which the chief length of the tool lies.
Axis ToolInUse::wanted_length_axis() const {
    const bool is_turned =
        tool_.source != Tool::Source::None && tool_offsets_.is_turning(tool_.length_number());
    if (is_turned || rules_.length_axis == nc::LengthAxis::Z) return Axis::Z;
    return path::axes_of(modal_.plane).normal;
}

Vec3 ToolInUse::wanted_lengths() const {
    Vec3 lengths = Vec3::Zero();
    const std::int64_t number = tool_.source == Tool::Source::None ? 0 : tool_.length_number();
    if (number == 0) return lengths;
    const auto put = [&](Axis axis, std::size_t part) {
        const double extra = extra_.lengths[static_cast<Eigen::Index>(part) - 1] + sum_offset(part);
        if ((axes_.present & bit(axis)) != 0)
            lengths[static_cast<Eigen::Index>(index(axis))] =
                tool_offsets_.length(part, number) + extra;
    };
    const bool goes_by_plane = rules_.length_axis == nc::LengthAxis::Plane;
    if (tool_offsets_.is_turning(number)) {
        // Lengths of a machine's tool are given by their axes.
        const bool is_typed = tool_offsets_.type(number) != 0;
        const auto axes = path::axes_of(goes_by_plane && is_typed ? modal_.plane : path::Plane::Zx);
        put(axes.second, 1);
        put(axes.first, 2);
        put(axes.normal, 3);
    } else if (goes_by_plane) {
        const auto axes = path::axes_of(modal_.plane);
        put(axes.normal, 1);
        put(axes.second, 2);
        put(axes.first, 3);
    } else {
        put(Axis::Z, 1);
    }
    lengths += extra_.along;
    if (carrier_.stand) return carrier_.stand->length(lengths);
    const bool is_taken_off = tool_.source == Tool::Source::Offset && tool_.is_taken_off;
    return is_taken_off ? Vec3(-lengths) : lengths;
}

/// A machine without a tool table has no lengths; a table with a gap is likely a mistake.
void ToolInUse::check_length_known(const Block& block) {
    const std::int64_t number = tool_.source == Tool::Source::None ? 0 : tool_.length_number();
    if (number == 0 || machine_.tools.empty() || tool_offsets_.is_known(number)) return;
    const std::int64_t tool = ToolOffsets::tool_of(number);
    if (!reported_.first_time(NoticeEach::Tool, tool)) return;
    reporter_.report(diag::ToolUnknown, block).arg(tool);
}

Vec3 ToolInUse::activate_length(const Block& block, AxisMask moved) {
    const Axis axis = wanted_length_axis();
    if ((moved & bit(axis)) != 0) {
        check_length_known(block);
        channel_.dangers.watch_length(block, axis);
    }
    const Vec3 wanted = wanted_lengths();
    Vec3 lengths = tool_.lengths;
    AxisMask changed = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        if ((moved >> i & 1u) == 0 || lengths[at] == wanted[at]) continue;
        lengths[at] = wanted[at];
        changed = static_cast<AxisMask>(changed | 1u << i);
    }
    // The watch looks at the first motion along the axis, whatever moves before.
    const bool is_by_number = tool_.source == Tool::Source::Offset && tool_.length_number() != 0;
    const bool is_unwatched =
        is_by_number && (moved & bit(axis)) == 0 && dangers_.tool != tool_.current;
    tool_.has_changed = lengths != wanted || is_unwatched;
    if (changed == 0) return Vec3::Zero();
    const Vec3 shift = length_shift_of(lengths);
    Vec3 carried = shift - length_shift_of(tool_.lengths);
    if (orienting_.is_on)
        carried = machine::rotation_of(machine_.kinematics->chain,
                                       channel_.transformation.joints_of(position_.base())) *
                  (lengths - tool_.lengths);
    tool_.lengths = lengths;
    tool_.axis = axis;
    set_length_shift(shift);
    put_tool_length(block, axis).changed = changed;
    return -carried;
}

Done ToolInUse::activate_length_on_arc(const Block& block, const Vec3& normal, AxisMask moved) {
    const Vec3 delta = activate_length(block, moved);
    const double aside = (delta - delta.dot(normal) * normal).norm();
    if (aside <= rules_.arc_tolerance) return kDone;
    reporter_.report(diag::ArcLengthChange, block, modal_.motion).arg(round_to(aside, 4));
    return kFailed;
}

path::ToolLength& ToolInUse::put_tool_length(const Block& block, Axis axis) {
    const bool is_turned = tilted_plane_.carries || tilted_plane_.turns > 0;
    const Vec3 carried = is_turned ? length_shift_of(tool_.lengths) : tool_.lengths;
    const auto chief = static_cast<Eigen::Index>(index(axis));
    path::ToolLength& length = channel_.stages.put(Op::ToolLength, block).tool_length();
    length.plane = plane_with_normal(axis);
    const std::int64_t number = tool_.source == Tool::Source::None ? 0 : tool_.length_number();
    length.number = ToolOffsets::tool_of(number);
    length.length = carried[chief];
    length.aside = carried;
    length.aside[chief] = 0;
    length.is_swivelled = is_turned || carrier_.stand.has_value();
    if (carrier_.stand) length.direction = carrier_.stand->head() * path::unit(axis);
    if (tilted_plane_.turns > 0) length.direction = frames_.tilt().direction(Vec3::UnitZ());
    else if (tilted_plane_.carries)
        length.direction = machine::tool_in_base(machine_.kinematics->chain, tilted_plane_.joints);
    return length;
}

void ToolInUse::move_length_alone(const Block& block) {
    if (!rules_.length_moves_alone) return;
    const Vec3 wanted = wanted_lengths();
    AxisMask changed = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        if (wanted[at] != tool_.lengths[at]) changed = static_cast<AxisMask>(changed | 1u << i);
    }
    if (changed == 0) {
        check_length_known(block);
        return;
    }
    channel_.motions.line(block, {position_.here(), position_.base(), changed},
                          modal_.motion == Function::Rapid ? Op::Rapid : Op::Line,
                          channel_.smoothing.stops_exactly());
}

void ToolInUse::move_behind_switch(const Block& block) {
    if (!rules_.length_moves_alone) return;
    const AxisMask moved =
        orienting_.is_on ? static_cast<AxisMask>(kLinearXYZ | channel_.transformation.joint_axes())
                         : kLinearXYZ;
    Target here{position_.here(), position_.base(), moved};
    if (orienting_.is_on) channel_.tool_motion.settle_orientation(here);
    channel_.motions.line(block, here, modal_.motion == Function::Rapid ? Op::Rapid : Op::Line,
                          channel_.smoothing.stops_exactly());
}

void ToolInUse::set_length_shift(const Vec3& shift) {
    for (std::size_t i = 0; i < 3; ++i) length_shift_[i] = shift[static_cast<Eigen::Index>(i)];
}

Vec3 ToolInUse::length_shift_of(const Vec3& lengths) const {
    if (orienting_.is_on) return Vec3::Zero();
    if (tilted_plane_.turns > 0) return frames_.tilt().direction(lengths);
    if (!tilted_plane_.carries) return lengths;
    return -machine::head_offset(machine_.kinematics->chain, tilted_plane_.joints, -lengths);
}

}  // namespace kadr::interp
