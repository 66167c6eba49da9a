#include "path/fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace kadr::path {

namespace {

/// What is measured at once is at most this share of the range, so that a closed curve is never
/// taken for the point where it begins.
constexpr double kLargestShare = 1.0 / 2;
constexpr double kFirstShare = 1.0 / 32;
/// A piece below this share of the range is as good as a point; the curve jumps if it is longer
/// than the tolerance.
constexpr double kLeastShare = 1e-10;
/// Measuring: neighbouring samples at first, of a piece at least and over the whole range, and how
/// often an interval may be halved.
constexpr int kLeastIntervals = 8;
constexpr int kIntervals = 64;
constexpr int kDeepest = 7;
/// Pieces go on along the same line or circle if their ends and centres differ by no more, mm.
constexpr double kSame = 1e-9;
/// An arc that is this flat is a line, mm: less than any control resolves.
constexpr double kFlat = 1e-6;
/// Controls take radii of six digits; a larger one is a line as well, if the tolerance allows.
constexpr double kLargestRadius = 1e5;

Vec2 left_of(const Vec2& v) { return {-v.y(), v.x()}; }
Vec2 flat(const Vec3& v) { return v.head<2>(); }

/// The arc that leaves `from` along a unit vector and ends at `to`; a line where it is straight.
std::optional<Element> arc_along(const Vec2& from, const Vec2& direction, const Vec2& to) {
    const Vec2 chord = to - from;
    const double across = left_of(direction).dot(chord);
    const double square = chord.squaredNorm();
    if (square == 0) return std::nullopt;
    if (direction.dot(chord) < 0) return std::nullopt;  // half a turn or more
    // r = c²/(2·across), and the arc rises above its chord by about c²/(8·r) = across/4.
    if (std::fabs(across) / 4 <= kFlat || square > 2 * kLargestRadius * std::fabs(across))
        return line_element(from, to);
    const Vec2 center = from + left_of(direction) * (square / (2 * across));
    const double half = std::atan2(across, direction.dot(chord));
    Element arc{from, to, center, 2 * half};
    return arc;
}

/// Greatest share of the tolerance that the error of the measure may have; below the smaller one
/// closer samples would not change the answer.
constexpr double kMeasured = 1.0 / 8;
constexpr double kWellMeasured = 1.0 / 64;
/// How often a cubic may be halved for closer bounds.
constexpr int kHalvings = 16;
/// Less than this before the start or behind the end is rounding, mm.
constexpr double kAtEnd = 1e-9;

Vec3 in_plane(const Vec2& point) { return {point.x(), point.y(), 0}; }

/// Bounds of how far a cubic is along a direction from a point, mm.
DistanceBounds along(const Cubic& cubic, const Vec2& point, const Vec2& direction) {
    DistanceBounds range{0, 0};
    for (std::size_t i = 0; i < 4; ++i) {
        const double distance = (flat(cubic[i]) - point).dot(direction);
        if (i == 0 || distance < range.lower) range.lower = distance;
        if (i == 0 || distance > range.upper) range.upper = distance;
    }
    return range;
}

bool is_around(const Cubic& cubic, const Vec2& point, double limit) {
    return std::all_of(cubic.begin(), cubic.end(),
                       [&](const Vec3& c) { return (flat(c) - point).norm() <= limit; });
}

/// Whether every point of a cubic is this close to the endless line or the whole circle.
bool is_along(const Cubic& cubic, const Element& element, double limit) {
    if (element.is_arc()) {
        const DistanceBounds range = distance_range(cubic, in_plane(element.center));
        const double r = radius(element);
        return range.lower >= r - limit && range.upper <= r + limit;
    }
    const DistanceBounds range = along(cubic, element.from, left_of(start_direction(element)));
    return range.lower >= -limit && range.upper <= limit;
}

}  // namespace

