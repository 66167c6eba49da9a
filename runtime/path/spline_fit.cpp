#include "path/spline_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/done.h"
#include "path/complete_spline.h"
#include "path/cubic.h"

namespace kadr::path {

namespace {

/// A stretch begins with so many intervals of one width. A closed curve is never taken for the
/// point where it begins; of several numbers the one that needs the fewest control points is taken.
constexpr std::int64_t kFirstIntervals[] = {8, 10, 12, 14};
/// Widths are counted in units, so that halving is exact; an interval of one unit that is not good
/// has a corner in it.
constexpr std::int64_t kUnits = 1 << 17;
/// A corner is known to this share of the range.
constexpr double kCornerShare = 1e-10;
/// Share of the tolerance that the cubics through the curve's own slopes may use; the rest is for
/// the spline, whose slopes are a little different.
constexpr double kCubicShare = 0.7;
/// How often points may be added where the spline does not keep the tolerance.
constexpr int kRounds = 12;
/// Measuring an interval: samples in it at first, and how often they may come closer.
constexpr int kSteps = 8;
constexpr int kDeepest = 5;
/// Share of the tolerance below which closer samples would not change the answer.
constexpr double kWellMeasured = 1.0 / 64;
/// Points of a corner that are closer are the same, mm; a curve within it does not move.
constexpr double kSameCorner = 1e-6;

struct Node {
    std::int64_t units = 0;  // from the start of the stretch
    double parameter = 0;
    CurveSample at;
};

/// A smooth part of the curve, and the spline's slopes by the parameter at its nodes.
struct SmoothPart {
    std::vector<Node> nodes;
    std::vector<Vec3> slopes;
    bool is_curvature_continuous = true;
};

bool is_finite(const Vec3& v) { return v.allFinite(); }

class Fitter {
  public:
    Fitter(const ParametricCurve& curve, const FitOptions& options)
        : curve_(curve), options_(options) {}

    SplineFitResult run() {
        const auto first = sample(options_.from);
        const auto last = first ? sample(options_.to) : std::nullopt;
        if (last && options_.from != options_.to)
            add_stretches({0, options_.from, *first}, {0, options_.to, *last});
        if (!moves(result_.spline)) result_.spline = {};
        return std::move(result_);
    }

  private:
    std::optional<CurveSample> sample(double parameter) {
        std::optional<CurveSample> found = curve_(parameter);
        if (!found) fail(FitFault::NotEvaluated, parameter);
        return found;
    }
    void fail(FitFault why, double parameter) {
        if (result_.fault) return;
        result_.fault = why;
        result_.parameter = parameter;
    }

    static bool moves(const Nurbs& spline) {
        return std::any_of(spline.control_points.begin(), spline.control_points.end(),
                           [&](const Vec3& pole) {
                               return (pole - spline.control_points[0]).norm() > kSameCorner;
                           });
    }

    // ------------------------------------------------------------ measuring

    /// Whether the curve keeps this close to a cubic whose parameter runs evenly with its own.
    bool follows(const Cubic& cubic, const Node& a, const Node& b, double limit) {
        CurveSample begin = a.at;
        Cubic rest = cubic;
        const double width = (b.parameter - a.parameter) / kSteps;
        for (int i = 0; i < kSteps; ++i) {
            const double from = a.parameter + width * i;
            const bool is_last = i + 1 == kSteps;
            const auto end = is_last ? std::optional(b.at) : sample(from + width);
            if (!end) return false;
            const auto [piece, behind] = split(rest, 1.0 / (kSteps - i));
            const double to = is_last ? b.parameter : from + width;
            if (!follows(is_last ? rest : piece, {from, begin}, {to, *end}, limit, 0)) return false;
            rest = behind;
            begin = *end;
        }
        return true;
    }

    struct Sample {
        double parameter;
        CurveSample at;
    };

