// The words of an arc: its centre or its radius on the grid of the text, and its feed.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "base/diagnostics/dialect.h"
#include "base/numbers.h"
#include "write/block_writer.h"

namespace kadr::write {

namespace {

/// The points with one coordinate halved.
ArcPoints halved(ArcPoints arc, std::size_t coordinate) {
    for (PlanePoint* point : {&arc.start, &arc.end, &arc.text_start, &arc.text_end})
        (*point)[coordinate] /= 2;
    return arc;
}

}  // namespace

void BlockWriter::place_arc(const Block& block, const WrittenPosition& start, Targets& targets) {
    if (block.has(Slot::Radius)) return place_radius(block, start, targets);
    if ((block.given & kCenterSlots) != 0) place_center(block, start, targets);
}

/// Whether the way from the start of an arc to its end, in the plane, is known: from positions, or
/// because the block says it. An axis without a word does not move.
bool BlockWriter::is_chord_known(const Block& block, const WrittenPosition& start) const {
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    return std::ranges::all_of(std::span(axes).first<2>(), [&](std::size_t axis) {
        return (start.known >> axis & 1u) != 0 || !block.has(static_cast<Slot>(axis)) ||
               text_.is_distance(block, axis);
    });
}

/// The words of an arc whose points nobody knows: as the block has them, nothing corrected.
void BlockWriter::place_arc_as_given(const Block& block, const WrittenPosition& start,
                                     Targets& targets) {
    if ((block.given & kCenterSlots) != 0) place_center_as_given(block, start, targets);
    if (!block.has(Slot::Radius)) return;
    if (!text_.has_address(Slot::Radius))
        return messages_.cannot_express(block, "an arc by its radius");
    targets.written |= bit(Slot::Radius);
    targets.number[static_cast<std::size_t>(Slot::Radius)] =
        text_.to_text(Slot::Radius, block.at(Slot::Radius));
}

void BlockWriter::place_center_as_given(const Block& block, const WrittenPosition& start,
                                        Targets& targets) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Slot slot = center_slot(axis);
        if (!block.has(slot)) continue;
        if (!text_.has_address(slot)) return messages_.cannot_express(block, "an arc centre");
        double number = text_.to_text(slot, block.at(slot));
        const bool is_start_known = (start.known >> axis & 1u) != 0;
        const bool is_coordinate = (block.absolute & bit(slot)) != 0;
        if (is_coordinate_center(slot)) {
            if (!is_coordinate && is_start_known)
                number += text_.to_text(slot, start.text[axis] * text_.on_part(axis));
            if (!is_coordinate && !is_start_known)
                messages_.position_unknown(block, text_.address_of(slot).name);
        } else if (is_coordinate) {
            // A coordinate, where the control takes distances only, needs the start.
            if (tables_.notation.has_modes) targets.wrapped_absolute |= bit(slot);
            else if (is_start_known) number -= text_.to_text(slot, start.text[axis]);
            else messages_.position_unknown(block, text_.address_of(slot).name);
        }
        targets.written |= bit(slot);
        targets.number[static_cast<std::size_t>(slot)] = number;
    }
}

/// Whether the end lies on the circle of the start as well as the control wants it.
bool BlockWriter::is_on_circle(const ArcPoints& arc, const PlanePoint& center) const {
    const double mm = text_.to_text(static_cast<Slot>(text_.plane_axes()[0]), 1);
    const double radius = std::hypot(arc.start[0] - center[0], arc.start[1] - center[1]);
    return radius_miss(arc, center) <=
           std::max(rules_.arc_tolerance * mm, rules_.arc_tolerance_factor * radius);
}

/// A length of the text, in the text's unit, for a message.
std::string BlockWriter::length_in_words(double length) const {
    std::string words;
    append_shortest(words, round_to(length, 4));
    return words + (modal_.units.inch ? " in" : " mm");
}

