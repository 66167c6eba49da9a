// corner.h — how fast the corner between two pieces of path may be taken.
//
// Looks at directions of travel and nothing else: no time (profile.h), no neighbours further away
// (lookahead.h). The path keeps its corner; the rules only bound what its sharpness costs.
#pragma once

#include <array>
#include <span>

#include "base/axes.h"
#include "path/vec3.h"

namespace kadr::motion {

/// dq/ds of every machine axis, in the order of Machine::axes; only the first so many are used.
using AxisRates = std::array<double, kAxes>;

/// Highest speed at which no axis changes its velocity at once by more than it may.
///
/// in, out  dq/ds before and after the corner, one per axis
/// jump     mm/s or rad/s, one per axis, > 0
/// returns  path speed; infinity if the corner is straight
/// source   reference motion §2.4, rule 1
double axis_jump_speed(std::span<const double> in, std::span<const double> out,
                       std::span<const double> jump);

/// How much of an axis' acceleration a jump of its velocity may take at a corner, so that the
/// change of velocity from one tick to the next stays within the limit: the jump comes on top of
/// the ramps before and behind it.
///
/// before, behind  acceleration of the axis on both sides, parts of its limit, 0 to 1
/// is_alone        no other corner lies within two ticks
/// most            of the limit, for the change in a tick: 1, or more where the axis stands it
/// returns         jump / (limit · tick), 0 to `most`
/// source          derived in the .cpp
double jump_share(double before, double behind, bool is_alone, double most = 1);

/// The greatest part of both ramps that a jump alone leaves room for.
///
/// before, behind  acceleration of the axis with the whole ramps, parts of its limit
/// jump            of the velocity, divided by the tick, in parts of the limit
/// returns         0 to 1
double ramp_share(double before, double behind, double jump, double most = 1);

/// Greatest change of velocity from tick to tick at a corner, per tick, as `jump_share` bounds it.
///
/// before, behind, jump  accelerations, the jump divided by the tick; all in one unit
double corner_acceleration(double before, double behind, double jump);

/// A jump of the acceleration counts this much of itself, divided by the tick, as a jerk: the third
/// difference of setpoints, divided by the tick cubed, averages the jerk with a bell of three
/// ticks.
inline constexpr double kJumpBell = 0.75;
inline constexpr double kJumpBellTicks = 3;
/// Part of an axis' jerk that a jump of its acceleration may take, where the curvature changes.
inline constexpr double kMostJump = 0.5;

/// Speed of an arc that touches both legs and misses the corner by `deviation`.
///
/// in, out       directions of travel, unit vectors
/// deviation     mm, > 0
/// acceleration  the lesser of both pieces, > 0
/// returns       mm/s; infinity if the corner is straight, 0 if it turns back
/// source        reference motion §2.4, rule 2
double junction_deviation_speed(const path::Vec3& in, const path::Vec3& out, double deviation,
                                double acceleration);

}  // namespace kadr::motion
