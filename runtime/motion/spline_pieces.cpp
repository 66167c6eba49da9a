#include "motion/spline_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kadr::motion {

namespace {

using path::Bezier;
using path::CurvePoint;
using path::Involute;
using path::Parametric;
using path::Vec3;

constexpr std::size_t kSamples = 9;
using Samples = std::array<CurvePoint, kSamples>;
using SampleDistances = std::array<double, kSamples - 1>;

/// cos of the greatest turn from one sample to the next: 15 degrees.
constexpr double kLeastCos = 0.9659258;
/// Greatest and least curvature of a piece differ by no more than this, as a factor: 20 % of speed.
constexpr double kBendRatio = 1.5;
/// A piece that turns by less than this as a whole, rad, is cut for its curvature no more.
constexpr double kLittleTurn = 0.02;
/// A piece this short is not cut any more, mm: it passes in a tick. One that turns sharply is cut
/// down to the second length: the straight piece that replaces it is nowhere farther from it than
/// that, and points without a tolerance are exact to as much (path_check.h).
constexpr double kShort = 0.02;
constexpr double kPoint = 1e-6;
/// Between samples closer than this, mm, a difference of curvatures is rounding.
constexpr double kNoDistance = 1e-9;

/// Of a kind with a parameter, as a span of a spline.
template <typename Bent>
Samples sample(const Bent& curve) {
    Samples samples;
    for (std::size_t i = 0; i < kSamples; ++i) {
        const double u = static_cast<double>(i) / static_cast<double>(kSamples - 1);
        samples[i] = path::curvature_at(curve, u);
    }
    return samples;
}

Samples sample(const Involute& involute) {
    Samples samples;
    for (std::size_t i = 0; i < kSamples; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(kSamples - 1);
        samples[i] = path::evaluate(involute, share * involute.length);
    }
    return samples;
}

/// From one sample to the next, mm.
template <std::size_t N>
SampleDistances sample_distances_of(const Bezier<N>& spline) {
    SampleDistances distances;
    for (std::size_t i = 0; i < distances.size(); ++i)
        distances[i] = spline.reached[i] - (i > 0 ? spline.reached[i - 1] : 0.0);
    return distances;
}

SampleDistances sample_distances_of(const Involute& involute) {
    SampleDistances distances;
    distances.fill(involute.length / static_cast<double>(distances.size()));
    return distances;
}

SampleDistances sample_distances_of(const Parametric& curve) {
    constexpr double kWidth = 1.0 / static_cast<double>(kSamples - 1);
    SampleDistances distances;
    double before = 0;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const double reached = path::length_to(curve, kWidth * static_cast<double>(i + 1));
        distances[i] = reached - before;
        before = reached;
    }
    return distances;
}

/// Where a curve turns back it ends and another begins: on neither side is anything sharp then.
template <typename Bent>
std::pair<Bent, Bent> halves(const Bent& curve, bool is_sharp) {
    const auto turn = is_sharp ? path::slow_parameter(curve) : std::nullopt;
    return path::split(curve, turn.value_or(0.5));
}

std::pair<Involute, Involute> halves(const Involute& involute, bool /*is_sharp*/) {
    const double middle = involute.length / 2;
    return {path::part(involute, 0, middle), path::part(involute, middle, involute.length)};
}

bool turns_sharply(const Samples& samples) {
    for (std::size_t i = 0; i + 1 < kSamples; ++i) {
        if (!(samples[i].tangent.dot(samples[i + 1].tangent) >= kLeastCos)) return true;
    }
    return false;
}

bool is_evenly_bent(const Samples& samples, double length) {
    double least = samples[0].curvature.norm();
    double most = least;
    for (const CurvePoint& point : samples) {
        least = std::min(least, point.curvature.norm());
        most = std::max(most, point.curvature.norm());
    }
    return most <= kBendRatio * least || most * length <= kLittleTurn;
}

template <typename Bent>
void cut(const Bent& curve, std::vector<path::Curve>& out) {
    const Samples samples = sample(curve);
    const bool is_sharp = turns_sharply(samples);
    const bool is_cut = is_sharp ? curve.length > kPoint
                                 : curve.length > kShort && !is_evenly_bent(samples, curve.length);
    if (is_cut) {
        const auto [before, behind] = halves(curve, is_sharp);
        cut(before, out);
        cut(behind, out);
        return;
    }
    if (!is_sharp && curve.length > 0) {
        out.emplace_back(curve);
    } else if ((curve.end - curve.start).norm() > 0) {
        out.emplace_back(path::make_line(curve.start, curve.end));
    }
}

template <typename Bent>
SplineBend bend_between(const Bent& curve) {
    const Samples samples = sample(curve);
    const SampleDistances distances = sample_distances_of(curve);
    SplineBend bend;
    Vec3 rate_step = Vec3::Zero();
    Vec3 bend_step = Vec3::Zero();
    Vec3 slope_before = Vec3::Zero();  // d³C/ds³ as the difference of curvatures
    Vec3 slope_step = Vec3::Zero();
    for (std::size_t i = 0; i < kSamples; ++i) {
        bend.rate = bend.rate.cwiseMax(samples[i].tangent.cwiseAbs());
        bend.bend = bend.bend.cwiseMax(samples[i].curvature.cwiseAbs());
        bend.curvature = std::max(bend.curvature, samples[i].curvature.norm());
        if (i == 0) continue;
        const CurvePoint& before = samples[i - 1];
        rate_step = rate_step.cwiseMax((samples[i].tangent - before.tangent).cwiseAbs());
        const Vec3 change = samples[i].curvature - before.curvature;
        bend_step = bend_step.cwiseMax(change.cwiseAbs());
        const double distance = distances[i - 1];
        if (!(distance > kNoDistance)) continue;
        const Vec3 slope = change / distance;
        bend.third = bend.third.cwiseMax(slope.cwiseAbs());
        if (i > 1) slope_step = slope_step.cwiseMax((slope - slope_before).cwiseAbs());
        slope_before = slope;
    }
    // A difference is a mean: at the ends it misses half of what it changes by, and a hump rises by
    // as much again at most.
    bend.third += slope_step;
    // A hump between two samples rises by an eighth of what the differences change at most, and
    // these change by no more than twice the greatest.
    bend.rate = (bend.rate + rate_step / 4).cwiseMin(1.0);
    bend.bend += bend_step / 4;
    bend.curvature += bend_step.norm() / 4;
    return bend;
}

}  // namespace

std::vector<path::Curve> evenly_bent(const path::Curve& curve) {
    std::vector<path::Curve> pieces;
    if (const auto* spline = std::get_if<path::CubicSpan>(&curve)) cut(*spline, pieces);
    if (const auto* quintic = std::get_if<path::QuinticSpan>(&curve)) cut(*quintic, pieces);
    if (const auto* involute = std::get_if<Involute>(&curve)) cut(*involute, pieces);
    if (const auto* parametric = std::get_if<Parametric>(&curve)) cut(*parametric, pieces);
    return pieces;
}

SplineBend bend_of(const path::Curve& curve) {
    if (const auto* spline = std::get_if<path::CubicSpan>(&curve)) return bend_between(*spline);
    if (const auto* quintic = std::get_if<path::QuinticSpan>(&curve)) return bend_between(*quintic);
    if (const auto* involute = std::get_if<Involute>(&curve)) return bend_between(*involute);
    return bend_between(std::get<Parametric>(curve));
}

}  // namespace kadr::motion
