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
    if (is_tilted_ && path::is_motion(command.op)) turn(lie_.transpose(), command);
    return command;
}

Command CompPlane::out_of(Command command) const {
    if (!is_tilted_ || !path::is_motion(command.op)) return command;
    turn(lie_, command);
    command.moved |= kLinearXYZ;
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

void CompPlane::shift(Command& command, const Vec2& by) const {
    shift(command.to, by);
    set_center(command, center(command) + by);
}

Element CompPlane::element_of(const Command& command, const Vec2& from) const {
    const Vec2 to = point(command.to);
    if (command.op != path::Op::Arc) return path::line_element(from, to);
    Element arc{from, to, center(command), 0};
    const bool is_left = command.normal.dot(path::unit(axes_.normal)) > 0;
    arc.sweep = (command.sweep - 2 * pi * command.turns) * (is_left ? 1 : -1);
    return arc;
}

void CompPlane::go_along(const Element& arc, Command& command) const {
    command.op = path::Op::Arc;
    set_point(command.to, arc.to);
    set_center(command, arc.center);
    command.normal = path::unit(axes_.normal) * (arc.sweep > 0 ? 1 : -1);
    command.sweep = std::abs(arc.sweep) + 2 * pi * command.turns;
    command.is_clockwise = arc.sweep < 0;
}

void CompPlane::set_center(Command& command, const Vec2& at) const {
    command.center[static_cast<Eigen::Index>(index(axes_.first))] = at.x();
    command.center[static_cast<Eigen::Index>(index(axes_.second))] = at.y();
}

Vec2 CompPlane::center(const Command& command) const {
    return {command.center[static_cast<Eigen::Index>(index(axes_.first))],
            command.center[static_cast<Eigen::Index>(index(axes_.second))]};
}

}  // namespace kadr::interp
