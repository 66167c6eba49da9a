// orient_law.h — tool orientation while its tip goes along a path.
//
// The direction of the tool as a function of the distance along the path: no machine takes part
// (machine/), no words (interp/), no time (motion/).
#pragma once

#include "path/curve.h"
#include "path/orient_kind.h"
#include "path/vec3.h"

namespace kadr::path {

/// The tool orientation over a piece of path. A plain value: pieces are copied by the million.
struct OrientLaw {
    OrientKind kind = OrientKind::None;
    double length = 0;  // of the piece's path
    /// Where the piece begins. Cone: direction of the tool; Surface: the surface normal; Point: the
    /// second point of the tool's axis, mm.
    Vec3 start = Vec3::UnitZ();
    /// Cone, Surface: unit vector about which that goes. Point: how it goes per unit of path.
    Vec3 axis = Vec3::Zero();
    double rate = 0;           // Cone, Surface: rad per unit of path
    LeadTiltAngles lead_tilt;  // Surface
    /// Joints: the rotary axes as three coordinates, rad.
    Glide joints{{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, 0};
    /// Point: the curve is an arc, and the point to which the direction counts lies so far outwards
    /// of it, mm: it is a path beside the one that is programmed.
    double outwards = 0;
};

/// Direction of the tool at a distance along a piece, from tip to holder: unit vector. Of Joints
/// and Axes it is the chain's matter; there the answer is `start`.
///
/// curve  path of the tip over the piece, of any parameter of the length `orientation.length`
Vec3 direction_at(const OrientLaw& orientation, const Curve& curve, double distance);

/// The orientation over a part of the piece.
OrientLaw part_of(const OrientLaw& orientation, double from, double to);

/// The tool by its angles to a surface: the tangent is brought into the surface, t' = unit(t −
/// (t·n)n); the lead angle inclines the normal towards t', the tilt angle turns the result about t'
/// or n. Motion.md 6.1.
///
/// normal   unit vector
/// tangent  unit vector; where it is along the normal, or zero, an inclined tool has no direction:
///          the answer is the normal
Vec3 leant(const Vec3& normal, const Vec3& tangent, const LeadTiltAngles& lead_tilt);

/// The angle between two vectors, rad, 0 … π; exact near both ends.
double angle_between(const Vec3& a, const Vec3& b);

/// The angle between a direction of travel and a surface, rad: 0 where it lies in the surface.
double rise_of(const Vec3& normal, const Vec3& tangent);

}  // namespace kadr::path
