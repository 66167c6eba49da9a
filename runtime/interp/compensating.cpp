// compensating.cpp — what switches the cutter radius compensation, and what passes through it.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "interp/executor.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;

namespace {

constexpr std::size_t kCheckedBlocks = 3;  // MD20240 CUTCOM_MAXNUM_CHECK_BLOCKS

/// Where the tip lies, seen from the centre of the nose, in Z and X.
path::Vec2 tip_direction(int tip) {
    static constexpr std::array<std::array<double, 2>, 10> kZx = {
        {{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0, 0}}};
    const auto& [z, x] = kZx[static_cast<std::size_t>(tip)];
    return {z, x};
}

}  // namespace

void Executor::choose_comp(const Block& block, const Invocation& invocation, Actions& actions) {
    actions.comp_changed = true;
    switch (invocation.function) {
        case Function::RadiusOffset:
            tool_.radius_offset = std::llround(block.argument(invocation, 0));
            break;
        case Function::CompStartNormal:
        case Function::CompStartAround: comp_.start = invocation.function; break;
        case Function::CompCornerArc:
        case Function::CompCornerIntersection: comp_.corner = invocation.function; break;
        case Function::CompCheckOn: comp_.has_check = true; break;
        case Function::CompCheckOff: comp_.has_check = false; break;
        case Function::CompAllowance: comp_.allowance = block.argument(invocation, 0); break;
        default: actions.radius_comp = invocation.function; break;
    }
}

/// The choices of a block count together, whatever their order in it.
void Executor::act_on_comp(const Block& block, const Actions& actions) {
    if (actions.radius_comp == Function::RadiusCompOff) {
        comp_.side = Function::RadiusCompOff;
        send_comp({CompChange::Kind::Leave, {}, modal_.plane, {}, position_.base});
        return;
    }
    if (actions.radius_comp != Function::None && actions.radius_comp != comp_.side) {
        begin_comp(block, actions.radius_comp);
        return;
    }
    if (comp_.side == Function::RadiusCompOff) return;
    send_comp(
        {CompChange::Kind::Set, comp_settings(), modal_.plane, comp_tool(block), position_.base});
}

/// At its place among the commands: behind a corner that is not known yet.
void Executor::send_comp(const CompChange& change) {
    if (corners_.is_active()) return corners_.change(change);
    change_comp(change);
}

void Executor::change_comp(const CompChange& change) {
    switch (change.kind) {
        case CompChange::Kind::Leave: compensation_.leave(); break;
        case CompChange::Kind::Set:
            compensation_.set_settings(change.settings);
            compensation_.set_tool(change.tool);
            break;
        case CompChange::Kind::Begin:
            // From one side to the other: the contour so far ends on its normal.
            if (compensation_.is_on()) flush_comp();
            if (ended_) return;
            compensation_.begin(change.settings, change.plane, change.tool, change.here);
            break;
    }
}

void Executor::begin_comp(const Block& block, Function side) {
    comp_.side = side;
    const CompTool tool = comp_tool(block);
    if (ended_) return;
    send_comp({CompChange::Kind::Begin, comp_settings(), modal_.plane, tool, position_.base});
}

CompSettings Executor::comp_settings() const {
    CompSettings settings;
    path::CompRules& corners = settings.corners;
    corners.outside = comp_.corner == Function::CompCornerArc ? path::OutsideCorner::Arc
                      : comp_.corner == Function::CompCornerIntersection
                          ? path::OutsideCorner::Intersection
                          : rules_.comp_corner;
    corners.limit = rad_from_deg(rules_.comp_corner_limit);
    corners.sharp = rules_.comp_sharp_corner;
    corners.extends_tangents = rules_.comp_extends_tangents;
    corners.leaves_out = comp_.has_check;
    corners.look_ahead = comp_.has_check
                             ? kCheckedBlocks
                             : static_cast<std::size_t>(std::max(1, rules_.comp_look_ahead));
    settings.start = comp_.start == Function::CompStartNormal   ? CompStart::Normal
                     : comp_.start == Function::CompStartAround ? CompStart::Around
                                                                : rules_.comp_start;
    settings.feed = rules_.comp_feed;
    settings.empty_blocks = rules_.comp_empty_blocks;
    settings.more_empty_is_fault = rules_.comp_more_empty_is_alarm;
    return settings;
}

/// Of the cutter's centre from the contour, positive to the left: a frame that mirrors the plane
/// changes the side. A lathe's tool is programmed by its tip.
CompTool Executor::comp_tool(const Block& block) {
    const bool by_offset = rules_.comp_radius_by_offset || tool_.radius_offset != 0;
    const bool has_edge = tool_.source != Tool::Source::None;
    const std::int64_t number = by_offset ? tool_.radius_offset : has_edge ? tool_.current : 0;
    if (number == 0 && !by_offset) {
        report(diag::CompWithoutTool, block, comp_.side);
        return {};
    }
    const double radius = tool_offsets_.radius(number);
    const int tip = tool_offsets_.tip(number);
    const bool is_known_gap =
        std::find(unknown_radii_.begin(), unknown_radii_.end(), number) != unknown_radii_.end();
    const bool has_no_tip = machine_.is_lathe && radius != 0 && tip == 0;
    if ((radius == 0 || has_no_tip) && number != 0 && !is_known_gap) {
        unknown_radii_.push_back(number);
        if (has_no_tip) report(diag::CompTipUnknown, block, comp_.side).arg(number);
        else report(diag::CompRadiusUnknown, block, comp_.side).arg(number);
    }
    const bool is_left =
        (comp_.side == Function::RadiusCompLeft) != frames_.is_mirrored(modal_.plane);
    CompTool tool;
    tool.distance = (radius + comp_.allowance) * (is_left ? 1 : -1);
    if (machine_.is_lathe && modal_.plane == path::Plane::Zx)
        tool.center = -radius * tip_direction(tip);
    return tool;
}

/// What a block has put goes through the compensation; what is settled of it goes out.
///
/// here     where the tool is behind the block, not compensated
/// is_last  no block waits behind it
void Executor::settle_comp(const Block& block, const AxisValues& here, bool is_last) {
    std::optional<CompAlarm> alarm;
    if (!alarmed_ && modal_.plane != compensation_.plane()) {
        report(diag::CompPlane, block);
    } else if (!alarmed_ && cycle_blocks_) {
        report(diag::CompMotion, block);
    } else if (!alarmed_ && frames_.is_tilted(modal_.plane)) {
        report(diag::IsoNotSupported, block).arg("cutter radius compensation in a tilted plane");
    }
    if (!alarmed_) alarm = compensation_.end_block(here, block);
    if (!alarmed_ && !alarm && ended_ && is_last) alarm = compensation_.flush();
    for (path::Command& command : compensation_.settled()) output_.next() = std::move(command);
    compensation_.settled().clear();
    if (alarm) report_comp(*alarm);
}

void Executor::flush_comp() {
    const std::optional<CompAlarm> alarm = compensation_.flush();
    for (path::Command& command : compensation_.settled()) output_.next() = std::move(command);
    compensation_.settled().clear();
    if (alarm) report_comp(*alarm);
}

void Executor::report_comp(const CompAlarm& alarm) {
    Block at{};
    at.source = alarm.source;
    at.line = alarm.line;
    report(*alarm.row, at);
}

}  // namespace kadr::interp
