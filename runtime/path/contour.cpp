#include "path/contour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kadr::path {

namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

/// How far beyond its ends an element still meets another one, mm: elements that touch at their
/// ends must be found, whatever the last bits are.
constexpr double kReach = 1e-7;

Vec2 left_of(const Vec2& v) { return {-v.y(), v.x()}; }

Vec2 turned(const Vec2& v, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

/// Angle from `from` to `to` in the sense of `sign`, in [0, 2π).
double angle_between(const Vec2& from, const Vec2& to, double sign) {
    double angle = sign * std::atan2(cross(from, to), from.dot(to));
    if (angle < 0) angle += kTwoPi;
    return angle >= kTwoPi ? 0 : angle;
}

/// Where a direction from the centre lies on the arc: a share, 0 … 1 on it. What lies outside comes
/// as the nearer end's side: below 0 or above 1.
double share_on_arc(const Element& arc, const Vec2& direction) {
    const double sign = arc.sweep > 0 ? 1 : -1;
    const double whole = std::fabs(arc.sweep);
    double angle = angle_between(arc.from - arc.center, direction, sign);
    // Beyond the end, nearer to the start: a little before it.
    if (angle > whole && angle - whole > kTwoPi - angle) angle -= kTwoPi;
    return angle / whole;
}

/// The share of a point that is known to be on the element's line or circle, or nothing if it is
/// farther than kReach from its ends.
std::optional<double> share_of(const Element& element, const Vec2& point) {
    const double size = length(element);
    const double reach = kReach / size;
    double share = 0;
    if (element.is_arc()) {
        share = share_on_arc(element, point - element.center);
    } else {
        const Vec2 delta = element.to - element.from;
        share = (point - element.from).dot(delta) / delta.squaredNorm();
    }
    if (share < -reach || share > 1 + reach) return std::nullopt;
    return std::clamp(share, 0.0, 1.0);
}

void add(std::vector<Crossing>& found, const Element& a, const Element& b, const Vec2& point) {
    const std::optional<double> share_a = share_of(a, point);
    const std::optional<double> share_b = share_of(b, point);
    if (!share_a || !share_b) return;
    for (const Crossing& other : found) {
        const bool is_same = std::fabs(other.share_a - *share_a) * length(a) < kReach &&
                             std::fabs(other.share_b - *share_b) * length(b) < kReach;
        if (is_same) return;
    }
    found.push_back({point, *share_a, *share_b});
}

/// Both run over the same line or circle: the common piece ends where one of them ends.
void add_overlap(std::vector<Crossing>& found, const Element& a, const Element& b) {
    add(found, a, b, b.from);
    add(found, a, b, b.to);
    add(found, a, b, a.from);
    add(found, a, b, a.to);
}

void cross_lines(std::vector<Crossing>& found, const Element& a, const Element& b) {
    const Vec2 u = a.to - a.from;
    const Vec2 v = b.to - b.from;
    const double w = cross(u, v);
    const Vec2 between = b.from - a.from;
    // Parallel as far as their lengths can tell.
    if (std::fabs(w) <= kReach * std::max(u.norm(), v.norm())) {
        const double apart = std::fabs(cross(between, u)) / u.norm();
        if (apart <= kReach) add_overlap(found, a, b);
        return;
    }
    add(found, a, b, a.from + u * (cross(between, v) / w));
}

void cross_line_arc(std::vector<Crossing>& found, const Element& line, const Element& arc,
                    bool is_line_first) {
    const Vec2 direction = (line.to - line.from).normalized();
    const Vec2 to_center = arc.center - line.from;
    const Vec2 foot = line.from + direction * to_center.dot(direction);
    const double r = radius(arc);
    const double apart = std::fabs(cross(direction, to_center));
    if (apart > r + kReach) return;
    const auto put = [&](const Vec2& point) {
        if (is_line_first) add(found, line, arc, point);
        else add(found, arc, line, point);
    };
    const double half = std::sqrt(std::max(0.0, (r - apart) * (r + apart)));
    // A line that touches: one point, not two that only rounding tells apart.
    if (half * half <= 2 * r * 1e-12) {
        put(foot);
        return;
    }
    put(foot - direction * half);
    put(foot + direction * half);
}

void cross_arcs(std::vector<Crossing>& found, const Element& a, const Element& b) {
    const double ra = radius(a);
    const double rb = radius(b);
    const Vec2 delta = b.center - a.center;
    const double apart = delta.norm();
    if (apart <= kReach && std::fabs(ra - rb) <= kReach) {
        add_overlap(found, a, b);
        return;
    }
    if (apart > ra + rb + kReach || apart < std::fabs(ra - rb) - kReach) return;
    if (apart < 1e-12) return;
    const Vec2 direction = delta / apart;
    const double along = (apart * apart + (ra - rb) * (ra + rb)) / (2 * apart);
    const double square = (ra - along) * (ra + along);
    if (square <= 2 * ra * 1e-12) {
        const double side = along < 0 ? -1 : 1;
        add(found, a, b, a.center + direction * (side * std::min(std::fabs(along), ra)));
        return;
    }
    const Vec2 half = left_of(direction) * std::sqrt(square);
    add(found, a, b, a.center + direction * along + half);
    add(found, a, b, a.center + direction * along - half);
}

bool is_apart(const Rectangle& a, const Rectangle& b, double by) {
    return a.lower.x() > b.upper.x() + by || b.lower.x() > a.upper.x() + by ||
           a.lower.y() > b.upper.y() + by || b.lower.y() > a.upper.y() + by;
}

/// How far an element runs around a point, rad.
double angle_around(const Element& element, const Vec2& point) {
    const Vec2 a = element.from - point;
    const Vec2 b = element.to - point;
    // One number tells on which side of the chord the point lies, here and below; a point on the
    // chord is left of it.
    const double side = cross(a, b) + 0.0;
    const double chord = std::atan2(side, a.dot(b));
    if (!element.is_arc()) return chord;
    // The chord passes the point on the other side than the arc does if the point lies between
    // them.
    const bool is_left = element.sweep > 0;
    const bool is_between =
        (point - element.center).norm() < radius(element) && (is_left ? side < 0 : side >= 0);
    if (!is_between) return chord;
    return chord + (is_left ? kTwoPi : -kTwoPi);
}

}  // namespace

