#include "path/parametric.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/assert.h"
#include "path/helix.h"
#include "path/parameter_point.h"
#include "path/quadrature.h"

namespace kadr::path {

namespace {

constexpr double kShare = 1.0 / static_cast<double>(Parametric::kParts);

/// Intervals of the parameter that quadrature begins with, in a quarter: what is narrower than
/// that it might look past.
constexpr int kIntervals = 8;

/// Below this part of the mean the derivative is taken for zero: the curve stands.
constexpr double kStands = 1e-7;

double parameter_of(const CurveLaw& law, double u) { return law.from + u * (law.to - law.from); }

/// In the coordinates of the machine, derivatives by the share u of the range.
SplinePoint point_at(const Parametric& curve, double u) {
    const CurveShape& shape = curve.shape;
    const double range = shape.law.to - shape.law.from;
    const SplinePoint own = shape.kind->at(shape.law.numbers, parameter_of(shape.law, u));
    return {curve.origin + shape.linear * own.position, shape.linear * own.first * range,
            shape.linear * own.second * (range * range)};
}

/// 0 where a law breaks its promise: quadrature would never be content with what is no number.
double speed(const Parametric& curve, double u) {
    const double rate = point_at(curve, u).first.norm();
    return std::isfinite(rate) ? rate : 0;
}

/// Where the curve turns back between two parameters, in a cusp: there its speed has a kink, and
/// what quadrature takes for its error may be nothing by chance.
std::optional<double> cusp_between(const Parametric& curve, double from, double to) {
    constexpr int kHalvings = 50;
    const SplinePoint before = point_at(curve, from);
    const SplinePoint behind = point_at(curve, to);
    const bool turns_back = before.first.dot(behind.first) < 0;
    const bool has_least =
        before.first.dot(before.second) < 0 && behind.first.dot(behind.second) > 0;
    if (!turns_back || !has_least) return std::nullopt;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (from + to);
        const SplinePoint here = point_at(curve, middle);
        (here.first.dot(here.second) > 0 ? to : from) = middle;
    }
    return 0.5 * (from + to);
}

double length_between(const Parametric& curve, double from, double to) {
    const auto rate = [&](double u) { return speed(curve, u); };
    const auto length = [&](double lower, double upper) {
        return integrate(rate, lower, upper, 0.1 * kArcLengthTolerance).value;
    };
    const auto cusp = cusp_between(curve, from, to);
    return cusp ? length(from, *cusp) + length(*cusp, to) : length(from, to);
}

void measure(Parametric& curve) {
    constexpr double kWidth = kShare / kIntervals;
    curve.length = 0;
    for (std::size_t part = 0; part < Parametric::kParts; ++part) {
        for (int i = 0; i < kIntervals; ++i) {
            const double from = kShare * static_cast<double>(part) + kWidth * i;
            curve.length += length_between(curve, from, from + kWidth);
        }
        curve.reached[part] = curve.length;
    }
}

/// What lies on a curve; `law` is its own part of the range.
Parametric of_law(const Parametric& whole, const CurveLaw& law, const Vec3& start,
                  const Vec3& end) {
    Parametric piece = whole;
    piece.shape.law = law;
    piece.start = start;
    piece.end = end;
    measure(piece);
    return piece;
}

}  // namespace

Vec3 end_of(const CurveShape& shape, const Vec3& start) {
    const Vec3 from = shape.kind->at(shape.law.numbers, shape.law.from).position;
    const Vec3 to = shape.kind->at(shape.law.numbers, shape.law.to).position;
    return start + shape.linear * (to - from);
}

Parametric make_parametric(const Vec3& start, const Vec3& end, const CurveShape& shape) {
    KADR_ASSERT(shape.kind != nullptr && shape.law.to > shape.law.from, "a curve with a range");
    Parametric curve;
    curve.shape = shape;
    curve.start = start;
    curve.end = end;
    curve.origin =
        start - shape.linear * shape.kind->at(shape.law.numbers, shape.law.from).position;
    measure(curve);
    return curve;
}

