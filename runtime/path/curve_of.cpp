#include "path/curve_of.h"

namespace kadr::path {

namespace {

/// Two places that are nearer, mm, differ by the rounding of frames.
constexpr double kSamePlace = 1e-9;

}  // namespace

Curve curve_of(const Command& command, const Vec3& from, const Vec3& to) {
    switch (command.op) {
        case Op::Arc: return make_helix(from, to, command.center, command.normal, command.sweep);
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
