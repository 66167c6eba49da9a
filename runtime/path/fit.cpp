#include "path/fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace kadr::path {

namespace {

/// A piece is at most this share of the range, so that a closed curve is never taken for the point
/// where it begins.
constexpr double kLargestShare = 1.0 / 8;
/// A piece below this share of the range is as good as a point; the curve jumps if it is longer
/// than the tolerance.
constexpr double kLeastShare = 1e-10;
/// Measuring: neighbouring samples at first, and how often an interval may be halved.
constexpr int kIntervals = 8;
constexpr int kDeepest = 7;
/// Where inside an interval the measure is checked: not the middle, which a periodic curve may
/// meet in step.
constexpr double kInside = 0.381966;
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

struct Extreme {
    double lower;
    double upper;
};

/// Least and greatest value on 0 … 1 of the cubic with these values and slopes at its ends.
Extreme cubic_extreme(double v0, double s0, double v1, double s1) {
    Extreme e{std::min(v0, v1), std::max(v0, v1)};
    const double b = 3 * (v1 - v0) - 2 * s0 - s1;
    const double a = s0 + s1 - 2 * (v1 - v0);
    const auto value = [&](double u) { return ((a * u + b) * u + s0) * u + v0; };
    const auto look = [&](double u) {
        if (!(u > 0 && u < 1)) return;
        const double v = value(u);
        e.lower = std::min(e.lower, v);
        e.upper = std::max(e.upper, v);
    };
    // 3a·u² + 2b·u + s0 = 0, without cancellation.
    const double root = b * b - 3 * a * s0;
    if (root < 0) return e;
    const double q = -(b + std::copysign(std::sqrt(root), b));
    if (a != 0) look(q / (3 * a));
    if (q != 0) look(s0 / q);
    return e;
}

double cubic_value(double v0, double s0, double v1, double s1, double u) {
    const double b = 3 * (v1 - v0) - 2 * s0 - s1;
    const double a = s0 + s1 - 2 * (v1 - v0);
    return ((a * u + b) * u + s0) * u + v0;
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

CurveFit::CurveFit(ParametricCurve curve, const FitOptions& options)
    : curve_(std::move(curve)),
      options_(options),
      at_(options.from),
      step_((options.to - options.from) * kLargestShare / 4) {}

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
    const Vec3 way = (near->position - at.position) * side;
    return way.norm() > 0 ? std::optional<Vec3>(way.normalized()) : Vec3(Vec3::Zero());
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

/// How far a point of the curve is beside the candidate, and how that changes with the parameter:
/// of a chord in two directions across it, of a biarc to the left. Beyond an end, the distance to
/// it counts.
CurveFit::Deviation CurveFit::deviation(const Candidate& candidate, const CurveSample& at) const {
    if (candidate.pieces == 1) {
        const Vec3 chord = candidate.end.position - here_.position;
        const double size = chord.norm();
        const Vec3 way = at.position - here_.position;
        if (size < 1e-12) return {{way.norm(), 0}, {0, 0}};
        const Vec3 along = chord / size;
        const double beyond = std::max({0.0, -way.dot(along), way.dot(along) - size});
        const Vec3 across = along.unitOrthogonal();
        const Vec3 other = along.cross(across);
        return {{std::hypot(way.dot(across), beyond), way.dot(other)},
                {at.derivative.dot(across), at.derivative.dot(other)}};
    }
    const Vec2 point = flat(at.position);
    const Vec2 slope = flat(at.derivative);
    const Element& first = candidate.elements[0];
    const bool is_second = (point - first.to).dot(end_direction(first)) > 0;
    const Element& element = candidate.elements[is_second ? 1 : 0];
    const Vec2 begin = start_direction(element);
    const Vec2 end = end_direction(element);
    const double before = -(point - element.from).dot(begin);
    const double behind = (point - element.to).dot(end);
    // Less than half a turn: what is before the start, or behind the end, is beyond it.
    const double beyond = std::max({0.0, is_second ? 0.0 : before, is_second ? behind : 0.0});
    double value = 0;
    double change = 0;
    if (!element.is_arc()) {
        const Vec2 left = left_of(begin);
        value = (point - element.from).dot(left);
        change = slope.dot(left);
    } else {
        const Vec2 outwards = point - element.center;
        const double apart = outwards.norm();
        const double sign = element.sweep > 0 ? -1 : 1;  // outside is right of a ccw arc
        value = sign * (apart - radius(element));
        if (apart > 1e-12) change = sign * slope.dot(outwards) / apart;
    }
    if (beyond > 0) value = std::copysign(std::hypot(value, beyond), value);
    return {{value, 0}, {change, 0}};
}

bool CurveFit::is_within(const Candidate& candidate, double from, const CurveSample& begin,
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
    const Deviation d0 = deviation(candidate, begin);
    const Deviation d1 = deviation(candidate, end);
    const Deviation dm = deviation(candidate, *middle);
    double square = 0;
    double miss = 0;
    double seen = 0;
    for (int i = 0; i < 2; ++i) {
        const double s0 = d0.slope[i] * width;
        const double s1 = d1.slope[i] * width;
        const Extreme extreme = cubic_extreme(d0.value[i], s0, d1.value[i], s1);
        const double error =
            std::fabs(cubic_value(d0.value[i], s0, d1.value[i], s1, kInside) - dm.value[i]);
        const double most = std::max(std::fabs(extreme.lower), std::fabs(extreme.upper));
        square += (most + 2 * error) * (most + 2 * error);
        miss = std::max(miss, error);
        seen = std::hypot(seen, std::max({std::fabs(d0.value[i]), std::fabs(d1.value[i]),
                                          std::fabs(dm.value[i])}));
    }
    if (!(seen <= options_.tolerance)) return false;  // also what is not a number
    if (square <= options_.tolerance * options_.tolerance && miss <= options_.tolerance / 4)
        return true;
    if (depth >= kDeepest) return false;
    return is_within(candidate, from, begin, inside, *middle, depth + 1) &&
           is_within(candidate, inside, *middle, to, end, depth + 1);
}

bool CurveFit::is_within(const Candidate& candidate) {
    if (candidate.pieces == 0) return false;
    const double width = (candidate.to - at_) / kIntervals;
    CurveSample begin = here_;
    for (int i = 0; i < kIntervals; ++i) {
        const double from = at_ + i * width;
        const bool is_last = i + 1 == kIntervals;
        const std::optional<CurveSample> end =
            is_last ? std::optional(candidate.end) : sample(from + width);
        if (!end) return false;
        if (!is_within(candidate, from, begin, is_last ? candidate.to : from + width, *end, 0))
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
        if (!candidate || !is_within(*candidate)) return std::nullopt;
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

std::optional<FitPiece> CurveFit::next() {
    while (ready_.empty()) {
        if (fault_ || !start() || at_ == options_.to) return std::nullopt;
        const std::optional<Candidate> candidate = longest();
        if (!candidate) return std::nullopt;
        const Vec3 begin = here_.position;
        const Vec3& end = candidate->end.position;
        for (int i = 0; i < candidate->pieces; ++i) {
            FitPiece piece;
            const bool is_last = i + 1 == candidate->pieces;
            piece.to = is_last ? end : Vec3((begin + end) / 2);
            if (candidate->pieces == 2) {
                const Element& element = candidate->elements[i];
                piece.center = element.center;
                piece.sweep = element.sweep;
                if (!is_last) piece.to.head<2>() = element.to;
            }
            const Vec3 from = ready_.empty() ? begin : ready_.back().to;
            if (piece.to != from) ready_.push_back(piece);  // else the curve stands
        }
        at_ = candidate->to;
        here_ = candidate->end;
    }
    const FitPiece piece = ready_.front();
    ready_.pop_front();
    return piece;
}

}  // namespace kadr::path
