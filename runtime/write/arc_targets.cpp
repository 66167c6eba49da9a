#include "write/arc_targets.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "base/diagnostics/dialect.h"
#include "base/numbers.h"
#include "write/arcs.h"

namespace kadr::write {

namespace {

/// The points with one coordinate halved.
ArcPoints halved(ArcPoints arc, std::size_t coordinate) {
    for (PlanePoint* point : {&arc.start, &arc.end, &arc.text_start, &arc.text_end})
        (*point)[coordinate] /= 2;
    return arc;
}

/// A length of the text, in the text's unit, for a message.
std::string length_in_words(const TextView& text, double length) {
    std::string words;
    append_shortest(words, round_to(length, 4));
    return words + (text.modal.units.inch ? " in" : " mm");
}

/// Controls refuse an arc whose end lies off the circle of its start (SINUMERIK 14040, MD21000 and
/// MD21010; FANUC PS0020, No.3410): it is refused here already.
void check_circle(const TextView& text, BlockMessages& messages, const Block& block,
                  const ArcPoints& arc, const PlanePoint& center) {
    if (is_on_circle(text, arc, center)) return;
    if (!messages.fails_first_time(block, "an arc off its circle")) return;
    const double begin = std::hypot(arc.start[0] - center[0], arc.start[1] - center[1]);
    const double end = std::hypot(arc.end[0] - center[0], arc.end[1] - center[1]);
    messages.report(diag::ArcOffCircle, block)
        .arg(length_in_words(text, begin))
        .arg(length_in_words(text, end));
}

void place_center_as_given(const TextView& text, BlockMessages& messages, const Block& block,
                           const WrittenPosition& start, Targets& targets) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Slot slot = center_slot(axis);
        if (!block.has(slot)) continue;
        if (!text.has_address(slot)) return messages.cannot_express(block, "an arc centre");
        double number = text.to_text(slot, block.at(slot));
        const bool is_start_known = (start.known >> axis & 1u) != 0;
        const bool is_coordinate = (block.absolute & bit(slot)) != 0;
        if (is_coordinate_center(text, slot)) {
            if (!is_coordinate && is_start_known)
                number += text.to_text(slot, start.text[axis] * text.on_part(axis));
            if (!is_coordinate && !is_start_known)
                messages.position_unknown(block, text.address_of(slot).name, axis);
        } else if (is_coordinate) {
            // A coordinate, where the control takes distances only, needs the start.
            if (text.tables.notation.has_modes) targets.wrapped_absolute |= bit(slot);
            else if (is_start_known) number -= text.to_text(slot, start.text[axis]);
            else messages.position_unknown(block, text.address_of(slot).name, axis);
        }
        targets.written |= bit(slot);
        targets.number[static_cast<std::size_t>(slot)] = number;
    }
}

/// Centre and end of an arc as coordinates, all of them: where a centre stays for the next arc, a
/// word that is missing is not 0.
void place_center_as_coordinates(const TextView& text, BlockMessages& messages, const Block& block,
                                 const WrittenPosition& start, const PlanePoint& center,
                                 Targets& targets) {
    const std::array<std::size_t, 3> axes = text.plane_axes();
    const PlanePoint words =
        center_words(arc_points(text, start), center, center_grid(text, block));
    for (std::size_t i = 0; i < 2; ++i) {
        const Slot slot = center_slot(axes[i]);
        if (!text.has_address(slot)) return messages.cannot_express(block, "an arc centre");
        if ((start.known >> axes[i] & 1u) == 0)
            return messages.position_unknown(block, kAxisNames[axes[i]], axes[i]);
        const SlotMask end = bit(static_cast<Slot>(axes[i]));
        if ((targets.written & end) == 0) {
            const auto slot_of_end = static_cast<Slot>(axes[i]);
            targets.number[axes[i]] = text.to_text(slot_of_end, text.modal.position.text[axes[i]]);
        }
        targets.written |= bit(slot) | end;
        targets.number[static_cast<std::size_t>(slot)] = words[i];
    }
}

