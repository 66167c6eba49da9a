#include "path/through_spline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "path/cubic.h"

namespace kadr::path {

namespace {

using Kind = SplineEnd::Kind;

/// Two weights that are both below this are none: what is left of them is rounding. The slopes of
/// chords are unit vectors.
constexpr double kNoWeight = 1e-9;

/// No slope is longer than this where chords are unit vectors. Inside it is 3 or that of an end, as
/// the rows are dominated by their diagonal. At an end whose last cubics are one it grows with the
/// ratio of the chords there: one of 100 mm beside one of a tenth of a micrometre.
constexpr double kGreatestSlope = 1e6;

/// A slope that is off by δ moves a cubic of width h by 4/27·h·δ at most.
constexpr double kMovesBy = 4.0 / 27;

/// Akima's slope of one coordinate between four chords, the point in the middle of them.
double akima_slope(double before2, double before, double behind, double behind2) {
    const double on_before = std::fabs(behind2 - behind);
    const double on_behind = std::fabs(before - before2);
    if (on_before + on_behind < kNoWeight) return (before + behind) / 2;
    return (on_before * before + on_behind * behind) / (on_before + on_behind);
}

}  // namespace

ThroughSpline::ThroughSpline(ThroughKind kind, const SplineEnd& start, const Vec3& first,
                             const Mat3& axes)
    : kind_(kind), start_(start), axes_(axes) {
    nodes_.emplace_back().point = first;
}

bool ThroughSpline::add_point(const Vec3& point) {
    const double chord = (point - nodes_.back().point).norm();
    if (!(chord > kSameKnot)) return false;
    add_point(point, chord);
    return true;
}

void ThroughSpline::add_point(const Vec3& point, double interval) {
    Node& before = nodes_.back();
    before.width = interval;
    before.chord = (point - before.point) / interval;
    nodes_.emplace_back().point = point;
}

void ThroughSpline::finish(const SplineEnd& end) { end_ = end; }

std::optional<ThroughSpan> ThroughSpline::next() {
    if (span_ >= last() || !settle(span_) || !settle(span_ + 1)) return std::nullopt;
    const Node& from = node(span_);
    const Node& to = node(span_ + 1);
    const Cubic cubic =
        hermite(from.point, *from.slope * from.width, to.point, *to.slope * from.width);
    ThroughSpan span;
    span.start = from.point;
    span.end = to.point;
    span.shape.inner = {cubic[1], cubic[2]};
    ++span_;
    // Akima's slopes need two points before.
    while (gone_ + 2 < span_) {
        nodes_.pop_front();
        ++gone_;
    }
    return span;
}

bool ThroughSpline::settle(std::size_t i) {
    if (node(i).slope) return true;
    return kind_ == ThroughKind::Akima ? settle_akima(i) : settle_cubic(i);
}

// ------------------------------------------------------------------------------ Akima

bool ThroughSpline::settle_akima(std::size_t i) {
    // Of the two chords behind a point one may be continued, once no further point comes.
    const bool is_known = end_ || i + 2 <= last();
    if (!is_known) return false;
    if (i == 0) {
        // The slope inside counts where there is no curvature at the end.
        if (start_.kind == Kind::Natural && !end_ && last() < 3) return false;
        node(0).slope = akima_end(start_, 0, 1);
    } else if (i == last()) {
        node(i).slope = akima_end(*end_, i, i - 1);
    } else {
        node(i).slope = akima_inside(i);
    }
    return node(i).slope.has_value();
}

Vec3 ThroughSpline::akima_inside(std::size_t i) const {
    const auto at = static_cast<std::ptrdiff_t>(i);
    const auto chord = [&](std::ptrdiff_t index) -> Vec3 {
        return axes_.transpose() * chord_beyond(index);
    };
    const std::array<Vec3, 4> beside = {chord(at - 2), chord(at - 1), chord(at), chord(at + 1)};
    Vec3 slope;
    for (Eigen::Index k = 0; k < 3; ++k)
        slope[k] = akima_slope(beside[0][k], beside[1][k], beside[2][k], beside[3][k]);
    return axes_ * slope;
}

/// A chord, or what Akima continues them with: each changes by as much as the one before.
Vec3 ThroughSpline::chord_beyond(std::ptrdiff_t i) const {
    const auto chords = static_cast<std::ptrdiff_t>(last());
    const auto chord = [&](std::ptrdiff_t at) {
        return node(static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at, 0, chords - 1))).chord;
    };
    if (i < 0) return chord(0) + static_cast<double>(-i) * (chord(0) - chord(1));
    if (i < chords) return chord(i);
    return chord(chords - 1) +
           static_cast<double>(i - chords + 1) * (chord(chords - 1) - chord(chords - 2));
}

