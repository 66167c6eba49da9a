// orient_kind.h — the kinds of orientation interpolation, and angles that commands give.
#pragma once

#include <cstdint>

namespace kadr::path {

/// How the orientation goes while the transformation of the machine holds its tip on the path.
enum class OrientKind : std::uint8_t {
    None,      // no transformation: every axis goes as `to` has it
    Straight,  // every axis of the machine goes straight from point to point: the tip is on no path
    Joints,    // the rotary axes go along a cubic of the path: around a corner that is blended
    Axes,      // the rotary axes go in proportion to the path
    Cone,      // the tool goes about an axis in space, in proportion to the path; square to the
               // axis that is a great circle
    Surface,   // the tool keeps its lead and tilt to a surface normal and the direction of travel
    Point,     // a second point of the tool's axis goes along a line, in proportion to the path
};

/// What a tilt turns about: the manuals say the path tangent, the article the surface normal
/// (motion.md 6.1, MD21094).
enum class TiltAbout : std::uint8_t { Tangent, Normal };

/// How a tool is inclined: first from the normal towards the direction of travel, then aside; rad.
struct LeadTiltAngles {
    double lead = 0;
    double tilt = 0;
    TiltAbout about = TiltAbout::Tangent;
};

}  // namespace kadr::path
