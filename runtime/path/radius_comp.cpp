#include "path/radius_comp.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

namespace kadr::path {

namespace {

using std::numbers::pi;

/// Two directions that differ by less make no corner: the gap is far below an increment.
constexpr double kSmooth = 1e-6;           // rad
constexpr double kHardly = 1e-3;           // rad: … where the sides end at one point, either
constexpr double kNear = 10 * kSamePoint;  // mm: the joint of two sides, found as a crossing
constexpr double kReversal = 1e-9;         // rad short of turning back
constexpr double kCut = 5e-4;              // mm: half an increment is not a cut into the contour
constexpr std::size_t kOpenSides = 3;      // that an end is looked for on; S 5.2 does not give it
constexpr int kChords = 64;                // of a conic where it is looked at for collisions

Vec2 left_of(const Vec2& direction) { return {-direction.y(), direction.x()}; }

/// From one direction to the other, −π … π, counter-clockwise positive.
double angle_between(const Vec2& a, const Vec2& b) { return std::atan2(cross(a, b), a.dot(b)); }

/// 1/mm, positive where it bends to the left.
double curvature(const Element& path) {
    return path.is_arc() ? (path.sweep > 0 ? 1 : -1) / radius(path) : 0;
}

/// From the end of one element to the start of the next one, −π … π, counter-clockwise positive.
///
/// At half a turn the tangents do not tell its sense: it is that in which the second element lies
/// beside the first one just before the corner. At a distance s back along the first, which is
/// κ₁·s²/2 left of its tangent, the second one is left of it by δ·s − (κ₁ + κ₂)·s²/2, δ the angle
/// by which the tangents miss half a turn. Elements that lie on each other there are gone around.
///
/// distance  of the cutter, mm, positive to the left
double turn_between(const Element& before, const Element& after, double distance) {
    constexpr double kJustBeside = 1e-2;  // mm: s, below every cutter that reaches into a corner
    constexpr double kNoBend = 1e-12;     // mm: how far apart elements on each other seem to be
    const double turn = angle_between(end_direction(before), start_direction(after));
    const double missed = turn > 0 ? pi - turn : -pi - turn;
    if (std::abs(missed) > kSmooth) return turn;
    const double bend = (curvature(before) + curvature(after)) * kJustBeside * kJustBeside / 2;
    if (std::abs(bend) > kNoBend) return missed * kJustBeside > bend ? pi : -pi;
    if (std::abs(missed) > kReversal) return turn;
    return distance > 0 ? -pi : pi;
}

/// A circle or a straight line without ends.
struct Curve {
    Vec2 point;      // on the line
    Vec2 direction;  // unit vector
    Vec2 center;
    double radius = 0;
    bool is_circle = false;
};

/// On which the element lies at its start, or at its end: an arc of a program may end some
/// micrometres beside the circle on which it begins, and a neighbour that is tangent to it there
/// meets only the circle through its end.
Curve curve_at(const Element& path, const Vec2& end) {
    if (path.is_arc()) return {{}, {}, path.center, (end - path.center).norm(), true};
    return {path.from, (path.to - path.from).normalized(), {}, 0, false};
}
Curve curve_at_start(const Element& path) { return curve_at(path, path.from); }
Curve curve_at_end(const Element& path) { return curve_at(path, path.to); }

std::vector<Vec2> crossings_of_lines(const Curve& a, const Curve& b) {
    const double sine = cross(a.direction, b.direction);
    if (std::abs(sine) < kReversal) return {};
    return {a.point + a.direction * (cross(b.point - a.point, b.direction) / sine)};
}

std::vector<Vec2> crossings_with_circle(const Curve& line, const Curve& circle) {
    const Vec2 foot = line.point + line.direction * line.direction.dot(circle.center - line.point);
    const double rest = circle.radius * circle.radius - (foot - circle.center).squaredNorm();
    if (rest < -kSamePoint * (circle.radius + kSamePoint)) return {};
    const Vec2 half = line.direction * std::sqrt(std::max(rest, 0.0));
    return {foot - half, foot + half};
}

std::vector<Vec2> crossings_of_circles(const Curve& a, const Curve& b) {
    const Vec2 between = b.center - a.center;
    const double apart = between.norm();
    if (apart < kSamePoint) return {};
    const double along = (apart + (a.radius - b.radius) * (a.radius + b.radius) / apart) / 2;
    const double rest = a.radius * a.radius - along * along;
    if (rest < -kSamePoint * (a.radius + kSamePoint)) return {};
    const Vec2 foot = a.center + between * (along / apart);
    const Vec2 half = left_of(between / apart) * std::sqrt(std::max(rest, 0.0));
    return {foot - half, foot + half};
}

std::vector<Vec2> crossings_of(const Curve& a, const Curve& b) {
    if (a.is_circle && b.is_circle) return crossings_of_circles(a, b);
    if (a.is_circle) return crossings_with_circle(b, a);
    if (b.is_circle) return crossings_with_circle(a, b);
    return crossings_of_lines(a, b);
}

/// How far a point on the element's curve is ahead of a point on it, mm along a line, rad along an
/// arc.
double ahead(const Element& path, const Vec2& at, const Vec2& point) {
    if (!path.is_arc()) return (path.to - path.from).normalized().dot(point - at);
    const double angle = angle_between(at - path.center, point - path.center);
    return path.sweep > 0 ? angle : -angle;
}

/// Length of the element in the unit of `ahead`.
double extent(const Element& path) {
    return path.is_arc() ? std::abs(path.sweep) : (path.to - path.from).norm();
}

/// The element with its ends moved inwards.
Element trimmed(const Element& path, double from, double to) {
    if (!path.is_arc()) {
        const Vec2 direction = (path.to - path.from).normalized();
        return line_element(path.from + direction * from, path.to - direction * to);
    }
    const double sign = path.sweep > 0 ? 1 : -1;
    const auto turned = [&](const Vec2& point, double angle) -> Vec2 {
        return path.center + Eigen::Rotation2Dd(angle) * (point - path.center);
    };
    Element arc = path;
    arc.from = turned(path.from, sign * from);
    arc.to = turned(path.to, -sign * to);
    arc.sweep = sign * (extent(path) - from - to);
    return arc;
}

/// The points of `path` of which one is nearest to the curve of `other`: its ends, the foot of the
/// other's centre and the point opposite to that.
std::vector<Vec2> near_points(const Element& path, const Element& other) {
    std::vector<Vec2> points = {path.from, path.to};
    if (!other.is_arc()) {
        if (!path.is_arc()) return points;
        // Where the arc runs along the line.
        const Vec2 across = left_of((other.to - other.from).normalized()) * radius(path);
        for (const double sign : {1.0, -1.0})
            points.push_back(nearest(path, path.center + sign * across).point);
        return points;
    }
    points.push_back(nearest(path, other.center).point);
    if (path.is_arc()) points.push_back(nearest(path, 2 * path.center - other.center).point);
    return points;
}

/// The least distance of two elements that do not cross.
double distance_between(const Element& a, const Element& b) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& point : near_points(a, b)) least = std::min(least, nearest(b, point).distance);
    for (const Vec2& point : near_points(b, a)) least = std::min(least, nearest(a, point).distance);
    return least;
}

