// arcs.h — arcs of blocks in the plane of the text: as they are meant, and as their words will have
// them.
//
// Questions only: which words an arc gets is arc_targets.h, which other blocks arc_blocks.h, the
// geometry behind both arc_words.h.
#pragma once

#include <optional>

#include "write/arc_words.h"
#include "write/text_view.h"

namespace kadr::write {

/// Whether the distance from the start of an arc to its end, in the plane, is known: from
/// positions, or because the block gives it. An axis without a word does not move.
bool is_chord_known(const TextView& text, const Block& block, const WrittenPosition& start);

/// Whether the end lies on the circle of the start as well as the control wants it.
bool is_on_circle(const TextView& text, const ArcPoints& arc, const PlanePoint& center);

/// Whether the letter of a centre counts as axis words do, and those are coordinates now.
bool is_coordinate_center(const TextView& text, Slot slot);

/// Start and end of the arc in the plane, on the part, in the text's units; the end is where the
/// axis words have brought the position.
ArcPoints arc_points(const TextView& text, const WrittenPosition& start);

/// Whether the radius and the end of an arc lose nothing by the decimals that the text has.
bool is_exact_arc(const TextView& text, const Block& block, double radius);

/// What the words of the block's centre can give; the control has one of the two.
CenterGrid center_grid(const TextView& text, const Block& block);

/// The centre as the block means it, in the plane; the start if the block does not give it.
PlanePoint meant_center(const TextView& text, const Block& block, const PlanePoint& start,
                        const PlanePoint& end);

struct MeantArc {
    double sweep;   // rad, above 0
    double radius;  // mm
};
/// The arc of a block in its plane, as the program means it. Its chord must be known.
MeantArc meant_arc(const TextView& text, const Block& block, const WrittenPosition& start);

/// An arc before its words are made: in its plane, on the part, in the text's units.
struct PlannedArc {
    ArcPoints points;
    PlanePoint center;  // as meant
    double sweep = 0;   // as meant, rad, above 0
    bool is_clockwise = false;
    std::array<double, 2> part = {1, 1};  // what coordinates are multiplied with
};
/// The arc of the block as it is meant and as the text has its ends, with the plane and the
/// dimensions that are in force; none if it is no arc whose points and centre are known.
std::optional<PlannedArc> planned_arc(const TextView& text, const Block& block);

/// By how much the control's path leaves the arc if the block is written in one piece, in the
/// text's units; infinity if it is another one.
double text_error(const TextView& text, const Block& block, const PlannedArc& arc);

/// Whether rounding takes an arc away: its end falls on its start or beside it, which a control
/// would take for a full circle, or it is smaller than two increments, so that its rounded words
/// mean any angle. An arc of more than half a turn is one that a full circle stands for well.
bool vanishes(const TextView& text, const Block& block);

}  // namespace kadr::write
