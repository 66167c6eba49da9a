#include "path/polar_passages.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kadr::path {

namespace {

// Between two points that are compared the rotary axis turns by less, rad: then none of its turns
// is missed. The first halvings are done in any case.
constexpr double kCloseTurn = 0.25;
constexpr int kFirstHalvings = 3;
constexpr int kMostHalvings = 48;

// Turns that differ by rounding are the same, rad; a direction with a smaller part in the plane of
// polar coordinates is none.
constexpr double kSameTurn = 1e-9;

/// Of a line where it is nearest to the centre, if it goes across it.
void passages_of_line(const VirtualAxes& axes, const Curve& curve, std::vector<double>& found) {
    const double length = path::length(curve);
    const CurvePoint from = evaluate(curve, 0);
    const double across = std::hypot(from.tangent.x(), from.tangent.y());
    if (across * length < kPoleRadius) return;
    const double along = (axes.center_x - from.position.x()) * from.tangent.x() +
                         (axes.center_y - from.position.y()) * from.tangent.y();
    const double at = along / (across * across);
    if (at > 0 && at < length && is_at_pole(axes, position(curve, at))) found.push_back(at);
}

/// The radius changes by no more than the path: what is farther than half of a part is not in it.
void passages_within(const VirtualAxes& axes, const Curve& curve, double from, double to,
                     std::vector<double>& found) {
    const double middle = (from + to) / 2;
    const double half = (to - from) / 2;
    if (radius_at(axes, position(curve, middle)) > half + kPoleRadius) return;
    if (half < kPoleRadius / 2) {
        const bool is_same = !found.empty() && middle - found.back() < 4 * kPoleRadius;
        if (!is_same) found.push_back(middle);
        return;
    }
    passages_within(axes, curve, from, middle, found);
    passages_within(axes, curve, middle, to, found);
}

/// Where within a few widths of the pole the curve is nearest to it: thirds of what is left.
double nearest_beside(const VirtualAxes& axes, const Curve& curve, double at) {
    double from = at - 4 * kPoleRadius;
    double to = at + 4 * kPoleRadius;
    while (to - from > kPoleRadius / 1000) {
        const double third = (to - from) / 3;
        const bool is_first = radius_at(axes, position(curve, from + third)) <
                              radius_at(axes, position(curve, to - third));
        (is_first ? to : from) += is_first ? -third : third;
    }
    return (from + to) / 2;
}

/// Whether the curve stays where the rotary axis means nothing, as a line along Z does.
bool stays_at_pole(const VirtualAxes& axes, const Curve& curve) {
    const double length = path::length(curve);
    return is_at_pole(axes, start(curve)) && is_at_pole(axes, end(curve)) &&
           is_at_pole(axes, position(curve, length / 3));
}

}  // namespace

std::vector<double> pole_passages(const VirtualAxes& axes, const Curve& curve) {
    std::vector<double> found;
    if (axes.kind != VirtualKind::Polar || std::holds_alternative<Point>(curve)) return found;
    const double length = path::length(curve);
    if (std::holds_alternative<Line>(curve)) {
        passages_of_line(axes, curve, found);
    } else if (!stays_at_pole(axes, curve)) {
        passages_within(axes, curve, 0, length, found);
        for (double& at : found) at = nearest_beside(axes, curve, at);
    }
    // At its ends it does not pass.
    constexpr double kEnd = 4 * kPoleRadius;
    std::erase_if(found, [&](double at) { return at < kEnd || at > length - kEnd; });
    return found;
}

std::vector<Curve> legs_between_poles(const VirtualAxes& axes, const Curve& curve) {
    std::vector<Curve> legs;
    const std::vector<double> passages = pole_passages(axes, curve);
    if (passages.empty()) return {curve};
    double from = 0;
    Vec3 start_of_leg = start(curve);
    const bool is_line = std::holds_alternative<Line>(curve);
    for (std::size_t i = 0; i <= passages.size(); ++i) {
        const double to = i == passages.size() ? length(curve) : passages[i];
        Vec3 end_of_leg = position(curve, to);
        if (i < passages.size()) {
            end_of_leg.x() = axes.center_x;
            end_of_leg.y() = axes.center_y;
        }
        legs.push_back(is_line ? Curve(make_line(start_of_leg, end_of_leg))
                               : part(curve, from, to));
        from = to;
        start_of_leg = end_of_leg;
    }
    return legs;
}

double rotary_to_leave(const VirtualAxes& axes, const Curve& leg, double rotary) {
    if (axes.kind != VirtualKind::Polar || !is_at_pole(axes, start(leg))) return rotary;
    const Vec3 out = evaluate(leg, 0).tangent;
    if (std::hypot(out.x(), out.y()) < kSameTurn) return rotary;
    const double to = rotary_towards(axes, out, rotary);
    // Half a turn is as long either way: the axis turns back towards where its angle is 0.
    const double by = to - rotary;
    if (std::abs(std::abs(by) - std::numbers::pi) > kSameTurn) return to;
    const bool goes_down = rotary > axes.zero + kSameTurn;
    return goes_down == (by < 0) ? to : to - std::copysign(2 * std::numbers::pi, by);
}

namespace {

struct ParameterRange {
    double from = 0;
    double to = 0;
};

double follow(const VirtualAxes& axes, const Curve& leg, const ParameterRange& reach, double rotary,
              int halvings) {
    const double middle = (reach.from + reach.to) / 2;
    const double half_way = rotary_at(axes, position(leg, middle), rotary);
    const double end = rotary_at(axes, position(leg, reach.to), half_way);
    const bool is_close =
        std::abs(half_way - rotary) < kCloseTurn && std::abs(end - half_way) < kCloseTurn;
    if ((is_close && halvings >= kFirstHalvings) || halvings >= kMostHalvings) return end;
    const double there = follow(axes, leg, {reach.from, middle}, rotary, halvings + 1);
    return follow(axes, leg, {middle, reach.to}, there, halvings + 1);
}

}  // namespace

double rotary_behind(const VirtualAxes& axes, const Curve& leg, double rotary) {
    if (axes.kind != VirtualKind::Polar) return rotary_at(axes, end(leg), rotary);
    return follow(axes, leg, {0, length(leg)}, rotary, 0);
}

}  // namespace kadr::path
