// compensation_paths.h — the cutter's path to a contour and away from it: around its end, or on a
// curve.
//
// Geometry of the working plane alone, mm. A distance is that of the cutter's centre from the
// contour, positive to the left of travel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/result.h"
#include "nc/rules.h"
#include "path/contour.h"

namespace kadr::interp {

/// Why there is no path to the contour, or away from it.
enum class CompPathFault : std::uint8_t {
    Blocked,  // the cutter is nearer to the contour's end than its radius
};

/// The approach as an element of the contour, if the first corner is to be treated as one; none:
/// straight to the normal.
///
/// start  of which kind the approach is
/// first  element of the contour
/// from   where the cutter's centre is
Result<std::optional<path::Element>, CompPathFault> approach_element(nc::CompStart start,
                                                                     const path::Element& first,
                                                                     const path::Vec2& from,
                                                                     double distance);
/// The same of the path from the last element of the contour to where the cutter's centre goes.
Result<std::optional<path::Element>, CompPathFault> retract_element(nc::CompStart start,
                                                                    const path::Element& last,
                                                                    const path::Vec2& to,
                                                                    double distance);

/// A Bézier curve between the contour and a point beside it. The other axes rest at its end at the
/// contour.
struct EndCurve {
    int degree = 2;
    std::array<path::Vec2, 2> inner{};  // control points between the ends: one fewer than `degree`
    bool leads_in = true;               // to the contour, not away from it
};

/// A parabola that ends beside the first element in its direction, or for CompStart::Smooth a cubic
/// that has the curvature there as well. None: the cutter is there.
std::optional<EndCurve> curve_in(nc::CompStart start, const path::Vec2& from,
                                 const path::Element& first, double distance);
/// The same from beside the last element, where the cutter's centre is, to a point.
///
/// element  from there to the point
std::optional<EndCurve> curve_out(nc::CompStart start, const path::Element& element,
                                  const path::Element& last, double distance);

}  // namespace kadr::interp
