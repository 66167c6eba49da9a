// polyline_deviation.h — how far a cubic and the lines that it takes the place of are apart.
//
// The one judge of what a fit gives: no fit is accepted on its own word.
#pragma once

#include <optional>
#include <span>

#include "path/cubic.h"

namespace kadr::path {

/// A bound of how far a cubic and lines are apart, in both directions: no point of the cubic is
/// farther from the lines, and no point of the lines, their ends among them, farther from the
/// cubic. Both are walked side by side, so a cubic that leaves out a part of the lines, or goes it
/// twice, is as far off as that part.
///
/// points   ends of the lines in order, two or more, mm; the cubic leads from the first to the last
/// most     mm; nobody wants to know what is farther
/// returns  mm; nothing if the bound is above `most`, or if the cubic is longer than the lines by
///          more than 1 %, which no smooth curve through their ends is where they turn by less than
///          28 degrees
std::optional<double> deviation_from_lines(const Cubic& cubic, std::span<const Vec3> points,
                                           double most);

}  // namespace kadr::path
