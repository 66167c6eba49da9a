// contour_corner.h — what takes the place of a corner between two elements: a chamfer or a
// rounding.
//
// Exact geometry of lines and arcs in a plane. How large it may be on a control, and what stands
// before and behind it, is the caller's matter.
#pragma once

#include <cstdint>
#include <optional>

#include "path/contour.h"

namespace kadr::path {

/// Changes of direction below this are no corner, rad: a contour goes on without a mark there.
inline constexpr double kNoTurn = 1e-6;

struct CornerCut {
    double leaves = 1;  // share of the first element's length up to which it is travelled
    double joins = 0;   // share of the second one's length from which it is travelled
    Element piece;      // between the two
};

/// Change of direction where the first element ends and the second one begins, rad, −π to π, left
/// positive.
double turn_between(const Element& a, const Element& b);

/// The line between the two points that lie at the distance `width` from the corner, mm, one on
/// each element. None if an element does not reach so far.
std::optional<CornerCut> chamfer(const Element& a, const Element& b, double width);
/// The greatest width of a chamfer.
double widest_chamfer(const Element& a, const Element& b);
/// The width of the longest chamfer: beside an arc it may be less than the greatest.
double width_of_longest_chamfer(const Element& a, const Element& b);
/// The least width of a chamfer that is `length` long; none if an element does not reach so far.
///
/// source  between two lines with the angle β inside the corner: length = 2 · width · sin(β/2)
std::optional<double> chamfer_width(const Element& a, const Element& b, double length);

/// The arc of this radius, mm, that is tangent to both elements. None if its ends would not lie on
/// them, or if there is no corner.
std::optional<CornerCut> rounding(const Element& a, const Element& b, double radius);
/// The greatest radius up to `most` that fits, 0 if none does.
double greatest_rounding(const Element& a, const Element& b, double most);

/// What a corner is to become, and how large.
struct CornerShape {
    enum class Kind : std::uint8_t { ChamferLength, ChamferWidth, Rounding };
    Kind kind = Kind::Rounding;
    double size = 0;  // length, width or radius, mm
};
struct MadeCorner {
    CornerCut cut;
    double size = 0;  // as it was made, mm
};
/// The corner as it is wanted. Where it does not fit: the greatest that does, if it may shrink;
/// else, and where there is none, nothing.
std::optional<MadeCorner> made_corner(const Element& a, const Element& b, const CornerShape& shape,
                                      bool may_shrink);

}  // namespace kadr::path