    bool follows(const Cubic& cubic, const Sample& a, const Sample& b, double limit, int depth) {
        if (!((b.at.position - cubic[3]).norm() <= limit)) return false;
        const double width = b.parameter - a.parameter;
        const double inside = a.parameter + width * kInside;
        const auto middle = sample(inside);
        if (!middle) return false;
        const auto [own, error] = measured_cubic(a.at, *middle, b.at, width);
        double apart = 0;
        for (std::size_t i = 0; i < 4; ++i) apart = std::max(apart, (own[i] - cubic[i]).norm());
        if (apart + 2 * error <= limit) return true;
        // Not a number, or no hope that closer samples show something else.
        if (!(error > kWellMeasured * limit) && !(apart > limit / 2)) return false;
        if (depth >= kDeepest || !std::isfinite(apart + error)) return false;
        const auto [left, right] = split(cubic, kInside);
        const Sample between{inside, *middle};
        return follows(left, a, between, limit, depth + 1) &&
               follows(right, between, b, limit, depth + 1);
    }

    /// Whether the curve's slope changes all at once somewhere between two nodes: half of the
    /// change is still there when only a millionth of the interval is left around it.
    bool has_kink(Node a, Node b) {
        constexpr int kHalvings = 20;
        constexpr double kNoticed = 0.02;  // of the speed; about a degree
        const auto change = [](const Node& from, const Node& to) {
            return (to.at.derivative - from.at.derivative).norm();
        };
        const double whole = change(a, b);
        if (!(whole > kNoticed * std::max(a.at.derivative.norm(), b.at.derivative.norm())))
            return false;
        for (int i = 0; i < kHalvings; ++i) {
            const auto middle = between(a, b, 0.5, 0);
            if (!middle) return false;
            (change(a, *middle) >= change(*middle, b) ? b : a) = *middle;
            if (change(a, b) < whole / 2) return false;
        }
        return true;
    }

    /// Of an interval, with the given slopes at its ends.
    static Cubic cubic_of(const Node& a, const Vec3& slope_a, const Node& b, const Vec3& slope_b) {
        const double width = b.parameter - a.parameter;
        return hermite(a.at.position, slope_a * width, b.at.position, slope_b * width);
    }
    bool is_good(const Node& a, const Node& b) {
        if (!is_finite(a.at.derivative) || !is_finite(b.at.derivative)) return false;
        return follows(cubic_of(a, a.at.derivative, b, b.at.derivative), a, b,
                       kCubicShare * options_.tolerance) &&
               !has_kink(a, b);
    }

    // ------------------------------------------------------------ stretches

    std::optional<Node> between(const Node& a, const Node& b, double share, std::int64_t units) {
        const double parameter = a.parameter + (b.parameter - a.parameter) * share;
        const auto at = sample(parameter);
        if (!at) return std::nullopt;
        return Node{units, parameter, *at};
    }

    /// The curve between two parameters, cut at its corners.
    void add_stretches(const Node& from, const Node& to) {
        std::optional<SmoothPart> best;
        for (const std::int64_t intervals : kFirstIntervals) {
            SmoothPart stretch;
            std::optional<std::pair<Node, Node>> corner;
            const Divided divided = divide(from, to, intervals, stretch, corner);
            if (divided == Divided::AtCorner) return cut(from, *corner, to);
            if (divided == Divided::NotAtAll) return;
            if (!solve(stretch)) return;
            const bool is_less = !best || control_point_count(stretch) < control_point_count(*best);
            if (is_less) best = std::move(stretch);
        }
        append(*best);
    }
    static std::size_t control_point_count(const SmoothPart& stretch) {
        const std::size_t nodes = stretch.nodes.size();
        return stretch.is_curvature_continuous ? nodes + 2 : 2 * nodes;
    }

    enum class Divided : std::uint8_t {
        Smoothly,
        AtCorner,  // there is one, in the interval that is given
        NotAtAll,  // a fault
    };
    /// Nodes of a stretch.
    Divided divide(const Node& from, const Node& to, std::int64_t intervals, SmoothPart& stretch,
                   std::optional<std::pair<Node, Node>>& corner) {
        stretch.nodes = {{0, from.parameter, from.at}};
        std::vector<Node> ahead;  // right ends, the nearest last
        const auto count = static_cast<double>(intervals);
        ahead.push_back({intervals * kUnits, to.parameter, to.at});
        for (std::int64_t i = intervals - 1; i > 0; --i) {
            const auto node = between(from, to, static_cast<double>(i) / count, i * kUnits);
            if (!node) return Divided::NotAtAll;
            ahead.push_back(*node);
        }
        while (!ahead.empty()) {
            const Node& a = stretch.nodes.back();
            const Node b = ahead.back();
            if (is_good(a, b)) {
                stretch.nodes.push_back(b);
                ahead.pop_back();
                continue;
            }
            if (result_.fault) return Divided::NotAtAll;
            if (b.units - a.units == 1) {
                corner = {a, b};
                return Divided::AtCorner;
            }
            const auto middle = between(a, b, 0.5, (a.units + b.units) / 2);
            if (!middle) return Divided::NotAtAll;
            ahead.push_back(*middle);
        }
        return Divided::Smoothly;
    }