/// How far an arc ends beside the circle on which it begins, mm: so much may be wrong about where
/// it lies between its ends.
double spread(const Element& path) {
    return path.is_arc() ? std::abs((path.to - path.center).norm() - radius(path)) : 0;
}

/// Where an element lies that has left another one.
enum class RelativeSide : std::uint8_t {
    Nowhere,
    Along,  // it goes the path of what is behind the other
    Left,
    Right,
};

/// On which side of the other the path goes on (direction 1) or comes from (-1), seen from a point
/// on one of its pieces at which both meet: nowhere, if it ends before more than rounding is
/// between them.
///
/// next  behind the other; nullptr: nobody knows yet
RelativeSide side_beyond(const std::vector<Element>& elements, std::size_t piece, double share,
                         int direction, const Element& other, const Element* next) {
    constexpr double kGrowth = 1.5;
    bool goes_along = false;
    for (double step = kCut;;) {
        const double whole = length(elements[piece]);
        const double at = whole > 0 ? share + direction * step / whole : direction;
        const Vec2 point = point_at(elements[piece], std::clamp(at, 0.0, 1.0));
        const Nearest foot = nearest(other, point);
        // Beyond an end of the other its tangent goes on, …
        const bool is_behind = foot.share >= 1;
        const Vec2 along =
            is_behind ? end_direction(other) : start_direction(part(other, foot.share, 1));
        const double aside = cross(along, point - foot.point);
        const double touching = kCut + spread(elements[piece]) + spread(other);
        // … and whoever goes the path of what is behind it, as the next turn of a circle, is beside
        // neither.
        if (std::abs(aside) > touching) {
            const bool is_along =
                next != nullptr && nearest(*next, point).distance <= touching + spread(*next);
            if (!is_along) return aside > 0 ? RelativeSide::Left : RelativeSide::Right;
            goes_along = true;
        }
        if (at > 0 && at < 1) {
            step *= kGrowth;
            continue;
        }
        if (piece == (direction > 0 ? elements.size() - 1 : 0))
            return goes_along ? RelativeSide::Along : RelativeSide::Nowhere;
        piece = direction > 0 ? piece + 1 : piece - 1;
        share = direction > 0 ? 0 : 1;
        step = kCut;
    }
}

