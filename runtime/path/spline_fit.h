// spline_fit.h — a parametric curve as one cubic B-spline within a tolerance.
//
// Between corners of the curve the spline is curvature-continuous; at a corner a knot stands three
// times, and the spline runs through the corner. Lines and arcs are fit.h.
#pragma once

#include "path/fit.h"
#include "path/nurbs.h"

namespace kadr::path {

struct SplineFitResult {
    Nurbs spline;  // of degree three, without weights; knots are multiples of 1/8
    std::optional<FitFault> fault;
    double parameter = 0;  // where the fault is
};

/// The spline through points of the curve whose second derivative is continuous, with the curve's
/// own directions at its ends and corners.
///
/// The points lie closer where the tolerance needs it: intervals are halved until the cubic through
/// both ends and slopes keeps to a part of the tolerance, and again where the spline itself does
/// not keep to it. Both are measured as in fit.h: the whole difference of two cubics, with the
/// error of the measure counted twice.
///
/// curve    point and derivative by the parameter
/// options  `kind` does not matter
/// returns  a spline without control points if the curve does not move
/// source   complete cubic splines: C. de Boor, A Practical Guide to Splines, ch. IV
SplineFitResult fit_spline(const ParametricCurve& curve, const FitOptions& options);

}  // namespace kadr::path