void place_center(const TextView& text, BlockMessages& messages, const Block& block,
                  const WrittenPosition& start, Targets& targets) {
    const std::array<std::size_t, 3> axes = text.plane_axes();
    const SlotMask in_plane = bit(center_slot(axes[0])) | bit(center_slot(axes[1]));
    const bool has_plane = text.modal.meant_of(Group::Plane) != Function::None;
    if (const Slot across = center_slot(axes[2]);
        has_plane && (block.given & kCenterSlots & ~in_plane) != 0 && text.has_address(across)) {
        if (!messages.fails_first_time(block, "a centre outside of the plane")) return;
        messages.report_word(diag::ArcWordOutsidePlane, block, text.address_of(across).name)
            .arg(text.address_of(across).name)
            .arg(std::string(kAxisNames[axes[0]]) + std::string(kAxisNames[axes[1]]));
        return;
    }
    const bool lacks_word = std::ranges::any_of(std::span(axes).first<2>(), [&](auto axis) {
        return block.has(center_slot(axis)) && !text.has_address(center_slot(axis));
    });
    if (lacks_word) return messages.cannot_express(block, "an arc centre");
    // A coordinate and a distance cannot be compared without the position.
    const bool is_comparable = std::ranges::all_of(std::span(axes).first<2>(), [&](auto axis) {
        return (start.known >> axis & 1u) != 0 ||
               (block.absolute & block.given & bit(center_slot(axis))) == 0;
    });
    if (!has_plane || (block.given & kCenterSlots & ~in_plane) != 0 || !is_comparable ||
        !is_chord_known(text, block, start)) {
        return place_center_as_given(text, messages, block, start, targets);
    }
    ArcPoints arc = arc_points(text, start);
    std::array<bool, 2> fixed_zero{};
    bool is_absolute = false;
    const auto find_center = [&](const ArcPoints& from) {
        PlanePoint found{};
        for (std::size_t i = 0; i < 2; ++i) {
            const Slot slot = center_slot(axes[i]);
            const double scale = text.to_text(static_cast<Slot>(axes[i]), 1);
            const bool is_coordinate = (block.absolute & bit(slot) & block.given) != 0;
            is_absolute |= is_coordinate;
            fixed_zero[i] = !block.has(slot);
            found[i] = (is_coordinate ? 0.0 : from.start[i]) +
                       (block.has(slot) ? block.at(slot) * scale : 0.0);
        }
        return found;
    };
    PlanePoint center = find_center(arc);
    // On a lathe X is a diameter, but the centre is not, and where no word sets it the circle on
    // which start and end lie does.
    if (axes[1] == kX && !text.knows_diameter()) {
        const ArcPoints radii = halved(arc, 1);
        const PlanePoint other = find_center(radii);
        if (is_on_circle(text, radii, other) &&
            radius_miss(radii, other) < radius_miss(arc, center)) {
            arc = radii;
            center = other;
        }
    }
    check_circle(text, messages, block, arc, center);
    if (is_coordinate_center(text, center_slot(axes[0])))
        return place_center_as_coordinates(text, messages, block, start, center, targets);
    const SlotMask coordinates = block.absolute & block.given & in_plane;
    // Where X is a diameter, controls do not agree on what a coordinate of the centre is.
    const bool is_turned = text.on_part(axes[0]) != 1 || text.on_part(axes[1]) != 1;
    const bool writes_absolute = is_absolute && text.tables.notation.has_modes && !is_turned;
    CenterGrid grid = center_grid(text, block);
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

/// The centre of an arc by its radius follows from its start, and near half a turn the rounding of
/// a word moves it by many times as much: from a start that nobody knows it may be anywhere.
void unknown_start(BlockMessages& messages, const Block& block) {
    if (!messages.fails_first_time(block, "an arc by radius from an unknown position")) return;
    messages.report(diag::ArcStartUnknown, block)
        .fix("say the start before it, `G0 X… Y…`, or the centre by `I` and `J`");
}

/// A radius stays a radius where the control has the word and the rounded points still give the
/// same centre; near half a turn they do not, and the centre is written instead.
void place_radius(const TextView& text, BlockMessages& messages, const Block& block,
                  const WrittenPosition& start, Targets& targets) {
    const std::array<std::size_t, 3> axes = text.plane_axes();
    const double scale = text.to_text(static_cast<Slot>(axes[0]), 1);
    const double radius = block.at(Slot::Radius) * scale;
    const bool has_word = text.has_address(Slot::Radius);
    const bool has_center =
        text.has_address(center_slot(axes[0])) && text.has_address(center_slot(axes[1]));
    if (!has_word && !has_center) {
        messages.cannot_express(block, "an arc by its radius");
        return;
    }
    const int places = text.decimals(has_word ? Slot::Radius : center_slot(axes[0]));
    const bool is_cw = text.effective_motion(block) == Function::ArcCw;
    RadiusArc arc = radius_arc(arc_points(text, start), radius, places, is_cw, scale);
    // On a lathe X is a diameter. While nothing tells whether it is, the centre cannot stand for a
    // radius that rounding moves a little.
    if (axes[1] == kX && !text.knows_diameter()) arc.fits = arc.fits_fairly;
    bool is_arc_of_diameter = false;
    if (axes[1] == kX && !arc.fits && !text.knows_diameter()) {
        const RadiusArc other = radius_arc(halved(arc.points, 1), radius, places, is_cw, scale);
        if (arc.exact && other.exact && is_chord_known(text, block, start)) {
            // Almost half a turn by the one reading: only its centre fits it, and that of the other
            // is elsewhere.
            messages.cannot_express(
                block,
                "an arc of almost half a turn by its radius, while nothing says "
                "whether X is a diameter (`DIAMON`, `DIAMOF`),");
            return;
        }
        // An arc that the radius does not reach is none where X is no diameter, and nothing tells
        // that it is one.
        is_arc_of_diameter = !arc.exact && !arc.reached && (other.exact || other.reached);
        if (!is_arc_of_diameter && (other.fits_fairly || (!arc.exact && other.exact))) arc = other;
    }
    const auto& [points, exact, reached, fits, fits_fairly] = arc;
    // Without a position of start and end nothing can be converted; the control judges.
    const bool is_comparable = is_chord_known(text, block, start);
    if (is_comparable && !exact && !reached) {
        if (!messages.fails_first_time(block, "an arc by its radius")) return;
        DiagnosticBuilder builder = messages.report(diag::ArcRadiusImpossible, block);
        builder.arg(length_in_words(text, radius))
            .arg(length_in_words(text, std::hypot(points.end[0] - points.start[0],
                                                  points.end[1] - points.start[1])));
        if (is_arc_of_diameter)
            builder.fix(text.has_code(Function::DiameterOn)
                            ? "if X is a diameter, say so before it: `DIAMON`"
                            : "for a lathe take the dialect of one, as `fanuc-lathe` is");
        return;
    }
    if (has_word && !is_comparable && !is_exact_arc(text, block, radius)) {
        unknown_start(messages, block);
        return;
    }
    if (has_word && (fits || !exact || !has_center || !is_comparable)) {
        targets.written |= bit(Slot::Radius);
        targets.number[static_cast<std::size_t>(Slot::Radius)] = radius;
        return;
    }
    if (!exact || !has_center || !is_comparable) {
        messages.cannot_express(block, "an arc by radius from an unknown position");
        return;
    }
    if (is_coordinate_center(text, center_slot(axes[0]))) {
        place_center_as_coordinates(text, messages, block, start, *exact, targets);
        return;
    }
    const PlanePoint words = center_words(points, *exact, center_grid(text, block));
    for (std::size_t i = 0; i < 2; ++i) {
        targets.written |= bit(center_slot(axes[i]));
        targets.number[static_cast<std::size_t>(center_slot(axes[i]))] = words[i];
    }
}

}  // namespace

