// rounding.h — the curve that takes the place of a corner between two motions.
//
// Geometry: how much of both motions it takes, so that it keeps the distance or the tolerance that
// the program gives. Whether the corner is passed faster with it is prepare_rounding.cpp's
// question.
#pragma once

#include <optional>

#include "path/command.h"
#include "path/curve.h"
#include "path/transition.h"

namespace kadr::motion {

/// A motion beside the corner: its whole way, and what the program asks for behind it.
struct RoundedSide {
    const path::Curve& curve;
    path::Blending blending;
};

struct Rounding {
    double way = 0;          // mm of the path on either side of the corner
    path::Transition curve;  // two pieces before the middle, two behind it
};

/// The curve around the corner between two motions.
///
/// Each gives half of its length at most, so that the corner at its other end has the other half,
/// and both give the same. A distance is that of the motion before the corner and, where the one
/// behind it has a distance of its own, as at rapid, also that one.
///
/// returns   nothing if there is no corner, if it turns back, or if nothing is left of the way
/// source    reference motion §2.4, rule 4; sinumerik §3.3 (G641, G642, G645)
std::optional<Rounding> rounding(const RoundedSide& before, const RoundedSide& behind);

}  // namespace kadr::motion