/// How far along an element a point on its curve is, from its start; of an arc 0 … 2π.
double along(const Element& path, const Vec2& point) {
    const double distance = ahead(path, path.from, point);
    return path.is_arc() && distance < -kSmooth ? distance + 2 * pi : distance;
}

}  // namespace

Vec2 conic_at(const CompPiece& piece, double u) {
    const double from = (1 - u) * (1 - u);
    const double apex = 2 * u * (1 - u) * piece.weight;
    const double to = u * u;
    return (piece.element.from * from + piece.apex * apex + piece.element.to * to) /
           (from + apex + to);
}

Vec2 RadiusComp::start_of(const Element& element, double distance) {
    return element.from + left_of(start_direction(element)) * distance;
}

std::optional<CompFault> RadiusComp::push(const Element& element, double distance,
                                          std::size_t index) {
    OffsetElement side{element, element, distance, Vec2::Zero(), 0, 0, index, {}};
    fault_at_ = index;
    const bool continues = !sides_.empty() && !element.is_arc();
    const double at_start = continues ? sides_.back().distance : distance;
    side.path.from += left_of(start_direction(element)) * at_start;
    side.path.to += left_of(end_direction(element)) * at_start;
    if (element.is_arc()) {
        const double radius = path::radius(element) - (element.sweep > 0 ? distance : -distance);
        if (radius < -kSamePoint) return CompFault::ArcTooSmall;
        // The cutter turns on the spot.
        if (radius < kSamePoint) side.path.from = side.path.to = element.center;
    }
    if (!sides_.empty()) {
        if (const auto fault = join(sides_.back(), side)) {
            const bool may_be_end = rules_.open_end != OpenEnd::None;
            if (*fault != CompFault::NoIntersection || !may_be_end) return fault;
            side.is_apart = true;
        }
    }
    if (at_start != distance) {
        side.aside = left_of(start_direction(element)) * (at_start - distance);
        side.path.from -= side.aside;
        side.path.to -= side.aside;
    }
    sides_.push_back(std::move(side));
    if (starts_open_) {
        if (const auto fault = settle_start()) return fault;
        if (starts_open_) return std::nullopt;  // what follows tells
    }
    return settle();
}

bool RadiusComp::fits(const OffsetElement& side) {
    return side.from + side.to <= extent(side.path) + kSamePoint;
}

