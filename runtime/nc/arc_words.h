// arc_words.h — the words of an arc on the grid of the text.
//
// End points are rounded to the control's increment, so the centre has to move a little as well,
// or the radii at start and end differ. Everything here is in the working plane and in the text's
// units; positions may count from any point that start and end share.
#pragma once

#include <array>
#include <optional>

namespace kadr::nc {

using PlanePoint = std::array<double, 2>;

struct ArcPoints {
    PlanePoint start;  // as meant
    PlanePoint end;
    PlanePoint text_start;  // as the control has them
    PlanePoint text_end;
};

/// Centre as seen from the start that fits the rounded points best, on the grid of `decimals`.
///
/// center        as meant, in the same coordinates as the points
/// fixed_zero    components that have no word and so are 0 from the start
/// is_absolute   the words are coordinates, not distances from the start
/// returns       the words
PlanePoint center_words(const ArcPoints& arc, const PlanePoint& center, int decimals,
                        const std::array<bool, 2>& fixed_zero, bool is_absolute);

/// By how much a chord may be longer than the diameter and makes half a turn, mm.
///
/// source       S 4.2, F 3.5
inline constexpr double kHalfTurnSlack = 1e-3;

/// Centre of the arc by radius (negative: more than half a turn); nothing if the radius does not
/// span the chord or there is no chord.
///
/// slack  as kHalfTurnSlack, in the unit of the points
std::optional<PlanePoint> center_of_radius(const PlanePoint& start, const PlanePoint& end,
                                           double radius, bool is_clockwise,
                                           double slack = kHalfTurnSlack);

/// Angle that the arc turns about its centre, rad, in (0, 2π]: start = end is a full circle.
double sweep_angle(const PlanePoint& start, const PlanePoint& end, const PlanePoint& center,
                   bool is_clockwise);

/// By how much the ends of an arc differ in their distance from its centre, as meant.
double radius_miss(const ArcPoints& arc, const PlanePoint& center);

/// An arc by its radius: the centre as meant and as the control makes it of the rounded words.
struct RadiusArc {
    ArcPoints points;
    std::optional<PlanePoint> exact;
    std::optional<PlanePoint> reached;
    bool fits = false;  // the rounding leaves the centre where it is
};

/// The arc between the points by a radius that is written with `places` decimals.
///
/// scale  units of the text in a millimetre
RadiusArc radius_arc(const ArcPoints& points, double radius, int places, bool is_clockwise,
                     double scale);

}  // namespace kadr::nc
