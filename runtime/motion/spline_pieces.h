// spline_pieces.h — spans of splines, and other curves, cut into pieces that one speed suits.
#pragma once

#include <vector>

#include "path/curve.h"

namespace kadr::motion {

/// Pieces of a curve that bends freely, in order, on each of which the curvature is about the same
/// and the direction turns by little between samples. Where it turns back it is cut; a turn inside
/// less than a nanometre becomes a straight piece: a corner at both its ends.
std::vector<path::Curve> evenly_bent(const path::Curve& curve);

/// What the limits of axes need to know of a piece: greatest |dq/ds|, |d²q/ds²| and |d³q/ds³| of X,
/// Y, Z, from samples so close that what is between them is covered by their differences.
struct SplineBend {
    path::Vec3 rate = path::Vec3::Zero();
    path::Vec3 bend = path::Vec3::Zero();   // 1/mm
    path::Vec3 third = path::Vec3::Zero();  // 1/mm²
    double curvature = 0;                   // greatest |d²C/ds²|, 1/mm
};
SplineBend bend_of(const path::Curve& curve);

}  // namespace kadr::motion
