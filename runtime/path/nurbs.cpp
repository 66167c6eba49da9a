#include "path/nurbs.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "path/helix.h"
#include "path/homogeneous.h"
#include "path/quadrature.h"

namespace kadr::path {

namespace {

/// So many control points and knots of spans that are done are kept, and then given away together.
constexpr std::size_t kGone = 64;

/// The largest k with Uk ≤ u < U(k+1); at the end the last span that is not empty.
std::size_t span_of(const Nurbs& nurbs, double u) {
    const auto first = nurbs.knots.begin() + nurbs.degree;
    const auto last =
        nurbs.knots.begin() + static_cast<std::ptrdiff_t>(nurbs.control_points.size());
    auto found = std::upper_bound(first, last, u);
    if (found == last && u >= *last) found = std::lower_bound(first, last, *last);
    return static_cast<std::size_t>(found - nurbs.knots.begin()) - 1;
}

}  // namespace

std::optional<NurbsFault> fault_of(const Nurbs& nurbs) {
    if (nurbs.degree < 1) return NurbsFault::Degree;
    const auto order = static_cast<std::size_t>(nurbs.degree) + 1;
    const std::size_t control_points = nurbs.control_points.size();
    if (control_points < order) return NurbsFault::ControlPoints;
    const bool has_weights = !nurbs.weights.empty();
    if (nurbs.knots.size() != control_points + order ||
        (has_weights && nurbs.weights.size() != control_points))
        return NurbsFault::Counts;
    if (!std::is_sorted(nurbs.knots.begin(), nurbs.knots.end())) return NurbsFault::Decreasing;
    if (nurbs.knots[0] != nurbs.knots[order - 1] ||
        nurbs.knots[control_points] != nurbs.knots.back())
        return NurbsFault::Unclamped;
    for (std::size_t i = order; i < control_points; ++i) {
        if (nurbs.knots[i] == nurbs.knots[i + order - 1]) return NurbsFault::Gap;
    }
    if (nurbs.knots[order - 1] == nurbs.knots[order]) return NurbsFault::Gap;
    const bool has_wrong = std::any_of(nurbs.weights.begin(), nurbs.weights.end(),
                                       [](double weight) { return !(weight > 0); });
    return has_wrong ? std::optional(NurbsFault::Weight) : std::nullopt;
}

SplinePoint point_at(const Nurbs& nurbs, double u) {
    const auto p = static_cast<std::size_t>(nurbs.degree);
    const std::vector<double>& knots = nurbs.knots;
    u = std::clamp(u, knots[p], knots[nurbs.control_points.size()]);
    const std::size_t k = span_of(nurbs, u);
    std::vector<ControlPoint> d(p + 1);
    for (std::size_t i = 0; i <= p; ++i)
        d[i] = control_point_of(nurbs.control_points[k - p + i], nurbs.weight(k - p + i));
    ControlPoint first = ControlPoint::Zero();
    ControlPoint second = ControlPoint::Zero();
    const auto degree = static_cast<double>(p);
    const double width = knots[k + 1] - knots[k];
    for (std::size_t r = 1; r <= p; ++r) {
        if (r + 1 == p) {
            const ControlPoint before = (d[p - 1] - d[p - 2]) / (knots[k + 1] - knots[k - 1]);
            const ControlPoint behind = (d[p] - d[p - 1]) / (knots[k + 2] - knots[k]);
            second = degree * (degree - 1) * (behind - before) / width;
        }
        if (r == p) first = degree * (d[p] - d[p - 1]) / width;
        for (std::size_t i = p; i >= r; --i) {
            const double from = knots[i + k - p];
            const double share = (u - from) / (knots[i + 1 + k - r] - from);
            d[i] = (1 - share) * d[i - 1] + share * d[i];
        }
    }
    return projected(d[p], first, second);
}

double length(const Nurbs& nurbs) {
    double sum = 0;
    const auto rate = [&](double u) { return point_at(nurbs, u).first.norm(); };
    for (auto i = static_cast<std::size_t>(nurbs.degree); i < nurbs.control_points.size(); ++i) {
        if (nurbs.knots[i] == nurbs.knots[i + 1]) continue;
        sum += integrate(rate, nurbs.knots[i], nurbs.knots[i + 1], kArcLengthTolerance).value;
    }
    return sum;
}

// ------------------------------------------------------------------------------ spans

void SplineSpans::add_control_point(const Vec3& pole, double weight) {
    control_points_.push_back(control_point_of(pole, weight));
}

std::optional<NurbsFault> SplineSpans::add_knot(double knot) {
    if (knot_count_ > 0 && !(knot >= knots_.back())) return NurbsFault::Decreasing;
    if (knot_count_ == 0 || knot != knots_.back()) {
        // The knot before is complete: the first one clamps, one inside must not break the curve.
        if (knot_count_ > 0 && is_first_knot_ && same_ != degree_ + 1) return NurbsFault::Unclamped;
        if (knot_count_ > 0 && !is_first_knot_ && same_ > degree_) return NurbsFault::Gap;
        is_first_knot_ = knot_count_ == 0;
        same_ = 0;
    }
    ++same_;
    ++knot_count_;
    knots_.push_back(knot);
    return std::nullopt;
}

/// The control point of a span on which the start of the span acts degree − at_end times, the end
/// at_end times: de Boor's scheme with an index of its own in every column.
ControlPoint SplineSpans::blossom(std::size_t span, std::size_t at_end) const {
    const std::size_t p = degree_;
    const std::size_t k = span + p - gone_;
    std::array<ControlPoint, 4> d;
    for (std::size_t i = 0; i <= p; ++i) d[i] = control_points_[k - p + i];
    for (std::size_t r = 1; r <= p; ++r) {
        const double parameter = r <= at_end ? knots_[k + 1] : knots_[k];
        for (std::size_t i = p; i >= r; --i) {
            const double from = knots_[i + k - p];
            const double share = (parameter - from) / (knots_[i + 1 + k - r] - from);
            d[i] = (1 - share) * d[i - 1] + share * d[i];
        }
    }
    return d[p];
}

std::optional<SplineSpan> SplineSpans::next() {
    const std::size_t p = degree_;
    KADR_ASSERT(p >= 1 && p <= 3, "spans are of degree one to three");
    for (;; ++span_) {
        if (control_points() < span_ + p + 1 || knot_count_ < span_ + 2 * p + 1)
            return std::nullopt;
        const std::size_t k = span_ + p - gone_;
        if (knots_[k] != knots_[k + 1]) break;
    }
    SplineSpan span;
    span.shape.degree = static_cast<int>(p);
    span.last_control_point = span_ + p;
    for (std::size_t i = 0; i <= p; ++i) {
        const ControlPoint control_point = blossom(span_, i);
        const Vec3 point = control_point.head<3>() / control_point[3];
        span.shape.weights[i] = control_point[3];
        if (i == 0) span.start = point;
        else if (i == p) span.end = point;
        else span.shape.inner[i - 1] = point;
    }
    ++span_;
    if (span_ - gone_ >= kGone) {
        const auto done = static_cast<std::ptrdiff_t>(span_ - gone_);
        control_points_.erase(control_points_.begin(), control_points_.begin() + done);
        knots_.erase(knots_.begin(), knots_.begin() + done);
        gone_ = span_;
    }
    return span;
}

std::optional<NurbsFault> SplineSpans::end_fault() const {
    if (control_points() < degree_ + 1) return NurbsFault::ControlPoints;
    if (knot_count_ != control_points() + degree_ + 1) return NurbsFault::Counts;
    if (is_first_knot_ || same_ != degree_ + 1) return NurbsFault::Unclamped;
    return std::nullopt;
}

}  // namespace kadr::path
