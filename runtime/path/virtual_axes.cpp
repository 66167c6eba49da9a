#include "path/virtual_axes.h"

#include <cmath>
#include <numbers>

namespace kadr::path {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

double nearest_turn(double angle, double near) {
    return angle + kTurn * std::round((near - angle) / kTurn);
}

Eigen::Index around(const VirtualAxes& axes) {
    return static_cast<Eigen::Index>(index(axes.virtual_axis()));
}

}  // namespace

double radius_at(const VirtualAxes& axes, const Vec3& tip) {
    return std::hypot(tip.x() - axes.center_x, tip.y() - axes.center_y);
}

double rotary_towards(const VirtualAxes& axes, const Vec3& out, double near) {
    const double angle = std::atan2(axes.side * out.y(), axes.side * out.x());
    return nearest_turn(axes.zero + axes.sign * angle, near);
}

double rotary_at(const VirtualAxes& axes, const Vec3& tip, double near) {
    switch (axes.kind) {
        case VirtualKind::None:
        case VirtualKind::Inclined: return near;
        case VirtualKind::Polar:
            if (is_at_pole(axes, tip)) return near;
            return rotary_towards(axes, tip - Vec3(axes.center_x, axes.center_y, 0), near);
        case VirtualKind::Cylinder:
            return axes.zero + (tip[around(axes)] - axes.center_y) / axes.size;
    }
    return near;
}

Vec3 real_position(const VirtualAxes& axes, const Vec3& tip) {
    Vec3 real = tip;
    switch (axes.kind) {
        case VirtualKind::None: break;
        case VirtualKind::Polar:
            real.x() = axes.center_x + axes.side * radius_at(axes, tip);
            real.y() = axes.standing;
            break;
        case VirtualKind::Cylinder: real[around(axes)] = axes.standing; break;
        case VirtualKind::Inclined:
            real.x() = tip.x() / std::cos(axes.size);
            real.z() = tip.z() - tip.x() * std::tan(axes.size);
            break;
    }
    return real;
}

Vec3 virtual_position(const VirtualAxes& axes, const Vec3& real, double rotary) {
    Vec3 tip = real;
    switch (axes.kind) {
        case VirtualKind::None: break;
        case VirtualKind::Polar: {
            const double angle = axes.sign * (rotary - axes.zero);
            const double along = real.x() - axes.center_x;
            tip.x() = axes.center_x + along * std::cos(angle);
            tip.y() = axes.center_y + along * std::sin(angle);
            break;
        }
        case VirtualKind::Cylinder:
            tip[around(axes)] = axes.center_y + axes.size * (rotary - axes.zero);
            break;
        case VirtualKind::Inclined:
            tip.x() = real.x() * std::cos(axes.size);
            tip.z() = real.z() + real.x() * std::sin(axes.size);
            break;
    }
    return tip;
}

bool is_at_pole(const VirtualAxes& axes, const Vec3& tip) {
    return axes.kind == VirtualKind::Polar && radius_at(axes, tip) < kPoleRadius;
}

}  // namespace kadr::path
