// Targets and arcs of a block: which words stand in the text, and with which numbers.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "base/diagnostics/dialect.h"
#include "base/numbers.h"
#include "base/units.h"
#include "nc/arc_words.h"
#include "nc/block_writer.h"

namespace kadr::nc {

namespace {

constexpr double kSame = 1e-9;  // mm or deg; far below any increment, above rounding noise

constexpr Slot center_slot(std::size_t axis) {
    return static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + axis);
}

constexpr std::size_t kX = 0;

/// By how much the ends of an arc differ in their distance from its centre.
double radius_miss(const ArcPoints& arc, const PlanePoint& center) {
    return std::fabs(std::hypot(arc.start[0] - center[0], arc.start[1] - center[1]) -
                     std::hypot(arc.end[0] - center[0], arc.end[1] - center[1]));
}

/// The points with one coordinate halved.
ArcPoints halved(ArcPoints arc, std::size_t coordinate) {
    for (PlanePoint* point : {&arc.start, &arc.end, &arc.text_start, &arc.text_end})
        (*point)[coordinate] /= 2;
    return arc;
}

/// An arc by its radius: the centre as meant and as the control makes it of the rounded words.
struct RadiusArc {
    ArcPoints points;
    std::optional<PlanePoint> exact;
    std::optional<PlanePoint> reached;
    bool fits = false;  // the rounding leaves the centre where it is
};

/// scale  units of the text in a millimetre
RadiusArc radius_arc(const ArcPoints& points, double radius, int places, bool is_clockwise,
                     double scale) {
    const double slack = kHalfTurnSlack * scale;
    RadiusArc arc{points, {}, {}};
    const double rounded = round_to(radius, places);
    arc.exact = center_of_radius(points.start, points.end, radius, is_clockwise, slack);
    arc.reached =
        center_of_radius(points.text_start, points.text_end, rounded, is_clockwise, slack);
    if (!arc.exact || !arc.reached) return arc;
    const auto apart = [](const PlanePoint& a, const PlanePoint& b) {
        return std::hypot(a[0] - b[0], a[1] - b[1]);
    };
    arc.fits = apart(*arc.exact, *arc.reached) <= 5 * std::pow(10.0, -places) &&
               apart(points.text_start, points.text_end) <= 2 * std::fabs(rounded);
    return arc;
}

}  // namespace

const Address& BlockWriter::address_of(Slot slot) const {
    return tables_.addresses[tables_.slot_address[static_cast<std::size_t>(slot)]];
}

bool BlockWriter::has_address(Slot slot) const {
    return tables_.slot_address[static_cast<std::size_t>(slot)] != kNoAddress;
}

double BlockWriter::to_text(Slot slot, double value) const {
    return value * text_scale(address_of(slot).dimension, modal_.units, true);
}

int BlockWriter::decimals(Slot slot) const {
    const Address& address = address_of(slot);
    if (slot == Slot::Feed && feed_is_lead_)
        return text_decimals(lead_format(address.format), address.dimension, modal_.units);
    return text_decimals(address.format, address.dimension, modal_.units);
}

/// First, second and third axis of the working plane.
std::array<std::size_t, 3> BlockWriter::plane_axes() const {
    switch (modal_.meant[static_cast<std::size_t>(Group::Plane)]) {
        case Function::PlaneZx: return {2, 0, 1};
        case Function::PlaneYz: return {1, 2, 0};
        default: return {0, 1, 2};
    }
}

/// Whether the block can be said under incremental dimensions only: all its words are distances,
/// and the control has neither AC() and IC() nor letters of distances to say them from places that
/// nobody knows.
bool BlockWriter::needs_incremental(const Block& block) const {
    const SlotMask given = block.given & kTargetSlots;
    if (given == 0 || (block.incremental & given) != given) return false;
    if (tables_.rules.has_modes || tables_.has_incremental_letters) return false;
    const bool has_functions = block.function_count != 0;
    if (has_functions && block.find(Function::MachineCoordinates) != nullptr) return false;
    // On the way to the reference point the control's own habit is a distance: G91 G28 Z0.
    const bool is_return = has_functions && block.find(Function::ReferenceReturn) != nullptr;
    return is_return || (modal_.position.known & given) != given;
}

void BlockWriter::place_targets(const Block& block, Targets& targets) {
    targets.needs_incremental = needs_incremental(block);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (block.has(static_cast<Slot>(axis))) place_target(block, axis, targets);
    }
}

