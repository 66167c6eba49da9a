#include "path/contour_corner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace kadr::path {

namespace {

/// How far beyond its ends an element may be touched, mm: rounding.
constexpr double kReach = 1e-7;

/// Halvings of an interval: below any length that counts.
constexpr int kHalvings = 60;

Vec2 left_of(const Vec2& v) { return {-v.y(), v.x()}; }

/// The share of the length between an end of the element and the point at a distance from that end.
/// None if no point lies so far.
std::optional<double> share_at_distance(const Element& element, double distance) {
    if (!element.is_arc()) {
        const double share = distance / length(element);
        return share <= 1 ? std::optional(share) : std::nullopt;
    }
    const double half = distance / (2 * radius(element));
    if (half > 1) return std::nullopt;
    const double share = 2 * std::asin(half) / std::fabs(element.sweep);
    return share <= 1 ? std::optional(share) : std::nullopt;
}

/// The greatest distance of a point from the element's end, as long as it grows along it.
double reach(const Element& element) {
    if (!element.is_arc()) return length(element);
    const double half = std::min(std::fabs(element.sweep), std::numbers::pi) / 2;
    return 2 * radius(element) * std::sin(half);
}

/// The line or circle on which the centre of an arc lies that touches the element from the left
/// (distance > 0) or from the right.
struct CenterLocus {
    bool is_line = true;
    Vec2 point = Vec2::Zero();  // on the line, or the centre
    Vec2 direction = Vec2::Zero();
    double radius = 0;
};

std::optional<CenterLocus> carrier_beside(const Element& element, double distance) {
    if (!element.is_arc()) {
        const Vec2 along = start_direction(element);
        return CenterLocus{true, element.from + left_of(along) * distance, along, 0};
    }
    const double side = element.sweep > 0 ? 1 : -1;
    const double inside = radius(element) - side * distance;
    if (inside <= 0) return std::nullopt;
    return CenterLocus{false, element.center, Vec2::Zero(), inside};
}

struct Points {
    std::array<Vec2, 2> at = {Vec2::Zero(), Vec2::Zero()};
    std::size_t count = 0;
};

Points common_points(const CenterLocus& a, const CenterLocus& b) {
    Points points;
    if (a.is_line && b.is_line) {
        const double w = cross(a.direction, b.direction);
        if (std::fabs(w) < kNoTurn) return points;
        points.at[points.count++] =
            a.point + a.direction * (cross(b.point - a.point, b.direction) / w);
        return points;
    }
    if (!a.is_line && b.is_line) return common_points(b, a);
    Vec2 foot;
    Vec2 along;
    double square = 0;
    if (a.is_line) {
        foot = a.point + a.direction * (b.point - a.point).dot(a.direction);
        along = a.direction;
        square = b.radius * b.radius - (b.point - foot).squaredNorm();
    } else {
        const Vec2 delta = b.point - a.point;
        const double apart = delta.norm();
        if (apart < kReach) return points;
        const double part =
            (apart * apart + (a.radius - b.radius) * (a.radius + b.radius)) / (2 * apart);
        foot = a.point + delta / apart * part;
        along = left_of(delta / apart);
        square = (a.radius - part) * (a.radius + part);
    }
    if (square < 0) return points;
    const double half = std::sqrt(square);
    points.at[points.count++] = foot + along * half;
    points.at[points.count++] = foot - along * half;
    return points;
}

/// Where an arc about `center` touches the element; none beyond its ends.
std::optional<double> touching_share(const Element& element, const Vec2& center) {
    Vec2 point;
    if (element.is_arc()) {
        point = element.center + (center - element.center).normalized() * radius(element);
    } else {
        const Vec2 along = start_direction(element);
        point = element.from + along * (center - element.from).dot(along);
    }
    const Nearest found = nearest(element, point);
    if (found.distance > kReach) return std::nullopt;
    return found.share;
}

/// 0 beyond what the elements reach.
double chamfer_length(const Element& a, const Element& b, double width) {
    const std::optional<CornerCut> cut = chamfer(a, b, width);
    return cut ? length(cut->piece) : 0;
}

/// So far an element reaches, rounding left aside.
constexpr double kInside = 1 - 1e-12;

/// Steps of the width in which a chamfer's length is looked for. Beside an arc it does not always
/// grow with the width: an arc that bends towards the other element comes back to it.
constexpr int kRiseSteps = 64;

/// Between these widths the chamfer becomes as long as is wanted.
struct Rise {
    double low = 0;
    double high = 0;
};

/// The first one.
std::optional<Rise> rise_to(const Element& a, const Element& b, double length) {
    const double longest = kInside * width_of_longest_chamfer(a, b);
    Rise rise;
    for (int i = 1; i <= kRiseSteps; ++i) {
        rise.high = longest * i / kRiseSteps;
        if (chamfer_length(a, b, rise.high) >= length) return rise;
        rise.low = rise.high;
    }
    return std::nullopt;
}

}  // namespace

double turn_between(const Element& a, const Element& b) {
    const Vec2 in = end_direction(a);
    const Vec2 out = start_direction(b);
    return std::atan2(cross(in, out), in.dot(out));
}

