// parametric.h — a curve of a registered kind, C(u), walked by its arc length.
//
// What a kind gives is a law: position and two derivatives by the parameter, in plain functions of
// few numbers. Everything else is here and the same for all of them: where the curve lies, its
// length by adaptive quadrature, the parameter at an arc length, parts. How a kind is made known,
// and a program comes to name it: curve_registry.h and docs/motion.md.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"
#include "path/spline.h"
#include "path/vec3.h"

namespace kadr::path {

/// What a kind works with; enough for the usual ones, and a segment stays a plain value.
inline constexpr std::size_t kCurveNumbers = 8;
using CurveNumbers = std::array<double, kCurveNumbers>;

/// What a kind has made of the arguments of one call.
struct CurveLaw {
    CurveNumbers numbers{};
    double from = 0;  // parameter at the start
    double to = 1;    // … and at the end, > from
};

/// What a call gives, in the order in which the dialect declares its parameters: mm, rad, s, mm/s
/// and rev/s; nothing where the call leaves it out.
using CurveArguments = std::span<const std::optional<double>>;

/// A kind of curve. In its own coordinates x and y are the first and the second axis of the working
/// plane, z the tool axis. Where it begins there does not matter: the tool is there already.
struct CurveKind {
    std::string_view name;
    /// Why a call has no curve is worded as a message: "the radius is zero".
    Result<CurveLaw, std::string> (*make)(CurveArguments arguments) = nullptr;
    /// Position, first and second derivative by the parameter, from ≤ u ≤ to; finite there, and the
    /// first derivative zero at single points at most. No state: threads ask at the same time.
    SplinePoint (*at)(const CurveNumbers& numbers, double u) = nullptr;
};

/// A curve as a Command states it: C(u) = start + linear·(at(u) − at(from)).
struct CurveShape {
    const CurveKind* kind = nullptr;  // of the registry
    CurveLaw law;
    /// From the kind's coordinates to those of the machine: plane, rotations, scales, mirrors.
    Eigen::Matrix<double, 3, 3, Eigen::DontAlign> linear =
        Eigen::Matrix<double, 3, 3, Eigen::DontAlign>::Identity();
};

/// Where a curve that begins at `start` ends.
Vec3 end_of(const CurveShape& shape, const Vec3& start);

struct Parametric {
    static constexpr std::size_t kParts = 4;

    CurveShape shape;
    Vec3 origin;  // of the kind's coordinates
    Vec3 start;   // as programmed
    Vec3 end;     // as programmed
    double length;
    std::array<double, kParts> reached;  // arc length at the end of each quarter of the parameter
};

/// The curve between two points, of which the second is `end_of` but for rounding.
Parametric make_parametric(const Vec3& start, const Vec3& end, const CurveShape& shape);

inline double length(const Parametric& curve) { return curve.length; }
inline Vec3 start(const Parametric& curve) { return curve.start; }
inline Vec3 end(const Parametric& curve) { return curve.end; }
/// The point at an arc length. The parameter is found by Newton's iteration on the length from the
/// start, in a bracket, to kArcLengthTolerance: nothing accumulates.
/// source: motion reference §1.7, §1.8
Vec3 position(const Parametric& curve, double s);
CurvePoint evaluate(const Parametric& curve, double s);
Parametric part(const Parametric& curve, double from, double to);
/// The pieces before and behind a share of the range of the parameter, 0 < u < 1.
std::pair<Parametric, Parametric> split(const Parametric& curve, double u);
/// The first share of the range inside at which the curve turns back, as in a cusp.
std::optional<double> slow_parameter(const Parametric& curve);
/// Of samples, and of what the curve bulges between them: not too small unless it waves between two
/// of a hundred.
Box bounds(const Parametric& curve);

/// Tangent and curvature at a share of the range of the parameter, 0 … 1; where the curve stands,
/// as in a cusp, those of the path onwards.
CurvePoint curvature_at(const Parametric& curve, double u);
/// Arc length up to such a share.
double length_to(const Parametric& curve, double u);

}  // namespace kadr::path