void BlockWriter::place_target(const Block& block, std::size_t axis, Targets& targets) {
    const auto slot = static_cast<Slot>(axis);
    const SlotMask mask = bit(slot);
    if (!has_address(slot)) {
        cannot_express(block, "the axis " + std::string(kAxisNames[axis]));
        return;
    }
    const double scale = to_text(slot, 1);
    const int places = decimals(slot);
    const double value = block.at(slot);
    targets.written |= mask;
    const bool by_itself = ((block.incremental | block.absolute) & mask) != 0;
    if (block.function_count != 0 && block.find(Function::MachineCoordinates) != nullptr) {
        targets.number[axis] = value * scale;
        place_machine_target(block, axis, by_itself, targets);
        return;
    }
    WrittenPosition& position = modal_.position;
    const Function text_distance = modal_.text_of(Group::Distance);
    const Function meant_distance = modal_.meant_of(Group::Distance);
    if (!by_itself && meant_distance == Function::None) {
        // After raw text nobody knows what the number is; it goes through, the position is lost.
        targets.number[axis] = value * scale;
        position.known &= ~mask;
        return;
    }
    const bool is_distance =
        by_itself ? (block.incremental & mask) != 0 : meant_distance == Function::Incremental;
    const bool was_known = is_known(axis);
    const double old_text = position.text[axis];
    position.meant[axis] = is_distance ? position.meant[axis] + value : value;
    position.text[axis] = round_to(position.meant[axis] * scale, places) / scale;
    if (!is_distance) position.known |= mask;
    position.told &= ~mask;

    bool writes_distance = is_distance;
    if (by_itself && tables_.rules.has_modes) {
        (is_distance ? targets.wrapped_incremental : targets.wrapped_absolute) |= mask;
    } else if (tables_.has_incremental_letters) {
        if (is_distance && tables_.incremental_address[axis] == kNoAddress) {
            cannot_express(block, "a distance along " + std::string(kAxisNames[axis]));
        }
        if (is_distance) targets.by_letter |= mask;
    } else if (by_itself) {
        writes_distance = text_distance == Function::Incremental || targets.needs_incremental;
        if (writes_distance != is_distance && !was_known) position_unknown(block, kAxisNames[axis]);
    }
    targets.number[axis] =
        (writes_distance ? position.text[axis] - old_text : position.text[axis]) * scale;
}

/// Where machine coordinates count, no known position turns a distance into a coordinate.
void BlockWriter::place_machine_target(const Block& block, std::size_t axis, bool by_itself,
                                       Targets& targets) {
    const bool is_way = is_distance(block, axis);
    // FANUC ignores it under G91, SINUMERIK travels or not as SD42440 says.
    const bool is_machine = block.find(Function::MachineCoordinates) != nullptr;
    if (is_way && is_machine && (by_itself || tables_.rules.has_modes))
        return cannot_express(block, "a distance in machine coordinates");
    if (by_itself && tables_.rules.has_modes) {
        (is_way ? targets.wrapped_incremental : targets.wrapped_absolute) |=
            bit(static_cast<Slot>(axis));
    } else if (is_way && (by_itself || tables_.has_incremental_letters)) {
        cannot_express(block, "a distance in machine coordinates");
    }
}

/// Words of axes that stay where they are need not be written, as long as one moves.
void BlockWriter::drop_unchanged(const Block& block, const WrittenPosition& start,
                                 Targets& targets) {
    const Function motion = effective_motion(block);
    if (motion != Function::Rapid && motion != Function::Line) return;
    if (((block.incremental | block.absolute) & block.given) != 0) return;
    if (modal_.text_of(Group::Distance) != Function::Absolute) return;
    SlotMask unchanged = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const SlotMask mask = bit(static_cast<Slot>(axis));
        if ((targets.written & start.known & ~start.told & mask) == 0) continue;
        if (std::fabs(start.text[axis] - modal_.position.text[axis]) < kSame) unchanged |= mask;
    }
    if (unchanged != targets.written) targets.written &= ~unchanged;
}

// ---------------------------------------------------------------- arcs

void BlockWriter::place_arc(const Block& block, const WrittenPosition& start, Targets& targets) {
    if (block.has(Slot::Radius)) {
        if (place_radius(block, start, targets)) return;
    }
    if ((block.given & kCenterSlots) != 0) place_center(block, start, targets);
}

