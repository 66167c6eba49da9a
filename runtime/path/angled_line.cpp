#include "path/angled_line.h"

#include <cmath>

#include "base/units.h"

namespace kadr::path {

Vec2 unit_at(double angle_deg) {
    const double angle = rad_from_deg(angle_deg);
    return {std::cos(angle), std::sin(angle)};
}

std::optional<Vec2> end_at(const Vec2& from, const Vec2& along, Eigen::Index coordinate,
                           double value) {
    const double part = along[coordinate];
    if (std::abs(part) < kParallelLines) return std::nullopt;
    const double length = (value - from[coordinate]) / part;
    if (!(length >= 0)) return std::nullopt;
    return from + length * along;
}

std::optional<Vec2> meeting_point(const Vec2& from, const Vec2& out, const Vec2& to,
                                  const Vec2& in) {
    const double w = cross(out, in);
    if (std::abs(w) < kParallelLines) return std::nullopt;
    const double along = cross(to - from, in) / w;
    const double beyond = cross(out, to - from) / w;
    if (!(along > 0) || !(beyond > 0)) return std::nullopt;
    return from + along * out;
}

}  // namespace kadr::path
