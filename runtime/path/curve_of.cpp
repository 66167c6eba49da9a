#include "path/curve_of.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace kadr::path {

namespace {

/// Two places that are nearer, mm, differ by the rounding of frames.
constexpr double kSamePlace = 1e-9;
/// A tip that is nearer, mm, is where the arc begins; and what controls forgive turns it by no more
/// than this, rad.
constexpr double kSameStart = 1e-6;
constexpr double kLittleTurn = 0.1;

/// The sweep of the arc from where the tip is, which may be a little beside where the program has
/// it: the arc ends where it should all the same, and does not jump there.
double sweep_from(const Command& command, const Vec3& from, const Vec3& to) {
    const auto flat = [&](const Vec3& place) {
        const Vec3 arm = place - command.center;
        return Vec3(arm - arm.dot(command.normal) * command.normal);
    };
    const Vec3 first = flat(from);
    const Vec3 last = flat(to);
    const double angle = std::atan2(command.normal.dot(first.cross(last)), first.dot(last));
    const double miss = std::remainder(angle - command.sweep, 2 * std::numbers::pi);
    const double aside = std::abs(miss) * std::min(first.norm(), last.norm());
    const bool is_slight = std::abs(miss) < std::min(kLittleTurn, command.sweep / 2);
    return aside > kSameStart && is_slight ? command.sweep + miss : command.sweep;
}

}  // namespace

Curve curve_of(const Command& command, const Vec3& from, const Vec3& to) {
    switch (command.op) {
        case Op::Arc: {
            const double sweep = sweep_from(command, from, to);
            return make_helix(from, to, command.center, command.normal, sweep);
        }
        case Op::Spline:
            if (command.spline.degree > 3) return make_quintic(from, to, command.spline);
            return make_spline(from, to, command.spline);
        case Op::Involute:
            return make_involute(from, to, command.center, command.normal, command.base_radius);
        case Op::Parametric: return make_parametric(from, to, command.curve.front());
        default: break;
    }
    if ((to - from).squaredNorm() > kSamePlace * kSamePlace) return make_line(from, to);
    return Point{from};
}

}  // namespace kadr::path