/// The slope at an end; `inside` is the point beside it.
std::optional<Vec3> ThroughSpline::akima_end(const SplineEnd& end, std::size_t at,
                                             std::size_t inside) const {
    if (end.kind == Kind::Tangent) return end.tangent;
    const Vec3& chord = node(std::min(at, inside)).chord;
    if (last() == 1) {
        // A single span: straight, or bent at the other end alone.
        const SplineEnd& other = at == 0 ? *end_ : start_;
        if (other.kind != Kind::Tangent) return chord;
        return (3 * chord - other.tangent) / 2;
    }
    // C'' = (6·chord − 4·slope − 2·slope inside)/width
    if (end.kind == Kind::Natural) return (3 * chord - akima_inside(inside)) / 2;
    return akima_inside(at);
}

// ------------------------------------------------------------------------------ cubic

bool ThroughSpline::settle_cubic(std::size_t i) {
    eliminate();
    if (end_ && last() >= 1) {
        solve_end();
        return node(i).slope.has_value();
    }
    if (rows_ < i + 2 || doubt_at(i) > kWindowError) return false;
    take_back(rows_ - 1, i, node(rows_ - 1).chord);
    return true;
}

/// How far the curve beside a point may still move, as far as its slope depends on points that are
/// not known.
double ThroughSpline::doubt_at(std::size_t i) const {
    double doubt = kGreatestSlope * kMovesBy;
    for (std::size_t k = i; k < rows_; ++k) doubt *= std::max(node(k).factor, 0.0);
    const double before = i > gone_ ? node(i - 1).width : 0;
    return doubt * (node(i).width + before);
}

/// Slopes from a row down to another one, with that of the point behind the first.
void ThroughSpline::take_back(std::size_t from, std::size_t to, Vec3 slope) {
    for (std::size_t k = from + 1; k-- > to;) {
        slope = node(k).right - node(k).factor * slope;
        if (k == to || end_) node(k).slope = node(k).slope.value_or(slope);
    }
}

/// The row of the first point; false: it has to wait for the third.
bool ThroughSpline::eliminate_first() {
    Node& first = node(0);
    const bool is_short = last() < 2;
    if (start_.kind == Kind::Tangent) {
        first.factor = 0;
        first.right = start_.tangent;
    } else if (start_.kind == Kind::Natural || (is_short && end_)) {
        first.factor = 0.5;
        first.right = 1.5 * first.chord;
    } else if (is_short) {
        return false;
    } else {
        // The third derivative does not jump at the second point:
        // h1·m0 + (h0 + h1)·m1 = ((3·h0 + 2·h1)·h1·d0 + h0²·d1)/(h0 + h1)
        const Node& second = node(1);
        const double h0 = first.width;
        const double h1 = second.width;
        const double sum = h0 + h1;
        first.factor = sum / h1;
        first.right = ((3 * h0 + 2 * h1) * h1 * first.chord + h0 * h0 * second.chord) / (sum * h1);
    }
    return true;
}

/// Works down the rows of all points behind which a chord is known:
/// h1·m(i−1) + 2·(h0 + h1)·m(i) + h0·m(i+1) = 3·(h1·d0 + h0·d1)
void ThroughSpline::eliminate() {
    if (rows_ == 0) {
        if (last() < 1 || !eliminate_first()) return;
        rows_ = 1;
    }
    for (; rows_ < last(); ++rows_) {
        const Node& before = node(rows_ - 1);
        Node& here = node(rows_);
        const double h0 = before.width;
        const double h1 = here.width;
        const double diagonal = 2 * (h0 + h1) - h1 * before.factor;
        here.factor = h0 / diagonal;
        here.right = (3 * (h1 * before.chord + h0 * here.chord) - h1 * before.right) / diagonal;
    }
}

/// All slopes that are left, once the end is known.
void ThroughSpline::solve_end() {
    if (node(last()).slope) return;
    const std::size_t n = last();
    const Node& before = node(n - 1);
    Vec3 slope = end_->tangent;
    const bool both_auto = start_.kind == Kind::Auto && end_->kind == Kind::Auto;
    if (end_->kind == Kind::Natural || (end_->kind == Kind::Auto && n == 1)) {
        // m(n−1) + 2·m(n) = 3·d(n−1)
        slope = (3 * before.chord - before.right) / (2 - before.factor);
    } else if (end_->kind == Kind::Auto && n == 2 && both_auto) {
        // One condition for both ends: the parabola through three points.
        const Node& first = node(0);
        const Vec3 bend = (before.chord - first.chord) / (first.width + before.width);
        slope = before.chord + before.width * bend;
    } else if (end_->kind == Kind::Auto) {
        const double h0 = node(n - 2).width;
        const double h1 = before.width;
        const double sum = h0 + h1;
        const Vec3 right =
            ((3 * h1 + 2 * h0) * h0 * before.chord + h1 * h1 * node(n - 2).chord) / sum;
        slope = (right - sum * before.right) / (h0 - sum * before.factor);
    }
    node(n).slope = slope;
    take_back(n - 1, std::max(gone_, span_), slope);
}

}  // namespace kadr::path
