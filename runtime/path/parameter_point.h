// parameter_point.h — point, direction and bending of a curve C(u) at a parameter.
#pragma once

#include <cmath>

#include "path/spline.h"
#include "path/vec3.h"

namespace kadr::path {

/// Of a curve whose parameter goes from 0 to 1.
///
/// at       C, C' and C'' by the parameter: SplinePoint(double)
/// least    |C'| up to which the curve stands, mm: its direction is then that of the path behind,
///          or at the end that of the path before
/// returns  curvature d²C/ds², 1/mm: what of C'' is across the tangent, divided by |C'|²
template <typename At>
CurvePoint parameter_point(const At& at, double u, double least) {
    const SplinePoint point = at(u);
    if (!(point.first.norm() > least)) {
        const double beside = u < 0.5 ? u + 1e-3 : u - 1e-3;
        const Vec3 delta = (at(beside).position - point.position) * (u < 0.5 ? 1 : -1);
        const double size = delta.norm();
        return {point.position, size > 0 ? Vec3(delta / size) : Vec3(Vec3::Zero()), Vec3::Zero()};
    }
    const double square = point.first.squaredNorm();
    const Vec3 tangent = point.first / std::sqrt(square);
    return {point.position, tangent, (point.second - point.second.dot(tangent) * tangent) / square};
}

}  // namespace kadr::path
