// tilted_plane.h — planes in which a program works beside X-Y, and the rotary axes that stand to
// them: three linear axes cut, the others hold (3+2).
//
// How a plane lies is a matrix: its columns are X, Y and Z of the plane in the system in which it
// is programmed. Words and signs of controls are the interpreter's; choosing among turns is
// path_choice.h's.
#pragma once

#include <span>

#include "base/axes.h"
#include "machine/path_choice.h"
#include "path/frame.h"

namespace kadr::machine {

/// A rotation about a linear axis, rad, right-handed.
struct AxisRotation {
    Axis axis = Axis::X;
    double angle = 0;
};

/// Rotations one after the other, each about the axis as the former ones have left it: CYCLE800
/// axis by axis, AROT.
Mat3 turned_in_order(std::span<const AxisRotation> turns);
/// The same about axes that stay: the first rotation acts first. Roll, pitch, yaw of G68.2 P1.
Mat3 turned_about_fixed(std::span<const AxisRotation> turns);

/// Angles of projections (CYCLE800, G68.2 P4; motion.md 7.2): the new X axis stays in the Z-X
/// plane, turned about Y by `about_y`; the line in which the plane cuts the Y-Z plane is turned
/// about X by `about_x`; then the whole about the new Z by `about_z`; rad.
struct ProjectionAngles {
    double about_x = 0;
    double about_y = 0;
    double about_z = 0;
};

enum class PlaneFault : std::uint8_t {
    OneLine,     // the points, vectors or angles do not span a plane
    NotSquare,   // the X and the Z axis are not at right angles
    ZeroVector,  // an axis without length
};

Result<Mat3, PlaneFault> projected(const ProjectionAngles& angles);

/// Through three points: X from the first to the second, the third on the side of +Y. G68.2 P2.
Result<Mat3, PlaneFault> through_points(std::span<const Vec3, 3> points);

/// By its X and Z axes, of any length. X counts, and Z is made square to it. G68.2 P3.
///
/// most_off  how far from a right angle they may be, rad
Result<Mat3, PlaneFault> by_axes(const Vec3& x, const Vec3& z, double most_off);

/// Square to the tool: Z along it, X square to it and to the vertical axis. Where both are one, the
/// plane lies as the system does. G68.3 with No.12321 = 0, the vertical axis being Z.
///
/// tool  unit vector from tip to holder
Mat3 square_to_tool(const Vec3& tool);

/// Square to the tool with X as near to an old X as it can be: TOFRAME, TOROT. Where the old X is
/// along the tool, the old Y is what the new Y comes near to.
Mat3 square_to_tool_near(const Vec3& tool, const Mat3& old);

/// From the workpiece system into the base system, whose axes are the linear axes: how the tables
/// have carried the workpiece along.
path::Frame table_frame(const Chain& chain, const Vec3& rotary);

/// From the end of the zero tool at base to the tip, as the heads have carried it, mm.
///
/// tip  the same at base position (tip_of_length)
Vec3 head_offset(const Chain& chain, const Vec3& rotary, const Vec3& tip);

/// Direction of the tool in the base system, from tip to holder; tables do not turn it.
Vec3 tool_in_base(const Chain& chain, const Vec3& rotary);

/// Which of the solutions a tilted plane takes.
struct SwivelQuery {
    Vec3 direction = Vec3::UnitZ();  // of the tool, workpiece system, unit vector
    Vec3 start = Vec3::Zero();       // where the rotary axes stand, rad
    JointLimits limits;
    PathRule rule = PathRule::LongInAxisMode;
    /// −1, +1: the solution with the lower, higher value of the reference joint in (−π, π], or the
    /// other one where limits forbid it; CYCLE800's _DIR. 0: by the rule.
    int sense = 0;
    std::size_t reference = kR2;
};

/// The end of a swivelling: every joint by the turn that is nearest to its start within the limits;
/// R1 stays where it is if the tool stands along it.
Result<Vec3, PathRefusal> choose_swivel(const Chain& chain, const SwivelQuery& query);

}  // namespace kadr::machine
