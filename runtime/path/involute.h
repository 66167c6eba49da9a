// involute.h — the involute of a circle: what the end of a taut string draws that unwinds from it.
//
// With the base circle's radius r, its centre c and the angle t that the string has unwound,
//
//     C(t) = c + r·(e(σt) − σt·e'(σt)),   e(θ) = cos θ·e1 + sin θ·e2,   σ = ±1
//
// so dC/dt = r·t·e(σt): the length is r·t²/2, and everything is known in closed form. The distance
// from the centre is r·√(1 + t²), the angle about it σ·(t − atan t). A height along the normal
// grows evenly with the path in the plane.
#pragma once

#include "base/result.h"
#include "path/vec3.h"

namespace kadr::path {

struct Involute {
    Vec3 base;           // centre, at the height of the start
    Vec3 e1;             // from the centre to where the string leaves the circle at t = 0
    Vec3 e2;             // e1 turned by 90° about the normal
    Vec3 normal;         // unit vector
    Vec3 start;          // as programmed
    Vec3 end;            // as programmed
    double radius;       // r of the base circle, mm, > 0
    double hand;         // σ: +1 where the string unwinds counter-clockwise about the normal
    double first;        // t at the start …
    double last;         // … and at the end, both ≥ 0
    double height;       // of the whole, mm
    double height_rate;  // mm per mm in the plane
    double length;       // mm
};

/// The involute as a Command states it: from `start` counter-clockwise about `normal` to `end`,
/// both outside of the base circle and not equally far from its centre.
Involute make_involute(const Vec3& start, const Vec3& end, const Vec3& center, const Vec3& normal,
                       double base_radius);

inline double length(const Involute& involute) { return involute.length; }
inline Vec3 start(const Involute& involute) { return involute.start; }
inline Vec3 end(const Involute& involute) { return involute.end; }
Vec3 position(const Involute& involute, double s);
CurvePoint evaluate(const Involute& involute, double s);
Involute part(const Involute& involute, double from, double to);
Box bounds(const Involute& involute);

/// What is programmed for an involute. It runs counter-clockwise about the normal.
struct InvoluteWords {
    Vec3 start = Vec3::Zero();
    Vec3 center = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();
    double base_radius = 0;  // mm, > 0
};

enum class InvoluteFault : std::uint8_t {
    Radius,  // of the base circle: not above zero
    Inside,  // an end is not outside of the base circle
    Even,    // both ends are equally far from the centre: no involute joins them
    EndOff,  // the end is not on the involute
};

/// The base radius with which an involute runs through both ends exactly. An end that lies beside
/// the involute of the radius that was programmed is accepted within `tolerance`, mm: how far it is
/// from that involute.
Result<double, InvoluteFault> base_radius_through(const InvoluteWords& words, const Vec3& end,
                                                  double tolerance);

/// Where the involute ends that is seen from the centre under this angle, rad: above zero away from
/// the base circle, below it towards the circle.
Result<Vec3, InvoluteFault> involute_end(const InvoluteWords& words, double opening);

}  // namespace kadr::path