void place_arc(const TextView& text, BlockMessages& messages, const Block& block,
               const WrittenPosition& start, Targets& targets) {
    if (block.has(Slot::Radius)) return place_radius(text, messages, block, start, targets);
    if ((block.given & kCenterSlots) != 0) place_center(text, messages, block, start, targets);
}

void place_arc_as_given(const TextView& text, BlockMessages& messages, const Block& block,
                        const WrittenPosition& start, Targets& targets) {
    if ((block.given & kCenterSlots) != 0)
        place_center_as_given(text, messages, block, start, targets);
    if (!block.has(Slot::Radius)) return;
    if (!text.has_address(Slot::Radius))
        return messages.cannot_express(block, "an arc by its radius");
    targets.written |= bit(Slot::Radius);
    targets.number[static_cast<std::size_t>(Slot::Radius)] =
        text.to_text(Slot::Radius, block.at(Slot::Radius));
}

void place_arc_feed(const TextView& text, BlockMessages& messages, const Block& block,
                    const WrittenPosition& start, Targets& targets) {
    if (!text.modal.units.inverse_time || !text.feed_word.arc_by_radius) return;
    if (!is_chord_known(text, block, start))
        return messages.position_unknown(block, "F", text.unknown_ends(block, start));
    targets.feed_factor = meant_arc(text, block, start).sweep;
}

void place_helix_feed(const TextView& text, BlockMessages& messages, const Block& block,
                      const WrittenPosition& start, Targets& targets) {
    if (block.feed_along_arc == text.tables.rules.helix_feed_along_arc) return;
    if (text.modal.meant_of(Group::FeedMode) == Function::FeedInverseTime) return;
    if (!block.has(Slot::Feed) && !text.modal.has_meant_feed)
        return;  // whoever cuts without has its message
    const std::array<std::size_t, 3> axes = text.plane_axes();
    const auto third = static_cast<Slot>(axes[2]);
    if (!block.has(third)) return;
    const bool is_distance = text.is_distance(block, axes[2]);
    if (!is_distance && (start.known >> axes[2] & 1u) == 0)
        return messages.position_unknown(block, "F", text.unknown_ends(block, start));
    const double height = (block.at(third) - (is_distance ? 0 : start.meant[axes[2]])) *
                          text.on_part(axes[2]) * text.modal.frame.factors[axes[2]];
    if (std::fabs(height) < kSame) return;
    if (!is_chord_known(text, block, start))
        return messages.position_unknown(block, "F", text.unknown_ends(block, start));
    const auto [sweep, radius] = meant_arc(text, block, start);
    const double turns = block.has(Slot::Turns) ? std::nearbyint(block.at(Slot::Turns)) : 0;
    const double arc = radius * (sweep + 2 * std::numbers::pi * turns) *
                       std::fabs(text.modal.frame.factors[axes[0]]);
    if (arc < kSame) return;  // no arc: that has its message
    const double path = std::hypot(arc, height);
    targets.feed_factor = block.feed_along_arc ? path / arc : arc / path;
}

}  // namespace kadr::write
