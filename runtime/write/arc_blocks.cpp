#include "write/arc_blocks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/done.h"
#include "base/units.h"

namespace kadr::write {

namespace {

/// Leaves in the part those functions of the block that act in it: what stops is the last one's.
void keep_functions_of_part(const Block& block, bool is_first, bool is_last, Block& part) {
    part.arguments = block.arguments;
    part.argument_count = block.argument_count;
    part.function_count = 0;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Function function = block.functions[i].function;
        const bool is_behind =
            has_fact(function, Fact::StopsProgram) || function == Function::ExactStopOnce;
        if (is_behind ? is_last : is_first)
            part.functions[part.function_count++] = block.functions[i];
    }
}

/// Whether the block orients the tool: that cannot be shared out among parts.
bool has_direction(const Block& block) { return block.find(Fact::ToolWord) != nullptr; }

/// Whether the points of a helix are known so far that its turns can be shared out; reports it if
/// not.
[[nodiscard]] Done require_known_turns(const TextView& text, BlockMessages& messages,
                                       const Block& block) {
    const std::array<std::size_t, 3> axes = text.plane_axes();
    const WrittenPosition& start = text.modal.position;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto slot = static_cast<Slot>(axis);
        const bool is_in_plane = axis == axes[0] || axis == axes[1];
        const bool is_center_absolute =
            is_in_plane && (block.absolute & block.given & bit(center_slot(axis))) != 0;
        const bool is_coordinate = block.has(slot) && !text.is_distance(block, axis);
        if ((start.known >> axis & 1u) != 0 || !(is_coordinate || is_center_absolute)) continue;
        messages.position_unknown(block, kAxisNames[axis], axis);
        return kFailed;
    }
    return kDone;
}

/// The ends of the parts, as shares of the angle: no part is close to half a turn or to a full one,
/// and by its radius none above a third.
void set_ends(ArcParts& parts, bool has_centers) {
    constexpr double kThird = kTurnRad / 3;
    constexpr double kAlmostFull = 5.5;  // rad
    const double sweep = parts.arc.sweep;
    if (!has_centers && sweep > 2 * kThird) {
        parts.ends = {1.0 / 3, 2.0 / 3, 1.0};
        parts.count = 3;
        return;
    }
    parts.ends = {sweep < kAlmostFull ? 0.5 : 1.0 / 3, 1.0};
    parts.count = 2;
}

/// Where a part ends, in the plane.
PlanePoint end_of(const ArcParts& parts, std::size_t part) {
    const PlannedArc& arc = parts.arc;
    if (part + 1 == parts.count) return arc.points.end;
    const auto radius_at = [&](const PlanePoint& point) {
        return std::hypot(point[0] - arc.center[0], point[1] - arc.center[1]);
    };
    const double first_angle =
        std::atan2(arc.points.start[1] - arc.center[1], arc.points.start[0] - arc.center[0]);
    const double direction = arc.is_clockwise ? -1 : 1;
    const double angle = first_angle + direction * arc.sweep * parts.ends[part];
    const double at =
        std::lerp(radius_at(arc.points.start), radius_at(arc.points.end), parts.ends[part]);
    return {arc.center[0] + at * std::cos(angle), arc.center[1] + at * std::sin(angle)};
}

/// How much of the whole angle lies before the end of a part.
double share_at(const ArcParts& parts, std::size_t part) {
    const double total = kTurnRad * parts.turns + parts.arc.sweep;
    return (kTurnRad * parts.turns + parts.arc.sweep * parts.ends[part]) / total;
}

