// contour_offset.h — the path of a tool's centre beside a contour, exact for lines and arcs.
#pragma once

#include <functional>
#include <span>

#include "base/result.h"
#include "path/contour.h"

namespace kadr::path {

enum class OffsetFault : std::uint8_t {
    Unresolved,  // the pieces do not join: the contour is degenerate beyond what numbers can tell
    Stopped,     // `is_over` asked for it
};

/// How far a result may come nearer to the contour than was asked for, mm.
inline constexpr double kOffsetTolerance = 1e-6;

/// The curve at a distance beside a contour, in its direction of travel.
///
/// distance  mm, positive to the left of travel, negative to the right; 0 gives the contour itself
/// returns   of a closed contour: closed contours, none if nothing is left, several if it falls
///           into parts. They travel as the contour does; one that bounds an enclosed rest runs
///           the other way around. Of an open contour: the pieces beside it, without caps at its
///           ends, in the order of travel, without crumbs of a micrometre. Corners that open are
///           rounded about the corner.
/// promise   every point is at least |distance| − kOffsetTolerance from every point of the
///           contour, and nothing that is farther from it is left out
/// source    the offset is part of: the parallels of the elements and the circles about the
///           corners. These are cut where they meet, and the pieces whose distance is right are
///           kept and joined.
/// is_over   asked now and then: whether it is to end without a result; empty: nobody is asked
Result<std::vector<Contour>, OffsetFault> offset(const Contour& contour, double distance,
                                                 const std::function<bool()>& is_over = {});

/// The curves at a distance beside several contours together: a wall and the islands within it.
///
/// contours  one, or several that are closed; those that bound one region have it on the same side
/// promise   as of one contour, with the distance to all of them
Result<std::vector<Contour>, OffsetFault> offset(std::span<const Contour> contours, double distance,
                                                 const std::function<bool()>& is_over = {});

}  // namespace kadr::path
