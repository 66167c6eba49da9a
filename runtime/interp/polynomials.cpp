// polynomials.cpp — blocks in which every axis is a polynomial of one parameter.
//
// With a denominator all polynomials are divided by it; an axis that is only given where to go
// moves evenly with the parameter all the same. The polynomials become control points of a rational
// curve, which the frame maps as it maps any points. Axes beside X, Y and Z go evenly with the
// parameter as well: a command lets them go evenly with the path, so the curve is cut until both
// are the same.
// source: SINUMERIK reference 4.5
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "base/diagnostics/iso.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/motion_checks.h"
#include "interp/motions.h"
#include "interp/splines.h"
#include "interp/tool_in_use.h"
#include "interp/tool_motion.h"
#include "interp/transformation.h"
#include "path/curve.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using path::ControlPoint;
using path::linear;
using path::Vec3;

namespace {

/// The weights of control points are cut until they are above this; a denominator that comes closer
/// to zero makes paths that no machine has.
constexpr double kLeastWeight = 1e-6;
constexpr int kMostCuts = 16;

/// What an axis that follows may be off, mm or deg: an increment of most controls.
constexpr double kFollowed = 1e-3;
constexpr int kMostFollowedCuts = 10;

/// The control points of both halves, homogeneous.
std::array<std::vector<ControlPoint>, 2> halves(std::vector<ControlPoint> control_points) {
    std::array<std::vector<ControlPoint>, 2> halves;
    std::vector<ControlPoint> behind(control_points.size());
    for (std::size_t k = 0; k < control_points.size(); ++k) {
        halves[0].push_back(control_points[0]);
        behind[control_points.size() - 1 - k] = control_points[control_points.size() - 1 - k];
        for (std::size_t i = 0; i + k + 1 < control_points.size(); ++i)
            control_points[i] = (control_points[i] + control_points[i + 1]) / 2;
    }
    halves[1] = std::move(behind);
    return halves;
}

/// Of the whole, the curve between two parameters.
struct PolynomialPiece {
    std::vector<ControlPoint> control_points;  // homogeneous
    double from = 0;
    double to = 1;
};

std::array<PolynomialPiece, 2> halves(const PolynomialPiece& piece) {
    auto [before, behind] = halves(piece.control_points);
    const double middle = (piece.from + piece.to) / 2;
    return {PolynomialPiece{std::move(before), piece.from, middle},
            PolynomialPiece{std::move(behind), middle, piece.to}};
}

/// Cuts a curve until the weights of all its control points are positive.
bool cut_to_positive(const PolynomialPiece& piece, int cuts, std::vector<PolynomialPiece>& out) {
    const std::vector<ControlPoint>& control_points = piece.control_points;
    if (!(control_points.front()[3] > kLeastWeight) || !(control_points.back()[3] > kLeastWeight))
        return false;
    const bool is_positive = std::ranges::all_of(
        control_points,
        [](const ControlPoint& control_point) { return control_point[3] > kLeastWeight; });
    if (is_positive) {
        out.push_back(piece);
        return true;
    }
    if (cuts == 0) return false;
    return std::ranges::all_of(halves(piece), [&](const PolynomialPiece& half) {
        return cut_to_positive(half, cuts - 1, out);
    });
}

path::SplineSpan span_of(const std::vector<ControlPoint>& control_points,
                         const path::Frame& frame) {
    const auto point = [&](const ControlPoint& control_point) {
        return frame(control_point.head<3>() / control_point[3]);
    };
    path::SplineSpan span;
    span.start = point(control_points.front());
    span.end = point(control_points.back());
    span.shape.degree = static_cast<int>(control_points.size()) - 1;
    for (std::size_t i = 0; i < control_points.size(); ++i)
        span.shape.weights[i] = control_points[i][3];
    for (std::size_t i = 1; i + 1 < control_points.size(); ++i)
        span.shape.inner[i - 1] = point(control_points[i]);
    return span;
}

/// How the length of a span grows with its parameter.
struct SpanLength {
    double whole = 0;   // mm
    double uneven = 0;  // greatest difference between the shares of parameter and length
};

template <typename Bent>
SpanLength span_length(const Bent& curve) {
    SpanLength length{curve.length, 0};
    for (std::size_t i = 0; i < Bent::kParts && curve.length > 0; ++i) {
        const double share = static_cast<double>(i + 1) / static_cast<double>(Bent::kParts);
        length.uneven = std::max(length.uneven, std::abs(curve.reached[i] / curve.length - share));
    }
    return length;
}

SpanLength span_length(const path::SplineSpan& span) {
    return span.shape.degree > 3 ? span_length(path::make_quintic(span.start, span.end, span.shape))
                                 : span_length(path::make_spline(span.start, span.end, span.shape));
}

/// Cuts pieces until axes that go by `distance` over the whole parameter are nowhere further than
/// kFollowed from where the parameter wants them.
void cut_evenly(const PolynomialPiece& piece, double distance, const path::Frame& frame, int cuts,
                std::vector<PolynomialPiece>& out) {
    const double own_distance = distance * (piece.to - piece.from);
    if (cuts == 0 ||
        span_length(span_of(piece.control_points, frame)).uneven * own_distance <= kFollowed) {
        out.push_back(piece);
        return;
    }
    for (const PolynomialPiece& half : halves(piece))
        cut_evenly(half, distance, frame, cuts - 1, out);
}

/// A span, and what its command gives beside it.
struct ProgrammedSpan {
    path::SplineSpan span;
    ControlPointBlock control_point;
};

/// The pieces as spans, which begin and end where the block does.
///
/// shares_time  the feed is that of the block's time, which the pieces share by their lengths
std::vector<ProgrammedSpan> programmed_spans(const std::vector<PolynomialPiece>& pieces,
                                             const path::Frame& frame, const AxisValues& from,
                                             const ControlPointBlock& control_point,
                                             bool shares_time) {
    std::vector<ProgrammedSpan> spans;
    std::vector<double> lengths;
    double whole = 0;
    for (const PolynomialPiece& piece : pieces) {
        ProgrammedSpan& span =
            spans.emplace_back(ProgrammedSpan{span_of(piece.control_points, frame), control_point});
        for (std::size_t i = 3; i < kAxes && &piece != &pieces.back(); ++i)
            span.control_point.to[i] = from[i] + (control_point.to[i] - from[i]) * piece.to;
    }
    spans.front().span.start = linear(from);
    spans.back().span.end = linear(control_point.to);
    if (!shares_time || spans.size() == 1) return spans;
    for (const ProgrammedSpan& span : spans)
        whole += lengths.emplace_back(span_length(span.span).whole);
    for (std::size_t i = 0; i < spans.size(); ++i)
        if (lengths[i] > 0) spans[i].control_point.feed = control_point.feed * whole / lengths[i];
    return spans;
}

/// Of the whole length.
std::vector<double> shares_of(const std::vector<ProgrammedSpan>& spans) {
    std::vector<double> shares;
    double whole = 0;
    for (const ProgrammedSpan& span : spans)
        whole += shares.emplace_back(span_length(span.span).whole);
    for (double& share : shares) share = whole > 0 ? share / whole : 1;
    return shares;
}

std::vector<ControlPointBlock*> blocks_of(std::vector<ProgrammedSpan>& spans) {
    std::vector<ControlPointBlock*> blocks;
    for (ProgrammedSpan& span : spans) blocks.push_back(&span.control_point);
    return blocks;
}

/// The greatest travel of an axis beside X, Y and Z, mm or deg.
double greatest_other_travel(const AxisValues& from, const AxisValues& to) {
    double distance = 0;
    for (std::size_t i = 3; i < kAxes; ++i)
        distance = std::max(distance, std::abs(to[i] - from[i]));
    return distance;
}

}  // namespace