    /// How much happens between two nodes: the path and, doubled, how far the change of slope
    /// leads.
    static double unrest(const Node& a, const Node& b) {
        const double width = std::fabs(b.parameter - a.parameter);
        const double turn = (b.at.derivative - a.at.derivative).norm();
        const double distance = (b.at.position - a.at.position).norm();
        return distance + 2 * (std::isfinite(turn) ? turn * width : distance);
    }

    /// Closes in on the corner between two nodes and goes on with what is before and behind it.
    void cut(const Node& from, const std::pair<Node, Node>& corner, const Node& to) {
        const double least = std::fabs(options_.to - options_.from) * kCornerShare;
        auto [a, b] = corner;
        while (std::fabs(b.parameter - a.parameter) > least) {
            const auto middle = between(a, b, 0.5, 0);
            if (!middle) return;
            if (middle->parameter == a.parameter || middle->parameter == b.parameter) break;
            const bool is_before = unrest(a, *middle) >= unrest(*middle, b);
            (is_before ? b : a) = *middle;
        }
        if (!((b.at.position - a.at.position).norm() <= options_.tolerance))
            return fail(FitFault::Jump, a.parameter);
        if (a.parameter != from.parameter) add_stretches(from, a);
        if (!result_.fault && b.parameter != to.parameter) add_stretches(b, to);
    }

    // ------------------------------------------------------------ the spline of a stretch

    /// Slopes with which second derivatives agree at every node between the ends.
    static void smooth_slopes(SmoothPart& stretch) {
        std::vector<SplineNode> nodes;
        for (const Node& node : stretch.nodes) nodes.push_back({node.parameter, node.at.position});
        stretch.slopes = complete_slopes(nodes, stretch.nodes.front().at.derivative,
                                         stretch.nodes.back().at.derivative);
    }

    /// Adds nodes until the spline keeps the tolerance; not done after a fault.
    Done solve(SmoothPart& stretch) {
        for (int round = 0; round < kRounds; ++round) {
            smooth_slopes(stretch);
            std::vector<Node> nodes = {stretch.nodes[0]};
            bool is_fine = true;
            for (std::size_t i = 0; i + 1 < stretch.nodes.size(); ++i) {
                const Node& a = stretch.nodes[i];
                const Node& b = stretch.nodes[i + 1];
                const bool keeps = follows(cubic_of(a, stretch.slopes[i], b, stretch.slopes[i + 1]),
                                           a, b, options_.tolerance);
                if (result_.fault) return kFailed;
                if (!keeps && b.units - a.units > 1) {
                    const auto middle = between(a, b, 0.5, (a.units + b.units) / 2);
                    if (!middle) return kFailed;
                    nodes.push_back(*middle);
                }
                is_fine = is_fine && keeps;
                nodes.push_back(b);
            }
            if (is_fine) return kDone;
            const bool is_halved = nodes.size() > stretch.nodes.size();
            stretch.nodes = std::move(nodes);
            if (!is_halved) break;
        }
        return take_own_slopes(stretch);
    }