/// Whether the axis word is a distance; not where nobody knows what it is.
bool BlockWriter::is_distance(const Block& block, std::size_t axis) const {
    const SlotMask mask = bit(static_cast<Slot>(axis));
    if (((block.incremental | block.absolute) & mask) != 0) return (block.incremental & mask) != 0;
    return modal_.meant[static_cast<std::size_t>(Group::Distance)] == Function::Incremental;
}

/// Whether the way from the start of an arc to its end, in the plane, is known: from positions, or
/// because the block says it. An axis without a word does not move.
bool BlockWriter::is_chord_known(const Block& block, const WrittenPosition& start) const {
    const std::array<std::size_t, 3> axes = plane_axes();
    return std::ranges::all_of(std::span(axes).first<2>(), [&](std::size_t axis) {
        return (start.known >> axis & 1u) != 0 || !block.has(static_cast<Slot>(axis)) ||
               is_distance(block, axis);
    });
}

/// The words of an arc whose points nobody knows: as the block has them, nothing corrected.
void BlockWriter::place_arc_as_given(const Block& block, const WrittenPosition& start,
                                     Targets& targets) {
    if ((block.given & kCenterSlots) != 0) place_center_as_given(block, start, targets);
    if (!block.has(Slot::Radius)) return;
    if (!has_address(Slot::Radius)) return cannot_express(block, "an arc by its radius");
    targets.written |= bit(Slot::Radius);
    targets.number[static_cast<std::size_t>(Slot::Radius)] =
        to_text(Slot::Radius, block.at(Slot::Radius));
}

void BlockWriter::place_center_as_given(const Block& block, const WrittenPosition& start,
                                        Targets& targets) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Slot slot = center_slot(axis);
        if (!block.has(slot)) continue;
        if (!has_address(slot)) return cannot_express(block, "an arc centre");
        double number = to_text(slot, block.at(slot));
        const bool is_start_known = (start.known >> axis & 1u) != 0;
        const bool is_coordinate = (block.absolute & bit(slot)) != 0;
        if (is_coordinate_center(slot)) {
            if (!is_coordinate && is_start_known)
                number += to_text(slot, start.text[axis] * on_part(axis));
            if (!is_coordinate && !is_start_known) position_unknown(block, address_of(slot).name);
        } else if (is_coordinate) {
            // A coordinate, where the control takes distances only, needs the start.
            if (tables_.rules.has_modes) targets.wrapped_absolute |= bit(slot);
            else if (is_start_known) number -= to_text(slot, start.text[axis]);
            else position_unknown(block, address_of(slot).name);
        }
        targets.written |= bit(slot);
        targets.number[static_cast<std::size_t>(slot)] = number;
    }
}

/// Whether the end lies on the circle of the start as well as controls want it.
bool BlockWriter::is_on_circle(const ArcPoints& arc, const PlanePoint& center) const {
    constexpr double kMiss = 0.01;        // mm
    constexpr double kMissShare = 0.001;  // of the radius
    const double mm = to_text(static_cast<Slot>(plane_axes()[0]), 1);
    const double radius = std::hypot(arc.start[0] - center[0], arc.start[1] - center[1]);
    return radius_miss(arc, center) <= std::max(kMiss * mm, kMissShare * radius);
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
    if (!is_new_message(block, "an arc off its circle")) return;
    const double begin = std::hypot(arc.start[0] - center[0], arc.start[1] - center[1]);
    const double end = std::hypot(arc.end[0] - center[0], arc.end[1] - center[1]);
    sink_.report(diag::ArcOffCircle, place(block))
        .arg(length_in_words(begin))
        .arg(length_in_words(end));
}

