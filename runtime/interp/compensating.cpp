// compensating.cpp — what switches the cutter radius compensation, and what passes through it.
#include <algorithm>
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
        send_comp({CompChange::Kind::Leave, {}, modal_.plane, 0, position_.base});
        return;
    }
    if (actions.radius_comp != Function::None && actions.radius_comp != comp_.side) {
        begin_comp(block, actions.radius_comp);
        return;
    }
    if (comp_.side == Function::RadiusCompOff) return;
    send_comp({CompChange::Kind::Set, comp_settings(), modal_.plane, comp_distance(block),
               position_.base});
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
            compensation_.set_distance(change.distance);
            break;
        case CompChange::Kind::Begin:
            // From one side to the other: the contour so far ends on its normal.
            if (compensation_.is_on()) flush_comp();
            if (ended_) return;
            compensation_.begin(change.settings, change.plane, change.distance, change.here);
            break;
    }
}

void Executor::begin_comp(const Block& block, Function side) {
    if (machine_.is_lathe) {
        report(diag::RadiusCompUnsupported, block, side);
        return;
    }
    comp_.side = side;
    const double distance = comp_distance(block);
    if (ended_) return;
    send_comp({CompChange::Kind::Begin, comp_settings(), modal_.plane, distance, position_.base});
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

/// Of the cutter's centre from the contour, mm, positive to the left. A frame that mirrors the
/// plane changes the side.
double Executor::comp_distance(const Block& block) {
    const bool by_offset = rules_.comp_radius_by_offset || tool_.radius_offset != 0;
    const bool has_edge = tool_.source != Tool::Source::None;
    const std::int64_t number = by_offset ? tool_.radius_offset : has_edge ? tool_.current : 0;
    if (number == 0 && !by_offset) {
        report(diag::CompWithoutTool, block, comp_.side);
        return 0;
    }
    const double radius = tool_offsets_.radius(number);
    const bool is_known_gap =
        std::find(unknown_radii_.begin(), unknown_radii_.end(), number) != unknown_radii_.end();
    if (radius == 0 && number != 0 && !is_known_gap) {
        unknown_radii_.push_back(number);
        report(diag::CompRadiusUnknown, block, comp_.side).arg(number);
    }
    const bool is_left =
        (comp_.side == Function::RadiusCompLeft) != frames_.is_mirrored(modal_.plane);
    return (radius + comp_.allowance) * (is_left ? 1 : -1);
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