std::optional<CornerCut> chamfer(const Element& a, const Element& b, double width) {
    const std::optional<double> leaves = share_at_distance(a, width);
    const std::optional<double> joins = share_at_distance(b, width);
    if (!leaves || !joins) return std::nullopt;
    CornerCut cut{1 - *leaves, *joins, {}};
    cut.piece = line_element(point_at(a, cut.leaves), point_at(b, cut.joins));
    return cut;
}

double widest_chamfer(const Element& a, const Element& b) { return std::min(reach(a), reach(b)); }

std::optional<double> chamfer_width(const Element& a, const Element& b, double length) {
    if (!a.is_arc() && !b.is_arc()) {
        const double half = std::cos(turn_between(a, b) / 2);  // sin(β/2), β = π − turn
        return half > kNoTurn ? std::optional(length / (2 * half)) : std::nullopt;
    }
    const std::optional<Rise> rise = rise_to(a, b, length);
    if (!rise) return std::nullopt;
    auto [low, high] = *rise;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = (low + high) / 2;
        (chamfer_length(a, b, middle) < length ? low : high) = middle;
    }
    return high;
}

double width_of_longest_chamfer(const Element& a, const Element& b) {
    if (!a.is_arc() && !b.is_arc()) return widest_chamfer(a, b);
    const double widest = kInside * widest_chamfer(a, b);
    int longest = 0;
    const auto length_at = [&](double step) {
        return chamfer_length(a, b, widest * step / kRiseSteps);
    };
    for (int i = 1; i <= kRiseSteps; ++i)
        if (length_at(i) > length_at(longest)) longest = i;
    double low = std::max(0, longest - 1);
    double high = std::min(kRiseSteps, longest + 1);
    for (int i = 0; i < kHalvings; ++i) {
        const double third = (high - low) / 3;
        if (length_at(low + third) < length_at(high - third)) low += third;
        else high -= third;
    }
    return widest * high / kRiseSteps;
}

std::optional<CornerCut> rounding(const Element& a, const Element& b, double radius) {
    const double turn = turn_between(a, b);
    if (std::fabs(turn) < kNoTurn || std::fabs(turn) > std::numbers::pi - kNoTurn)
        return std::nullopt;
    const double side = turn > 0 ? 1 : -1;
    const std::optional<CenterLocus> beside_a = carrier_beside(a, side * radius);
    const std::optional<CenterLocus> beside_b = carrier_beside(b, side * radius);
    if (!beside_a || !beside_b) return std::nullopt;
    const Points centers = common_points(*beside_a, *beside_b);
    std::optional<CornerCut> best;
    for (std::size_t i = 0; i < centers.count; ++i) {
        const Vec2& center = centers.at[i];
        const std::optional<double> leaves = touching_share(a, center);
        const std::optional<double> joins = touching_share(b, center);
        if (!leaves || !joins) continue;
        const auto cut_away = [&](const CornerCut& cut) {
            return (1 - cut.leaves) * length(a) + cut.joins * length(b);
        };
        CornerCut cut{*leaves, *joins, {}};
        cut.piece = arc_element(point_at(a, *leaves), point_at(b, *joins), center, side < 0);
        if (!best || cut_away(cut) < cut_away(*best)) best = cut;
    }
    return best;
}

double greatest_rounding(const Element& a, const Element& b, double most) {
    if (rounding(a, b, most)) return most;
    double low = 0;
    double high = most;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = (low + high) / 2;
        (rounding(a, b, middle) ? low : high) = middle;
    }
    return low;
}

namespace {

std::optional<MadeCorner> made_rounding(const Element& a, const Element& b, double radius,
                                        bool may_shrink) {
    if (const auto found = rounding(a, b, radius)) return MadeCorner{*found, radius};
    const double most = may_shrink ? greatest_rounding(a, b, radius) : 0;
    if (!(most > kSamePoint)) return std::nullopt;
    const auto found = rounding(a, b, most);
    if (!found) return std::nullopt;
    return MadeCorner{*found, most};
}

}  // namespace

std::optional<MadeCorner> made_corner(const Element& a, const Element& b, const CornerShape& shape,
                                      bool may_shrink) {
    if (shape.kind == CornerShape::Kind::Rounding)
        return made_rounding(a, b, shape.size, may_shrink);
    const bool is_length = shape.kind == CornerShape::Kind::ChamferLength;
    const std::optional<double> width =
        is_length ? chamfer_width(a, b, shape.size) : std::optional(shape.size);
    const double widest = is_length ? width_of_longest_chamfer(a, b) : widest_chamfer(a, b);
    if (width && *width <= widest + kSamePoint) {
        if (const auto found = chamfer(a, b, std::min(*width, widest)))
            return MadeCorner{*found, shape.size};
    }
    if (!may_shrink) return std::nullopt;
    const auto found = chamfer(a, b, widest);
    if (!found || length(found->piece) < kSamePoint) return std::nullopt;
    return MadeCorner{*found, is_length ? length(found->piece) : widest};
}

}  // namespace kadr::path
