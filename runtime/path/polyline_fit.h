// polyline_fit.h — many short lines as few cubics within a tolerance.
//
// The points may be rounded ones of a smooth curve; where no cubic keeps the tolerance, as at a
// corner, lines stay lines.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "path/cubic.h"

namespace kadr::path {

/// Some of the lines, as one cubic from the start of the first to the end of the last.
struct PolylinePart {
    std::size_t from = 0;  // points of the polyline
    std::size_t to = 0;
    bool is_line = false;
    Cubic cubic{};
    Vec3 slope = Vec3::Zero();  // at its end, by length of the polyline
    double apart = 0;           // from the lines at most, mm; by deviation_from_lines
};

struct PolylineFitOptions {
    double tolerance = 0.01;            // mm, > 0
    std::optional<Vec3> first_slope;    // at the first point, by length of the polyline
    std::span<const std::size_t> ends;  // points at which a part has to end, ascending, for one
};

/// Parts in order, that together lead from the first point to the last. Neighbours that are cubics
/// have one direction and one curvature where they meet.
///
/// The cubics run through some of the points, with continuous second derivative by the length of
/// the polyline. A cubic that is farther from its lines than the tolerance, or they from it, is
/// halved until it keeps to it, or is one line. What comes out has been judged as it comes out; the
/// work for each line is bounded, and where it does not suffice lines stay lines.
///
/// points   two or more, no two neighbours the same, mm
std::vector<PolylinePart> fit_polyline(std::span<const Vec3> points,
                                       const PolylineFitOptions& options);

}  // namespace kadr::path