void BlockWriter::place_center(const Block& block, const WrittenPosition& start, Targets& targets) {
    const std::array<std::size_t, 3> axes = plane_axes();
    const SlotMask in_plane = bit(center_slot(axes[0])) | bit(center_slot(axes[1]));
    const bool has_plane = modal_.meant_of(Group::Plane) != Function::None;
    if (const Slot across = center_slot(axes[2]);
        has_plane && (block.given & kCenterSlots & ~in_plane) != 0 && has_address(across)) {
        if (!is_new_message(block, "a centre outside of the plane")) return;
        sink_.report(diag::ArcWordOutsidePlane, word_place(block, address_of(across).name))
            .arg(address_of(across).name)
            .arg(std::string(kAxisNames[axes[0]]) + std::string(kAxisNames[axes[1]]));
        return;
    }
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
            const double scale = to_text(static_cast<Slot>(axes[i]), 1);
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
    if (axes[1] == kX && !knows_diameter()) {
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
    const bool is_turned = on_part(axes[0]) != 1 || on_part(axes[1]) != 1;
    const bool writes_absolute = is_absolute && tables_.rules.has_modes && !is_turned;
    const int places = decimals(center_slot(axes[0]));
    const PlanePoint words = center_words(arc, center, places, fixed_zero, writes_absolute);
    for (std::size_t i = 0; i < 2; ++i) {
        const Slot slot = center_slot(axes[i]);
        if (fixed_zero[i]) continue;
        if (!has_address(slot)) {
            cannot_express(block, "an arc centre");
            return;
        }
        targets.written |= bit(slot);
        double number = words[i];
        if (writes_absolute && (coordinates & bit(slot)) == 0) number -= arc.text_start[i];
        if (writes_absolute && (coordinates & bit(slot)) != 0)
            targets.wrapped_absolute |= bit(slot);
        targets.number[static_cast<std::size_t>(slot)] = number;
    }
}

/// Whether the letter of a centre counts as axis words do, and those are coordinates now.
bool BlockWriter::is_coordinate_center(Slot slot) const {
    return has_address(slot) && address_of(slot).is_coordinate &&
           modal_.text_of(Group::Distance) != Function::Incremental;
}

/// Centre and end of an arc as coordinates, all of them: where a centre stays for the next arc, a
/// word that is missing is not 0.
void BlockWriter::place_center_as_coordinates(const Block& block, const WrittenPosition& start,
                                              const PlanePoint& center, Targets& targets) {
    const std::array<std::size_t, 3> axes = plane_axes();
    const int places = decimals(center_slot(axes[0]));
    const PlanePoint words = center_words(arc_points(start), center, places, {false, false}, true);
    for (std::size_t i = 0; i < 2; ++i) {
        const Slot slot = center_slot(axes[i]);
        if (!has_address(slot)) return cannot_express(block, "an arc centre");
        if ((start.known >> axes[i] & 1u) == 0) return position_unknown(block, kAxisNames[axes[i]]);
        const SlotMask end = bit(static_cast<Slot>(axes[i]));
        if ((targets.written & end) == 0) {
            const auto slot_of_end = static_cast<Slot>(axes[i]);
            targets.number[axes[i]] = to_text(slot_of_end, modal_.position.text[axes[i]]);
        }
        targets.written |= bit(slot) | end;
        targets.number[static_cast<std::size_t>(slot)] = words[i];
    }
}

/// Whether the text says, or the control knows, what X is.
bool BlockWriter::knows_diameter() const {
    return modal_.text_of(Group::Diameter) != Function::None;
}

/// What a coordinate is multiplied with to be one of the part: X may be a diameter, a centre never.
double BlockWriter::on_part(std::size_t axis) const {
    return axis == kX && modal_.text_of(Group::Diameter) == Function::DiameterOn ? 0.5 : 1;
}

/// Start and end of the arc in the plane, on the part, in the text's units.
ArcPoints BlockWriter::arc_points(const WrittenPosition& start) const {
    const std::array<std::size_t, 3> axes = plane_axes();
    ArcPoints arc{};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t axis = axes[i];
        const double scale = to_text(static_cast<Slot>(axis), 1) * on_part(axis);
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
    const std::array<std::size_t, 3> axes = plane_axes();
    return is_exact(radius, decimals(Slot::Radius)) &&
           std::ranges::all_of(std::span(axes).first<2>(), [&](std::size_t axis) {
               const auto slot = static_cast<Slot>(axis);
               return !block.has(slot) || is_exact(to_text(slot, block.at(slot)), decimals(slot));
           });
}

/// The centre of an arc by its radius follows from its start, and near half a turn the rounding of
/// a word moves it by many times as much: from a start that nobody knows it may be anywhere.
void BlockWriter::unknown_start(const Block& block) {
    if (!is_new_message(block, "an arc by radius from an unknown position")) return;
    sink_.report(diag::ArcStartUnknown, place(block))
        .fix("say the start before it, `G0 X… Y…`, or the centre by `I` and `J`");
}

/// A radius stays a radius where the control has the word and the rounded points still give the
/// same centre; near half a turn they do not, and the centre is written instead.
bool BlockWriter::place_radius(const Block& block, const WrittenPosition& start, Targets& targets) {
    const std::array<std::size_t, 3> axes = plane_axes();
    const double scale = to_text(static_cast<Slot>(axes[0]), 1);
    const double radius = block.at(Slot::Radius) * scale;
    const bool has_word = has_address(Slot::Radius);
    const int places = decimals(has_word ? Slot::Radius : center_slot(axes[0]));
    const bool is_cw = effective_motion(block) == Function::ArcCw;
    RadiusArc arc = radius_arc(arc_points(start), radius, places, is_cw, scale);
    if (axes[1] == kX && !arc.fits && !knows_diameter()) {  // on a lathe X is a diameter
        const RadiusArc other = radius_arc(halved(arc.points, 1), radius, places, is_cw, scale);
        if (arc.exact && other.exact && is_chord_known(block, start)) {
            // Almost half a turn by the one reading: only its centre says it, and that of the other
            // is elsewhere.
            cannot_express(block,
                           "an arc of almost half a turn by its radius, while nothing says "
                           "whether X is a diameter (`DIAMON`, `DIAMOF`),");
            return true;
        }
        if (other.fits || (!arc.exact && other.exact)) arc = other;
    }
    const auto& [points, exact, reached, fits] = arc;
    const bool has_center = has_address(center_slot(axes[0])) && has_address(center_slot(axes[1]));
    // Without a position of start and end nothing can be converted; the control judges.
    const bool is_comparable = is_chord_known(block, start);
    if (is_comparable && !exact && !reached) {
        if (!is_new_message(block, "an arc by its radius")) return true;
        sink_.report(diag::ArcRadiusImpossible, place(block))
            .arg(length_in_words(radius))
            .arg(length_in_words(
                std::hypot(points.end[0] - points.start[0], points.end[1] - points.start[1])));
        return true;
    }
    if (has_word && !is_comparable && !is_exact_arc(block, radius)) {
        unknown_start(block);
        return true;
    }
    if (has_word && (fits || !exact || !has_center || !is_comparable)) {
        targets.written |= bit(Slot::Radius);
        targets.number[static_cast<std::size_t>(Slot::Radius)] = radius;
        return true;
    }
    if (!exact || !has_center || !is_comparable) {
        cannot_express(block, "an arc by radius from an unknown position");
        return true;
    }
    if (is_coordinate_center(center_slot(axes[0]))) {
        place_center_as_coordinates(block, start, *exact, targets);
        return true;
    }
    const int finest = decimals(center_slot(axes[0]));
    const PlanePoint words = center_words(points, *exact, finest, {false, false}, false);
    for (std::size_t i = 0; i < 2; ++i) {
        targets.written |= bit(center_slot(axes[i]));
        targets.number[static_cast<std::size_t>(center_slot(axes[i]))] = words[i];
    }
    return true;
}

/// The centre as the block means it, in the plane; the start if the block does not say.
PlanePoint BlockWriter::meant_center(const Block& block, const PlanePoint& start,
                                     const PlanePoint& end) const {
    const std::array<std::size_t, 3> axes = plane_axes();
    PlanePoint center = start;
    for (std::size_t i = 0; i < 2; ++i) {
        const Slot slot = center_slot(axes[i]);
        if (!block.has(slot)) continue;
        center[i] = (block.absolute & bit(slot)) != 0 ? block.at(slot) : start[i] + block.at(slot);
    }
    if (!block.has(Slot::Radius)) return center;
    const bool is_clockwise = effective_motion(block) == Function::ArcCw;
    return center_of_radius(start, end, block.at(Slot::Radius), is_clockwise).value_or(center);
}

/// The arc of a block in its plane, as the program means it. Its chord must be known.
BlockWriter::MeantArc BlockWriter::meant_arc(const Block& block,
                                             const WrittenPosition& start) const {
    const std::array<std::size_t, 3> axes = plane_axes();
    PlanePoint from{};
    PlanePoint to{};
    for (std::size_t i = 0; i < 2; ++i) {
        from[i] = start.meant[axes[i]] * on_part(axes[i]);
        to[i] = modal_.position.meant[axes[i]] * on_part(axes[i]);
    }
    const bool is_clockwise = effective_motion(block) == Function::ArcCw;
    const PlanePoint center = meant_center(block, from, to);
    return {.sweep = sweep_angle(from, to, center, is_clockwise),
            .radius = std::hypot(from[0] - center[0], from[1] - center[1]) / 2 +
                      std::hypot(to[0] - center[0], to[1] - center[1]) / 2};
}

/// Where F of an arc under inverse time is feed/radius, it is the angle over the time: so much
/// greater than 1/time.
void BlockWriter::place_arc_feed(const Block& block, const WrittenPosition& start,
                                 Targets& targets) {
    if (!modal_.units.inverse_time || !inverse_arc_by_radius_) return;
    if (!is_chord_known(block, start)) return position_unknown(block, "F");
    targets.feed_factor = meant_arc(block, start).sweep;
}

/// The tool of a helix shall be as fast as the program means it, where program and control count F
/// along different lengths: the way of the tool, or the arc that the helix is over.
void BlockWriter::place_helix_feed(const Block& block, const WrittenPosition& start,
                                   Targets& targets) {
    if (block.feed_along_arc == counts_feed_along_arc_) return;
    if (modal_.meant_of(Group::FeedMode) == Function::FeedInverseTime) return;
    if (!block.has(Slot::Feed) && !modal_.has_meant_feed)
        return;  // whoever cuts without has its message
    const std::array<std::size_t, 3> axes = plane_axes();
    const auto third = static_cast<Slot>(axes[2]);
    if (!block.has(third)) return;
    const bool is_way = is_distance(block, axes[2]);
    if (!is_way && (start.known >> axes[2] & 1u) == 0) return position_unknown(block, "F");
    const double height = (block.at(third) - (is_way ? 0 : start.meant[axes[2]])) *
                          on_part(axes[2]) * modal_.factors[axes[2]];
    if (std::fabs(height) < kSame) return;
    if (!is_chord_known(block, start)) return position_unknown(block, "F");
    const auto [sweep, radius] = meant_arc(block, start);
    const double turns = block.has(Slot::Turns) ? std::nearbyint(block.at(Slot::Turns)) : 0;
    const double arc =
        radius * (sweep + 2 * std::numbers::pi * turns) * std::fabs(modal_.factors[axes[0]]);
    if (arc < kSame) return;  // no arc: that has its message
    const double path = std::hypot(arc, height);
    targets.feed_factor = block.feed_along_arc ? path / arc : arc / path;
}

/// The axes of a straight block shall be as fast as the program means it, where program and control
/// count different ones: X, Y and Z, or all of them, of which a degree is a unit of length.
void BlockWriter::place_axes_feed(const Block& block, const WrittenPosition& start,
                                  Targets& targets) {
    constexpr SlotMask kFollowers = kTargetSlots & ~SlotMask{kLinearXYZ};
    if (block.feed_of_all_axes == counts_all_axes_ || (block.given & kFollowers) == 0) return;
    if (leads_tip() || modal_.meant_of(Group::FeedMode) == Function::FeedInverseTime) return;
    if (!block.has(Slot::Feed) && !modal_.has_meant_feed) return;  // that has its message
    double way = 0;                                                // squares, mm
    double parallel = 0;                                           // of U, V, W
    double turn = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (!block.has(static_cast<Slot>(axis))) continue;
        const std::optional<double> distance = meant_way(block, start, axis);
        if (!distance) return position_unknown(block, "F");
        const bool turns = is_rotary(static_cast<Axis>(axis));
        const double unit = turns && modal_.units.inch_feed ? kMmPerInch : 1;
        (turns ? turn : axis < 3 ? way : parallel) += *distance * *distance * unit * unit;
    }
    const double all = std::sqrt(way + parallel + turn);
    const double counted = std::sqrt(way > kSame * kSame ? way : parallel);
    if (counted < kSame || all - counted < kSame)
        return;  // where rotary axes are alone, F is theirs
    targets.feed_factor = block.feed_of_all_axes ? counted / all : all / counted;
}

/// How far an axis goes in a block, frames included; none where nobody knows where it stands.
std::optional<double> BlockWriter::meant_way(const Block& block, const WrittenPosition& start,
                                             std::size_t axis) const {
    const bool is_way = is_distance(block, axis);
    if (!is_way && (start.known >> axis & 1u) == 0) return std::nullopt;
    const double way = block.at(static_cast<Slot>(axis)) - (is_way ? 0 : start.meant[axis]);
    return axis < modal_.factors.size() ? way * on_part(axis) * modal_.factors[axis] : way;
}

/// Whether F is the speed of the tip, whatever the axes do.
bool BlockWriter::leads_tip() {
    const Function length = modal_.meant_of(Group::LengthComp);
    const Function transformation = modal_.meant_of(Group::Transformation);
    const bool is_axes = transformation == Function::None || transformation == Function::TcpOff;
    return !is_axes || length == Function::TcpLength || length == Function::TcpVector;
}

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
