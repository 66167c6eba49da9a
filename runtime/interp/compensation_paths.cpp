#include "interp/compensation_paths.h"

#include <cmath>

#include <Eigen/Geometry>

#include "path/radius_comp.h"

namespace kadr::interp {

using path::Element;
using path::Vec2;

namespace {

using MaybeElement = std::optional<Element>;
using FoundElement = Result<MaybeElement, CompPathFault>;

Vec2 left_of(const Vec2& direction) { return {-direction.y(), direction.x()}; }

/// The point on the circle about the corner that a line from `from` touches, so that the corner is
/// at the distance beside it. None within the circle.
std::optional<Vec2> touched(const Vec2& corner, const Vec2& from, double distance) {
    const Vec2 away = from - corner;
    const double apart = away.norm();
    const double radius = std::abs(distance);
    if (apart <= radius) return std::nullopt;
    const double angle = std::acos(radius / apart);
    const Vec2 direction = away / apart;
    for (const double sign : {1.0, -1.0}) {
        const Vec2 point = corner + Eigen::Rotation2D(sign * angle) * direction * radius;
        if (left_of(point - from).dot(point - corner) * distance > 0) return point;
    }
    return std::nullopt;
}

/// Of the cutter's path beside an element, 1/mm, positive where it bends to the left.
double curvature_beside(const Element& element, double distance) {
    if (!element.is_arc()) return 0;
    const double bend = element.sweep > 0 ? 1 : -1;
    const double radius = path::radius(element) - bend * distance;
    return radius > path::kSamePoint ? bend / radius : 0;
}

}  // namespace

FoundElement approach_element(nc::CompStart start, const Element& first, const Vec2& from,
                              double distance) {
    const Vec2 tangent = path::start_direction(first);
    const Vec2 along = first.from - from;
    if (along.norm() < path::kSamePoint || distance == 0) return MaybeElement{};
    if (start == nc::CompStart::Extended) {
        const double turn = along.x() * tangent.y() - along.y() * tangent.x();
        return turn * distance < 0 ? MaybeElement(path::line_element(from, first.from))
                                   : MaybeElement{};
    }
    const bool is_behind = left_of(tangent).dot(along) * distance > path::kSamePoint;
    if (start != nc::CompStart::Around || !is_behind) return MaybeElement{};
    const std::optional<Vec2> touch = touched(first.from, from, distance);
    if (!touch) return CompPathFault::Blocked;
    return MaybeElement(path::line_element(first.from - (*touch - from), first.from));
}

FoundElement retract_element(nc::CompStart start, const Element& last, const Vec2& to,
                             double distance) {
    const Vec2 tangent = path::end_direction(last);
    const Vec2 along = to - last.to;
    if (along.norm() < path::kSamePoint || distance == 0) return MaybeElement{};
    if (start == nc::CompStart::Extended) {
        const double turn = tangent.x() * along.y() - tangent.y() * along.x();
        return turn * distance < 0 ? MaybeElement(path::line_element(last.to, to)) : MaybeElement{};
    }
    const bool is_behind = left_of(tangent).dot(along) * distance < -path::kSamePoint;
    if (start != nc::CompStart::Around || !is_behind) return MaybeElement{};
    // The retraction touches from the other side.
    const std::optional<Vec2> touch = touched(last.to, to, -distance);
    if (!touch) return CompPathFault::Blocked;
    return MaybeElement(path::line_element(last.to, last.to + (to - *touch)));
}

/// A parabola p that ends with the direction t of the contour, or a cubic that ends with its
/// curvature κ as well: with p'(1) = l·t and p''(1) = l²·κ·n, n the normal, l the distance of the
/// ends. Béziers: b₃ = p(1), b₂ = b₃ − p'(1)/3, b₁ = p''(1)/6 + 2·b₂ − b₃.
std::optional<EndCurve> curve_in(nc::CompStart start, const Vec2& from, const Element& first,
                                 double distance) {
    const Vec2 end = path::RadiusComp::start_of(first, distance);
    const Vec2 tangent = path::start_direction(first);
    const double reach = (end - from).norm();
    if (reach < path::kSamePoint) return std::nullopt;
    if (start == nc::CompStart::Tangent)
        return EndCurve{2, {Vec2(end - tangent * reach / 2), Vec2::Zero()}, true};
    const Vec2 bend = left_of(tangent) * curvature_beside(first, distance) * reach * reach;
    return EndCurve{
        3, {Vec2(end - tangent * reach * 2 / 3 + bend / 6), Vec2(end - tangent * reach / 3)}, true};
}

/// The same, travelled back.
std::optional<EndCurve> curve_out(nc::CompStart start, const Element& element, const Element& last,
                                  double distance) {
    const Vec2& from = element.from;
    const Vec2 tangent = path::end_direction(last);
    const double reach = (element.to - from).norm();
    if (reach < path::kSamePoint) return std::nullopt;
    if (start == nc::CompStart::Tangent)
        return EndCurve{2, {Vec2(from + tangent * reach / 2), Vec2::Zero()}, false};
    const Vec2 bend = left_of(tangent) * curvature_beside(last, distance) * reach * reach;
    return EndCurve{
        3,
        {Vec2(from + tangent * reach / 3), Vec2(from + tangent * reach * 2 / 3 + bend / 6)},
        false};
}

}  // namespace kadr::interp
