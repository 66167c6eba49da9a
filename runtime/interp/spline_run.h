// spline_run.h — a spline whose blocks are still coming, by control points and knots.
//
// A control gives knots in one of two ways, and the blocks show which. As intervals: the spline
// begins where the tool is, block i brings control point i and the width of span i; both ends are
// clamped. As knots: the first block repeats the position of the tool as the first control point,
// each of them has a knot, and degree + 1 further knots close the spline.
//
// X, Y and Z make the path. The other axes have control points in the same blocks, of the same
// knots and weights: at the end of every span each is where its own spline is, and between they go
// in proportion to the path. So it is with the direction of the tool, on great circles.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "base/axes.h"
#include "base/source.h"
#include "interp/state.h"
#include "path/nurbs.h"

namespace kadr::interp {

/// What the block of a control point programs beside it; its span is executed with that.
struct ControlPointBlock {
    std::uint32_t line = 0;
    SourceId source;
    double feed = 0;
    AxisValues to{};           // of the control point, or of the end of the span, base coordinates
    std::uint32_t number = 0;  // among the blocks of its spline, from 1
    bool stops = false;        // exactly, at the end of the block
    /// Of the tool beside the control point, in the base system; between control points that lie
    /// against each other zero.
    std::optional<path::Vec3> direction = std::nullopt;
    std::optional<ToolWords> tool = std::nullopt;  // … or its words of the tool along the span,
    OrientModes modes = {};                        // … understood like this
};

/// A span, and the block that completed it.
struct SplineStep {
    path::SplineSpan span;
    ControlPointBlock block;
    bool is_last = false;  // of the spline
};

class SplineRun {
  public:
    SplineRun(int degree, bool by_knots);

    bool is_by_knots() const { return by_knots_; }
    std::size_t control_points() const { return spans_.control_points(); }
    int degree() const { return degree_; }
    /// Of the tool, beside the latest control point.
    const std::optional<path::Vec3>& direction() const { return direction_; }

    void add_control_point(const path::Vec3& pole, double weight, const ControlPointBlock& block);
    /// By knots: the next one.
    std::optional<path::NurbsFault> add_knot(double knot);
    /// By intervals: that of the control point added last, ≥ 0.
    std::optional<path::NurbsFault> add_interval(double interval);
    /// No further block belongs to the spline.
    std::optional<path::NurbsFault> finish();

    /// The next span that is known in full; the very last one only behind `finish`.
    std::optional<SplineStep> next();

    AxisMask moved = 0;  // axes that its blocks have named

  private:
    int degree_;
    bool by_knots_;
    bool is_finished_ = false;
    std::optional<path::NurbsFault> add_to_all(double knot);

    path::SplineSpans spans_;
    path::SplineSpans rotary_;      // … of A, B, C as a position
    path::SplineSpans parallel_;    // … of U, V, W
    path::SplineSpans directions_;  // … of the tool
    std::optional<path::Vec3> direction_;
    bool turns_ = false;                    // directions beside control points differ
    AxisValues first_{};                    // of the first control point
    AxisMask led_ = 0;                      // axes of which control points differ from it
    double knot_ = 0;                       // the sum of the intervals
    double known_knot_ = 0;                 // the latest that a clamped end does not replace
    std::deque<double> waiting_;            // knots that a clamped end would replace
    std::deque<ControlPointBlock> blocks_;  // of control points from number first_block_ on
    std::size_t first_block_ = 0;
    std::optional<SplineStep> held_;
};

}  // namespace kadr::interp
