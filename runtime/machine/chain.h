// chain.h — the rotary axes of a machine, between workpiece and tool: a description that never
// changes.
//
// Data and its preparation only; where the tool stands is kinematics.h's, which of two solutions is
// taken path_choice.h's matter.
//
// The chain reads from the workpiece to the tool: workpiece – R1 – R2 – Ψ – tool. R1 is the rotary
// axis nearest to the workpiece, R2 the next one, Ψ turns the tool about itself. A joint on the
// table carries the workpiece, one on the head the tool, and the linear axes stand between both. At
// base position every rotary axis stands at 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/axes.h"
#include "base/result.h"
#include "path/vec3.h"

namespace kadr::machine {

using path::Vec3;
using Mat3 = Eigen::Matrix3d;

/// The indices of the rotary joints in the chain; they index joints and rotary positions.
inline constexpr std::size_t kR1 = 0;
inline constexpr std::size_t kR2 = 1;
inline constexpr std::size_t kPsi = 2;
inline constexpr std::size_t kJoints = 3;

enum class ChainSide : std::uint8_t { Table, Head };

/// One rotary axis at base position.
struct RotaryJoint {
    bool is_present = false;  // an absent joint stands at 0 for ever
    Axis axis = Axis::C;      // the logical axis that programs it
    ChainSide side = ChainSide::Table;
    Vec3 direction = Vec3::UnitZ();  // unit vector
    /// A point on the axis, mm. Of a table: in machine coordinates, where the end of the zero tool
    /// meets it. Of a head: from the end of the zero tool.
    Vec3 point = Vec3::Zero();
    /// +1: a positive value turns the tool relative to the workpiece by the right-hand rule (ISO
    /// 841; a table itself then turns the other way). −1: the opposite.
    double sign = 1;
};

/// What the solution of an orientation needs of a chain with R1 and R2; prepare() works it out.
///
/// n1, n2 and the tool's direction z0 are corners of a spherical triangle; α is the side between
/// n1 and n2, β that between n2 and z0. `b` is the angle of the second joint, zero at base.
struct OrientationTriangle {
    double sin_half_difference = 0;  // of (α − β)/2
    double cos_half_difference = 1;
    double sin_half_sum = 0;  // of (α + β)/2
    double cos_half_sum = 1;
    double sin_product = 1;  // sin α · sin β
    double nearest = 0;  // b where the tool comes nearest to n1, rad; the middle of both solutions
    double sin_nearest = 0;
    double cos_nearest = 1;
    double first_side = 1;  // configuration 1 is that of sin(b − nearest) of this sign
};

/// An immutable chain: fill in the upper part, then prepare().
struct Chain {
    std::array<RotaryJoint, kJoints> joints{};
    Vec3 tool_direction = Vec3::UnitZ();  // z0, unit vector from tip to holder at base position
    /// U, V, W enter the chain: X, Y, Z move against them, and the tip stays.
    bool compensates_parallel = false;
    AxisMask linear = kLinearXYZ;  // a missing one stands at 0 for ever
    OrientationTriangle tilt;      // by prepare()

    bool has(std::size_t joint) const { return joints[joint].is_present; }
    bool is_turning() const { return has(kR1) || has(kR2); }
    /// Both R1 and R2: any orientation within reach can be programmed as a vector.
    bool orients() const { return has(kR1) && has(kR2); }
};

enum class ChainFault : std::uint8_t {
    NoJoint,           // neither R1 nor R2
    TableBehindHead,   // R1 on the head, R2 on the table: the chain is read from the workpiece on
    ParallelJoints,    // R1 and R2 turn about the same direction
    SecondAlongTool,   // R2 turns the tool about itself: that would be Ψ
    SpinNotAlongTool,  // Ψ is not about the tool, or not on the head
    SpinWithoutPair,   // Ψ without R1 and R2
};

/// Works out what the solver needs and normalises directions.
///
/// Configuration 1 is that of R2 ≥ 0 where R2 = 0 is the middle between both (a head C/B, a
/// nutating one); else the one that contains R2 = 0, which is |R2| ≤ 90° where they meet at ±90°
/// (A/B). Both readings are those of motion.md 5.2 and axioma.md 3.1.
///
/// chain    its directions must not be zero (asserted)
/// returns  the same chain, ready for kinematics.h
Result<Chain, ChainFault> prepare(Chain chain);

/// Vectors between the axes as a builder measures them: motion.md 5.1, AxiOMA's L1 and L2.
struct AxisVectors {
    Vec3 first_to_second = Vec3::Zero();  // L1: from axis R1 to axis R2, mm
    Vec3 second_to_tool = Vec3::Zero();   // L2: from axis R2 to the end of the zero tool
    /// Machine position in which both are measured: the end of the zero tool in the workpiece zero.
    Vec3 start = Vec3::Zero();
};

/// Puts the points of R1 and R2 where the vectors lead. With R1 alone, L1 + L2 leads to the tool's
/// end.
void place_by_vectors(Chain& chain, const AxisVectors& vectors);

/// How the end position of a block is chosen among the turns and configurations; path_choice.h.
enum class PathRule : std::uint8_t {
    Shortest,        // AxiOMA 1: R1 only by its shortest travel
    LongInAxisMode,  // AxiOMA 2: R1 also the long travel, if the axes are interpolated
    LongAlways,      // AxiOMA 3: as 2; a vector block without a short travel is run in axis mode
    LeastTravel,     // SINUMERIK: least travel of R1, then of R2
    MasterFirst,     // FANUC: least travel of the master, then of the slave, then nearest to 0
    LeastSquares,    // least sum of squares over all turns within limits
};

/// What a machine file gives about orientation.
struct Kinematics {
    Chain chain;
    PathRule rule = PathRule::LongInAxisMode;
    /// A path that passes the pole of R1 nearer than this is led through it, rad.
    double pole_tolerance = 0;
    /// R1 or R2: its value tells the two solutions of a swivelled plane apart, SINUMERIK's _DIR.
    /// Nothing: R2, or R1 where it is alone.
    std::optional<std::size_t> swivel_reference = std::nullopt;
};

}  // namespace kadr::machine