std::optional<CompFault> RadiusComp::finish_open() {
    if (rules_.open_end != OpenEnd::None && sides_.size() > 1) {
        const OffsetElement& last = sides_.back();
        if (!last.is_apart && fits(last) && fits(sides_[sides_.size() - 2])) return finish();
        fault_at_ = last.index;
        if (!leave_earlier()) return CompFault::Reversed;
    }
    return finish();
}

/// The last element ends beside the contour before it meets the one in front of it: the cutter
/// leaves that one, or an earlier one, where it comes to the last one's lengthening.
bool RadiusComp::leave_earlier() {
    const OffsetElement& last = sides_.back();
    const Vec2 end = last.path.to + last.aside;
    const Vec2 direction = end_direction(last.contour);
    const bool is_arc = rules_.open_end == OpenEnd::Arc;
    const Curve longer = is_arc ? Curve{{}, {}, last.contour.to, std::abs(last.distance), true}
                                : Curve{end, direction, {}, 0, false};
    std::optional<std::size_t> leaves;
    double to = 0;
    for (std::size_t i = sides_.size() - 1; i-- > 0;) {
        const OffsetElement& side = sides_[i];
        const double whole = extent(side.path);
        double first = whole + kSamePoint;
        for (const Vec2& point : crossings_of(curve_at_end(side.path), longer)) {
            const double distance = along(side.path, point);
            const bool is_ahead = is_arc || direction.dot(point - end) > -kSamePoint;
            if (is_ahead && distance >= side.from - kSamePoint && distance < first)
                first = distance;
        }
        if (first > whole) continue;
        leaves = i;
        to = whole - first;
        if (!rules_.leaves_out) break;
    }
    if (!leaves) return false;
    sides_.resize(*leaves + 1);
    sides_.back().to = to;
    return true;
}

/// The same at the start: the cutter comes to the newest element where it leaves the first one's
/// lengthening.
bool RadiusComp::begin_later(const OffsetElement& first) {
    OffsetElement& side = sides_.back();
    const Vec2 direction = start_direction(first.contour);
    const bool is_arc = rules_.open_end == OpenEnd::Arc;
    const Curve longer = is_arc ? Curve{{}, {}, first.contour.from, std::abs(first.distance), true}
                                : Curve{first.path.from, direction, {}, 0, false};
    const double whole = extent(side.path);
    double latest = -1;
    for (const Vec2& point : crossings_of(curve_at_start(side.path), longer)) {
        const double distance = along(side.path, point);
        const bool is_behind = is_arc || direction.dot(point - first.path.from) < kSamePoint;
        if (is_behind && distance >= -kSamePoint && distance <= whole + kSamePoint)
            latest = std::max(latest, distance);
    }
    if (latest < 0) return false;
    side.from = std::clamp(latest, 0.0, whole);
    side.before.clear();
    side.is_apart = false;
    return true;
}

/// Behind the newest element: whether the first one stays, or is left out. Of two elements that do
/// not meet the second one may be the last, and be left out itself.
std::optional<CompFault> RadiusComp::settle_start() {
    if (!left_out_) {
        if (sides_.size() < 2) return std::nullopt;
        if (sides_.size() == 2) {
            const bool stays = !sides_[1].is_apart && fits(sides_[0]);
            if (!stays && !begin_later(OffsetElement(sides_[0]))) return std::nullopt;
            if (!stays) sides_.pop_front();
            starts_open_ = false;
            return std::nullopt;
        }
        left_out_ = std::move(sides_.front());
        sides_.pop_front();
        sides_.pop_front();
        count_left_out_ = 1;
    }
    if (begin_later(*left_out_)) {
        left_out_.reset();
        starts_open_ = false;
        return std::nullopt;
    }
    fault_at_ = left_out_->index;
    if (++count_left_out_ >= kOpenSides) return CompFault::Reversed;
    sides_.pop_back();
    return std::nullopt;
}