/// Controls refuse an arc whose end lies off the circle of its start (SINUMERIK 14040, MD21000 and
/// MD21010; FANUC PS0020, No.3410): it is refused here already.
void BlockWriter::check_circle(const Block& block, const ArcPoints& arc, const PlanePoint& center) {
    if (is_on_circle(arc, center)) return;
    if (!messages_.fails_first_time(block, "an arc off its circle")) return;
    const double begin = std::hypot(arc.start[0] - center[0], arc.start[1] - center[1]);
    const double end = std::hypot(arc.end[0] - center[0], arc.end[1] - center[1]);
    messages_.report(diag::ArcOffCircle, block)
        .arg(length_in_words(begin))
        .arg(length_in_words(end));
}

void BlockWriter::place_center(const Block& block, const WrittenPosition& start, Targets& targets) {
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    const SlotMask in_plane = bit(center_slot(axes[0])) | bit(center_slot(axes[1]));
    const bool has_plane = modal_.meant_of(Group::Plane) != Function::None;
    if (const Slot across = center_slot(axes[2]);
        has_plane && (block.given & kCenterSlots & ~in_plane) != 0 && text_.has_address(across)) {
        if (!messages_.fails_first_time(block, "a centre outside of the plane")) return;
        messages_.report_word(diag::ArcWordOutsidePlane, block, text_.address_of(across).name)
            .arg(text_.address_of(across).name)
            .arg(std::string(kAxisNames[axes[0]]) + std::string(kAxisNames[axes[1]]));
        return;
    }
    const bool lacks_word = std::ranges::any_of(std::span(axes).first<2>(), [&](auto axis) {
        return block.has(center_slot(axis)) && !text_.has_address(center_slot(axis));
    });
    if (lacks_word) return messages_.cannot_express(block, "an arc centre");
    // A coordinate and a distance cannot be compared without the position.
    const bool is_comparable = std::ranges::all_of(std::span(axes).first<2>(), [&](auto axis) {
        return (start.known >> axis & 1u) != 0 ||
               (block.absolute & block.given & bit(center_slot(axis))) == 0;
    });
    if (!has_plane || (block.given & kCenterSlots & ~in_plane) != 0 || !is_comparable ||
        !is_chord_known(block, start)) {
        return place_center_as_given(block, start, targets);
    }
    ArcPoints arc = arc_points(start);
    std::array<bool, 2> fixed_zero{};
    bool is_absolute = false;
    const auto find_center = [&](const ArcPoints& from) {
        PlanePoint found{};
        for (std::size_t i = 0; i < 2; ++i) {
            const Slot slot = center_slot(axes[i]);
            const double scale = text_.to_text(static_cast<Slot>(axes[i]), 1);
            const bool is_coordinate = (block.absolute & bit(slot) & block.given) != 0;
            is_absolute |= is_coordinate;
            fixed_zero[i] = !block.has(slot);
            found[i] = (is_coordinate ? 0.0 : from.start[i]) +
                       (block.has(slot) ? block.at(slot) * scale : 0.0);
        }
        return found;
    };
    PlanePoint center = find_center(arc);
    // On a lathe X is a diameter, but the centre is not, and where no word says so the circle on
    // which start and end lie does.
    if (axes[1] == kX && !text_.knows_diameter()) {
        const ArcPoints radii = halved(arc, 1);
        const PlanePoint other = find_center(radii);
        if (is_on_circle(radii, other) && radius_miss(radii, other) < radius_miss(arc, center)) {
            arc = radii;
            center = other;
        }
    }
    check_circle(block, arc, center);
    if (is_coordinate_center(center_slot(axes[0])))
        return place_center_as_coordinates(block, start, center, targets);
    const SlotMask coordinates = block.absolute & block.given & in_plane;
    // Where X is a diameter, controls do not agree on what a coordinate of the centre is.
    const bool is_turned = text_.on_part(axes[0]) != 1 || text_.on_part(axes[1]) != 1;
    const bool writes_absolute = is_absolute && tables_.notation.has_modes && !is_turned;
    CenterGrid grid = center_grid(block);
    grid.fixed_zero = fixed_zero;
    grid.is_absolute = writes_absolute;
    const PlanePoint words = center_words(arc, center, grid);
    for (std::size_t i = 0; i < 2; ++i) {
        const Slot slot = center_slot(axes[i]);
        if (fixed_zero[i]) continue;
        targets.written |= bit(slot);
        double number = words[i];
        if (writes_absolute && (coordinates & bit(slot)) == 0) number -= arc.text_start[i];
        if (writes_absolute && (coordinates & bit(slot)) != 0)
            targets.wrapped_absolute |= bit(slot);
        targets.number[static_cast<std::size_t>(slot)] = number;
    }
}

