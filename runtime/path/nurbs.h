// nurbs.h — splines by control points, knots and weights: evaluated, measured, cut into spans.
//
// Knots U0 … U(n+p+1), degree p, control points P0 … Pn: the curve runs over [Up, U(n+1)]. Both
// ends are clamped, so it begins in the first and ends in the last control point.
// source: L. Piegl, W. Tiller, The NURBS Book; motion reference §1.5
#pragma once

#include <optional>
#include <vector>

#include "path/spline.h"

namespace kadr::path {

struct Nurbs {
    int degree = 3;
    std::vector<double> knots;
    std::vector<Vec3> control_points;
    std::vector<double> weights;  // > 0; none: all are 1

    double weight(std::size_t pole) const { return weights.empty() ? 1 : weights[pole]; }
};

enum class NurbsFault : std::uint8_t {
    Degree,         // below one
    ControlPoints,  // fewer than degree + 1
    Counts,  // knots are not control points + degree + 1, or weights not as many as control points
    Decreasing,  // a knot is less than the one before
    Unclamped,   // an end is no control point: its knot does not stand degree + 1 times
    Gap,         // a knot inside stands more than `degree` times: the curve breaks off there
    Weight,      // not positive
};
std::optional<NurbsFault> fault_of(const Nurbs& nurbs);

/// Point and derivatives by the parameter.
/// nurbs     without fault
/// u         clamped to [Up, U(n+1)]; at a knot the span behind it counts, at the end the last
/// source    de Boor's scheme; derivatives from its last two columns, then the quotient rule
SplinePoint point_at(const Nurbs& nurbs, double u);

/// Arc length, mm, to a millionth of a micrometre, a span at a time.
double length(const Nurbs& nurbs);

/// A span between two knots, of degree one to three.
struct SplineSpan {
    Vec3 start = Vec3::Zero();
    Vec3 end = Vec3::Zero();
    SplineShape shape;
    std::size_t last_control_point = 0;  // the last one that it depends on
};

/// Cuts a spline of any length into spans while its control points and knots still come.
class SplineSpans {
  public:
    explicit SplineSpans(int degree = 3) : degree_(static_cast<std::size_t>(degree)) {}

    /// weight  > 0
    void add_control_point(const Vec3& pole, double weight);
    /// A knot that cannot follow the ones before is not taken.
    std::optional<NurbsFault> add_knot(double knot);
    /// The next span, once all that it depends on is known.
    std::optional<SplineSpan> next();
    /// What is wrong with a spline that ends here.
    std::optional<NurbsFault> end_fault() const;

    std::size_t control_points() const { return gone_ + control_points_.size(); }

  private:
    ControlPoint blossom(std::size_t span, std::size_t at_end) const;

    std::size_t degree_;
    std::vector<ControlPoint> control_points_;  // from number gone_ on
    std::vector<double> knots_;                 // from number gone_ on
    std::size_t gone_ = 0;
    std::size_t span_ = 0;        // number of the next one
    std::size_t knot_count_ = 0;  // of all
    std::size_t same_ = 0;        // how often the latest knot stands
    bool is_first_knot_ = true;   // all have been the same so far
};

}  // namespace kadr::path