/// What a part has of the block beside its points.
Block frame_of(const ArcParts& parts, std::size_t part) {
    const Block& block = parts.block;
    Block out;
    if (part == 0) {
        out = block;
        out.given &= ~(kTargetSlots | kCenterSlots | bit(Slot::Radius));
    } else {
        out.source = block.source;
        out.skip_level = block.skip_level;
        out.further_skip_levels = block.further_skip_levels;
        out.motion = block.motion;
        out.feed_along_arc = block.feed_along_arc;
    }
    keep_functions_of_part(block, part == 0, part + 1 == parts.count, out);
    const SlotMask programmed = block.given & kTargetSlots;
    out.incremental = block.incremental & programmed;
    out.absolute = block.absolute & programmed;
    return out;
}

}  // namespace

std::optional<ArcParts> parts_of_arc(const TextView& text, BlockMessages& messages,
                                     const Block& block) {
    const std::optional<PlannedArc> arc = planned_arc(text, block);
    if (!arc) return std::nullopt;
    const auto& [start, end, text_start, text_end] = arc->points;
    if (std::hypot(end[0] - start[0], end[1] - start[1]) < kSame) return std::nullopt;
    if (!is_on_circle(text, arc->points, arc->center)) return std::nullopt;  // has its message
    const CenterGrid grid = center_grid(text, block);
    // Two roundings, and what the program itself misses the circle by.
    const double most =
        grid.end_increment + std::pow(10.0, -grid.decimals) + radius_miss(arc->points, arc->center);
    if (text_error(text, block, *arc) <= most) return std::nullopt;
    if (has_direction(block)) {
        messages.cannot_express(block,
                                "an arc whose rounded words say another one, beside a direction of "
                                "the tool");
        return std::nullopt;
    }
    ArcParts parts;
    parts.block = block;
    parts.arc = *arc;
    parts.axes = text.plane_axes();
    const bool has_first = text.has_address(center_slot(parts.axes[0]));
    set_ends(parts, has_first && text.has_address(center_slot(parts.axes[1])));
    parts.begin = text.modal.position;
    parts.turns = block.has(Slot::Turns) ? std::nearbyint(block.at(Slot::Turns)) : 0;
    parts.by_radius = block.has(Slot::Radius) && !has_first;
    parts.shares_time = text.modal.meant_of(Group::FeedMode) == Function::FeedInverseTime &&
                        (block.has(Slot::Feed) || text.modal.has_meant_feed);
    parts.feed = block.has(Slot::Feed) ? block.at(Slot::Feed) : text.modal.meant_feed;
    return parts;
}

Block block_of(const ArcParts& parts, std::size_t part, const TextView& text) {
    const Block& block = parts.block;
    const PlannedArc& arc = parts.arc;
    const bool is_last = part + 1 == parts.count;
    const PlanePoint from = part == 0 ? arc.points.start : end_of(parts, part - 1);
    const PlanePoint to = end_of(parts, part);
    const double share_before = part == 0 ? 0 : share_at(parts, part - 1);
    const double share = share_at(parts, part);
    Block out = frame_of(parts, part);
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t axis = parts.axes[i];
        const auto slot = static_cast<Slot>(axis);
        const double scale = text.to_text(slot, 1);
        const double base = text.is_distance(block, axis) ? from[i] : 0;
        if (block.has(slot) || !is_last || to[i] != arc.points.start[i])
            out.set(slot, (to[i] - base) / scale / arc.part[i]);
        if (!parts.by_radius) out.set(center_slot(axis), (arc.center[i] - from[i]) / scale);
    }
    if (parts.by_radius) out.set(Slot::Radius, std::fabs(block.at(Slot::Radius)));
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto slot = static_cast<Slot>(axis);
        if (axis == parts.axes[0] || axis == parts.axes[1] || !block.has(slot)) continue;
        const bool is_distance = text.is_distance(block, axis);
        const double distance = block.at(slot) - (is_distance ? 0 : parts.begin.meant[axis]);
        out.set(slot, is_distance ? distance * (share - share_before)
                      : is_last   ? block.at(slot)
                                  : parts.begin.meant[axis] + distance * share);
    }
    // Under inverse time the time of the block is shared out by the angle.
    if (parts.shares_time) out.set(Slot::Feed, parts.feed / (share - share_before));
    return out;
}

