// cubic.h — a cubic piece of a curve in Bernstein form, and bounds of how far it leaves a line, a
// circle or another cubic.
//
// The bounds hold for every point of the piece, not for samples: a cubic stays in the hull of its
// control points, and so does the square of its distance from a centre in the hull of its own
// coefficients. Halving the piece makes the bounds as close as one likes.
#pragma once

#include <array>
#include <utility>

#include "path/vec3.h"

namespace kadr::path {

/// Control points of a cubic over 0 … 1, mm.
using Cubic = std::array<Vec3, 4>;

/// The cubic with these ends and derivatives by its parameter there.
Cubic hermite(const Vec3& from, const Vec3& slope_from, const Vec3& to, const Vec3& slope_to);

struct CubicPoint {
    Vec3 position;
    Vec3 derivative;  // mm per unit of the parameter 0 … 1
};
CubicPoint evaluate(const Cubic& cubic, double u);

/// The pieces before and behind a parameter, 0 … 1.
std::pair<Cubic, Cubic> split(const Cubic& cubic, double u);

/// How far a curve may be from the cubic that has its points and slopes at both ends, judged by
/// one point inside.
///
/// u               where the point is, 0 < u < 1
/// miss            curve less cubic there, mm
/// slope_miss      difference of the derivatives by the cubic's parameter there
/// returns         mm, the greatest difference on 0 … 1 if a polynomial of degree five joins the
///                 three points; a curve with a bounded sixth derivative differs from that by the
///                 sixth power of the width
/// source          error of Hermite interpolation: u²(1 − u)²·(k0 + k1·(u − u0))
double interpolation_error(double u, const Vec3& miss, const Vec3& slope_miss);

/// Least and greatest of the distance from a point in the plane of the first two coordinates, as
/// bounds: no point of the cubic is outside them. mm
struct DistanceBounds {
    double lower;
    double upper;
};
DistanceBounds distance_range(const Cubic& cubic, const Vec3& center);

/// Distance of a point from the straight line between two points, its ends included, mm.
double distance_to_line(const Vec3& point, const Vec3& from, const Vec3& to);

}  // namespace kadr::path
