// Arcs that need other blocks than their own: several turns, almost half a turn, too small an arc.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/diagnostics/dialect.h"
#include "base/numbers.h"
#include "nc/block_writer.h"

namespace kadr::nc {

/// Whether the points of a helix are known so far that its turns can be shared out; says so if not.
bool BlockWriter::are_turns_known(const Block& block) {
    const std::array<std::size_t, 3> axes = plane_axes();
    const WrittenPosition& start = modal_.position;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto slot = static_cast<Slot>(axis);
        const bool is_in_plane = axis == axes[0] || axis == axes[1];
        const bool is_center_absolute =
            is_in_plane && (block.absolute & block.given & bit(center_slot(axis))) != 0;
        const bool is_coordinate = block.has(slot) && !is_distance(block, axis);
        if ((start.known >> axis & 1u) != 0 || !(is_coordinate || is_center_absolute)) continue;
        position_unknown(block, kAxisNames[axis]);
        return false;
    }
    return true;
}

/// Whether rounding takes an arc away: its end falls on its start, which a control would take for a
/// full circle, or it is smaller than two increments, so that its rounded words say any angle. An
/// arc of more than half a turn is one that a full circle stands for well.
bool BlockWriter::vanishes(const Block& block) const {
    const Function motion = effective_motion(block);
    if (!is_arc(motion) || modal_.meant[static_cast<std::size_t>(Group::Plane)] == Function::None)
        return false;
    if (block.has(Slot::Turns) && std::lround(block.at(Slot::Turns)) != 0) return false;
    if (!block.has(Slot::Radius) && (block.given & kCenterSlots) == 0) return false;
    const std::array<std::size_t, 3> axes = plane_axes();
    const WrittenPosition& start = modal_.position;
    const bool is_incremental =
        modal_.meant[static_cast<std::size_t>(Group::Distance)] == Function::Incremental;
    PlanePoint from{};
    PlanePoint to{};
    bool is_same = true;  // in the text
    double increment = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto slot = static_cast<Slot>(axes[i]);
        if (!is_known(axes[i])) return false;
        const bool is_distance = (block.incremental & bit(slot)) != 0 ||
                                 (is_incremental && (block.absolute & bit(slot)) == 0);
        from[i] = start.meant[axes[i]];
        to[i] = !block.has(slot) ? from[i]
                : is_distance    ? from[i] + block.at(slot)
                                 : block.at(slot);
        const double text_from = round_to(to_text(slot, start.text[axes[i]]), decimals(slot));
        const double text_to = round_to(to_text(slot, to[i]), decimals(slot));
        is_same = is_same && text_from == text_to;
        increment = std::max(increment, std::pow(10.0, -decimals(slot)) / to_text(slot, 1));
        from[i] *= on_part(axes[i]);
        to[i] *= on_part(axes[i]);
    }
    const double chord = std::hypot(to[0] - from[0], to[1] - from[1]);
    if (chord < kSame) {  // a full circle is meant, or nothing
        const PlanePoint center = meant_center(block, from, to);
        const double radius = std::hypot(from[0] - center[0], from[1] - center[1]);
        return !block.has(Slot::Radius) && radius > kSame && radius < increment / 2;
    }
    const bool is_cw = motion == Function::ArcCw;
    if (block.has(Slot::Radius) && !center_of_radius(from, to, block.at(Slot::Radius), is_cw)) {
        return false;
    }
    const PlanePoint center = meant_center(block, from, to);
    const double radius = std::hypot(from[0] - center[0], from[1] - center[1]);
    // Neither an arc whose radius does not span its chord nor one whose end is off its circle.
    if (chord > 2 * radius + increment) return false;
    if (radius < 2 * increment) return true;
    if (!is_same) return false;
    const double sweep = sweep_angle(from, to, center, is_cw);
    return sweep < std::numbers::pi;
}