Element line_element(const Vec2& from, const Vec2& to) { return {from, to, Vec2::Zero(), 0}; }

Element arc_element(const Vec2& from, const Vec2& to, const Vec2& center, bool is_clockwise) {
    const double sign = is_clockwise ? -1 : 1;
    double sweep = angle_between(from - center, to - center, sign);
    const double size = (from - center).norm();
    if (sweep * size < 1e-9 || (kTwoPi - sweep) * size < 1e-9) sweep = kTwoPi;
    return {from, to, center, sign * sweep};
}

double radius(const Element& element) { return (element.from - element.center).norm(); }

double length(const Element& element) {
    if (!element.is_arc()) return (element.to - element.from).norm();
    return radius(element) * std::fabs(element.sweep);
}

Vec2 start_direction(const Element& element) {
    if (!element.is_arc()) return (element.to - element.from).normalized();
    const Vec2 left = left_of(element.from - element.center).normalized();
    return element.sweep > 0 ? left : Vec2(-left);
}

Vec2 end_direction(const Element& element) {
    if (!element.is_arc()) return (element.to - element.from).normalized();
    const Vec2 left = left_of(element.to - element.center).normalized();
    return element.sweep > 0 ? left : Vec2(-left);
}

Vec2 point_at(const Element& element, double share) {
    if (share <= 0) return element.from;
    if (share >= 1) return element.to;
    if (!element.is_arc()) return element.from + (element.to - element.from) * share;
    return element.center + turned(element.from - element.center, element.sweep * share);
}

Element part(const Element& element, double from, double to) {
    Element piece = element;
    piece.from = point_at(element, from);
    piece.to = point_at(element, to);
    piece.sweep = element.sweep * (to - from);
    return piece;
}

Element reversed(const Element& element) {
    return {element.to, element.from, element.center, -element.sweep};
}

Rectangle bounds(const Element& element) {
    Rectangle box{element.from.cwiseMin(element.to), element.from.cwiseMax(element.to)};
    if (!element.is_arc()) return box;
    const double r = radius(element);
    for (const Vec2& delta : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) {
        const double share = share_on_arc(element, delta);
        if (share < 0 || share > 1) continue;
        const Vec2 point = element.center + delta * r;
        box.lower = box.lower.cwiseMin(point);
        box.upper = box.upper.cwiseMax(point);
    }
    return box;
}

Nearest nearest(const Element& element, const Vec2& point) {
    Nearest result;
    if (element.is_arc()) {
        const Vec2 delta = point - element.center;
        const double apart = delta.norm();
        const double r = radius(element);
        if (apart < 1e-12) {  // every point of the arc is as near
            return {element.from, r, 0, 0};
        }
        const double share = share_on_arc(element, delta);
        if (share >= 0 && share <= 1) {
            return {element.center + delta * (r / apart), std::fabs(apart - r), 0, share};
        }
    } else {
        const Vec2 delta = element.to - element.from;
        const double square = delta.squaredNorm();
        const double share = square > 0 ? (point - element.from).dot(delta) / square : 0;
        if (share > 0 && share < 1) {
            result.point = element.from + delta * share;
            result.share = share;
            result.distance = (point - result.point).norm();
            return result;
        }
    }
    const double to_start = (point - element.from).norm();
    const double to_end = (point - element.to).norm();
    if (to_start <= to_end) return {element.from, to_start, 0, 0};
    return {element.to, to_end, 0, 1};
}

std::vector<Crossing> crossings(const Element& a, const Element& b) {
    std::vector<Crossing> found;
    if (length(a) == 0 || length(b) == 0) return found;
    if (is_apart(bounds(a), bounds(b), kReach)) return found;
    if (!a.is_arc() && !b.is_arc()) cross_lines(found, a, b);
    else if (!a.is_arc()) cross_line_arc(found, a, b, true);
    else if (!b.is_arc()) cross_line_arc(found, b, a, false);
    else cross_arcs(found, a, b);
    return found;
}

