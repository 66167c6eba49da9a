#include "path/curve_of.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace kadr::path {

namespace {

/// Two points that are nearer, mm, differ by the rounding of frames.
constexpr double kSamePlace = 1e-9;
/// A tip that is nearer, mm, is where the arc begins; and what controls forgive turns it by no more
/// than this, rad.
constexpr double kSameStart = 1e-6;
constexpr double kLittleTurn = 0.1;

/// The sweep of the arc from where the tip is, which may be a little beside where the program has
/// it: the arc ends where it should all the same, and does not jump there.
double sweep_from(const ArcShape& arc, const Vec3& from, const Vec3& to) {
    const auto flat = [&](const Vec3& point) {
        const Vec3 arm = point - arc.center;
        return Vec3(arm - arm.dot(arc.normal) * arc.normal);
    };
    const Vec3 first = flat(from);
    const Vec3 last = flat(to);
    const double angle = std::atan2(arc.normal.dot(first.cross(last)), first.dot(last));
    const double miss = std::remainder(angle - arc.sweep, 2 * std::numbers::pi);
    const double aside = std::abs(miss) * std::min(first.norm(), last.norm());
    const bool is_slight = std::abs(miss) < std::min(kLittleTurn, arc.sweep / 2);
    return aside > kSameStart && is_slight ? arc.sweep + miss : arc.sweep;
}

}  // namespace

Curve curve_of(const Motion& motion, const Vec3& from, const Vec3& to) {
    switch (motion.op()) {
        case Op::Arc: {
            const ArcShape& arc = motion.arc();
            return make_helix(from, to, arc.center, arc.normal, sweep_from(arc, from, to));
        }
        case Op::Spline:
            if (motion.spline().degree > 3) return make_quintic(from, to, motion.spline());
            return make_spline(from, to, motion.spline());
        case Op::Involute: {
            const InvoluteShape& involute = motion.involute();
            return make_involute(from, to, involute.center, involute.normal, involute.base_radius);
        }
        case Op::Parametric: return make_parametric(from, to, motion.curve());
        default: break;
    }
    if ((to - from).squaredNorm() > kSamePlace * kSamePlace) return make_line(from, to);
    return Point{from};
}

}  // namespace kadr::path
