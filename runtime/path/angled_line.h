// angled_line.h — lines that are given by their direction: where they end.
//
// Angles count from the first axis of the plane, counter-clockwise.
#pragma once

#include <optional>

#include "path/contour.h"

namespace kadr::path {

/// Sine of the angle below which two directions are one.
inline constexpr double kParallelLines = 1e-9;

/// The unit vector at an angle, degrees.
Vec2 unit_at(double angle_deg);

/// Where a line that starts at `from` in a direction comes to a value of one coordinate (0 the
/// first, 1 the second). None if it never does, or only backwards.
std::optional<Vec2> end_at(const Vec2& from, const Vec2& along, Eigen::Index coordinate,
                           double value);

/// Where a line that leaves `from` in the direction `out` meets the one that comes to `to` in the
/// direction `in`; both go forward. None if they do not.
std::optional<Vec2> meeting_point(const Vec2& from, const Vec2& out, const Vec2& to,
                                  const Vec2& in);

}  // namespace kadr::path
