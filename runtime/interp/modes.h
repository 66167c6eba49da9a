// modes.h — what a group of the vocabulary has chosen: a small enum for each group of which the
// executor keeps what acts, with the functions that choose it. Internal to interp.
//
// The modal motion is not here: it stays a function of the vocabulary, as blocks are read and
// written with it.
#pragma once

#include <cstdint>

#include "nc/block.h"
#include "nc/rules.h"
#include "path/command.h"

namespace kadr::interp {

/// On which side of the contour the cutter goes.
enum class CompSide : std::uint8_t { Off, Left, Right };
CompSide comp_side_of(nc::Function function);
nc::Function function_of(CompSide side);

/// What of the cutter is compensated: its radius in a plane, its side, or its end on a surface.
enum class CompKind : std::uint8_t {
    InPlane,
    Peripheral,
    FaceMilling,
    FaceMillingInFrame,
    FaceMillingInPlane
};
CompKind comp_system_of(nc::Function function);  // in a frame it is in a plane, too
bool is_face_milling(CompKind system);

/// How the orientation goes from one direction to the next.
enum class OrientInterpolation : std::uint8_t {
    Plane,
    Axes,
    Surface,
    ConeCw,
    ConeCcw,
    ConeOver,
    ConeOn,
    Point,
};
OrientInterpolation orient_interpolation_of(nc::Function function);
nc::Function function_of(OrientInterpolation interpolation);
bool is_on_cone(OrientInterpolation interpolation);

/// How the angles of the tool are understood.
enum class ToolAngles : std::uint8_t { Euler, Zyz, Rpy, Xyz };
ToolAngles tool_angles_of(nc::Function function);

/// From where the angle about the tool's axis counts.
enum class SpinFrom : std::uint8_t { Fixed, Plane, Turn, Path };
SpinFrom spin_from_of(nc::Function function);
nc::Function function_of(SpinFrom from);

/// Which motions go from point to point under a transformation.
enum class PointToPoint : std::uint8_t { None, Rapids, All };
PointToPoint point_to_point_of(nc::Function function);

/// How corners are blended.
enum class Blend : std::uint8_t { None, Distance, Tolerance, Smooth };
Blend blend_of(nc::Function function);

/// What F means, and in which plane arcs lie.
path::FeedMode feed_mode_of(nc::Function function);
path::Plane plane_of(nc::Function function);

/// How the cutter comes to its contour, and how it goes around the corners.
nc::CompStart comp_start_of(nc::Function function);
nc::CompCorner comp_corner_of(nc::Function function);

/// Of the lengths in the text, as far as it is programmed.
enum class ProgrammedUnits : std::uint8_t { Unsaid, Metric, Inch };
ProgrammedUnits units_of(nc::Function function);

}  // namespace kadr::interp
