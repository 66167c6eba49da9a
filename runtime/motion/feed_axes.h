// feed_axes.h — how fast the axes go of which F is the speed, where the path goes at speed 1.
//
// A program may choose of which axes F is the speed; the path of a piece stays that of X, Y and Z.
#pragma once

#include "motion/axis_table.h"
#include "motion/segment.h"
#include "path/dynamics.h"

namespace kadr::motion {

/// Speed of the feed axes together where the path goes at 1 mm/s (deg/s if only rotary axes move);
/// rotary axes count at their radii.
///
/// Where no feed axis moves, and no other one but rotary axes, these count instead; where others
/// move the answer is 0: F does not count for the motion, and its axes have their limits.
/// distance     along the piece; of a transformed piece its start or its end is meant
/// source       SINUMERIK reference 2.3 (FGROUP, FGREF)
double feed_axes_rate(const path::Dynamics& dynamics, const Segment& piece, double distance,
                      const AxisTable* axes);

/// The mean over a piece, whose time is then that of F along the path of the feed axes.
double mean_feed_axes_rate(const path::Dynamics& dynamics, const Segment& piece, double length,
                           const AxisTable* axes);

/// The least and the greatest rate that were found on a piece.
struct FeedAxesRange {
    double least = 0;
    double most = 0;
};
FeedAxesRange feed_axes_range(const path::Dynamics& dynamics, const Segment& piece, double from,
                              double to);

}  // namespace kadr::motion