double length_to(const Parametric& curve, double u) {
    if (u <= 0) return 0;
    if (u >= 1) return curve.length;
    const auto part = static_cast<std::size_t>(u / kShare);
    const double begin = part == 0 ? 0 : curve.reached[part - 1];
    return begin + length_between(curve, kShare * static_cast<double>(part), u);
}

namespace {

double parameter_at(const Parametric& curve, double s) {
    if (s <= 0) return 0;
    if (s >= curve.length) return 1;
    const auto& reached = curve.reached;
    const auto found = std::upper_bound(reached.begin(), reached.end() - 1, s);
    const auto part = static_cast<std::size_t>(found - reached.begin());
    double lower = kShare * static_cast<double>(part);
    double upper = lower + kShare;
    double begin = part == 0 ? 0 : reached[part - 1];  // arc length at `at`
    double at = lower;
    // The first guess divides the quarter by length; Newton's step is kept in the bracket.
    double u = lower + kShare * (s - begin) / (reached[part] - begin);
    for (int pass = 0; pass < 60; ++pass) {
        begin += u > at ? length_between(curve, at, u) : -length_between(curve, u, at);
        at = u;
        const double miss = begin - s;
        if (std::fabs(miss) <= 0.1 * kArcLengthTolerance) return u;
        (miss > 0 ? upper : lower) = u;
        const double next = u - miss / speed(curve, u);
        u = next > lower && next < upper ? next : 0.5 * (lower + upper);
    }
    return u;
}

}  // namespace

Vec3 position(const Parametric& curve, double s) {
    if (s <= 0) return curve.start;
    if (s >= curve.length) return curve.end;
    return point_at(curve, parameter_at(curve, s)).position;
}

CurvePoint curvature_at(const Parametric& curve, double u) {
    return parameter_point([&](double at) { return point_at(curve, at); }, u,
                           kStands * curve.length);
}

CurvePoint evaluate(const Parametric& curve, double s) {
    CurvePoint point = curvature_at(curve, parameter_at(curve, s));
    if (s <= 0) point.position = curve.start;
    if (s >= curve.length) point.position = curve.end;
    return point;
}

Parametric part(const Parametric& curve, double from, double to) {
    const CurveLaw& whole = curve.shape.law;
    CurveLaw law = whole;
    law.from = parameter_of(whole, parameter_at(curve, from));
    law.to = to >= curve.length ? whole.to : parameter_of(whole, parameter_at(curve, to));
    return of_law(curve, law, position(curve, from), position(curve, to));
}

std::pair<Parametric, Parametric> split(const Parametric& curve, double u) {
    CurveLaw before = curve.shape.law;
    CurveLaw behind = curve.shape.law;
    before.to = behind.from = parameter_of(curve.shape.law, u);
    const Vec3 middle = point_at(curve, u).position;
    return {of_law(curve, before, curve.start, middle), of_law(curve, behind, middle, curve.end)};
}

std::optional<double> slow_parameter(const Parametric& curve) {
    constexpr int kLooks = kIntervals * static_cast<int>(Parametric::kParts);
    for (int i = 0; i < kLooks; ++i) {
        const double from = static_cast<double>(i) / kLooks;
        const double to = static_cast<double>(i + 1) / kLooks;
        const auto place = cusp_between(curve, from, to);
        if (place && *place > 0 && *place < 1) return place;
    }
    return std::nullopt;
}

Box bounds(const Parametric& curve) {
    constexpr int kSamples = 128;
    constexpr double kWidth = 1.0 / kSamples;
    Box box{curve.start.cwiseMin(curve.end), curve.start.cwiseMax(curve.end)};
    SplinePoint before = point_at(curve, 0);
    for (int i = 1; i <= kSamples; ++i) {
        const SplinePoint point = point_at(curve, kWidth * i);
        // Between two samples a coordinate leaves their chord by |C''|·width²/8 at most.
        const Vec3 bulge =
            before.second.cwiseAbs().cwiseMax(point.second.cwiseAbs()) * (kWidth * kWidth / 8);
        box.lower = box.lower.cwiseMin(before.position.cwiseMin(point.position) - bulge);
        box.upper = box.upper.cwiseMax(before.position.cwiseMax(point.position) + bulge);
        before = point;
    }
    return box;
}

}  // namespace kadr::path
