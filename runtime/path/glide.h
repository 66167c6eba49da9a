// glide.h — a cubic walked by its parameter instead of its arc length.
//
// What other curves call s is the parameter here, scaled so that |dC/ds| is 1 where the curve
// leaves and joins the path beside it; elsewhere it is less. So the axes follow a cubic of the time
// while s grows evenly, as in a ramp under a limit of the jerk: around a corner one axis slows down
// while the other one speeds up, and the tool is slower in the middle.
//
// "length" is the range of s, mm; `tangent` is dC/ds, not a unit vector, and `curvature` d²C/ds².
// Every limit of an axis holds for them as it does for arc lengths.
#pragma once

#include "path/cubic.h"
#include "path/vec3.h"

namespace kadr::path {

struct Glide {
    Cubic cubic;
    double length;  // > 0
};

inline double length(const Glide& glide) { return glide.length; }
inline Vec3 start(const Glide& glide) { return glide.cubic[0]; }
inline Vec3 end(const Glide& glide) { return glide.cubic[3]; }
Vec3 position(const Glide& glide, double s);
CurvePoint evaluate(const Glide& glide, double s);
/// d³C/ds³, 1/mm²; the same everywhere.
Vec3 third_derivative(const Glide& glide);
Glide part(const Glide& glide, double from, double to);
/// Of the control points: never too small.
Box bounds(const Glide& glide);
double arc_length(const Glide& glide);

}  // namespace kadr::path