void Splines::polynomial(const Block& block, const ToolWords& tool, bool exact_stop) {
    if (!channel_.checks.require_feed(block, "polynomial")) return;
    channel_.cornering.leave_corners(diag::CornerNotContour);
    if (reporter_.has_ended()) return;
    std::optional<MotionWords::Polynomials> polynomials =
        channel_.motions.motion_words().polynomials_of(block);
    if (!polynomials) return;
    Target* const target = &polynomials->target;
    std::vector<ControlPoint>& control_points = polynomials->control_points;
    const std::size_t degree = control_points.size() - 1;
    std::vector<PolynomialPiece> positive;
    if (!cut_to_positive({std::move(control_points)}, kMostCuts, positive)) {
        reporter_.report(diag::PolynomialZero, block);
        return;
    }
    const double distance = greatest_other_travel(position_.base(), target->base);
    std::vector<PolynomialPiece> pieces;
    for (const PolynomialPiece& piece : positive)
        cut_evenly(piece, distance, frames_.total(), kMostFollowedCuts, pieces);
    if (!channel_.tool_motion.require_orientation_along(block, tool)) return;
    if (tool_.has_changed) channel_.tool.activate_length(block, target->moved);
    if (!channel_.checks.require_within_limits(block, target->base, target->moved)) return;
    ControlPointBlock control_point{block.line, block.source, modal_.feed, target->base, {}, {}};
    control_point.modes = orienting_;
    const bool shares_time = modal_.feed_mode == path::FeedMode::InverseTime;
    std::vector<ProgrammedSpan> spans =
        programmed_spans(pieces, frames_.total(), position_.base(), control_point, shares_time);
    if (!channel_.tool_motion.share_orientation(block, tool, shares_of(spans), blocks_of(spans)))
        return;
    for (std::size_t i = 0; i < spans.size() && !reporter_.has_ended(); ++i) {
        const bool is_last = i + 1 == spans.size();
        put_span(spans[i].span, spans[i].control_point, target->moved, is_last && exact_stop);
    }
    if (reporter_.has_ended()) return;
    if (orienting_.is_on)
        channel_.tool_motion.put_joints(channel_.transformation.joints_of(position_.base()),
                                        *target);
    channel_.motions.arrive(*target);
    const path::SplineSpan& last = spans.back().span;
    const Vec3 came_from = degree > 1 ? last.shape.inner[degree - 2] : last.start;
    if (came_from != linear(target->base)) position_.come_from(came_from);
}

}  // namespace kadr::interp
