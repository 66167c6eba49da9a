#include "interp/compensation_plane.h"

#include <cmath>
#include <numbers>

#include "interp/rotated_command.h"

namespace kadr::interp {

using path::Command;
using path::Element;
using path::Vec2;
using std::numbers::pi;

CompPlane::CompPlane(path::Plane plane, const path::Mat3& lie)
    : plane_(plane),
      axes_(path::axes_of(plane)),
      lie_(lie),
      is_tilted_(lie != path::Mat3::Identity()) {}

AxisValues CompPlane::into(const AxisValues& base) const {
    if (!is_tilted_) return base;
    AxisValues values = base;
    turn(lie_.transpose(), values);
    return values;
}

AxisValues CompPlane::out_of(const AxisValues& values) const {
    if (!is_tilted_) return values;
    AxisValues base = values;
    turn(lie_, base);
    return base;
}

Command CompPlane::into(Command command) const {
    if (is_tilted_ && command.is_motion()) turn(lie_.transpose(), command.motion());
    return command;
}

Command CompPlane::out_of(Command command) const {
    if (!is_tilted_ || !command.is_motion()) return command;
    turn(lie_, command.motion());
    command.motion().moved |= kLinearXYZ;
    return command;
}

Vec2 CompPlane::point(const AxisValues& values) const {
    return {values[index(axes_.first)], values[index(axes_.second)]};
}

void CompPlane::set_point(AxisValues& values, const Vec2& at) const {
    values[index(axes_.first)] = at.x();
    values[index(axes_.second)] = at.y();
}

void CompPlane::shift(AxisValues& values, const Vec2& by) const {
    set_point(values, point(values) + by);
}

void CompPlane::shift(path::Motion& motion, const Vec2& by) const {
    shift(motion.to, by);
    if (motion.op() == path::Op::Arc) shift(motion.arc().center, by);
    else if (motion.op() == path::Op::Involute) shift(motion.involute().center, by);
}

void CompPlane::shift(path::Vec3& center, const Vec2& by) const {
    set_center(center, in_plane(center) + by);
}

Element CompPlane::element_of(const path::Motion& motion, const Vec2& from) const {
    const Vec2 to = point(motion.to);
    if (motion.op() != path::Op::Arc) return path::line_element(from, to);
    const path::ArcShape& shape = motion.arc();
    Element arc{from, to, in_plane(shape.center), 0};
    const bool is_left = shape.normal.dot(path::unit(axes_.normal)) > 0;
    arc.sweep = (shape.sweep - 2 * pi * shape.turns) * (is_left ? 1 : -1);
    return arc;
}

void CompPlane::go_along(const Element& arc, path::Motion& motion) const {
    if (motion.op() != path::Op::Arc) motion.become(path::Op::Arc);
    set_point(motion.to, arc.to);
    path::ArcShape& shape = motion.arc();
    set_center(shape.center, arc.center);
    shape.normal = path::unit(axes_.normal) * (arc.sweep > 0 ? 1 : -1);
    shape.sweep = std::abs(arc.sweep) + 2 * pi * shape.turns;
    shape.is_clockwise = arc.sweep < 0;
}

void CompPlane::set_center(path::Vec3& center, const Vec2& at) const {
    center[static_cast<Eigen::Index>(index(axes_.first))] = at.x();
    center[static_cast<Eigen::Index>(index(axes_.second))] = at.y();
}

Vec2 CompPlane::in_plane(const path::Vec3& center) const {
    return {center[static_cast<Eigen::Index>(index(axes_.first))],
            center[static_cast<Eigen::Index>(index(axes_.second))]};
}

}  // namespace kadr::interp
