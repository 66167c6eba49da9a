// polar_passages.h — curves of polar coordinate interpolation that meet the centre, where the
// rotary axis would have to turn at once.
//
// Between two passages of the centre a curve is a leg; in the centre the tool stands while the
// rotary axis turns to where the next leg leads away. Without polar coordinates there is one leg.
#pragma once

#include <vector>

#include "path/curve.h"
#include "path/virtual_axes.h"

namespace kadr::path {

/// Lengths of a curve, inside of it and in order, at which it goes through the polar centre.
std::vector<double> pole_passages(const VirtualAxes& axes, const Curve& curve);

/// A curve between passages of the centre; lines end in the centre exactly.
std::vector<Curve> legs_between_poles(const VirtualAxes& axes, const Curve& curve);

/// Where the rotary axis has to stand at the start of a leg: in the polar centre so that the
/// leg leads away along the radius, by the shorter distance from `rotary`; elsewhere it stays.
double rotary_to_leave(const VirtualAxes& axes, const Curve& leg, double rotary);

/// Where the rotary axis stands behind a leg that began with it at `rotary`, rad.
double rotary_behind(const VirtualAxes& axes, const Curve& leg, double rotary);

}  // namespace kadr::path