    /// The curve's own slopes, with which intervals that are narrow enough keep the tolerance;
    /// every knot stands twice. Not done after a fault.
    Done take_own_slopes(SmoothPart& stretch) {
        std::vector<Node> ahead(stretch.nodes.rbegin(), stretch.nodes.rend());
        std::vector<Node> nodes = {ahead.back()};
        ahead.pop_back();
        while (!ahead.empty()) {
            const Node& a = nodes.back();
            const Node b = ahead.back();
            const bool keeps =
                follows(cubic_of(a, a.at.derivative, b, b.at.derivative), a, b, options_.tolerance);
            if (result_.fault) return kFailed;
            if (keeps) {
                nodes.push_back(b);
                ahead.pop_back();
                continue;
            }
            if (b.units - a.units == 1) {
                fail(FitFault::Jump, a.parameter);
                return kFailed;
            }
            const auto middle = between(a, b, 0.5, (a.units + b.units) / 2);
            if (!middle) return kFailed;
            ahead.push_back(*middle);
        }
        stretch.nodes = std::move(nodes);
        stretch.is_curvature_continuous = false;
        stretch.slopes.clear();
        for (const Node& node : stretch.nodes) stretch.slopes.push_back(node.at.derivative);
        return kDone;
    }

    // ------------------------------------------------------------ control points and knots

    void append(const SmoothPart& stretch) {
        const Nurbs piece = nurbs_of(stretch);
        Nurbs& all = result_.spline;
        if (all.control_points.empty()) {
            all = piece;
            return;
        }
        if ((piece.control_points[0] - all.control_points.back()).norm() > kSameCorner) {
            const Vec3 from = all.control_points.back();
            const Vec3 delta = piece.control_points[0] - from;
            join(all, {3,
                       {0, 0, 0, 0, 1, 1, 1, 1},
                       {from, from + delta / 3, from + delta * (2.0 / 3), piece.control_points[0]},
                       {}});
        }
        join(all, piece);
    }

    /// The end of one and the start of the other become one control point, with a knot of three.
    static void join(Nurbs& all, const Nurbs& piece) {
        const double from = all.knots.back();
        all.knots.pop_back();
        for (std::size_t i = 4; i < piece.knots.size(); ++i)
            all.knots.push_back(from + piece.knots[i]);
        all.control_points.insert(all.control_points.end(), piece.control_points.begin() + 1,
                                  piece.control_points.end());
    }

    static Nurbs nurbs_of(const SmoothPart& stretch) {
        const std::vector<Node>& nodes = stretch.nodes;
        const std::size_t last = nodes.size() - 1;
        std::int64_t least = kUnits;
        for (std::size_t i = 0; i < last; ++i)
            least = std::min(least, nodes[i + 1].units - nodes[i].units);
        // Short numbers: the widest interval is 1, unless the narrowest would be below 1/8.
        const double unit =
            std::max(1.0 / static_cast<double>(kUnits), 0.125 / static_cast<double>(least));
        Nurbs nurbs;
        const auto knot = [&](std::size_t i) { return static_cast<double>(nodes[i].units) * unit; };
        const auto add_knot = [&](std::size_t i, int times) {
            nurbs.knots.insert(nurbs.knots.end(), static_cast<std::size_t>(times), knot(i));
        };
        const auto cubic = [&](std::size_t i) {
            return cubic_of(nodes[i], stretch.slopes[i], nodes[i + 1], stretch.slopes[i + 1]);
        };
        add_knot(0, 4);
        const Cubic first = cubic(0);
        nurbs.control_points = {first[0], first[1]};
        Cubic before = first;
        for (std::size_t i = 1; i < last; ++i) {
            const Cubic behind = cubic(i);
            if (stretch.is_curvature_continuous) {
                // The control point of three knots lies on the line of two control points of either
                // cubic; the wider one is stretched less.
                const double h0 = knot(i) - knot(i - 1);
                const double h1 = knot(i + 1) - knot(i);
                nurbs.control_points.push_back(
                    h1 >= h0 ? Vec3(behind[1] - (behind[2] - behind[1]) * (h0 / h1))
                             : Vec3(before[2] + (before[2] - before[1]) * (h1 / h0)));
                add_knot(i, 1);
            } else {
                nurbs.control_points.push_back(before[2]);
                nurbs.control_points.push_back(behind[1]);
                add_knot(i, 2);
            }
            before = behind;
        }
        nurbs.control_points.push_back(before[2]);
        nurbs.control_points.push_back(before[3]);
        add_knot(last, 4);
        return nurbs;
    }

    const ParametricCurve& curve_;
    const FitOptions& options_;
    SplineFitResult result_;
};

}  // namespace

SplineFitResult fit_spline(const ParametricCurve& curve, const FitOptions& options) {
    return Fitter(curve, options).run();
}

}  // namespace kadr::path
