// path_choice.h — which rotary positions end a block, of all turns and both configurations.
//
// AxiOMA's five steps with the three options (axioma.md 5, made exact in motion.md 5.3), and the
// rules of SINUMERIK, FANUC and the plain least sum of squares. A refusal carries every reason with
// its values: the interpreter, who knows the control and the location, words the alarm.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "machine/kinematics.h"

namespace kadr::machine {

/// Positions that a rotary axis may take, rad.
struct AxisRange {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
};
using JointLimits = std::array<AxisRange, kJoints>;

/// How the block interpolates the orientation.
enum class PathMode : std::uint8_t {
    Axis,    // the rotary axes run linearly
    Vector,  // the tool follows the great circle
};

struct PathQuery {
    Vec3 start = Vec3::Zero();  // R1, R2, Ψ where the block begins, rad
    /// The wanted orientation at the end: without Ψ only its image of the tool's direction counts.
    Mat3 rotation = Mat3::Identity();
    bool fixes_spin = true;  // else Ψ stays where it is, whatever the tool does about itself
    PathMode mode = PathMode::Axis;
    PathRule rule = PathRule::LongInAxisMode;
    JointLimits limits;
    int configuration = 0;         // 1, 2: only this one, where they differ; 0: either
    double pole_tolerance = 1e-6;  // Kinematics::pole_tolerance, rad
};

/// A query for a direction of the tool, whatever it does about itself.
///
/// direction  unit vector, workpiece system
PathQuery query_for(const Chain& chain, const Vec3& direction);

/// Why this end and no other.
enum class PathReason : std::uint8_t {
    OnlyOne,       // nothing else was admissible
    PoleSwitch,    // step 4: R2 alone turns, through the pole into the other configuration
    LeastSquares,  // step 5
    LeastFirst,    // least travel of R1, or of FANUC's master
    LeastSecond,   // equal travel there: least travel of the other one
    Tie,           // equal all over: present configuration, configuration 1, nearest to 0, positive
                   // direction
};

struct PathEnd {
    Vec3 rotary = Vec3::Zero();  // rad, with whole turns; continues from the start
    int configuration = 1;
    PathMode mode = PathMode::Axis;  // as asked, or Axis where LongAlways replaced it
    bool is_long = false;            // R1 takes more than its shortest travel
    /// In vector mode: the great circle passes the pole of R1. R1 stands if the configuration
    /// changes, else the motion stops there and R1 turns.
    bool passes_pole = false;
    bool switches_at_pole = false;  // the configuration changes and R1 stands
    double sum_squares = 0;         // of the travels of R1, R2 and Ψ, rad²
    PathReason reason = PathReason::OnlyOne;
};

/// Why a configuration is not admissible.
enum class CandidateFault : std::uint8_t {
    NoSolution,          // the orientation has only one configuration
    FirstOutside,        // no turn of R1 is within its limits
    SecondOutside,       // no turn of R2 is
    SpinOutside,         // no turn of Ψ is
    OnlyLongTravel,      // R1 could get there by longer travel, which the rule does not admit
    OtherConfiguration,  // the great circle does not lead into this configuration
    LimitOnPath,         // an axis leaves its limits between start and end of the great circle
};

struct CandidateRefusal {
    CandidateFault fault = CandidateFault::NoSolution;
    std::size_t joint = kR1;  // the axis that is meant
    double value = 0;         // where it would be, rad: the turn next to its start
    AxisRange limits;         // what it may
};

enum class PathChoiceFault : std::uint8_t {
    Unreachable,  // no position of the axes has the orientation, whatever the limits
    NoCandidate,  // step 3: both configurations are refused
};

struct PathRefusal {
    PathChoiceFault fault = PathChoiceFault::NoCandidate;
    ReachFault reach = ReachFault::OutsideReach;       // of Unreachable
    std::array<CandidateRefusal, 2> configurations{};  // of NoCandidate: of configuration 1 and 2
};

/// The end positions of a block.
///
/// chain    prepared; with one rotary axis its only solution is taken
/// returns  positions within the limits (to 1e-9 rad), in vector mode those reached by following
/// the
///          great circle from the start
Result<PathEnd, PathRefusal> choose_path(const Chain& chain, const PathQuery& query);

/// Whether the shorter great circle between two directions leads through some that no position of
/// the axes has: beside R1 where the axes are not exactly square to each other.
bool crosses_gap(const Chain& chain, const Vec3& from, const Vec3& to);

/// How near the great circle between two directions comes to the axis R1, on either side of it.
struct PoleApproach {
    double distance = 0;  // rad, of the nearest point between both ends, these included
    double fraction = 0;  // of the path to it, 0 … 1
};
/// from, to  unit vectors, not opposite to each other
PoleApproach pole_approach(const Chain& chain, const Vec3& from, const Vec3& to);

}  // namespace kadr::machine
