// orientation.h — orientations as programs name them, and how one goes over into another.
//
// Angles, vectors and surface normals become unit vectors and matrices here, and back; between two
// of them the tool follows an arc on the sphere. No machine takes part (kinematics.h has the axes)
// and no words (those are the interpreter's). Angles in rad.
#pragma once

#include <array>
#include <cstdint>

#include "base/result.h"
#include "machine/chain.h"
#include "path/orient_law.h"

namespace kadr::machine {

enum class OrientationFault : std::uint8_t {
    ZeroVector,          // a vector without length has no direction
    Antiparallel,        // opposite ends: the plane between them is not determined
    NotOnCone,           // the ends are not on a cone about this axis, or one of them is the axis
    OpeningSmall,        // the opening angle is less than the angle between the ends
    EqualVectors,        // three different vectors are needed
    NormalAlongTangent,  // the surface normal has no part across the path
};

/// The direction of a vector of any length; missing components are zeros.
Result<Vec3, OrientationFault> unit_of(const Vec3& vector);

/// Rotations about Z, Y', Z'' (AxiOMA's Euler angles): R = Rz(first) · Ry(second) · Rz(third). The
/// tool is (cos first · sin second, sin first · sin second, cos second).
Mat3 euler_zyz(const Vec3& angles);
/// Rotations about Z, X', Z'' (SINUMERIK, ORIEULER A2, B2, C2): R = Rz(A2) · Rx(B2) · Rz(C2).
Mat3 euler_zxz(const Vec3& angles);
/// Roll, pitch, yaw about Z, Y', X'' (ORIRPY; A2, B2, C2 are the angles about X, Y, Z):
/// R = Rz(C2) · Ry(B2) · Rx(A2).
Mat3 rpy_zyx(const Vec3& angles);
/// Rotations about X, Y', Z'' (ORIRPY2): R = Rx(A2) · Ry(B2) · Rz(C2).
Mat3 rpy_xyz(const Vec3& angles);

/// Two names of the same orientation, in (−π, π].
using AnglePair = std::array<Vec3, 2>;

/// Angles of a rotation, the second angle ≥ 0 first. Where the second is 0 or π only the sum or the
/// difference of the others is determined; the first is 0 then.
AnglePair euler_zyz_of(const Mat3& rotation);
AnglePair euler_zxz_of(const Mat3& rotation);
/// A2 and B2 of a direction with C2 = 0, ORIRPY; |A2| ≤ π/2 first.
AnglePair rpy_of_direction(const Vec3& direction);

/// A vector that changes along the path, with its derivative by the parameter.
struct Varying {
    Vec3 value = Vec3::Zero();
    Vec3 rate = Vec3::Zero();
};

/// The direction of a changing vector and how it changes; e.g. of the difference of two curves,
/// ORICURVE.
Result<Varying, OrientationFault> unit_of(const Varying& vector);

using path::TiltAbout;
using LeadTilt = path::LeadTiltAngles;

/// The tool by its angles to a surface: the tangent is first brought into the surface, t' = unit(t
/// − (t·n)n); LEAD inclines the normal towards t', TILT turns the result about t' or n.
///
/// tangent, normal  of any length; their rates may be zero
Result<Varying, OrientationFault> by_lead_tilt(const Varying& tangent, const Varying& normal,
                                               const LeadTilt& angles);

/// LEAD and TILT of a direction; the inverse. At LEAD = 0 about the normal TILT is 0.
///
/// tangent, normal  unit vectors at right angles
LeadTilt lead_tilt_of(const Vec3& direction, const Vec3& tangent, const Vec3& normal,
                      TiltAbout about);

/// The tool between start and end of a block: at `polar` from an axis, turning about it by `turn`.
/// A great circle is the cone with the polar angle of a right angle. Plain values, no allocation.
struct OrientationArc {
    Vec3 axis = Vec3::UnitZ();    // unit vector
    Vec3 across = Vec3::UnitX();  // unit vector at right angles, towards the start
    Vec3 beside = Vec3::UnitY();  // axis × across
    double polar = 0;             // of the start
    double polar_change = 0;      // to the end; 0 on a cone
    double turn = 0;              // to the end, right-handed about the axis
    double spin = 0;              // of the tool about itself, at the start …
    double spin_change = 0;       // … and to the end
};

/// Point on an arc, and derivatives by the fraction of the path.
struct OrientationPoint {
    Vec3 direction = Vec3::UnitZ();
    Vec3 rate = Vec3::Zero();     // dw/df
    Vec3 bending = Vec3::Zero();  // d²w/df²
    double spin = 0;              // about the tool, rad
    double spin_rate = 0;
};

/// fraction  0 … 1 of the path
OrientationPoint at(const OrientationArc& arc, double fraction);

/// Length of the path of the direction, rad.
double length_of(const OrientationArc& arc);

/// The shorter great circle, ORIVECT. start, end: unit vectors, as in all of the following.
Result<OrientationArc, OrientationFault> great_circle(const Vec3& start, const Vec3& end);

enum class ConeSense : std::uint8_t { Ccw, Cw };  // right-handed about the axis, or not

/// Cone about a given axis, ORICONCCW and ORICONCW. Ends that are not on one cone get an opening
/// that changes linearly, up to a difference of `tolerance` (rad); beyond it there is no answer.
Result<OrientationArc, OrientationFault> cone_about(const Vec3& start, const Vec3& end,
                                                    const Vec3& axis, ConeSense sense,
                                                    double tolerance);

/// Cone with a given full opening angle, NUT, by its shorter rotation (motion.md 6.2).
Result<OrientationArc, OrientationFault> cone_of_opening(const Vec3& start, const Vec3& end,
                                                         double opening, ConeSense sense);

/// Cone from start over a vector between, to the end, ORICONIO.
Result<OrientationArc, OrientationFault> cone_through(const Vec3& start, const Vec3& between,
                                                      const Vec3& end);

/// Cone that leaves the start in the direction in which the motion before arrived, ORICONTO.
///
/// rate  direction of the change at the start, of any length; zero: the great circle
Result<OrientationArc, OrientationFault> cone_tangential(const Vec3& start, const Vec3& rate,
                                                         const Vec3& end);

}  // namespace kadr::machine