// ---------------------------------------------------------------- contours

double length(const Contour& contour) {
    double sum = 0;
    for (const Element& element : contour) sum += length(element);
    return sum;
}

bool is_closed(const Contour& contour) {
    return !contour.empty() && (contour.back().to - contour.front().from).norm() <= kSamePoint;
}

double signed_area(const Contour& contour) {
    if (contour.empty()) return 0;
    // Coordinates from the first point: the area does not depend on where the part lies.
    const Vec2 origin = contour.front().from;
    double sum = 0;
    for (const Element& element : contour) {
        sum += cross(element.from - origin, element.to - origin) / 2;
        if (!element.is_arc()) continue;
        const double r = radius(element);
        sum += r * r * (element.sweep - std::sin(element.sweep)) / 2;
    }
    return sum;
}

Rectangle bounds(const Contour& contour) {
    if (contour.empty()) return {};
    Rectangle box = bounds(contour.front());
    for (const Element& element : contour) {
        const Rectangle own = bounds(element);
        box.lower = box.lower.cwiseMin(own.lower);
        box.upper = box.upper.cwiseMax(own.upper);
    }
    return box;
}

int turns_around(const Contour& contour, const Vec2& point) {
    double sum = 0;
    for (const Element& element : contour) {
        if (!element.is_arc()) {
            sum += angle_around(element, point);
            continue;
        }
        // Quarters: between an arc of less than half a turn and its chord nothing is ambiguous.
        const int pieces = 1 + static_cast<int>(std::fabs(element.sweep) / (kTwoPi / 4));
        for (int i = 0; i < pieces; ++i) {
            sum += angle_around(
                part(element, double(i) / pieces, i + 1 == pieces ? 1.0 : double(i + 1) / pieces),
                point);
        }
    }
    return static_cast<int>(std::lround(sum / kTwoPi));
}

bool is_inside(const Contour& contour, const Vec2& point) {
    if (!is_closed(contour)) return false;
    return nearest(contour, point).distance <= 1e-9 || turns_around(contour, point) != 0;
}

Nearest nearest(const Contour& contour, const Vec2& point) {
    Nearest best;
    best.distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < contour.size(); ++i) {
        Nearest found = nearest(contour[i], point);
        if (found.distance >= best.distance) continue;
        found.element = i;
        best = found;
    }
    return best;
}

std::vector<Vec2> intersections(const Contour& a, const Contour& b) {
    std::vector<Vec2> points;
    for (const Element& element : a) {
        std::vector<Crossing> found;
        for (const Element& other : b) {
            const std::vector<Crossing> here = crossings(element, other);
            found.insert(found.end(), here.begin(), here.end());
        }
        std::sort(found.begin(), found.end(),
                  [](const Crossing& x, const Crossing& y) { return x.share_a < y.share_a; });
        for (const Crossing& crossing : found) {
            const bool is_known = std::any_of(points.begin(), points.end(), [&](const Vec2& p) {
                return (p - crossing.point).norm() <= kSamePoint;
            });
            if (!is_known) points.push_back(crossing.point);
        }
    }
    return points;
}

std::vector<Vec2> crossings(const Contour& contour, Eigen::Index coordinate, double value) {
    // A line that is longer than the contour is as good as an endless one.
    const Rectangle box = bounds(contour);
    Vec2 from = box.lower - Vec2(1, 1);
    Vec2 to = box.upper + Vec2(1, 1);
    from[coordinate] = to[coordinate] = value;
    std::vector<Vec2> points = intersections(contour, {line_element(from, to)});
    for (Vec2& point : points) point[coordinate] = value;
    return points;
}

Contour reversed(const Contour& contour) {
    Contour result;
    result.reserve(contour.size());
    for (std::size_t i = contour.size(); i-- > 0;) result.push_back(reversed(contour[i]));
    return result;
}

Contour shifted(const Contour& contour, const Vec2& by) {
    Contour result = contour;
    for (Element& element : result) {
        element.from += by;
        element.to += by;
        if (element.is_arc()) element.center += by;
    }
    return result;
}

Contour rotated(const Contour& contour, double angle) {
    Contour result = contour;
    for (Element& element : result) {
        element.from = turned(element.from, angle);
        element.to = turned(element.to, angle);
        if (element.is_arc()) element.center = turned(element.center, angle);
    }
    return result;
}

Contour mirrored(const Contour& contour, bool first, bool second) {
    Contour result = contour;
    const Vec2 signs(first ? -1 : 1, second ? -1 : 1);
    for (Element& element : result) {
        element.from = element.from.cwiseProduct(signs);
        element.to = element.to.cwiseProduct(signs);
        if (element.is_arc()) element.center = element.center.cwiseProduct(signs);
        if (first != second) element.sweep = -element.sweep;
    }
    return result;
}

}  // namespace kadr::path
