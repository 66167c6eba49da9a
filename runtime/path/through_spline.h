// through_spline.h — cubic splines that run through their points, span by span while these come.
//
// The parameter is the sum of the chords. A span is known as soon as the slopes at both its ends
// are. Of Akima's spline they depend on two points to either side. Of the spline with a continuous
// second derivative they depend on every point, but from point to point by less than half: a
// window is solved, and what lies beyond it would move the curve by less than kWindowError.
//
// source     motion reference §1.4; H. Akima, J. ACM 17 (1970); C. de Boor, A Practical Guide to
//            Splines, ch. IV
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "path/frame.h"
#include "path/spline.h"

namespace kadr::path {

/// What makes the slopes at the points.
enum class ThroughKind : std::uint8_t {
    Akima,        // weighted mean of the slopes beside the point; continuous direction
    CubicSpline,  // continuous second derivative
};

/// What is asked of an end of the spline.
struct SplineEnd {
    enum class Kind : std::uint8_t {
        Auto,     // of the points alone: the first three lie on one cubic (Akima: his continuation)
        Natural,  // no curvature
        Tangent,  // this direction
    };
    Kind kind = Kind::Natural;
    Vec3 tangent = Vec3::Zero();  // unit vector, along the path
};

/// Two points closer than this are one, mm: far below the increment of every control.
inline constexpr double kSameKnot = 1e-7;

/// How far the curve may be from the one that knows all its points, mm.
inline constexpr double kWindowError = 1e-6;

struct ThroughSpan {
    Vec3 start = Vec3::Zero();
    Vec3 end = Vec3::Zero();
    SplineShape shape;
};

/// Span i runs from point i to point i + 1.
class ThroughSpline {
  public:
    /// `axes`: unit vectors, square to each other. Akima's weights are taken along each of them, so
    /// his spline is the same curve in a turned system only if they turn with it.
    ThroughSpline(ThroughKind kind, const SplineEnd& start, const Vec3& first,
                  const Mat3& axes = Mat3::Identity());

    /// The next point; false: it is where the one before is, and was not taken.
    bool add_point(const Vec3& point);
    /// The same, with the interval of the parameter that leads there, > 0, instead of the chord.
    void add_point(const Vec3& point, double interval);
    /// No further point comes. With a single point there is no span.
    void finish(const SplineEnd& end);
    /// The next span that is known.
    std::optional<ThroughSpan> next();

    std::size_t points() const { return gone_ + nodes_.size(); }

  private:
    /// A point, the interval that leads to the next one, and its row of the equations, worked
    /// down: slope = right − factor · slope of the next point.
    struct Node {
        Vec3 point = Vec3::Zero();
        double width = 0;
        Vec3 chord = Vec3::Zero();  // mean slope to the next point
        double factor = 0;
        Vec3 right = Vec3::Zero();
        std::optional<Vec3> slope;  // that is settled
    };
    Node& node(std::size_t i) { return nodes_[i - gone_]; }
    const Node& node(std::size_t i) const { return nodes_[i - gone_]; }
    std::size_t last() const { return points() - 1; }

    bool settle(std::size_t i);
    bool settle_akima(std::size_t i);
    Vec3 akima_inside(std::size_t i) const;
    Vec3 chord_beyond(std::ptrdiff_t i) const;
    std::optional<Vec3> akima_end(const SplineEnd& end, std::size_t at, std::size_t inside) const;
    bool settle_cubic(std::size_t i);
    bool eliminate_first();
    void eliminate();
    double doubt_at(std::size_t i) const;
    void solve_end();
    void take_back(std::size_t from, std::size_t to, Vec3 slope);

    ThroughKind kind_;
    SplineEnd start_;
    Mat3 axes_;
    std::optional<SplineEnd> end_;
    std::deque<Node> nodes_;  // from number gone_ on
    std::size_t gone_ = 0;
    std::size_t span_ = 0;  // number of the next one
    std::size_t rows_ = 0;  // worked down
};

}  // namespace kadr::path