std::optional<std::pair<Element, Element>> biarc(const Vec2& a, const Vec2& out_of_a, const Vec2& b,
                                                 const Vec2& into_b) {
    // The junction is the middle of a + d·t0 and b − d·t1, where d solves
    // 2(1 − t0·t1)·d² + 2 v·(t0 + t1)·d − v² = 0, v = b − a.
    const Vec2 v = b - a;
    const double square = v.squaredNorm();
    if (square == 0) return std::nullopt;
    const double half_b = v.dot(out_of_a + into_b);
    const double k = 2 * (1 - out_of_a.dot(into_b));
    const double root = std::sqrt(half_b * half_b + k * square);
    if (half_b + root <= 0) return std::nullopt;
    const double d = square / (half_b + root);
    const Vec2 junction = (a + b + (out_of_a - into_b) * d) / 2;
    const std::optional<Element> first = arc_along(a, out_of_a, junction);
    const std::optional<Element> back = arc_along(b, -into_b, junction);
    if (!first || !back) return std::nullopt;
    return std::pair(*first, reversed(*back));
}

MeasuredCubic measured_cubic(const CurveSample& begin, const CurveSample& inside,
                             const CurveSample& end, double width) {
    MeasuredCubic measured;
    measured.cubic =
        hermite(begin.position, begin.derivative * width, end.position, end.derivative * width);
    const CubicPoint there = evaluate(measured.cubic, kInside);
    measured.error = interpolation_error(kInside, inside.position - there.position,
                                         inside.derivative * width - there.derivative);
    return measured;
}

CurveFit::CurveFit(ParametricCurve curve, const FitOptions& options)
    : curve_(std::move(curve)),
      options_(options),
      at_(options.from),
      step_((options.to - options.from) * kFirstShare) {}

std::optional<CurveSample> CurveFit::sample(double parameter) {
    std::optional<CurveSample> found = curve_(parameter);
    if (!found) fault_ = FitFault::NotEvaluated;
    return found;
}

std::optional<Vec3> CurveFit::direction(const CurveSample& at, double parameter, double side) {
    const double range = options_.to - options_.from;
    const double sense = range < 0 ? -1 : 1;
    const double speed = at.derivative.norm() * std::fabs(range);
    if (std::isfinite(speed) && speed > 1e-9) return Vec3(at.derivative.normalized() * sense);
    // The curve stands, or its slope has no end: the direction to a point beside.
    const double beside = parameter + side * range * 1e-7;
    const std::optional<CurveSample> near = sample(beside);
    if (!near) return std::nullopt;
    const Vec3 delta = (near->position - at.position) * side;
    return delta.norm() > 0 ? std::optional<Vec3>(delta.normalized()) : Vec3(Vec3::Zero());
}

std::optional<Vec3> CurveFit::start() {
    if (!is_started_) {
        const std::optional<CurveSample> first = sample(options_.from);
        if (!first) return std::nullopt;
        here_ = *first;
        is_started_ = true;
    }
    return here_.position;
}

std::optional<CurveFit::Candidate> CurveFit::make(double to) {
    const std::optional<CurveSample> end = sample(to);
    if (!end) return std::nullopt;
    Candidate candidate;
    candidate.end = *end;
    candidate.to = to;
    const bool stands = (end->position - here_.position).norm() <= kSamePoint * 1e-3;
    if (options_.kind == FitKind::Lines || stands) {
        candidate.pieces = 1;
        return candidate;
    }
    const std::optional<Vec3> out = direction(here_, at_, 1);
    const std::optional<Vec3> in = direction(*end, to, -1);
    if (!out || !in) return std::nullopt;
    const auto pair = biarc(flat(here_.position), flat(*out), flat(end->position), flat(*in));
    if (!pair) return candidate;  // no pieces: not good
    candidate.elements[0] = pair->first;
    candidate.elements[1] = pair->second;
    candidate.pieces = 2;
    return candidate;
}

double CurveFit::distance(const Candidate& candidate, const Vec3& point) const {
    if (candidate.pieces == 1)
        return distance_to_line(point, here_.position, candidate.end.position);
    return std::min(nearest(candidate.elements[0], flat(point)).distance,
                    nearest(candidate.elements[1], flat(point)).distance);
}