std::optional<CompFault> RadiusComp::finish() {
    rounds_next_ = false;
    const bool has_open_start = std::exchange(starts_open_, false) && sides_.size() > 1;
    if (left_out_.has_value()) return CompFault::Reversed;
    if (has_open_start && !fits(sides_.front())) return CompFault::Reversed;
    if (!sides_.empty()) {
        const OffsetElement& last = sides_.back();
        fault_at_ = last.index;
        if (last.is_apart) return CompFault::NoIntersection;
        if (!fits(last)) return CompFault::Reversed;
        if (rules_.look_ahead > 1 && runs_into_earlier(sides_.size() - 1))
            return CompFault::Bottleneck;
    }
    release(0);
    return std::nullopt;
}

std::optional<CompFault> RadiusComp::finish_towards(const Vec2& direction) {
    if (sides_.empty()) return finish();
    OffsetElement& last = sides_.back();
    const Vec2 corner = last.contour.to;
    const Vec2 beside = corner + left_of(direction) * last.distance;
    const std::vector<Vec2> common = crossings_of(
        curve_at_end(last.path), {beside, direction.normalized(), Vec2::Zero(), 0, false});
    if (!common.empty()) {
        const Vec2 meeting = *std::ranges::min_element(
            common, {}, [&](const Vec2& point) { return (point - corner).squaredNorm(); });
        last.to = ahead(last.path, meeting, last.path.to);
    }
    return finish();
}

std::optional<CompFault> RadiusComp::join(OffsetElement& a, OffsetElement& b) {
    const bool rounds = std::exchange(rounds_next_, false);
    const Vec2 corner = b.contour.from;
    const double turn = turn_between(a.contour, b.contour, a.distance);
    const double gap = (a.path.to - b.path.from).norm();
    if (std::abs(turn) < kSmooth) {
        if (gap > kSamePoint)  // an arc with another distance
            insert(b, line_element(a.path.to, b.path.from));
        return std::nullopt;
    }
    if (gap < kSamePoint && std::abs(turn) < kHardly) return std::nullopt;
    const bool closes = turn * a.distance > 0;
    if (closes && rounds) return CompFault::Bottleneck;
    if (closes) return join_inside(a, b, corner);
    join_outside(a, b, turn, rounds);
    return std::nullopt;
}

void RadiusComp::insert(OffsetElement& side, const Element& element) {
    side.before.push_back({element, side.index, true, 0, Vec2::Zero()});
}

std::optional<CompFault> RadiusComp::join_inside(OffsetElement& a, OffsetElement& b,
                                                 const Vec2& corner) const {
    std::vector<Vec2> common = crossings_of(curve_at_end(a.path), curve_at_start(b.path));
    if (common.empty()) return CompFault::NoIntersection;
    // Where the elements turn back both crossings may be as far from the corner: the sides are
    // shortened, not extended.
    const auto is_nearer = [&](const Vec2& one, const Vec2& other) {
        const double more = (one - corner).norm() - (other - corner).norm();
        if (std::abs(more) > kNear) return more < 0;
        return ahead(a.path, one, a.path.to) > ahead(a.path, other, a.path.to);
    };
    const Vec2 meeting = *std::ranges::min_element(common, is_nearer);
    a.to = ahead(a.path, meeting, a.path.to);
    b.from = ahead(b.path, b.path.from, meeting);
    return std::nullopt;
}