/// What the words of the block's centre can say; the control has one of the two.
CenterGrid BlockWriter::center_grid(const Block& block) const {
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    const Slot first = center_slot(axes[text_.has_address(center_slot(axes[0])) ? 0 : 1]);
    CenterGrid grid{text_.decimals(first), text_.end_increment(), {}, is_coordinate_center(first)};
    const bool has_all = grid.is_absolute || block.has(Slot::Radius);
    for (std::size_t i = 0; i < 2; ++i)
        grid.fixed_zero[i] = !has_all && !block.has(center_slot(axes[i]));
    grid.most_misfit = rules_.arc_tolerance * text_.to_text(static_cast<Slot>(axes[0]), 1);
    return grid;
}

/// Whether the letter of a centre counts as axis words do, and those are coordinates now.
bool BlockWriter::is_coordinate_center(Slot slot) const {
    return text_.has_address(slot) && text_.address_of(slot).is_coordinate &&
           modal_.text_of(Group::Distance) != Function::Incremental;
}

/// Centre and end of an arc as coordinates, all of them: where a centre stays for the next arc, a
/// word that is missing is not 0.
void BlockWriter::place_center_as_coordinates(const Block& block, const WrittenPosition& start,
                                              const PlanePoint& center, Targets& targets) {
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    const PlanePoint words = center_words(arc_points(start), center, center_grid(block));
    for (std::size_t i = 0; i < 2; ++i) {
        const Slot slot = center_slot(axes[i]);
        if (!text_.has_address(slot)) return messages_.cannot_express(block, "an arc centre");
        if ((start.known >> axes[i] & 1u) == 0)
            return messages_.position_unknown(block, kAxisNames[axes[i]]);
        const SlotMask end = bit(static_cast<Slot>(axes[i]));
        if ((targets.written & end) == 0) {
            const auto slot_of_end = static_cast<Slot>(axes[i]);
            targets.number[axes[i]] = text_.to_text(slot_of_end, modal_.position.text[axes[i]]);
        }
        targets.written |= bit(slot) | end;
        targets.number[static_cast<std::size_t>(slot)] = words[i];
    }
}

/// Start and end of the arc in the plane, on the part, in the text's units.
ArcPoints BlockWriter::arc_points(const WrittenPosition& start) const {
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    ArcPoints arc{};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t axis = axes[i];
        const double scale = text_.to_text(static_cast<Slot>(axis), 1) * text_.on_part(axis);
        arc.start[i] = start.meant[axis] * scale;
        arc.text_start[i] = start.text[axis] * scale;
        arc.end[i] = modal_.position.meant[axis] * scale;
        arc.text_end[i] = modal_.position.text[axis] * scale;
    }
    return arc;
}

/// Whether the radius and the end of an arc lose nothing by the places that the text has.
bool BlockWriter::is_exact_arc(const Block& block, double radius) const {
    constexpr double kExact = 1e-9;  // of the text's unit: what a sum leaves of a decimal number
    const auto is_exact = [](double number, int places) {
        return std::fabs(number - round_to(number, places)) < kExact;
    };
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    return is_exact(radius, text_.decimals(Slot::Radius)) &&
           std::ranges::all_of(std::span(axes).first<2>(), [&](std::size_t axis) {
               const auto slot = static_cast<Slot>(axis);
               return !block.has(slot) ||
                      is_exact(text_.to_text(slot, block.at(slot)), text_.decimals(slot));
           });
}

