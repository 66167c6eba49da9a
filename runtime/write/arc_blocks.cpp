// Arcs that need other blocks than their own: several turns, almost half a turn, too small an arc.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "base/diagnostics/dialect.h"
#include "base/numbers.h"
#include "write/block_writer.h"

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

/// Whether the block says how the tool stands: that cannot be shared out among parts.
bool has_direction(const Block& block) { return block.find(Fact::ToolWord) != nullptr; }

}  // namespace

/// Whether the points of a helix are known so far that its turns can be shared out; says so if not.
Done BlockWriter::require_known_turns(const Block& block) {
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    const WrittenPosition& start = modal_.position;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto slot = static_cast<Slot>(axis);
        const bool is_in_plane = axis == axes[0] || axis == axes[1];
        const bool is_center_absolute =
            is_in_plane && (block.absolute & block.given & bit(center_slot(axis))) != 0;
        const bool is_coordinate = block.has(slot) && !text_.is_distance(block, axis);
        if ((start.known >> axis & 1u) != 0 || !(is_coordinate || is_center_absolute)) continue;
        messages_.position_unknown(block, kAxisNames[axis]);
        return kFailed;
    }
    return kDone;
}

/// The arc of the block as it is meant and as the text has its ends, with the plane and the
/// dimensions that are in force; none if it is no arc whose points and centre are known.
std::optional<BlockWriter::PlannedArc> BlockWriter::planned_arc(const Block& block) const {
    const bool may_be_diameter = text_.plane_axes()[1] == kX && !text_.knows_diameter();
    std::optional<PlannedArc> arc = planned_arc(block, text_.on_part(kX));
    if (!arc || !may_be_diameter || block.has(Slot::Radius)) return arc;
    // Where no word says what X is, the circle on which start and end lie does.
    std::optional<PlannedArc> other = planned_arc(block, 0.5);
    const bool is_other =
        other && is_on_circle(other->points, other->center) &&
        radius_miss(other->points, other->center) < radius_miss(arc->points, arc->center);
    return is_other ? other : arc;
}

/// x_part   what a coordinate of X is multiplied with
std::optional<BlockWriter::PlannedArc> BlockWriter::planned_arc(const Block& block,
                                                                double x_part) const {
    const Function motion = text_.effective_motion(block);
    if (!is_arc(motion) || modal_.meant[index_of(Group::Plane)] == Function::None)
        return std::nullopt;
    if (!block.has(Slot::Radius) && (block.given & kCenterSlots) == 0) return std::nullopt;
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    const WrittenPosition& start = modal_.position;
    if (!is_chord_known(block, start)) return std::nullopt;
    PlannedArc arc;
    arc.is_clockwise = motion == Function::ArcCw;
    ArcPoints& points = arc.points;
    std::array<bool, 2> is_center_absolute{};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto slot = static_cast<Slot>(axes[i]);
        const Slot center = center_slot(axes[i]);
        is_center_absolute[i] = (block.absolute & block.given & bit(center)) != 0;
        if (!text_.has_address(slot) || (is_center_absolute[i] && !text_.is_known(axes[i])))
            return std::nullopt;
        const double scale = text_.to_text(slot, 1);
        const double part = axes[i] == kX ? x_part : 1;
        arc.part[i] = part;
        const double begin = start.meant[axes[i]];
        const double end = !block.has(slot)                    ? begin
                           : text_.is_distance(block, axes[i]) ? begin + block.at(slot)
                                                               : block.at(slot);
        points.start[i] = begin * scale * part;
        points.end[i] = end * scale * part;
        points.text_start[i] = start.text[axes[i]] * scale * part;
        points.text_end[i] = block.has(slot) ? round_to(end * scale, text_.decimals(slot)) * part
                                             : points.text_start[i];
        const double said = block.has(center) ? block.at(center) * scale : 0;
        arc.center[i] = is_center_absolute[i] ? said : points.start[i] + said;
    }
    if (block.has(Slot::Radius)) {
        const double scale = text_.to_text(static_cast<Slot>(axes[0]), 1);
        const auto center =
            center_of_radius(points.start, points.end, block.at(Slot::Radius) * scale,
                             arc.is_clockwise, kHalfTurnSlack * scale);
        if (!center) return std::nullopt;
        arc.center = *center;
    }
    arc.sweep = sweep_angle(points.start, points.end, arc.center, arc.is_clockwise);
    return arc;
}

