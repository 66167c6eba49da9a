#include "write/arcs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "base/numbers.h"

namespace kadr::write {

namespace {

/// x_part   what a coordinate of X is multiplied with
std::optional<PlannedArc> planned_arc(const TextView& text, const Block& block, double x_part) {
    const Function motion = text.effective_motion(block);
    if (!is_arc(motion) || text.modal.meant[index_of(Group::Plane)] == Function::None)
        return std::nullopt;
    if (!block.has(Slot::Radius) && (block.given & kCenterSlots) == 0) return std::nullopt;
    const std::array<std::size_t, 3> axes = text.plane_axes();
    const WrittenPosition& start = text.modal.position;
    if (!is_chord_known(text, block, start)) return std::nullopt;
    PlannedArc arc;
    arc.is_clockwise = motion == Function::ArcCw;
    ArcPoints& points = arc.points;
    std::array<bool, 2> is_center_absolute{};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto slot = static_cast<Slot>(axes[i]);
        const Slot center = center_slot(axes[i]);
        is_center_absolute[i] = (block.absolute & block.given & bit(center)) != 0;
        if (!text.has_address(slot) || (is_center_absolute[i] && !text.is_known(axes[i])))
            return std::nullopt;
        const double scale = text.to_text(slot, 1);
        const double part = axes[i] == kX ? x_part : 1;
        arc.part[i] = part;
        const double begin = start.meant[axes[i]];
        const double end = !block.has(slot)                   ? begin
                           : text.is_distance(block, axes[i]) ? begin + block.at(slot)
                                                              : block.at(slot);
        points.start[i] = begin * scale * part;
        points.end[i] = end * scale * part;
        points.text_start[i] = start.text[axes[i]] * scale * part;
        points.text_end[i] = block.has(slot) ? round_to(end * scale, text.decimals(slot)) * part
                                             : points.text_start[i];
        const double programmed = block.has(center) ? block.at(center) * scale : 0;
        arc.center[i] = is_center_absolute[i] ? programmed : points.start[i] + programmed;
    }
    if (block.has(Slot::Radius)) {
        const double scale = text.to_text(static_cast<Slot>(axes[0]), 1);
        const auto center =
            center_of_radius(points.start, points.end, block.at(Slot::Radius) * scale,
                             arc.is_clockwise, kHalfTurnSlack * scale);
        if (!center) return std::nullopt;
        arc.center = *center;
    }
    arc.sweep = sweep_angle(points.start, points.end, arc.center, arc.is_clockwise);
    return arc;
}

}  // namespace

bool is_chord_known(const TextView& text, const Block& block, const WrittenPosition& start) {
    const std::array<std::size_t, 3> axes = text.plane_axes();
    return std::ranges::all_of(std::span(axes).first<2>(), [&](std::size_t axis) {
        return (start.known >> axis & 1u) != 0 || !block.has(static_cast<Slot>(axis)) ||
               text.is_distance(block, axis);
    });
}

bool is_on_circle(const TextView& text, const ArcPoints& arc, const PlanePoint& center) {
    const double mm = text.to_text(static_cast<Slot>(text.plane_axes()[0]), 1);
    const double radius = std::hypot(arc.start[0] - center[0], arc.start[1] - center[1]);
    return radius_miss(arc, center) <= std::max(text.tables.rules.arc_tolerance * mm,
                                                text.tables.rules.arc_tolerance_factor * radius);
}

bool is_coordinate_center(const TextView& text, Slot slot) {
    // Where the axes of the plane are counted, the first letter tells for all.
    if (text.tables.rules.center_by_plane) slot = Slot::CenterX;
    return text.has_address(slot) && text.address_of(slot).is_coordinate &&
           text.modal.text_of(Group::Distance) != Function::Incremental;
}

ArcPoints arc_points(const TextView& text, const WrittenPosition& start) {
    const std::array<std::size_t, 3> axes = text.plane_axes();
    ArcPoints arc{};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t axis = axes[i];
        const double scale = text.to_text(static_cast<Slot>(axis), 1) * text.on_part(axis);
        arc.start[i] = start.meant[axis] * scale;
        arc.text_start[i] = start.text[axis] * scale;
        arc.end[i] = text.modal.position.meant[axis] * scale;
        arc.text_end[i] = text.modal.position.text[axis] * scale;
    }
    return arc;
}

bool is_exact_arc(const TextView& text, const Block& block, double radius) {
    constexpr double kExact = 1e-9;  // of the text's unit: what a sum leaves of a decimal number
    const auto is_exact = [](double number, int places) {
        return std::fabs(number - round_to(number, places)) < kExact;
    };
    const std::array<std::size_t, 3> axes = text.plane_axes();
    return is_exact(radius, text.decimals(Slot::Radius)) &&
           std::ranges::all_of(std::span(axes).first<2>(), [&](std::size_t axis) {
               const auto slot = static_cast<Slot>(axis);
               return !block.has(slot) ||
                      is_exact(text.to_text(slot, block.at(slot)), text.decimals(slot));
           });
}

