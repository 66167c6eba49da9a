// contact.h — where a cutter touches what is programmed, and where its tip is then (motion.md §8.2,
// §8.3; S 5.3).
//
// Under 3D compensation the path of a program is that of the point where the cutter
// touches. Where the tip goes follows from it, from the tool's direction and from how the contour
// or the surface lies there.
#pragma once

#include <cstdint>
#include <optional>

#include "path/vec3.h"

namespace kadr::path {

enum class ContactKind : std::uint8_t {
    Tip,     // the tip itself
    Flank,   // the flank touches the contour, whose tangent is that of the path
    Pivot,   // … while it stays at one point and `guide`, the tangent, turns
    Corner,  // … and touches two lines that meet there: `guide` and `axis` are their directions
    Face,    // a cutter with an edge radius touches a surface; `guide` is its normal, outwards,
             // along the path or, where that stands, at an edge around which the cutter rolls
};

/// How a cutter touches along a motion.
struct Contact {
    ContactKind kind = ContactKind::Tip;
    Vec3 guide = Vec3::Zero();  // unit vector where the motion begins
    Vec3 axis = Vec3::Zero();   // about which it turns, unit vector
    double turn = 0;            // by so much over the motion, rad
    double radius = 0;          // mm; peripheral: positive where the cutter is right of the contour
    double depth = 0;           // mm; of the contour above the tip (ISD); face milling: edge radius
    double allowance = 0;       // mm; face milling: left on the surface
};

/// The same with the point in a motion, and which part of the programmed one that is.
struct ContactMotion {
    Contact contact;
    Vec3 from = Vec3::Zero();  // of the whole path; the end of a command is where its tip ends
    Vec3 to = Vec3::Zero();
    double begin = 0;  // shares of its length: what a corner has left of it
    double end = 1;
};

/// Square to the tangent and to the tool, to the right of travel seen from the holder: unit vector.
/// None where the tool lies along the path (SINUMERIK alarm 10759).
std::optional<Vec3> beside(const Vec3& tangent, const Vec3& tool);

/// From the contact to the tip, mm.
///
/// guide    tangent of the contour or normal of the surface there, unit vector
/// tool     unit vector from tip to holder
/// returns  none where the tool lies along the path, or where a surface lies square to the tool: it
///          touches with all of it, and no point of its edge is the one
/// source   motion.md §8.2, §8.3
std::optional<Vec3> tip_beside(const Contact& contact, const Vec3& guide, const Vec3& tool);

/// `guide` at a share of the motion, 0 … 1.
Vec3 guide_at(const Contact& contact, double share);

/// From the contact to the tip where a surface that lies square to the tool touches with its
/// middle.
Vec3 tip_square(const Contact& contact, const Vec3& tool);

/// How far the tip goes while the contact stays at one point and its guide turns, mm.
///
/// tool  unit vector; it keeps its direction
double tip_travel_about(const Contact& contact, const Vec3& tool);

/// From the contact to the tip at a share of a motion; where a surface comes square to the tool
/// there, as it is beside.
///
/// aside    tip_beside() at a share
/// returns  none where there is none beside either
///
/// What the tip lies aside changes by the rotation of tool and surface times the radius. The steps
/// grow as the rotations need them that they can tell from rounding: at none of them the error is
/// more than a nanometre per millimetre of radius.
template <typename Aside>
std::optional<Vec3> tip_or_limit(double share, Aside aside) {
    if (const std::optional<Vec3> found = aside(share)) return found;
    for (const double step : {1e-7, 1e-5, 1e-3}) {
        if (const std::optional<Vec3> found = aside(share > 0.5 ? share - step : share + step))
            return found;
    }
    return std::nullopt;
}

}  // namespace kadr::path