/// By how much the control's path leaves the arc if the block is written in one piece, in the
/// text's units; infinity if it is another one.
double BlockWriter::text_error(const Block& block, const PlannedArc& arc) const {
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    const double scale = text_.to_text(static_cast<Slot>(axes[0]), 1);
    const bool has_centers =
        text_.has_address(center_slot(axes[0])) && text_.has_address(center_slot(axes[1]));
    if (block.has(Slot::Radius) && axes[1] == kX && !text_.knows_diameter())
        return 0;  // place_radius
    if (block.has(Slot::Radius) && text_.has_address(Slot::Radius)) {
        const RadiusArc by_radius =
            radius_arc(arc.points, block.at(Slot::Radius) * scale, text_.decimals(Slot::Radius),
                       arc.is_clockwise, scale);
        if (by_radius.fits) return 0;
        if (!has_centers) {
            if (!by_radius.reached) return std::numeric_limits<double>::infinity();
            const TracedArc traced =
                traced_arc(arc.points, *by_radius.reached, arc.is_clockwise, false);
            return path_error(arc.points, arc.center, arc.sweep, arc.is_clockwise, traced,
                              text_.end_increment());
        }
    }
    if (!has_centers) return 0;  // what cannot be said has its message
    const CenterGrid grid = center_grid(block);
    const PlanePoint words = center_words(arc.points, arc.center, grid);
    PlanePoint center = words;
    if (!grid.is_absolute) {
        for (std::size_t i = 0; i < 2; ++i) center[i] += arc.points.text_start[i];
    }
    const TracedArc traced =
        traced_arc(arc.points, center, arc.is_clockwise, rules_.arc_error == ArcError::ShiftCenter);
    return path_error(arc.points, arc.center, arc.sweep, arc.is_clockwise, traced,
                      grid.increment());
}

/// Whether rounding takes an arc away: its end falls on its start or beside it, which a control
/// would take for a full circle, or it is smaller than two increments, so that its rounded words
/// say any angle. An arc of more than half a turn is one that a full circle stands for well.
bool BlockWriter::vanishes(const Block& block) const {
    if (block.has(Slot::Turns) && std::lround(block.at(Slot::Turns)) != 0) return false;
    const std::optional<PlannedArc> arc = planned_arc(block);
    if (!arc) return false;
    const auto& [start, end, text_start, text_end] = arc->points;
    const double increment = text_.end_increment();
    const double chord = std::hypot(end[0] - start[0], end[1] - start[1]);
    const double radius = std::hypot(start[0] - arc->center[0], start[1] - arc->center[1]);
    if (chord < kSame)  // a full circle is meant, or nothing
        return !block.has(Slot::Radius) && radius > kSame && radius < increment / 2;
    // Neither an arc whose radius does not span its chord nor one whose end is off its circle.
    if (chord > 2 * radius + increment) return false;
    if (radius < 2 * increment) return true;
    constexpr double kNear = 4;  // increments; no rounding turns longer chords round
    const double text_chord = std::hypot(text_end[0] - text_start[0], text_end[1] - text_start[1]);
    if (arc->sweep >= std::numbers::pi) return false;
    // A line that is nowhere a quarter of an increment beside the arc, where a control would refuse
    // that because its centre lies aside of the rounded ends.
    const bool is_flat = chord * chord / (8 * radius) < increment / 4;
    if (text_chord > kNear * increment) return is_flat && std::isinf(text_error(block, *arc));
    return text_chord < increment / 4 || std::isinf(text_error(block, *arc));
}

/// Arcs that rounding spoils are written in two parts: almost a full circle, where the direction
/// from end to start is noise of the rounding, and almost half a turn, where a control that moves
/// the centre moves it far.
BlockWriter::Written BlockWriter::split_arc(const Block& block, std::string& out) {
    const std::optional<PlannedArc> arc = planned_arc(block);
    if (!arc) return Written::NotYet;
    const auto& [start, end, text_start, text_end] = arc->points;
    if (std::hypot(end[0] - start[0], end[1] - start[1]) < kSame) return Written::NotYet;
    if (!is_on_circle(arc->points, arc->center)) return Written::NotYet;  // that has its message
    const CenterGrid grid = center_grid(block);
    // Two roundings, and what the program itself misses the circle by.
    const double most =
        grid.end_increment + std::pow(10.0, -grid.decimals) + radius_miss(arc->points, arc->center);
    if (text_error(block, *arc) <= most) return Written::NotYet;
    if (has_direction(block)) {
        messages_.cannot_express(
            block,
            "an arc whose rounded words say another one, beside a direction of "
            "the tool");
        return Written::NotYet;
    }
    // No part is close to half a turn or to a full one, and by its radius none above a third.
    const double sweep = arc->sweep;
    constexpr double kThird = 2 * std::numbers::pi / 3;
    const bool has_centers = text_.has_address(center_slot(text_.plane_axes()[0])) &&
                             text_.has_address(center_slot(text_.plane_axes()[1]));
    if (!has_centers && sweep > 2 * kThird) {
        write_parts(block, *arc, std::array{1.0 / 3, 2.0 / 3, 1.0}, out);
    } else {
        constexpr double kAlmostFull = 5.5;  // rad
        write_parts(block, *arc, std::array{sweep < kAlmostFull ? 0.5 : 1.0 / 3, 1.0}, out);
    }
    return Written::Already;
}