CenterGrid center_grid(const TextView& text, const Block& block) {
    const std::array<std::size_t, 3> axes = text.plane_axes();
    const Slot first = center_slot(axes[text.has_address(center_slot(axes[0])) ? 0 : 1]);
    CenterGrid grid{
        text.decimals(first), text.end_increment(), {}, is_coordinate_center(text, first)};
    const bool has_all = grid.is_absolute || block.has(Slot::Radius);
    for (std::size_t i = 0; i < 2; ++i)
        grid.fixed_zero[i] = !has_all && !block.has(center_slot(axes[i]));
    grid.most_misfit =
        text.tables.rules.arc_tolerance * text.to_text(static_cast<Slot>(axes[0]), 1);
    return grid;
}

PlanePoint meant_center(const TextView& text, const Block& block, const PlanePoint& start,
                        const PlanePoint& end) {
    const std::array<std::size_t, 3> axes = text.plane_axes();
    PlanePoint center = start;
    for (std::size_t i = 0; i < 2; ++i) {
        const Slot slot = center_slot(axes[i]);
        if (!block.has(slot)) continue;
        center[i] = (block.absolute & bit(slot)) != 0 ? block.at(slot) : start[i] + block.at(slot);
    }
    if (!block.has(Slot::Radius)) return center;
    const bool is_clockwise = text.effective_motion(block) == Function::ArcCw;
    return center_of_radius(start, end, block.at(Slot::Radius), is_clockwise).value_or(center);
}

MeantArc meant_arc(const TextView& text, const Block& block, const WrittenPosition& start) {
    const std::array<std::size_t, 3> axes = text.plane_axes();
    PlanePoint from{};
    PlanePoint to{};
    for (std::size_t i = 0; i < 2; ++i) {
        from[i] = start.meant[axes[i]] * text.on_part(axes[i]);
        to[i] = text.modal.position.meant[axes[i]] * text.on_part(axes[i]);
    }
    const bool is_clockwise = text.effective_motion(block) == Function::ArcCw;
    const PlanePoint center = meant_center(text, block, from, to);
    return {.sweep = sweep_angle(from, to, center, is_clockwise),
            .radius = std::hypot(from[0] - center[0], from[1] - center[1]) / 2 +
                      std::hypot(to[0] - center[0], to[1] - center[1]) / 2};
}

std::optional<PlannedArc> planned_arc(const TextView& text, const Block& block) {
    const bool may_be_diameter = text.plane_axes()[1] == kX && !text.knows_diameter();
    std::optional<PlannedArc> arc = planned_arc(text, block, text.on_part(kX));
    if (!arc || !may_be_diameter || block.has(Slot::Radius)) return arc;
    // Where no word tells what X is, the circle on which start and end lie does.
    std::optional<PlannedArc> other = planned_arc(text, block, 0.5);
    const bool is_other =
        other && is_on_circle(text, other->points, other->center) &&
        radius_miss(other->points, other->center) < radius_miss(arc->points, arc->center);
    return is_other ? other : arc;
}

double text_error(const TextView& text, const Block& block, const PlannedArc& arc) {
    const std::array<std::size_t, 3> axes = text.plane_axes();
    const double scale = text.to_text(static_cast<Slot>(axes[0]), 1);
    const bool has_centers =
        text.has_address(center_slot(axes[0])) && text.has_address(center_slot(axes[1]));
    if (block.has(Slot::Radius) && axes[1] == kX && !text.knows_diameter())
        return 0;  // place_radius
    if (block.has(Slot::Radius) && text.has_address(Slot::Radius)) {
        const RadiusArc by_radius =
            radius_arc(arc.points, block.at(Slot::Radius) * scale, text.decimals(Slot::Radius),
                       arc.is_clockwise, scale);
        if (by_radius.fits) return 0;
        if (!has_centers) {
            if (!by_radius.reached) return std::numeric_limits<double>::infinity();
            const TracedArc traced =
                traced_arc(arc.points, *by_radius.reached, arc.is_clockwise, false);
            return path_error(arc.points, arc.center, arc.sweep, arc.is_clockwise, traced,
                              text.end_increment());
        }
    }
    if (!has_centers) return 0;  // what cannot be written has its message
    const CenterGrid grid = center_grid(text, block);
    const PlanePoint words = center_words(arc.points, arc.center, grid);
    PlanePoint center = words;
    if (!grid.is_absolute) {
        for (std::size_t i = 0; i < 2; ++i) center[i] += arc.points.text_start[i];
    }
    const TracedArc traced = traced_arc(arc.points, center, arc.is_clockwise,
                                        text.tables.rules.arc_error == ArcError::ShiftCenter);
    return path_error(arc.points, arc.center, arc.sweep, arc.is_clockwise, traced,
                      grid.increment());
}

bool vanishes(const TextView& text, const Block& block) {
    if (block.has(Slot::Turns) && std::lround(block.at(Slot::Turns)) != 0) return false;
    const std::optional<PlannedArc> arc = planned_arc(text, block);
    if (!arc) return false;
    const auto& [start, end, text_start, text_end] = arc->points;
    const double increment = text.end_increment();
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
    if (text_chord > kNear * increment) return is_flat && std::isinf(text_error(text, block, *arc));
    return text_chord < increment / 4 || std::isinf(text_error(text, block, *arc));
}

}  // namespace kadr::write
