// mill_shape.h — what of a tool touches a surface: its shape by its type, and its sizes
// (S 5.1, 5.3).
#pragma once

#include <cstdint>

#include "base/result.h"
#include "interp/tool_offsets.h"

namespace kadr::interp {

/// A mill as it touches with its end: an end, an edge that is a part of a torus, and a flank.
struct MillShape {
    double radius = 0;     // mm, wear included
    double edge = 0;       // radius of the rounding between end and flank, mm
    double flank = 0;      // between side and axis, rad: there the edge ends
    bool is_known = true;  // false: the type tells no shape of a mill
};

enum class MillShapeFault : std::uint8_t {
    EdgeTooLarge,  // or below zero
    FlankTooLarge,
};

/// The mill that an offset describes. Types 110, 111 and 157 have a ball, whose radius is that of
/// the tool, 121, 131 and 156 a rounded edge ($TC_DP7 and its wear), 120, 130, 140 and 155 none;
/// 111, 155, 156 and 157 taper ($TC_DP11 and its wear). A tool of another type counts as one with a
/// ball, of which the caller tells the user (unsure: taken from a published manual, from memory).
///
/// extra  mm, added to the radius
Result<MillShape, MillShapeFault> mill_shape(const ToolOffsets& offsets, std::int64_t number,
                                             double extra);

}  // namespace kadr::interp
