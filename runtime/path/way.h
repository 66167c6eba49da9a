// way.h — the curve of a command.
#pragma once

#include "path/command.h"
#include "path/curve.h"

namespace kadr::path {

/// Ways shorter than this are none: rounding of the positions of a program, mm.
inline constexpr double kStill = 1e-9;

/// The way of a motion between two places; a Point where it has none.
Curve way_of(const Command& command, const Vec3& from, const Vec3& to);

}  // namespace kadr::path