/// Writes the arc in parts that end at these shares of its angle, the last one at 1. What stops or
/// ends the program comes behind the last part, other functions before the first; additional turns
/// come first, as everywhere.
void BlockWriter::write_parts(const Block& block, const PlannedArc& arc,
                              std::span<const double> ends, std::string& out) {
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    const WrittenPosition begin = modal_.position;
    const double turns = block.has(Slot::Turns) ? std::nearbyint(block.at(Slot::Turns)) : 0;
    const double total = 2 * std::numbers::pi * turns + arc.sweep;
    const bool by_radius = block.has(Slot::Radius) && !text_.has_address(center_slot(axes[0]));
    const double radius = std::fabs(block.has(Slot::Radius) ? block.at(Slot::Radius) : 0);
    const auto radius_at = [&](const PlanePoint& point) {
        return std::hypot(point[0] - arc.center[0], point[1] - arc.center[1]);
    };
    const double first_radius = radius_at(arc.points.start);
    const double last_radius = radius_at(arc.points.end);
    const double first_angle =
        std::atan2(arc.points.start[1] - arc.center[1], arc.points.start[0] - arc.center[0]);
    const double direction = arc.is_clockwise ? -1 : 1;
    const bool shares_time = modal_.meant_of(Group::FeedMode) == Function::FeedInverseTime &&
                             (block.has(Slot::Feed) || modal_.has_meant_feed);
    const double feed = block.has(Slot::Feed) ? block.at(Slot::Feed) : modal_.meant_feed;

    PlanePoint from = arc.points.start;
    double share_before = 0;  // of the whole angle
    is_part_ = true;
    for (std::size_t n = 0; n < ends.size(); ++n) {
        const bool is_first = n == 0;
        const bool is_last = n + 1 == ends.size();
        Block part;
        if (is_first) {
            part = block;
            part.given &= ~(kTargetSlots | kCenterSlots | bit(Slot::Radius));
        } else {
            part.source = block.source;
            part.skip = block.skip;
            part.skip_also = block.skip_also;
            part.motion = block.motion;
            part.feed_along_arc = block.feed_along_arc;
        }
        keep_functions_of_part(block, is_first, is_last, part);
        const SlotMask said = block.given & kTargetSlots;
        part.incremental = block.incremental & said;
        part.absolute = block.absolute & said;
        const double angle = first_angle + direction * arc.sweep * ends[n];
        const double at = std::lerp(first_radius, last_radius, ends[n]);
        const PlanePoint to = is_last ? arc.points.end
                                      : PlanePoint{arc.center[0] + at * std::cos(angle),
                                                   arc.center[1] + at * std::sin(angle)};
        const double share = (2 * std::numbers::pi * turns + arc.sweep * ends[n]) / total;
        for (std::size_t i = 0; i < 2; ++i) {
            const auto slot = static_cast<Slot>(axes[i]);
            const double scale = text_.to_text(slot, 1);
            const double base = text_.is_distance(block, axes[i]) ? from[i] : 0;
            if (block.has(slot) || !is_last || to[i] != arc.points.start[i])
                part.set(slot, (to[i] - base) / scale / arc.part[i]);
            if (!by_radius) part.set(center_slot(axes[i]), (arc.center[i] - from[i]) / scale);
        }
        if (by_radius) part.set(Slot::Radius, radius);
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            const auto slot = static_cast<Slot>(axis);
            if (axis == axes[0] || axis == axes[1] || !block.has(slot)) continue;
            const bool is_way = text_.is_distance(block, axis);
            const double way = block.at(slot) - (is_way ? 0 : begin.meant[axis]);
            part.set(slot, is_way    ? way * (share - share_before)
                           : is_last ? block.at(slot)
                                     : begin.meant[axis] + way * share);
        }
        // Under inverse time the time of the block is shared out by the angle.
        if (shares_time) part.set(Slot::Feed, feed / (share - share_before));
        write_block(part, out);
        from = to;
        share_before = share;
    }
    is_part_ = false;
    if (!shares_time) return;
    state_.mean_shared_feed(feed);
}

