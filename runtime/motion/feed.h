// feed.h — the path speed that a program asks for, from its feed words and its spindle.
//
// What the axes allow is axis_table.h's matter.
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "motion/axis_table.h"
#include "motion/segment.h"
#include "motion/spindle.h"
#include "path/motion.h"

namespace kadr::motion {

enum class FeedFault : std::uint8_t { NoFeed, SpindleStands };

/// Path speed of a Line or an Arc over a piece, mm/s (deg/s if only rotary axes move).
///
/// Under constant cutting speed it is the mean over the piece in time, by Simpson's rule over the
/// radius: exact on a line as long as the spindle does not reach a limit.
/// Where the program has chosen the feed axes, it is infinite if none of them moves.
/// length       of the path, mm (deg), > 0
/// axes         may be null: of a transformed piece only axes that follow it are known then
/// source       reference motion §2.8, §9.1; feed_axes.h
Result<double, FeedFault> path_feed(const path::Motion& motion, const Segment& piece, double length,
                                    const CommandedSpindle& spindle,
                                    const AxisTable* axes = nullptr);

/// Where a piece is cut so that one feed does for each part: its feed is within a hundredth of what
/// the spindle's speed and the feed axes make it everywhere in the part. Lengths from 0 to that of
/// the piece; empty if neither changes on it.
std::vector<double> feed_bounds(const path::Motion& motion, const Segment& piece, double length,
                                const CommandedSpindle& spindle);

}  // namespace kadr::motion
