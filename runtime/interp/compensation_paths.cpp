// compensation_paths.cpp — the cutter's way to the contour and away from it: around its end, or on
// a curve.
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "base/diagnostics/iso.h"
#include "interp/compensation.h"

namespace kadr::interp {

using path::Command;
using path::Element;
using path::Op;
using path::Vec2;

namespace {

Vec2 left_of(const Vec2& direction) { return {-direction.y(), direction.x()}; }

}  // namespace

/// The place on the circle about the corner that a line from `from` touches, so that the corner is
/// at the distance beside it. None within the circle.
std::optional<Vec2> Compensation::touched(const Vec2& corner, const Vec2& from,
                                          double distance) const {
    const Vec2 away = from - corner;
    const double apart = away.norm();
    const double radius = std::abs(distance);
    if (apart <= radius) return std::nullopt;
    const double angle = std::acos(radius / apart);
    const Vec2 direction = away / apart;
    for (const double sign : {1.0, -1.0}) {
        const Vec2 place = corner + Eigen::Rotation2D(sign * angle) * direction * radius;
        if (left_of(place - from).dot(place - corner) * distance > 0) return place;
    }
    return std::nullopt;
}

/// The approach as an element of the contour, if the first corner is to be treated as one; none:
/// straight to the normal.
Compensation::Fault Compensation::way_in(const Element& first, std::optional<Element>& way) const {
    const Vec2 from = in_plane(shown_);
    const Vec2 tangent = path::start_direction(first);
    const Vec2 along = first.from - from;
    if (along.norm() < path::kSamePoint || distance_ == 0) return nullptr;
    // From the other side of the contour the way is straight, whatever the corner.
    const bool is_beside = (from - in_plane(meant_)).norm() > path::kSamePoint;
    if (settings_.start == nc::CompStart::Extended && !is_beside) {
        const double turn = along.x() * tangent.y() - along.y() * tangent.x();
        if (turn * distance_ < 0) way = path::line_element(from, first.from);
    }
    const bool is_behind = left_of(tangent).dot(along) * distance_ > path::kSamePoint;
    if (settings_.start != nc::CompStart::Around || !is_behind) return nullptr;
    const std::optional<Vec2> touch = touched(first.from, from, distance_);
    if (!touch) return &diag::CompStartBlocked;
    way = path::line_element(first.from - (*touch - from), first.from);
    return nullptr;
}

Compensation::Fault Compensation::retract_path(const Vec2& to, std::optional<Element>& way) const {
    const Vec2 tangent = path::end_direction(last_);
    const Vec2 along = to - last_.to;
    if (along.norm() < path::kSamePoint || distance_ == 0) return nullptr;
    if (settings_.start == nc::CompStart::Extended) {
        const double turn = tangent.x() * along.y() - tangent.y() * along.x();
        if (turn * distance_ < 0) way = path::line_element(last_.to, to);
    }
    const bool is_behind = left_of(tangent).dot(along) * distance_ < -path::kSamePoint;
    if (settings_.start != nc::CompStart::Around || !is_behind) return nullptr;
    // The way back touches from the other side.
    const std::optional<Vec2> touch = touched(last_.to, to, -distance_);
    if (!touch) return &diag::CompStartBlocked;
    way = path::line_element(last_.to, last_.to + (to - *touch));
    return nullptr;
}

/// Of the cutter's way beside an element, 1/mm, positive where it bends to the left.
double Compensation::curvature_beside(const Element& element) const {
    if (!element.is_arc()) return 0;
    const double bend = element.sweep > 0 ? 1 : -1;
    const double radius = path::radius(element) - bend * distance_;
    return radius > path::kSamePoint ? bend / radius : 0;
}

/// A parabola p that ends with the direction t of the contour, or a cubic that ends with its
/// curvature κ as well: with p'(1) = l·t and p''(1) = l²·κ·n, n the normal, l the distance of the
/// ends. Béziers: b₃ = p(1), b₂ = b₃ − p'(1)/3, b₁ = p''(1)/6 + 2·b₂ − b₃. The other axes come to
/// rest at their end.
void Compensation::emit_curve_in(const Element& first) {
    Command command = held_.front().command;
    const Vec2 end = path::RadiusComp::start_of(first, distance_);
    const Vec2 tangent = path::start_direction(first);
    const double reach = (end - in_plane(shown_)).norm();
    if (reach < path::kSamePoint) return emit_line(held_.front(), end, false);
    set_in_plane(command.to, end);
    AxisValues inner = command.to;
    const auto place = [&](std::size_t i, const Vec2& at) {
        set_in_plane(inner, at);
        command.spline.inner[i] = path::Vec3(inner[0], inner[1], inner[2]);
    };
    command.op = Op::Spline;
    command.spline.weights = {1, 1, 1, 1};
    if (settings_.start == nc::CompStart::Tangent) {
        command.spline.degree = 2;
        place(0, end - tangent * reach / 2);
    } else {
        command.spline.degree = 3;
        const Vec2 bend = left_of(tangent) * curvature_beside(first) * reach * reach;
        place(0, end - tangent * reach * 2 / 3 + bend / 6);
        place(1, end - tangent * reach / 3);
    }
    put_beside(std::move(command), held_.front().command.to);
}

/// The same, travelled back.
void Compensation::emit_curve_out(Command& command) {
    const Vec2 from = in_plane(shown_);
    const Vec2 tangent = path::end_direction(last_);
    const double reach = (in_plane(command.to) - from).norm();
    AxisValues inner = shown_;
    const auto place = [&](std::size_t i, const Vec2& at) {
        set_in_plane(inner, at);
        command.spline.inner[i] = path::Vec3(inner[0], inner[1], inner[2]);
    };
    if (reach < path::kSamePoint)
        return emit_line({command, 0, 0, true}, in_plane(command.to), false);
    command.op = Op::Spline;
    command.spline.weights = {1, 1, 1, 1};
    if (settings_.start == nc::CompStart::Tangent) {
        command.spline.degree = 2;
        place(0, from + tangent * reach / 2);
    } else {
        command.spline.degree = 3;
        const Vec2 bend = left_of(tangent) * curvature_beside(last_) * reach * reach;
        place(0, from + tangent * reach / 3);
        place(1, from + tangent * reach * 2 / 3 + bend / 6);
    }
    const AxisValues to = command.to;
    put_beside(std::move(command), to);
}

}  // namespace kadr::interp
