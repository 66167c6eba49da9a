// cutting_speed.h — what constant cutting speed (G96) with a feed per revolution (G95) amounts to.
//
// The ideal law: the spindle follows the radius at once. What drives make of it is drives.h's. How
// fast the spindle turns at a radius is motion/spindle.h's, which the planner uses too.
#pragma once

#include "motion/spindle.h"

namespace kadr::process {

/// A cut towards the axis or away from it, by its radii.
struct FacePass {
    double from = 0;                 // mm, distance from the axis
    double to = 0;                   // mm
    double feed_per_revolution = 0;  // mm along the path, > 0
    double cone = 0;                 // rad from the face, below a right angle; 0: facing
};

/// The radius below which the spindle runs at its limit and the cutting speed falls, mm; 0 if
/// nothing limits it.
double limit_radius(const motion::CommandedSpindle& spindle);

/// The radius above which the spindle runs at its least speed and the cutting speed rises, mm;
/// infinity if it has none.
double least_speed_radius(const motion::CommandedSpindle& spindle);

/// Cutting speed at a radius, mm/s: the programmed one between the limit radius and that of the
/// least speed.
double cutting_speed(const motion::CommandedSpindle& spindle, double radius);

/// Path speed of the feed at a radius, mm/s.
double feed_speed(const motion::CommandedSpindle& spindle, const FacePass& pass, double radius);

/// How fast the spindle has to change its speed, rad/s²: it grows with 1/R³ down to the limit
/// radius, and is 0 below, as above the radius of the least speed.
///
/// source       dω/dt of the hyperbola R² = R0² − f·V·t/π, reference motion §9.1
double spindle_acceleration(const motion::CommandedSpindle& spindle, const FacePass& pass,
                            double radius);

/// Time of the whole pass, s; the spindle holds a cutting speed.
///
/// source       π(R0² − R1²)/(f·V) above the limit radius, (R0 − R1)/(f·n) below and where
///              n is the least speed; reference motion §9.1
double pass_time(const motion::CommandedSpindle& spindle, const FacePass& pass);

/// Revolutions of the pass; the speed does not count.
double pass_revolutions(const FacePass& pass);

}  // namespace kadr::process