void RadiusComp::join_outside(OffsetElement& a, OffsetElement& b, double turn, bool rounds) const {
    const double sharpness = std::abs(turn);
    const bool has_arc = a.path.is_arc() || b.path.is_arc();
    OutsideCorner style = sharpness <= rules_.limit + kSmooth ? rules_.outside : rules_.sharp;
    if ((has_arc && !rules_.extends_tangents) || rounds) style = OutsideCorner::Arc;
    const double reach = std::abs(a.distance);
    if (reach < kSamePoint) return;
    const bool turns_back = pi - sharpness < kSmooth;
    if (style == OutsideCorner::Arc && rules_.pointed > 0 && !turns_back && !rounds)
        return join_by_conic(a, b, turn);
    if (style == OutsideCorner::Arc || (style == OutsideCorner::Intersection && turns_back)) {
        Element arc{a.path.to, b.path.from, b.contour.from, turn};
        if (turns_back) arc.sweep = a.distance > 0 ? -pi : pi;
        insert(b, arc);
        return;
    }
    const bool meets = style == OutsideCorner::Intersection;
    const double more = meets ? reach * std::tan(sharpness / 2) : reach;
    const Vec2 behind_a = a.path.to + end_direction(a.contour) * more;
    const Vec2 before_b = b.path.from - start_direction(b.contour) * more;
    if (a.path.is_arc()) insert(b, line_element(a.path.to, behind_a));
    else a.to = -more;
    if (!meets) insert(b, line_element(behind_a, before_b));
    if (b.path.is_arc()) insert(b, line_element(before_b, b.path.from));
    else b.from = -more;
}

/// The arc about the corner is a conic whose middle weight is c, the cosine of half the turn. Seen
/// from the corner its middle is at the radius r, the sides meet at r/c, and the chord is at r·c:
/// the weight that puts the middle at m is (m − r·c)/(r/c − m).
void RadiusComp::join_by_conic(OffsetElement& a, OffsetElement& b, double turn) const {
    const double reach = std::abs(a.distance);
    const double cosine = std::cos(turn / 2);
    const Vec2 apex = a.path.to + end_direction(a.contour) * reach * std::tan(std::abs(turn) / 2);
    const double middle = reach + rules_.pointed * (reach / cosine - reach);
    const double rest = reach / cosine - middle;
    if (rest < kSamePoint) {  // the sides meet
        insert(b, line_element(a.path.to, apex));
        insert(b, line_element(apex, b.path.from));
        return;
    }
    const Element ends = line_element(a.path.to, b.path.from);
    b.before.push_back({ends, b.index, true, (middle - reach * cosine) / rest, apex});
}

/// Looks at the element that has got its second end, and lets go of what is far enough behind.
std::optional<CompFault> RadiusComp::settle() {
    if (sides_.size() >= 2) {
        const OffsetElement& done = sides_[sides_.size() - 2];
        fault_at_ = done.index;
        if (done.is_apart) return CompFault::NoIntersection;
        if (!fits(done) && !leaves_out_reversed()) return CompFault::Reversed;
        if (rules_.look_ahead > 1 && runs_into_earlier(sides_.size() - 2))
            return CompFault::Bottleneck;
    }
    const bool has_open_ends = rules_.open_end != OpenEnd::None;
    release(has_open_ends ? std::max(rules_.look_ahead, kOpenSides) : rules_.look_ahead);
    return std::nullopt;
}

/// The neighbours of an element that the cutter cannot enter are joined without it.
bool RadiusComp::leaves_out_reversed() {
    const std::size_t count = sides_.size();
    if (!rules_.leaves_out || rules_.look_ahead < 2 || count < 3) return false;
    OffsetElement& a = sides_[count - 3];
    OffsetElement& c = sides_[count - 1];
    const double a_to = a.to;
    const double c_from = c.from;
    if (a.distance != c.distance || c.aside != Vec2::Zero()) return false;
    if (join_inside(a, c, c.contour.from)) return false;
    const bool fits = a.from + a.to <= extent(a.path) + kSamePoint &&
                      c.from <= extent(c.path) + kSamePoint && a.to >= a_to - kSamePoint &&
                      c.from >= c_from - kSamePoint;
    if (!fits) return false;
    c.before.clear();
    sides_.erase(sides_.end() - 2);
    return true;
}

/// Between the ends that are left to it, from the old distance to the new one.
Element RadiusComp::path_of(const OffsetElement& side) {
    Element path = trimmed(side.path, side.from, side.to);
    path.from += side.aside;
    return path;
}

