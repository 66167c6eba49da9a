// kinematics.h — where the tool stands for given axes, and which axes put it there.
//
// Free functions of a prepared chain (chain.h); nothing is kept, nothing allocated: motion asks at
// every tick. Orientations are unit vectors and matrices in the workpiece system: the machine's
// coordinates at base position, which turn with the table. Source of all formulas: the matrices of
// the chain (motion.md 5.1), solved by Paden–Kahan's second subproblem in half angles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "machine/chain.h"

namespace kadr::machine {

/// Below this angle between the tool and the axis R1 the position of R1 has no meaning, rad; the
/// same as a vector may differ that an answer was found for.
inline constexpr double kPoleAngle = 1e-9;

/// Positions of the machine's axes, mm and rad.
struct ChainPosition {
    Vec3 linear = Vec3::Zero();    // X, Y, Z
    Vec3 parallel = Vec3::Zero();  // U, V, W
    Vec3 rotary = Vec3::Zero();    // R1, R2, Ψ; of an absent joint without influence
};

/// The tool in the workpiece system.
struct Pose {
    Vec3 tip = Vec3::Zero();  // mm
    Mat3 rotation =
        Mat3::Identity();  // from base position; the tool's direction is its image of z0
};

/// From the end of the zero tool to the tip of a tool of this length at base position, mm.
Vec3 tip_of_length(const Chain& chain, double length);

/// Matrix of the tool's rotation, from base position into the workpiece system:
/// R = Rot(n1, R1) · Rot(n2, R2) · Rot(z0, Ψ), with the signs of the joints.
Mat3 rotation_of(const Chain& chain, const Vec3& rotary);

/// Direction of the tool, from tip to holder, in the workpiece system; unit vector.
Vec3 tool_vector(const Chain& chain, const Vec3& rotary);

/// Where tip and tool stand.
///
/// tip  from the end of the zero tool to the tip at base position, mm (tip_of_length)
Pose forward(const Chain& chain, const ChainPosition& position, const Vec3& tip);

/// X, Y, Z that bring the tip to a point of the workpiece system while the rotary axes (and U, V,
/// W) stand as they do.
///
/// target    mm, in the workpiece system
/// position  its rotary and parallel axes are read
/// tip       as for forward()
/// returns   mm; of an axis that the machine does not have it is 0 only if the point is in its
/// plane
Vec3 inverse_linear(const Chain& chain, const Vec3& target, const ChainPosition& position,
                    const Vec3& tip);

/// Rotary positions for an orientation.
struct Solution {
    Vec3 rotary =
        Vec3::Zero();  // R1, R2, Ψ, rad, in (−π, π]; Ψ is 0 unless a rotation was asked for
    int configuration = 1;  // 1 or 2, by the chain's rule
    /// The tool stands along the axis R1, which is free; its value is 0 here, see at_pole().
    bool is_pole = false;
    /// Both configurations meet here at the end of the reach: the other pole of the path.
    bool is_equator = false;
};

/// All solutions, one for each configuration; without those that differ by whole turns.
struct Solutions {
    std::array<Solution, 2> all{};
    std::size_t count = 0;

    const Solution* begin() const { return all.data(); }
    const Solution* end() const { return all.data() + count; }
    const Solution& operator[](std::size_t i) const { return all[i]; }
};

enum class ReachFault : std::uint8_t {
    OutsideReach,  // no position of the rotary axes gives this direction; see pole_angle_reach()
    MissingJoint,  // one rotary axis only, and it does not lead there
    NoRotaryAxis,  // none, and the direction is not that of the tool at base
};

/// Every configuration of the rotary axes that holds the tool in a direction.
///
/// direction  from tip to holder, workpiece system, unit vector
/// returns    one or two solutions, configuration 1 first; each was checked forwards to 1e-9
Result<Solutions, ReachFault> solve(const Chain& chain, const Vec3& direction);

/// The same for a tool that must not rotate about its axis either: with Ψ for every solution.
///
/// rotation  the wanted Pose::rotation; without a joint Ψ only its image of z0 counts
Result<Solutions, ReachFault> solve(const Chain& chain, const Mat3& rotation);

/// A solution at the pole with R1 at a given position, and Ψ turned against it so that the rotation
/// is the same; any other solution as it is.
///
/// first  R1, rad
Solution at_pole(const Chain& chain, const Solution& solution, double first);

/// The configuration to which positions of the rotary axes belong.
int configuration_of(const Chain& chain, const Vec3& rotary);

/// The angles between the tool and the axis R1 that can be reached, rad; lower ≤ upper.
struct PoleAngleReach {
    double lower = 0;
    double upper = 0;
};
/// chain  orients()
PoleAngleReach pole_angle_reach(const Chain& chain);

/// The angle between a direction and the axis R1, 0 … π, rad; exact near both ends.
double pole_angle_of(const Chain& chain, const Vec3& direction);

/// How R1 changes if the configuration is kept and the direction goes along the shorter great
/// circle, which must not pass the axis R1. Not reduced to a turn: a nutating head's R1 may turn by
/// more than half of one.
///
/// from_rotary, to_rotary  solutions of the same configuration, neither of them at the pole
/// returns                 rad
double first_along_great_circle(const Chain& chain, const Vec3& from_rotary, const Vec3& to_rotary);

/// Velocity of a tool in the workpiece system; of whatever parameter, time or length of path.
struct ToolVelocity {
    Vec3 tip = Vec3::Zero();
    /// Angular velocity of the tool, rad: w' = turn × w. From w' alone: turn = w × w'. The part
    /// along the tool counts only with a joint Ψ.
    Vec3 turn = Vec3::Zero();
};

/// Velocities of the axes, in the order of ChainPosition. U, V, W stand.
struct ChainVelocity {
    Vec3 linear = Vec3::Zero();
    Vec3 rotary = Vec3::Zero();
};

enum class VelocityFault : std::uint8_t {
    Singular,      // pole or end of reach: R1 would have to turn infinitely fast
    MissingJoint,  // the orientation cannot turn that way
};

/// Velocities of X, Y, Z that give the tip a velocity while the rotary axes turn: axis mode.
///
/// tip_velocity  of the tip, workpiece system
/// rotary        velocities of R1, R2, Ψ, rad
Vec3 linear_velocity(const Chain& chain, const ChainPosition& position, const Vec3& tip,
                     const Vec3& tip_velocity, const Vec3& rotary);

/// Velocities of all axes for a velocity of the tool: the inverse Jacobian. At the pole there is an
/// answer only where R1 may stand: the tool turns about R2 alone.
///
/// tip       as for forward()
Result<ChainVelocity, VelocityFault> axis_velocities(const Chain& chain,
                                                     const ChainPosition& position, const Vec3& tip,
                                                     const ToolVelocity& velocity);

/// Velocity of the tool for velocities of the axes: the Jacobian, for checks and for axis mode.
ToolVelocity tool_velocity(const Chain& chain, const ChainPosition& position, const Vec3& tip,
                           const ChainVelocity& velocity);

/// Rotation about a unit vector by the right-hand rule; angle in rad (Rodrigues).
Mat3 rotation_about(const Vec3& axis, double angle);

}  // namespace kadr::machine