/// Whether all control points, and with them the cubic, are close enough; of a biarc: whether what
/// may be before, beside and behind its arcs is.
bool CurveFit::is_bounded(const Candidate& candidate, const Cubic& cubic, double limit) const {
    if (candidate.pieces == 1) {
        return std::all_of(cubic.begin(), cubic.end(),
                           [&](const Vec3& point) { return distance(candidate, point) <= limit; });
    }
    // The arcs are of less than half a turn: what is behind the start of one and before its end is
    // beside it.
    const Element& first = candidate.elements[0];
    const Element& second = candidate.elements[1];
    const DistanceBounds start = along(cubic, first.from, start_direction(first));
    const DistanceBounds joint = along(cubic, first.to, end_direction(first));
    const DistanceBounds end = along(cubic, second.to, end_direction(second));
    if (start.lower < -kAtEnd && !is_around(cubic, first.from, limit)) return false;
    if (end.upper > kAtEnd && !is_around(cubic, second.to, limit)) return false;
    if (joint.lower <= 0 && !is_along(cubic, first, limit)) return false;
    return joint.upper < 0 || is_along(cubic, second, limit);
}

bool CurveFit::is_within(const Candidate& candidate, const Cubic& cubic, double limit,
                         int depth) const {
    if (is_bounded(candidate, cubic, limit)) return true;
    if (depth >= kHalvings) return false;
    const auto [left, right] = split(cubic, 0.5);
    if (!(distance(candidate, right[0]) <= limit)) return false;
    return is_within(candidate, left, limit, depth + 1) &&
           is_within(candidate, right, limit, depth + 1);
}

bool CurveFit::stays_within(const Candidate& candidate, double from, const CurveSample& begin,
                            double to, const CurveSample& end, int depth) {
    const double inside = from + (to - from) * kInside;
    const std::optional<CurveSample> middle = sample(inside);
    if (!middle) return false;
    const double width = to - from;
    // Two points that are farther apart than any speed between them explains: a jump.
    const double speed =
        std::max({begin.derivative.norm(), middle->derivative.norm(), end.derivative.norm()});
    const double apart = (end.position - begin.position).norm();
    if (apart > 4 * speed * std::fabs(width) + options_.tolerance) return false;
    if (!(distance(candidate, middle->position) <= options_.tolerance)) return false;
    if (!(distance(candidate, end.position) <= options_.tolerance)) return false;
    const auto [cubic, error] = measured_cubic(begin, *middle, end, width);
    if (error <= kMeasured * options_.tolerance &&
        is_within(candidate, cubic, options_.tolerance - 2 * error - kSame, 0))
        return true;
    if (error <= kWellMeasured * options_.tolerance || depth >= kDeepest) return false;
    return stays_within(candidate, from, begin, inside, *middle, depth + 1) &&
           stays_within(candidate, inside, *middle, to, end, depth + 1);
}

bool CurveFit::stays_within(const Candidate& candidate) {
    if (candidate.pieces == 0) return false;
    const double share = (candidate.to - at_) / (options_.to - options_.from);
    const int intervals =
        std::max(kLeastIntervals, static_cast<int>(std::ceil(share * kIntervals)));
    const double width = (candidate.to - at_) / intervals;
    CurveSample begin = here_;
    for (int i = 0; i < intervals; ++i) {
        const double from = at_ + i * width;
        const bool is_last = i + 1 == intervals;
        const std::optional<CurveSample> end =
            is_last ? std::optional(candidate.end) : sample(from + width);
        if (!end) return false;
        if (!stays_within(candidate, from, begin, is_last ? candidate.to : from + width, *end, 0))
            return false;
        begin = *end;
    }
    return true;
}