/// What the cutter does at the corner before a side and along it, in lines and arcs.
std::vector<Element> RadiusComp::elements_of(const OffsetElement& side) {
    std::vector<Element> elements;
    for (const CompPiece& piece : side.before) {
        if (!(piece.weight > 0)) {
            elements.push_back(piece.element);
            continue;
        }
        for (int i = 0; i < kChords; ++i)
            elements.push_back(line_element(conic_at(piece, static_cast<double>(i) / kChords),
                                            conic_at(piece, static_cast<double>(i + 1) / kChords)));
    }
    elements.push_back(path_of(side));
    return elements;
}

/// Whether the cutter on its path along one side comes too near to another's element of the
/// contour.
bool RadiusComp::cuts_into(const OffsetElement& side, const OffsetElement& other) {
    const double apart = std::min(std::abs(side.distance), std::abs(other.distance)) - kCut;
    const std::vector<Element> elements = elements_of(side);
    return std::any_of(elements.begin(), elements.end(), [&](const Element& piece) {
        const double least = apart - spread(piece) - spread(other.contour);
        return !crossings(piece, other.contour).empty() ||
               distance_between(piece, other.contour) < least;
    });
}

/// Whether a side that is done, or what was inserted before it, crosses an earlier one and cuts
/// into the contour there. Sides that touch, or lie on each other, do not.
bool RadiusComp::runs_into_earlier(std::size_t done) const {
    if (std::abs(sides_[done].distance) < kCut) return false;
    const std::vector<Element> latest = elements_of(sides_[done]);
    // Where it comes from the side before it tells.
    std::vector<Element> whole = done > 0 ? elements_of(sides_[done - 1]) : std::vector<Element>();
    const std::size_t in_front = whole.size();
    whole.insert(whole.end(), latest.begin(), latest.end());
    const auto meets_at = [&](const Element& earlier, const Element* next, bool is_neighbour,
                              std::size_t piece, double share) {
        const RelativeSide beyond = side_beyond(latest, piece, share, 1, earlier, next);
        // What follows tells.
        if (beyond == RelativeSide::Nowhere || beyond == RelativeSide::Along) return false;
        const RelativeSide before =
            is_neighbour ? side_beyond(latest, piece, share, -1, earlier, next)
                         : side_beyond(whole, in_front + piece, share, -1, earlier, next);
        return before != RelativeSide::Nowhere && before != RelativeSide::Along && before != beyond;
    };
    const auto crosses = [&](const Element& earlier, const Element* next, bool is_neighbour) {
        for (std::size_t piece = 0; piece < latest.size(); ++piece)
            for (const Crossing& crossing : crossings(earlier, latest[piece]))
                if (meets_at(earlier, next, is_neighbour, piece, crossing.share_b)) return true;
        return false;
    };
    for (std::size_t i = 0; i < done; ++i) {
        std::vector<Element> elements = elements_of(sides_[i]);
        const std::size_t count = elements.size();
        const bool is_neighbour = i + 1 == done;  // what goes on behind it is this side itself
        if (!is_neighbour) elements.push_back(elements_of(sides_[i + 1]).front());
        bool meet = false;
        for (std::size_t piece = 0; piece < count && !meet; ++piece)
            meet =
                crosses(elements[piece],
                        piece + 1 < elements.size() ? &elements[piece + 1] : nullptr, is_neighbour);
        if (meet && (cuts_into(sides_[done], sides_[i]) || cuts_into(sides_[i], sides_[done])))
            return true;
    }
    return false;
}

void RadiusComp::release(std::size_t kept) {
    for (; sides_.size() > kept; sides_.pop_front()) {
        const OffsetElement& side = sides_.front();
        pieces_.insert(pieces_.end(), side.before.begin(), side.before.end());
        Element path = path_of(side);
        // What is left of an arc on the spot, or of nothing, is no arc.
        if (path.is_arc() && std::abs(path.sweep) * path::radius(path) < kSamePoint) path.sweep = 0;
        pieces_.push_back({path, side.index, false, 0, Vec2::Zero()});
    }
}

}  // namespace kadr::path
