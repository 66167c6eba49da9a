// curve.h — one piece of path as geometry, walked by its arc length (a Glide: by its parameter).
//
// Geometry only: no time (motion/profile.h), no axes (motion/limits.h), no text (nc/). What the
// planner has closed forms for is a kind of its own: a file beside line.h, helix.h and spline.h
// with the functions below, and one entry in `Curve`; the compiler then finds what it forgot.
// Everything else is Parametric, which is open: its kinds are registered (curve_registry.h).
//
// Every kind has `length`, `start`, `end`, `position`, `evaluate`, `part` and `bounds`.
#pragma once

#include <variant>

#include "path/glide.h"
#include "path/helix.h"
#include "path/involute.h"
#include "path/line.h"
#include "path/parametric.h"
#include "path/spline.h"
#include "path/vec3.h"

namespace kadr::path {

/// A plain value without heap: segments are copied by the million.
using Curve = std::variant<Point, Line, Helix, CubicSpan, Glide, QuinticSpan, Involute, Parametric>;

/// Whether the curvature may change along it in its own manner: a line and an arc have one.
inline bool bends_freely(const Curve& curve) {
    return std::holds_alternative<CubicSpan>(curve) || std::holds_alternative<QuinticSpan>(curve) ||
           std::holds_alternative<Involute>(curve) || std::holds_alternative<Glide>(curve) ||
           std::holds_alternative<Parametric>(curve);
}

/// Range of `s` of the whole curve, mm: its arc length but for a Glide.
double length(const Curve& curve);
/// How far the tool goes along the whole curve, mm.
double arc_length(const Curve& curve);
Vec3 start(const Curve& curve);
/// The programmed end, exactly.
Vec3 end(const Curve& curve);

/// The point at arc length `s` from the start. `s` ≤ 0 gives the start and `s` ≥ length the end,
/// both exactly; every other point is computed from `s` alone, so nothing accumulates.
Vec3 position(const Curve& curve, double s);

/// Point, direction and bending at arc length `s`; of a Point the direction is zero.
CurvePoint evaluate(const Curve& curve, double s);

/// The piece from arc length `from` to `to`, 0 ≤ from ≤ to ≤ length.
Curve part(const Curve& curve, double from, double to);

/// Least and greatest coordinates on the whole curve.
Box bounds(const Curve& curve);

}  // namespace kadr::path