/// The longest piece from here that is within the tolerance: doubled while it is good, then closed
/// in.
std::optional<CurveFit::Candidate> CurveFit::longest() {
    const double rest = options_.to - at_;
    const double most = (options_.to - options_.from) * kLargestShare;
    const double least = (options_.to - options_.from) * kLeastShare;
    const auto limited = [&](double step) {
        if (std::fabs(step) > std::fabs(most)) step = most;
        return std::fabs(step) >= std::fabs(rest) * (1 - 1e-9) ? rest : step;
    };
    const auto try_step = [&](double step) -> std::optional<Candidate> {
        const double to = step == rest ? options_.to : at_ + step;
        std::optional<Candidate> candidate = make(to);
        if (!candidate || !stays_within(*candidate)) return std::nullopt;
        return candidate;
    };
    double step = limited(step_);
    double bad = 0;
    std::optional<Candidate> good = try_step(step);
    while (!good) {
        if (fault_) return std::nullopt;
        bad = step;
        if (std::fabs(step) <= std::fabs(least)) break;
        step /= 2;
        good = try_step(step);
    }
    if (!good) {
        // As good as a point: a corner of the curve, or a jump.
        const std::optional<CurveSample> end = sample(at_ + step);
        if (!end) return std::nullopt;
        if (!((end->position - here_.position).norm() <= options_.tolerance)) {
            fault_ = FitFault::Jump;
            return std::nullopt;
        }
        Candidate point;
        point.end = *end;
        point.to = at_ + step;
        point.pieces = 1;
        point.elements[0] = line_element(flat(here_.position), flat(end->position));
        return point;
    }
    while (bad == 0 && good->to != options_.to && std::fabs(step) < std::fabs(most)) {
        const double further = limited(2 * step);
        std::optional<Candidate> longer = try_step(further);
        if (fault_) return std::nullopt;
        if (!longer) {
            bad = further;
            break;
        }
        step = further;
        good = longer;
    }
    for (int i = 0; i < 5 && bad != 0; ++i) {
        const double middle = (step + bad) / 2;
        std::optional<Candidate> longer = try_step(middle);
        if (fault_) return std::nullopt;
        if (longer) {
            step = middle;
            good = longer;
        } else {
            bad = middle;
        }
    }
    step_ = step;
    return good;
}

bool CurveFit::Made::take(const Made& next) {
    if ((piece.sweep == 0) != (next.piece.sweep == 0)) return false;
    double off = 0;
    if (piece.sweep == 0) {
        off = distance_to_line(piece.to, from, next.piece.to);
        if ((piece.to - from).dot(next.piece.to - piece.to) <= 0) return false;
    } else {
        off = (piece.center - next.piece.center).norm();
        // Beyond half a turn a radius by itself no longer tells which arc is meant.
        const double sweep = piece.sweep + next.piece.sweep;
        if (piece.sweep * next.piece.sweep < 0 || std::fabs(sweep) > std::numbers::pi + kSame)
            return false;
    }
    if (!(error + off <= kSame)) return false;
    error += off;
    piece.to = next.piece.to;
    piece.sweep += next.piece.sweep;
    return true;
}

/// Makes the pieces of one candidate. False: there are no more.
bool CurveFit::make_pieces() {
    if (fault_ || !start() || at_ == options_.to) return false;
    const std::optional<Candidate> candidate = longest();
    if (!candidate) return false;
    const Vec3& end = candidate->end.position;
    Vec3 from = here_.position;
    for (int i = 0; i < candidate->pieces; ++i) {
        Made made;
        made.from = from;
        const bool is_last = i + 1 == candidate->pieces;
        made.piece.to = is_last ? end : Vec3((from + end) / 2);
        if (candidate->pieces == 2) {
            const Element& element = candidate->elements[i];
            made.piece.center = element.center;
            made.piece.sweep = element.sweep;
            if (!is_last) made.piece.to.head<2>() = element.to;
        }
        if (made.piece.to == from) continue;  // the curve stands
        from = made.piece.to;
        if (ready_.empty() || !ready_.back().take(made)) ready_.push_back(made);
    }
    at_ = candidate->to;
    here_ = candidate->end;
    return true;
}

std::optional<FitPiece> CurveFit::next() {
    // The last one may go on in the next: a whole line, half a circle are one piece.
    while (ready_.size() < 2 && make_pieces()) {
    }
    if (fault_ || ready_.empty()) return std::nullopt;
    const FitPiece piece = ready_.front().piece;
    ready_.pop_front();
    return piece;
}

}  // namespace kadr::path