/// The centre of an arc by its radius follows from its start, and near half a turn the rounding of
/// a word moves it by many times as much: from a start that nobody knows it may be anywhere.
void BlockWriter::unknown_start(const Block& block) {
    if (!messages_.fails_first_time(block, "an arc by radius from an unknown position")) return;
    messages_.report(diag::ArcStartUnknown, block)
        .fix("say the start before it, `G0 X… Y…`, or the centre by `I` and `J`");
}

/// A radius stays a radius where the control has the word and the rounded points still give the
/// same centre; near half a turn they do not, and the centre is written instead.
void BlockWriter::place_radius(const Block& block, const WrittenPosition& start, Targets& targets) {
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    const double scale = text_.to_text(static_cast<Slot>(axes[0]), 1);
    const double radius = block.at(Slot::Radius) * scale;
    const bool has_word = text_.has_address(Slot::Radius);
    const bool has_center =
        text_.has_address(center_slot(axes[0])) && text_.has_address(center_slot(axes[1]));
    if (!has_word && !has_center) {
        messages_.cannot_express(block, "an arc by its radius");
        return;
    }
    const int places = text_.decimals(has_word ? Slot::Radius : center_slot(axes[0]));
    const bool is_cw = text_.effective_motion(block) == Function::ArcCw;
    RadiusArc arc = radius_arc(arc_points(start), radius, places, is_cw, scale);
    // On a lathe X is a diameter. While nothing says whether it is, the centre cannot stand for a
    // radius that rounding moves a little.
    if (axes[1] == kX && !text_.knows_diameter()) arc.fits = arc.fits_fairly;
    if (axes[1] == kX && !arc.fits && !text_.knows_diameter()) {
        const RadiusArc other = radius_arc(halved(arc.points, 1), radius, places, is_cw, scale);
        if (arc.exact && other.exact && is_chord_known(block, start)) {
            // Almost half a turn by the one reading: only its centre says it, and that of the other
            // is elsewhere.
            messages_.cannot_express(
                block,
                "an arc of almost half a turn by its radius, while nothing says "
                "whether X is a diameter (`DIAMON`, `DIAMOF`),");
            return;
        }
        if (other.fits_fairly || (!arc.exact && other.exact)) arc = other;
    }
    const auto& [points, exact, reached, fits, fits_fairly] = arc;
    // Without a position of start and end nothing can be converted; the control judges.
    const bool is_comparable = is_chord_known(block, start);
    if (is_comparable && !exact && !reached) {
        if (!messages_.fails_first_time(block, "an arc by its radius")) return;
        messages_.report(diag::ArcRadiusImpossible, block)
            .arg(length_in_words(radius))
            .arg(length_in_words(
                std::hypot(points.end[0] - points.start[0], points.end[1] - points.start[1])));
        return;
    }
    if (has_word && !is_comparable && !is_exact_arc(block, radius)) {
        unknown_start(block);
        return;
    }
    if (has_word && (fits || !exact || !has_center || !is_comparable)) {
        targets.written |= bit(Slot::Radius);
        targets.number[static_cast<std::size_t>(Slot::Radius)] = radius;
        return;
    }
    if (!exact || !has_center || !is_comparable) {
        messages_.cannot_express(block, "an arc by radius from an unknown position");
        return;
    }
    if (is_coordinate_center(center_slot(axes[0]))) {
        place_center_as_coordinates(block, start, *exact, targets);
        return;
    }
    const PlanePoint words = center_words(points, *exact, center_grid(block));
    for (std::size_t i = 0; i < 2; ++i) {
        targets.written |= bit(center_slot(axes[i]));
        targets.number[static_cast<std::size_t>(center_slot(axes[i]))] = words[i];
    }
}

