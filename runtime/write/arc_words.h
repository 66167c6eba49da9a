// arc_words.h — the words of an arc on the grid of the text.
//
// End points are rounded to the control's increment, so the centre has to move a little as well,
// or the radii at start and end differ. Everything here is in the working plane and in the text's
// units; positions may count from any point that start and end share.
#pragma once

#include <array>
#include <optional>

namespace kadr::write {

using PlanePoint = std::array<double, 2>;

struct ArcPoints {
    PlanePoint start;  // as meant
    PlanePoint end;
    PlanePoint text_start;  // as the control has them
    PlanePoint text_end;
};

/// What the words of a centre can give.
struct CenterGrid {
    int decimals = 3;                  // of the words
    double end_increment = 1e-3;       // of the coordinates of start and end
    std::array<bool, 2> fixed_zero{};  // components that have no word and so are 0 from the start
    bool is_absolute = false;          // the words are coordinates, not distances from the start
    double most_misfit = 1e-2;         // of the radii that the control takes

    /// One increment: the coarser of both kinds of words.
    double increment() const;
};

/// Words of the centre that fit the rounded points best, and lie an increment at most from where
/// it is meant.
///
/// Of radii that do not agree the control makes a spiral, or moves the centre. A centre on the
/// bisector of the rounded ends has equal radii, but the direction of a short chord is noise of the
/// rounding: on an almost full circle that centre may be anywhere. Only where the radii would
/// differ by more than the control takes, since its increment is so coarse, it lies there all the
/// same.
///
/// center   as meant, in the same coordinates as the points
PlanePoint center_words(const ArcPoints& arc, const PlanePoint& center, const CenterGrid& grid);

/// The arc that a control makes of the words: its radius goes from one to the other.
struct TracedArc {
    PlanePoint center;
    double start_radius = 0;
    double end_radius = 0;
    double sweep = 0;         // rad, above 0
    bool is_refused = false;  // the centre would be shifted too far
};

/// What a control makes of rounded ends and a centre.
///
/// center         as the words give it, a point
/// shifts_center  whether it moves the centre onto the bisector, at the radius of the start
/// (S 4.2);
///                else the radius changes along the arc (F 3.5)
TracedArc traced_arc(const ArcPoints& arc, const PlanePoint& center, bool is_clockwise,
                     bool shifts_center);

/// By how much the traced arc leaves the one that is meant, across its direction; infinity if one
/// of them is almost a full circle and the other almost nothing, or the text does not tell which.
///
/// center, sweep  as meant
double path_error(const ArcPoints& arc, const PlanePoint& center, double sweep, bool is_clockwise,
                  const TracedArc& traced, double increment);

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
    bool fits = false;         // the rounding moves the centre by an increment at most
    bool fits_fairly = false;  // … by a few
};

/// The arc between the points by a radius that is written with `places` decimals.
///
/// scale  units of the text in a millimetre
RadiusArc radius_arc(const ArcPoints& points, double radius, int places, bool is_clockwise,
                     double scale);

}  // namespace kadr::write