// ---------------------------------------------------------------- turns of a helix

namespace {

/// Whether the block is a helix that the control is not told of.
bool is_straightened(const TextView& text, const Block& block) {
    const bool has_helices = text.tables.rules.helix_written;
    if (has_helices || !is_arc(text.effective_motion(block))) return false;
    if (text.modal.meant_of(Group::Plane) == Function::None) return false;
    const std::size_t across = text.plane_axes()[2];
    const auto slot = static_cast<Slot>(across);
    if (!block.has(slot)) return false;
    return text.is_distance(block, across)
               ? block.at(slot) != 0
               : (text.modal.position.known >> across & 1u) == 0 ||
                     block.at(slot) != text.modal.position.meant[across];
}

/// How many lines are as near to the helix as a contour is cut.
int chords_of(const HelixTurns& helix) {
    constexpr double kChord = 0.005;  // mm between an arc and its chord; half the tolerance of arcs
    constexpr int kMost = 100'000;
    const double radius =
        std::hypot(helix.from[0] - helix.center[0], helix.from[1] - helix.center[1]);
    const double total = kTurnRad * helix.turns + helix.rest;
    const double step = radius > 2 * kChord ? 2 * std::acos(1 - kChord / radius) : kTurnRad / 4;
    return static_cast<int>(std::clamp(std::ceil(total / step), 1.0, double{kMost}));
}

}  // namespace

std::optional<HelixTurns> turns_of(const TextView& text, BlockMessages& messages,
                                   const Block& block) {
    const bool is_in_lines = is_straightened(text, block);
    const bool is_whole = !block.has(Slot::Turns) || text.has_address(Slot::Turns);
    if (is_whole && !is_in_lines) return std::nullopt;
    const Function motion = text.effective_motion(block);
    const double asked = block.has(Slot::Turns) ? block.at(Slot::Turns) : 0;
    HelixTurns helix;
    helix.block = block;
    // No further turns are what every arc has; what cannot be travelled has its message.
    const bool is_sane =
        (asked > 0 || (is_in_lines && asked == 0)) && asked <= kMostTurns && is_arc(motion);
    if (asked > 0 && motion == Function::None)
        messages.cannot_express(block, "turns of an unknown motion");
    if (!is_sane || !require_known_turns(text, messages, block)) return helix;
    helix.is_shared = true;
    helix.motion = motion;
    helix.is_incremental = text.modal.meant_of(Group::Distance) == Function::Incremental;
    helix.turns = static_cast<int>(std::lround(asked));
    helix.axes = text.plane_axes();
    const WrittenPosition& start = text.modal.position;
    helix.begin = start.meant;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto slot = static_cast<Slot>(axis);
        helix.end[axis] = !block.has(slot)                ? start.meant[axis]
                          : text.is_distance(block, axis) ? start.meant[axis] + block.at(slot)
                                                          : block.at(slot);
    }
    PlanePoint to{};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t axis = helix.axes[i];
        helix.from[i] = start.meant[axis] * text.on_part(axis);
        to[i] = helix.end[axis] * text.on_part(axis);
    }
    helix.center = meant_center(text, block, helix.from, to);
    helix.rest = sweep_angle(helix.from, to, helix.center, motion == Function::ArcCw);
    // Under inverse time the time of the block is shared out by the angle.
    helix.shares_time =
        text.modal.meant_of(Group::FeedMode) == Function::FeedInverseTime && block.has(Slot::Feed);
    if (helix.shares_time)
        helix.inverse_time = block.at(Slot::Feed) * (kTurnRad * helix.turns + helix.rest);
    if (is_in_lines) helix.chords = chords_of(helix);
    return helix;
}