/// By how much the control's centre lies beside the one that is meant, where it moves it onto the
/// bisector of the rounded ends at the radius of the start, in the text's units: close to half a
/// turn the rounding of a word moves it by many times as much.
///
/// source       S 4.2
double BlockWriter::center_drift(const Block& block, const ArcPoints& arc,
                                 const PlanePoint& center) const {
    const int places = decimals(center_slot(plane_axes()[0]));
    const PlanePoint words = center_words(arc, center, places, {false, false}, false);
    const PlanePoint reached = {arc.text_start[0] + words[0], arc.text_start[1] + words[1]};
    const double radius = std::hypot(words[0], words[1]);
    const PlanePoint half = {(arc.text_end[0] - arc.text_start[0]) / 2,
                             (arc.text_end[1] - arc.text_start[1]) / 2};
    const double half_chord = std::hypot(half[0], half[1]);
    const double told = std::hypot(reached[0] - arc.text_start[0] - half[0],
                                   reached[1] - arc.text_start[1] - half[1]);
    const double height = std::sqrt(std::fmax(0.0, radius * radius - half_chord * half_chord));
    return block.has(Slot::Turns) ? 0 : std::fabs(height - told);
}

/// Almost half a turn, where rounding moves the control's centre, is written as two arcs. True: it
/// was one.
bool BlockWriter::halve(const Block& block, std::string& out) {
    const Function motion = effective_motion(block);
    const std::array<std::size_t, 3> axes = plane_axes();
    const WrittenPosition& start = modal_.position;
    const bool is_said = block.has(Slot::Radius) || (block.given & kCenterSlots) != 0;
    const bool has_centers = has_address(center_slot(axes[0])) && has_address(center_slot(axes[1]));
    if (!shifts_center_ || !is_arc(motion) || !is_said || !has_centers ||
        modal_.meant_of(Group::Plane) == Function::None || !is_known(axes[0]) || !is_known(axes[1]))
        return false;
    const auto end_of = [&](std::size_t axis) {
        const auto slot = static_cast<Slot>(axis);
        if (!block.has(slot)) return start.meant[axis];
        return is_distance(block, axis) ? start.meant[axis] + block.at(slot) : block.at(slot);
    };
    ArcPoints arc{};
    for (std::size_t i = 0; i < 2; ++i) {
        const double part = on_part(axes[i]);
        const auto slot = static_cast<Slot>(axes[i]);
        arc.start[i] = start.meant[axes[i]] * part;
        arc.end[i] = end_of(axes[i]) * part;
        const double scale = to_text(slot, 1);
        arc.text_start[i] = start.text[axes[i]] * part;
        arc.text_end[i] = round_to(end_of(axes[i]) * scale, decimals(slot)) / scale * part;
    }
    const double chord = std::hypot(arc.end[0] - arc.start[0], arc.end[1] - arc.start[1]);
    const bool is_cw = motion == Function::ArcCw;
    const bool has_radius = block.has(Slot::Radius);
    if (chord < kSame ||
        (has_radius && !center_of_radius(arc.start, arc.end, block.at(Slot::Radius), is_cw)))
        return false;
    if (has_radius && has_address(Slot::Radius) &&
        radius_arc(arc, block.at(Slot::Radius), decimals(Slot::Radius), is_cw, 1).fits)
        return false;
    const PlanePoint center = meant_center(block, arc.start, arc.end);
    constexpr double kDrift = 0.005;  // mm
    if (radius_miss(arc, center) > kDrift || center_drift(block, arc, center) <= kDrift)
        return false;
    const double sweep = sweep_angle(arc.start, arc.end, center, is_cw) * (is_cw ? -1 : 1);
    write_halves(block, center, arc, sweep, out);
    return true;
}