/// An arc that the control cannot tell from its chord is written as that.
BlockWriter::Written BlockWriter::straighten(const Block& block, std::string& out) {
    if (!vanishes(block)) return Written::NotYet;
    messages_.report(diag::ArcVanishes, block).arg(dialect_.title());
    const Function motion = text_.effective_motion(block);
    Block line = block;
    line.motion = Function::Line;
    line.given &= ~(kCenterSlots | bit(Slot::Radius) | bit(Slot::Turns));
    write_block(line, out);
    state_.mean(Group::Motion, motion);
    return Written::Already;
}

/// A helix of several turns on a control without a word for them: one block a turn.
BlockWriter::Written BlockWriter::split_turns(const Block& block, std::string& out) {
    if (!block.has(Slot::Turns) || text_.has_address(Slot::Turns)) return Written::NotYet;
    const Function motion = text_.effective_motion(block);
    const double asked = block.at(Slot::Turns);
    Block last = block;
    last.given &= ~bit(Slot::Turns);
    // No further turns are what every arc has; what cannot be turned has its message.
    const bool is_sane = asked > 0 && asked <= kMostTurns && is_arc(motion);
    if (asked > 0 && motion == Function::None)
        messages_.cannot_express(block, "turns of an unknown motion");
    if (!is_sane || !require_known_turns(block)) {
        write_block(last, out);
        return Written::Already;
    }
    const auto turns = static_cast<int>(std::lround(asked));
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    const WrittenPosition& start = modal_.position;
    const bool is_incremental = modal_.meant_of(Group::Distance) == Function::Incremental;
    const auto end_of = [&](std::size_t axis) {
        const auto slot = static_cast<Slot>(axis);
        if (!block.has(slot)) return start.meant[axis];
        return text_.is_distance(block, axis) ? start.meant[axis] + block.at(slot) : block.at(slot);
    };
    const PlanePoint from = {start.meant[axes[0]] * text_.on_part(axes[0]),
                             start.meant[axes[1]] * text_.on_part(axes[1])};
    const PlanePoint to = {end_of(axes[0]) * text_.on_part(axes[0]),
                           end_of(axes[1]) * text_.on_part(axes[1])};
    const PlanePoint center = meant_center(block, from, to);
    constexpr double kTurn = 2 * std::numbers::pi;
    const double sweep = sweep_angle(from, to, center, motion == Function::ArcCw);
    const double total = kTurn * turns + sweep;
    const std::array<double, kAxes> begin = start.meant;
    std::array<double, kAxes> end{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) end[axis] = end_of(axis);
    // Under inverse time the time of the block is shared out by the angle.
    const bool shares_time =
        modal_.meant_of(Group::FeedMode) == Function::FeedInverseTime && block.has(Slot::Feed);
    const double inverse_time = shares_time ? block.at(Slot::Feed) * total : 0;
    if (shares_time) last.set(Slot::Feed, inverse_time / sweep);
    for (int turn = 1; turn <= turns; ++turn) {
        Block circle;
        if (turn == 1) {
            circle = last;
            circle.given &= ~(kTargetSlots | kCenterSlots | bit(Slot::Radius));
            circle.incremental = circle.absolute = 0;
            circle.comment.clear();
        }
        circle.source = block.source;
        circle.skip = block.skip;
        circle.motion = motion;
        if (shares_time) circle.set(Slot::Feed, inverse_time / kTurn);
        for (std::size_t i = 0; i < 2; ++i) circle.set(center_slot(axes[i]), center[i] - from[i]);
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
            const auto slot = static_cast<Slot>(axis);
            if (axis == axes[0] || axis == axes[1] || !block.has(slot)) continue;
            const double at = begin[axis] + (end[axis] - begin[axis]) * kTurn * turn / total;
            const bool as_distance = text_.is_distance(block, axis);
            circle.set(slot, as_distance ? at - start.meant[axis] : at);
            if (as_distance && !is_incremental) circle.incremental |= bit(slot);
            if (!as_distance && is_incremental) circle.absolute |= bit(slot);
        }
        write_block(circle, out);
    }
    // Of a distance the last block has what the circles have left.
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto slot = static_cast<Slot>(axis);
        if (axis == axes[0] || axis == axes[1] || !block.has(slot)) continue;
        if (text_.is_distance(block, axis)) last.set(slot, end[axis] - start.meant[axis]);
    }
    last.function_count = 0;
    last.argument_count = 0;
    write_block(last, out);
    return Written::Already;
}

}  // namespace kadr::write