Block chord_of(const HelixTurns& helix, int chord, const TextView& text) {
    const Block& block = helix.block;
    Block line;
    if (chord == 1) {
        line = block;
        line.given &= ~(kTargetSlots | kCenterSlots | bit(Slot::Radius) | bit(Slot::Turns));
        line.incremental = line.absolute = 0;
    }
    line.source = block.source;
    line.skip_level = block.skip_level;
    line.motion = Function::Line;
    const double total = kTurnRad * helix.turns + helix.rest;
    if (helix.shares_time) line.set(Slot::Feed, helix.inverse_time * helix.chords / total);
    const double part = static_cast<double>(chord) / helix.chords;
    const double radius =
        std::hypot(helix.from[0] - helix.center[0], helix.from[1] - helix.center[1]);
    const double turned = helix.motion == Function::ArcCw ? -total * part : total * part;
    const double angle =
        std::atan2(helix.from[1] - helix.center[1], helix.from[0] - helix.center[0]) + turned;
    const PlanePoint on_part{helix.center[0] + radius * std::cos(angle),
                             helix.center[1] + radius * std::sin(angle)};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto slot = static_cast<Slot>(axis);
        const bool is_first = axis == helix.axes[0];
        const bool is_in_plane = is_first || axis == helix.axes[1];
        if (!is_in_plane && !block.has(slot)) continue;
        const double at = chord == helix.chords ? helix.end[axis]
                          : is_in_plane
                              ? on_part[is_first ? 0 : 1] / text.on_part(axis)
                              : helix.begin[axis] + (helix.end[axis] - helix.begin[axis]) * part;
        const bool as_distance =
            block.has(slot) ? text.is_distance(block, axis) : helix.is_incremental;
        line.set(slot, as_distance ? at - text.modal.position.meant[axis] : at);
        if (as_distance && !helix.is_incremental) line.incremental |= bit(slot);
        if (!as_distance && helix.is_incremental) line.absolute |= bit(slot);
    }
    return line;
}

Block circle_of(const HelixTurns& helix, int turn, const TextView& text) {
    const Block& block = helix.block;
    Block circle;
    if (turn == 1) {
        circle = block;
        circle.given &= ~(kTargetSlots | kCenterSlots | bit(Slot::Radius) | bit(Slot::Turns));
        circle.incremental = circle.absolute = 0;
        circle.comment.clear();
    }
    circle.source = block.source;
    circle.skip_level = block.skip_level;
    circle.motion = helix.motion;
    if (helix.shares_time) circle.set(Slot::Feed, helix.inverse_time / kTurnRad);
    for (std::size_t i = 0; i < 2; ++i)
        circle.set(center_slot(helix.axes[i]), helix.center[i] - helix.from[i]);
    const double total = kTurnRad * helix.turns + helix.rest;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto slot = static_cast<Slot>(axis);
        if (axis == helix.axes[0] || axis == helix.axes[1] || !block.has(slot)) continue;
        const double at =
            helix.begin[axis] + (helix.end[axis] - helix.begin[axis]) * kTurnRad * turn / total;
        const bool as_distance = text.is_distance(block, axis);
        circle.set(slot, as_distance ? at - text.modal.position.meant[axis] : at);
        if (as_distance && !helix.is_incremental) circle.incremental |= bit(slot);
        if (!as_distance && helix.is_incremental) circle.absolute |= bit(slot);
    }
    return circle;
}

Block rest_of(const HelixTurns& helix, const TextView& text) {
    Block rest = helix.block;
    rest.given &= ~bit(Slot::Turns);
    if (!helix.is_shared) return rest;
    if (helix.shares_time) rest.set(Slot::Feed, helix.inverse_time / helix.rest);
    // Of a distance it has what the circles have left.
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto slot = static_cast<Slot>(axis);
        if (axis == helix.axes[0] || axis == helix.axes[1] || !rest.has(slot)) continue;
        if (text.is_distance(helix.block, axis))
            rest.set(slot, helix.end[axis] - text.modal.position.meant[axis]);
    }
    rest.function_count = 0;
    rest.argument_count = 0;
    return rest;
}

}  // namespace kadr::write