void BlockWriter::write_halves(const Block& block, const PlanePoint& center, const ArcPoints& arc,
                               double sweep, std::string& out) {
    const std::array<std::size_t, 3> axes = plane_axes();
    const WrittenPosition begin = modal_.position;
    const double c = std::cos(sweep / 2);
    const double s = std::sin(sweep / 2);
    const PlanePoint out_of = {arc.start[0] - center[0], arc.start[1] - center[1]};
    const PlanePoint middle = {center[0] + c * out_of[0] - s * out_of[1],
                               center[1] + s * out_of[0] + c * out_of[1]};
    Block first = block;
    first.given &= ~(kCenterSlots | bit(Slot::Radius));
    Block second;
    second.source = block.source;
    second.skip = block.skip;
    second.motion = block.motion;
    second.feed_along_arc = block.feed_along_arc;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto slot = static_cast<Slot>(axes[i]);
        const double part = on_part(axes[i]);
        const bool is_way = is_distance(block, axes[i]);
        first.set(slot, (middle[i] - (is_way ? arc.start[i] : 0)) / part);
        second.set(slot, (arc.end[i] - (is_way ? middle[i] : 0)) / part);
        first.set(center_slot(axes[i]), center[i] - arc.start[i]);
        second.set(center_slot(axes[i]), center[i] - middle[i]);
    }
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto slot = static_cast<Slot>(axis);
        if (axis == axes[0] || axis == axes[1] || !block.has(slot)) continue;
        const bool is_way = is_distance(block, axis);
        const double way = block.at(slot) - (is_way ? 0 : begin.meant[axis]);
        first.set(slot, is_way ? way / 2 : begin.meant[axis] + way / 2);
        second.set(slot, is_way ? way / 2 : block.at(slot));
    }
    const SlotMask said = block.given & kTargetSlots;
    first.incremental = block.incremental & said;
    first.absolute = block.absolute & said;
    second.incremental = first.incremental;
    second.absolute = first.absolute;
    if (modal_.units.inverse_time && block.has(Slot::Feed)) {
        first.set(Slot::Feed, 2 * block.at(Slot::Feed));
        second.set(Slot::Feed, 2 * block.at(Slot::Feed));
    }
    is_halved_ = true;
    write_block(first, out);
    write_block(second, out);
    is_halved_ = false;
}

/// An arc that the control cannot tell from its chord is written as that. True: it was one.
bool BlockWriter::straighten(const Block& block, std::string& out) {
    if (!vanishes(block)) return false;
    sink_.report(diag::ArcVanishes, place(block)).arg(dialect_.title());
    const Function motion = effective_motion(block);
    Block line = block;
    line.motion = Function::Line;
    line.given &= ~(kCenterSlots | bit(Slot::Radius) | bit(Slot::Turns));
    write_block(line, out);
    modal_.meant_of(Group::Motion) = motion;
    return true;
}

/// A helix of several turns on a control without a word for them: one block a turn.
bool BlockWriter::split_turns(const Block& block, std::string& out) {
    if (!block.has(Slot::Turns) || has_address(Slot::Turns)) return false;
    const Function motion = effective_motion(block);
    const double asked = block.at(Slot::Turns);
    Block last = block;
    last.given &= ~bit(Slot::Turns);
    // No further turns are what every arc has; what cannot be turned has its message.
    const bool is_sane = asked > 0 && asked <= kMostTurns && is_arc(motion);
    if (asked > 0 && motion == Function::None) cannot_express(block, "turns of an unknown motion");
    if (!is_sane || !are_turns_known(block)) {
        write_block(last, out);
        return true;
    }
    const auto turns = static_cast<int>(std::lround(asked));
    const std::array<std::size_t, 3> axes = plane_axes();
    const WrittenPosition& start = modal_.position;
    const bool is_incremental = modal_.meant_of(Group::Distance) == Function::Incremental;
    const auto end_of = [&](std::size_t axis) {
        const auto slot = static_cast<Slot>(axis);
        if (!block.has(slot)) return start.meant[axis];
        return is_distance(block, axis) ? start.meant[axis] + block.at(slot) : block.at(slot);
    };
    const PlanePoint from = {start.meant[axes[0]] * on_part(axes[0]),
                             start.meant[axes[1]] * on_part(axes[1])};
    const PlanePoint to = {end_of(axes[0]) * on_part(axes[0]), end_of(axes[1]) * on_part(axes[1])};
    const PlanePoint center = meant_center(block, from, to);
    constexpr double kTurn = 2 * std::numbers::pi;
    const double sweep = sweep_angle(from, to, center, motion == Function::ArcCw);
    const double total = kTurn * turns + sweep;
    const std::array<double, kAxes> begin = start.meant;
    std::array<double, kAxes> end{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) end[axis] = end_of(axis);
    // Under inverse time the time of the block is shared out by the angle.
    const bool shares_time = modal_.units.inverse_time && block.has(Slot::Feed);
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
            const bool as_distance = is_distance(block, axis);
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
        if (is_distance(block, axis)) last.set(slot, end[axis] - start.meant[axis]);
    }
    last.function_count = 0;
    last.argument_count = 0;
    write_block(last, out);
    return true;
}

}  // namespace kadr::nc
