// arc.h — circular arcs and helices as controls program them, made into one form.
//
// Whatever was programmed (centre, radius, three points, tangent), the result is an Arc: a centre,
// a direction and an angle. Knows planes and tolerances, no G-codes and no axes' limits. Angles
// rad.
#pragma once

#include <numbers>

#include "base/result.h"
#include "path/command.h"
#include "path/frame.h"

namespace kadr::path {

/// Runs from `start` counter-clockwise about `normal` by `sweep`. Radius and height along the
/// normal go linearly from the start's to the end's, so both ends are met exactly: a small radius
/// error is spread over the arc, and a helix is an arc with height.
struct Arc {
    Vec3 start = Vec3::Zero();
    Vec3 end = Vec3::Zero();
    Vec3 center = Vec3::Zero();   // at the height of the start
    Vec3 normal = Vec3::UnitZ();  // unit vector
    double sweep = 0;             // rad, > 0, additional turns included
};

struct ArcEnds {
    Vec3 start = Vec3::Zero();
    Vec3 end = Vec3::Zero();
};

/// How the arc turns: as G2/G3 and G17…G19 have it.
struct ArcTurning {
    Plane plane = Plane::Xy;
    bool is_clockwise = false;  // seen from the positive third axis of the plane
    int turns = 0;              // additional full turns, >= 0
};

/// What a control does with an end point that is not exactly on the circle.
enum class RadiusError : std::uint8_t {
    Spread,       // the radius goes linearly from the start's to the end's
    ShiftCenter,  // the centre moves onto the perpendicular bisector, radius of the start
};

/// The end point is accepted when |r0 − r1| <= max(constant, factor · r0).
struct ArcTolerance {
    double constant = 0.01;  // mm
    double factor = 1e-3;
    RadiusError mode = RadiusError::Spread;
    /// How far the centre may turn about the start when it is shifted, rad; beyond it the
    /// correction would be none any more. Source: SINUMERIK, reference chapter "Circles".
    double shift_angle = 1.8 * std::numbers::pi / 180;
};

enum class ArcFault : std::uint8_t {
    NoRadius,        // the centre is the start point
    RadiusMismatch,  // the end point is not on the circle
    NoChord,         // radius form with end = start: the centre is not determined
    RadiusTooSmall,  // the radius is smaller than half the chord
    BadTurns,        // number of turns negative or absurd
    Collinear,       // three points on a line, the middle one not between the others
    Straight,        // no arc, but the straight line from start to end
    Backwards,       // tangent form: the end lies straight behind
};

/// Largest number of additional turns (SINUMERIK, programming manual, "TURN").
inline constexpr int kMaxTurns = 999;

/// Arc about `center` (its height does not matter). End equal to start is a full turn.
Result<Arc, ArcFault> arc_about_center(const ArcEnds& ends, const Vec3& center,
                                       const ArcTurning& turning, const ArcTolerance& tolerance);

/// Arc of a radius, mm: positive up to half a turn, negative more than half a turn. A chord that is
/// longer than the diameter by less than kSemicircleSlack makes a semicircle.
Result<Arc, ArcFault> arc_of_radius(const ArcEnds& ends, double radius, const ArcTurning& turning);
inline constexpr double kSemicircleSlack = 1e-3;  // mm; one increment of a millimetre control

/// Arc in space from start over `through` to end.
Result<Arc, ArcFault> arc_through(const ArcEnds& ends, const Vec3& through);

/// Arc in space that leaves the start along `tangent` (any length > 0).
Result<Arc, ArcFault> arc_along_tangent(const ArcEnds& ends, const Vec3& tangent);

/// Position, first and second derivative by the angle swept, at an angle from 0 to `sweep`.
/// Computed from the angle itself, so that nothing drifts.
struct ArcPoint {
    Vec3 position;
    Vec3 first;
    Vec3 second;
};
ArcPoint point_at(const Arc& arc, double angle);

/// Radius at the start and at the end, and the height from start to end along the normal, mm.
struct ArcMeasures {
    double start_radius = 0;
    double end_radius = 0;
    double height = 0;
};
ArcMeasures measures_of(const Arc& arc);

/// Length of the arc, mm; closed form, exact for equal radii and for spirals.
double length_of(const Arc& arc);

}  // namespace kadr::path
