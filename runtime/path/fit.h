// fit.h — a parametric curve as lines or as arcs that run into each other, within a tolerance.
//
// Knows points and tangents by the parameter and nothing else: what computes them is the caller's.
// The pieces come one by one, so a curve of any length takes no memory. A curve as one spline is
// spline_fit.h.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <optional>

#include "path/contour.h"
#include "path/cubic.h"
#include "path/vec3.h"

namespace kadr::path {

/// A point of a curve and how it moves with the parameter.
struct CurveSample {
    Vec3 position = Vec3::Zero();    // mm
    Vec3 derivative = Vec3::Zero();  // mm per unit of the parameter
};

/// The cubic through two samples with their slopes, and how far the curve may be from it.
struct MeasuredCubic {
    Cubic cubic{};
    double error = 0;  // mm; counts twice where a tolerance is kept
};
/// inside   sample at the share kInside of the distance between the others
/// width    of the parameter between the two
MeasuredCubic measured_cubic(const CurveSample& begin, const CurveSample& inside,
                             const CurveSample& end, double width);
/// Where inside an interval the measure is checked: not the middle, which a periodic curve may
/// meet in step.
inline constexpr double kInside = 0.381966;

/// Nothing if the curve has no point there; who evaluates it has reported why.
using ParametricCurve = std::function<std::optional<CurveSample>(double parameter)>;

enum class FitKind : std::uint8_t {
    Lines,   // chords, in space
    Biarcs,  // pairs of arcs in the plane of the first two coordinates, tangents continuous inside
             // and from pair to pair; the third coordinate is 0
};

struct FitOptions {
    FitKind kind = FitKind::Lines;
    double tolerance = 0.005;  // mm, > 0: how far the curve may be from the pieces
    double from = 0;           // range of the parameter; from > to runs backwards
    double to = 1;
};

/// One piece; it begins where the one before ended.
struct FitPiece {
    Vec3 to = Vec3::Zero();
    Vec2 center = Vec2::Zero();  // of an arc
    double sweep = 0;            // rad, counter-clockwise positive; 0: a line
};

enum class FitFault : std::uint8_t {
    NotEvaluated,  // the curve has no point somewhere
    Jump,          // two points of the curve are apart although their parameters are not
};

/// Cuts a curve into pieces, each as long as the tolerance lets it be; a straight line is one, a
/// circle two halves.
///
/// Whether a piece is good is measured: between neighbouring samples the curve is taken for the
/// cubic through both points with both slopes, and the whole cubic, not points of it, is held
/// against the piece. How far a further sample inside and its slope miss the cubic tells the error
/// of the measure, which counts twice. Where it is not small against the tolerance, the samples
/// come closer.
class CurveFit {
  public:
    CurveFit(ParametricCurve curve, const FitOptions& options);

    /// The first point of the curve.
    std::optional<Vec3> start();
    /// The next piece; nothing at the end, or after a fault.
    std::optional<FitPiece> next();
    /// Why there is no further piece; nothing if the end was reached.
    std::optional<FitFault> fault() const { return fault_; }
    /// The parameter up to which there are pieces, for messages.
    double parameter() const { return at_; }

  private:
    struct Candidate {
        CurveSample end;
        double to = 0;
        int pieces = 0;  // 1: a line; 2: a biarc; 0: none leads there
        std::array<Element, 2> elements;
    };

    /// A piece that the next one may still make longer.
    struct Made {
        Vec3 from = Vec3::Zero();
        FitPiece piece;
        double error = 0;  // mm: what joining has cost so far
        /// Takes in the piece behind, if it goes on along the same line or circle.
        bool take(const Made& next);
    };

    std::optional<CurveSample> sample(double parameter);
    bool make_pieces();
    /// Unit vector of travel beside a parameter; looks a little further where the curve stands.
    std::optional<Vec3> direction(const CurveSample& at, double parameter, double side);
    std::optional<Candidate> make(double to);
    bool stays_within(const Candidate& candidate);
    bool stays_within(const Candidate& candidate, double from, const CurveSample& begin, double to,
                      const CurveSample& end, int depth);
    bool is_within(const Candidate& candidate, const Cubic& cubic, double limit, int depth) const;
    bool is_bounded(const Candidate& candidate, const Cubic& cubic, double limit) const;
    double distance(const Candidate& candidate, const Vec3& point) const;
    std::optional<Candidate> longest();

    ParametricCurve curve_;
    FitOptions options_;
    double at_ = 0;
    double step_ = 0;  // of the latest piece
    CurveSample here_;
    bool is_started_ = false;
    std::optional<FitFault> fault_;
    std::deque<Made> ready_;
};

/// Two arcs, or lines where they would be straight, from one point and direction to another.
///
/// a, b               points, mm
/// out_of_a, into_b   unit vectors of travel
/// returns            the two elements, joined with a common tangent; nothing if none of less than
///                    half a turn each leads there
/// source             K. Bolton, Biarc curves, CAD 7 (1975); both control legs of one length
std::optional<std::pair<Element, Element>> biarc(const Vec2& a, const Vec2& out_of_a, const Vec2& b,
                                                 const Vec2& into_b);

}  // namespace kadr::path
