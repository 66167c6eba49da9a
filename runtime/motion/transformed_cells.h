// transformed_cells.h — parts of a motion under the transformation as cells (bent_cell.h): where no
// axis has a limit of its jerk, they are as fast as the axes allow at every point, near a pole of
// R1 too.
//
// Every axis takes its own path, so p = dq/ds and c = d²q/ds² are those of its path. Between the
// ends of a cell p, c and c·v² differ a little from the straight line; that much of an axis'
// acceleration is kept back.
//
// source       reference motion §2.6 (the constraints of TOPP-RA at both ends of every cell)
#pragma once

#include <optional>

#include "motion/bent_cell.h"
#include "motion/transformed.h"

namespace kadr::motion {

/// Whether one speed and one acceleration suit a part as well as a cell does, at a wanted speed.
bool is_nearly_straight(const AxisPolynomials& polynomials, const AxisBounds& bounds, double speed);

/// A part as a cell; nothing if it is nearly straight, if p or c differ too much from their
/// straight lines, or if it is too long to have one acceleration.
///
/// speed  wanted along the path, mm/s; may be infinite
std::optional<BentCell> cell_on(const AxisPolynomials& polynomials, const AxisBounds& bounds,
                                double speed);

}  // namespace kadr::motion
