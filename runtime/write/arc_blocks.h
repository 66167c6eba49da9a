// arc_blocks.h — arcs that need other blocks than their own: several revolutions on a control
// without a word for them, and arcs that their rounded words would make others.
//
// A plan tells once what is shared out; each of its blocks follows from it and from where the text
// stands when its turn comes.
#pragma once

#include <array>
#include <optional>

#include "write/arcs.h"
#include "write/messages.h"

namespace kadr::write {

/// An arc in parts that end at shares of its angle, the last one at 1.
struct ArcParts {
    Block block;  // the whole
    PlannedArc arc;
    std::array<double, 3> ends{};
    std::size_t count = 0;
    std::array<std::size_t, 3> axes{};  // of the plane
    WrittenPosition begin;
    double turns = 0;          // additional ones, which come first
    bool by_radius = false;    // the parts have a radius, not a centre
    bool shares_time = false;  // under inverse time
    double feed = 0;           // of the whole; holds if shares_time
};
/// Arcs that rounding spoils are written in two or three parts: almost a full circle, where the
/// direction from end to start is noise of the rounding, and almost half a turn, where a control
/// that moves the centre moves it far. None: the block can be written as it is.
std::optional<ArcParts> parts_of_arc(const TextView& text, BlockMessages& messages,
                                     const Block& block);

/// The block of a part. What stops or ends the program comes behind the last part, other functions
/// before the first; additional turns come first, as everywhere.
Block block_of(const ArcParts& parts, std::size_t part, const TextView& text);

/// A helix of several turns, one block a turn, and the rest of it.
struct HelixTurns {
    Block block;             // the whole
    bool is_shared = false;  // false: its turns cannot be shared out, and the rest is all there is
    Function motion = Function::None;
    bool is_incremental = false;  // the dimensions that are meant
    int turns = 0;                // full ones
    int chords = 0;               // lines that it is written as, where the control has no helices
    double rest = 0;              // angle of the rest, rad
    std::array<std::size_t, 3> axes{};
    PlanePoint from{};    // in the plane, on the part, mm
    PlanePoint center{};  // …
    std::array<double, kAxes> begin{};
    std::array<double, kAxes> end{};
    bool shares_time = false;  // under inverse time
    double inverse_time = 0;   // of F, for a radian; holds if shares_time
};
/// None: the block has no turns, or the control has a word for them; and it is no helix of a
/// control without these.
std::optional<HelixTurns> turns_of(const TextView& text, BlockMessages& messages,
                                   const Block& block);

/// turn  from 1
Block circle_of(const HelixTurns& helix, int turn, const TextView& text);
/// chord  from 1
Block chord_of(const HelixTurns& helix, int chord, const TextView& text);
/// What the circles have left.
Block rest_of(const HelixTurns& helix, const TextView& text);

}  // namespace kadr::write
