// helix.h — an arc of a circle, with or without height, whose ends may lie on different radii.
//
// The angle φ runs from 0 to the sweep, counter-clockwise about the normal:
//
//     C(φ) = base + (r0 + r'·φ)·(cos φ·e1 + sin φ·e2) + h'·φ·normal
//
// A control accepts an end point that misses the circle by some hundredths of a millimetre and
// spreads the miss over the arc; r' does that and is 0 for an exact circle.
#pragma once

#include "path/vec3.h"

namespace kadr::path {

struct Helix {
    Vec3 base;           // centre, at the height of the start
    Vec3 e1;             // unit vector from the centre to the start
    Vec3 e2;             // e1 turned by 90° about the normal
    Vec3 normal;         // unit vector
    Vec3 start;          // as programmed
    Vec3 end;            // as programmed
    double radius;       // r0 at the start, mm
    double radius_rate;  // r' = (r1 − r0)/sweep, mm/rad
    double height_rate;  // h' = height/sweep, mm/rad
    double sweep;        // rad, > 0
    double length;       // mm
    // s(φ) ≈ rate·φ + rate_slope·φ²/2, exact for r' = 0.
    double rate;        // ds/dφ at the start, mm/rad
    double rate_slope;  // mm/rad²
    bool needs_newton;  // the approximation misses by more than the arc length may
};

/// An arc as a Command states it.
///
/// start, end   programmed points
/// center       any point of the axis
/// normal       unit vector; the arc runs counter-clockwise about it
/// sweep        rad, > 0, additional turns included
Helix make_helix(const Vec3& start, const Vec3& end, const Vec3& center, const Vec3& normal,
                 double sweep);

inline double length(const Helix& helix) { return helix.length; }
inline Vec3 start(const Helix& helix) { return helix.start; }
inline Vec3 end(const Helix& helix) { return helix.end; }
Vec3 position(const Helix& helix, double s);
CurvePoint evaluate(const Helix& helix, double s);
Helix part(const Helix& helix, double from, double to);
Box bounds(const Helix& helix);

/// The angle φ, rad, at arc length `s`, 0 ≤ s ≤ length; true to kArcLengthTolerance.
double angle_at(const Helix& helix, double s);
Vec3 position_at_angle(const Helix& helix, double angle);

/// Least and greatest value of `mean + a·cos φ + b·sin φ` for φ from 0 to `sweep`.
struct Extremes {
    double lower;
    double upper;
};
Extremes wave_extremes(double mean, double a, double b, double sweep);

/// How far the arc length of a point may be from the length asked for, mm. A thousandth of the
/// smallest increment that controls use.
inline constexpr double kArcLengthTolerance = 1e-9;

}  // namespace kadr::path