/// The centre as the block means it, in the plane; the start if the block does not say.
PlanePoint BlockWriter::meant_center(const Block& block, const PlanePoint& start,
                                     const PlanePoint& end) const {
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    PlanePoint center = start;
    for (std::size_t i = 0; i < 2; ++i) {
        const Slot slot = center_slot(axes[i]);
        if (!block.has(slot)) continue;
        center[i] = (block.absolute & bit(slot)) != 0 ? block.at(slot) : start[i] + block.at(slot);
    }
    if (!block.has(Slot::Radius)) return center;
    const bool is_clockwise = text_.effective_motion(block) == Function::ArcCw;
    return center_of_radius(start, end, block.at(Slot::Radius), is_clockwise).value_or(center);
}

/// The arc of a block in its plane, as the program means it. Its chord must be known.
BlockWriter::MeantArc BlockWriter::meant_arc(const Block& block,
                                             const WrittenPosition& start) const {
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    PlanePoint from{};
    PlanePoint to{};
    for (std::size_t i = 0; i < 2; ++i) {
        from[i] = start.meant[axes[i]] * text_.on_part(axes[i]);
        to[i] = modal_.position.meant[axes[i]] * text_.on_part(axes[i]);
    }
    const bool is_clockwise = text_.effective_motion(block) == Function::ArcCw;
    const PlanePoint center = meant_center(block, from, to);
    return {.sweep = sweep_angle(from, to, center, is_clockwise),
            .radius = std::hypot(from[0] - center[0], from[1] - center[1]) / 2 +
                      std::hypot(to[0] - center[0], to[1] - center[1]) / 2};
}

/// Where F of an arc under inverse time is feed/radius, it is the angle over the time: so much
/// greater than 1/time.
void BlockWriter::place_arc_feed(const Block& block, const WrittenPosition& start,
                                 Targets& targets) {
    if (!modal_.units.inverse_time || !text_.feed_word.arc_by_radius) return;
    if (!is_chord_known(block, start)) return messages_.position_unknown(block, "F");
    targets.feed_factor = meant_arc(block, start).sweep;
}

/// The tool of a helix shall be as fast as the program means it, where program and control count F
/// along different lengths: the way of the tool, or the arc that the helix is over.
void BlockWriter::place_helix_feed(const Block& block, const WrittenPosition& start,
                                   Targets& targets) {
    if (block.feed_along_arc == rules_.helix_feed_along_arc) return;
    if (modal_.meant_of(Group::FeedMode) == Function::FeedInverseTime) return;
    if (!block.has(Slot::Feed) && !modal_.has_meant_feed)
        return;  // whoever cuts without has its message
    const std::array<std::size_t, 3> axes = text_.plane_axes();
    const auto third = static_cast<Slot>(axes[2]);
    if (!block.has(third)) return;
    const bool is_way = text_.is_distance(block, axes[2]);
    if (!is_way && (start.known >> axes[2] & 1u) == 0)
        return messages_.position_unknown(block, "F");
    const double height = (block.at(third) - (is_way ? 0 : start.meant[axes[2]])) *
                          text_.on_part(axes[2]) * modal_.frame.factors[axes[2]];
    if (std::fabs(height) < kSame) return;
    if (!is_chord_known(block, start)) return messages_.position_unknown(block, "F");
    const auto [sweep, radius] = meant_arc(block, start);
    const double turns = block.has(Slot::Turns) ? std::nearbyint(block.at(Slot::Turns)) : 0;
    const double arc =
        radius * (sweep + 2 * std::numbers::pi * turns) * std::fabs(modal_.frame.factors[axes[0]]);
    if (arc < kSame) return;  // no arc: that has its message
    const double path = std::hypot(arc, height);
    targets.feed_factor = block.feed_along_arc ? path / arc : arc / path;
}

}  // namespace kadr::write
