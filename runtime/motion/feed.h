// feed.h — the path speed that a program asks for, from its feed words and its spindle.
//
// What the axes allow is axis_table.h's matter.
#pragma once

#include <cstdint>

#include "base/result.h"
#include "motion/segment.h"
#include "motion/spindle.h"
#include "path/command.h"

namespace kadr::motion {

enum class FeedFault : std::uint8_t { NoFeed, SpindleStands };

/// Path speed of a Line or an Arc over a piece, mm/s (deg/s if it only turns).
///
/// Under constant cutting speed it is the mean over the piece in time, by Simpson's rule over the
/// radius: exact on a line as long as the spindle does not reach a limit.
/// length       of the path, mm (deg), > 0
/// source       reference motion §2.8, §9.1
Result<double, FeedFault> path_feed(const path::Command& command, const Segment& piece,
                                    double length, const Spindle& spindle);

/// Into how many parts of equal length a piece is cut so that one feed does for each: the radius
/// changes by a twentieth in a part at most, except close to the axis. 1 if the spindle does not
/// follow the radius.
int feed_parts(const path::Command& command, const Segment& piece, const Spindle& spindle);

}  // namespace kadr::motion
