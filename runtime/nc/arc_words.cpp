#include "nc/arc_words.h"

#include <cmath>
#include <numbers>

#include "base/numbers.h"

namespace kadr::nc {

namespace {

/// Not hypot: positions of machines neither overflow nor vanish when they are squared, and every
/// arc asks for thirty of these.
double distance(const PlanePoint& a, const PlanePoint& b) {
    const double dx = a[0] - b[0];
    const double dy = a[1] - b[1];
    return std::sqrt(dx * dx + dy * dy);
}

/// The point of the perpendicular bisector of a and b that is nearest to p.
PlanePoint onto_bisector(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
    const double dx = b[0] - a[0];
    const double dy = b[1] - a[1];
    const double along =
        ((p[0] - (a[0] + b[0]) / 2) * dx + (p[1] - (a[1] + b[1]) / 2) * dy) / (dx * dx + dy * dy);
    return {p[0] - along * dx, p[1] - along * dy};
}

}  // namespace

PlanePoint center_words(const ArcPoints& arc, const PlanePoint& center, int decimals,
                        const std::array<bool, 2>& fixed_zero, bool is_absolute) {
    const double increment = std::pow(10.0, -decimals);
    const PlanePoint origin = is_absolute ? PlanePoint{0, 0} : arc.text_start;
    const auto word = [&](const PlanePoint& c, std::size_t i, int step) {
        if (fixed_zero[i]) return is_absolute ? c[i] : 0.0;
        return round_to(round_to(c[i] - origin[i], decimals) + step * increment, decimals);
    };
    const bool is_full = distance(arc.text_start, arc.text_end) < increment / 2;
    const double miss = std::fabs(distance(arc.start, center) - distance(arc.end, center));
    // A miss of the program itself is the control's to judge; it is not smoothed over here.
    if (is_full || miss > 1.5 * increment) return {word(center, 0, 0), word(center, 1, 0)};

    const PlanePoint ideal = onto_bisector(center, arc.text_start, arc.text_end);
    // The nine points of the grid around the ideal centre.
    const std::array<double, 3> across = {word(ideal, 0, -1), word(ideal, 0, 0), word(ideal, 0, 1)};
    const std::array<double, 3> along = {word(ideal, 1, -1), word(ideal, 1, 0), word(ideal, 1, 1)};
    PlanePoint best{};
    double best_cost = 1e300;
    for (const double first : across) {
        for (const double second : along) {
            const PlanePoint words = {first, second};
            const PlanePoint c = {origin[0] + words[0], origin[1] + words[1]};
            const double misfit =
                std::fabs(distance(arc.text_start, c) - distance(arc.text_end, c));
            // Equal radii first; among equals the centre nearest to the one that was meant.
            const double cost = misfit + 1e-3 * distance(c, center);
            if (cost >= best_cost) continue;
            best_cost = cost;
            best = words;
        }
    }
    return best;
}

double sweep_angle(const PlanePoint& start, const PlanePoint& end, const PlanePoint& center,
                   bool is_clockwise) {
    constexpr double kTurn = 2 * std::numbers::pi;
    constexpr double kNothing =
        1e-9;  // rad; start and end that are the same point but for rounding
    const double from = std::atan2(start[1] - center[1], start[0] - center[0]);
    const double to = std::atan2(end[1] - center[1], end[0] - center[0]);
    double sweep = is_clockwise ? from - to : to - from;
    while (sweep <= kNothing) sweep += kTurn;
    while (sweep > kTurn + kNothing) sweep -= kTurn;
    return sweep;
}

std::optional<PlanePoint> center_of_radius(const PlanePoint& start, const PlanePoint& end,
                                           double radius, bool is_clockwise, double slack) {
    const double dx = end[0] - start[0];
    const double dy = end[1] - start[1];
    const double chord = std::hypot(dx, dy);
    if (chord == 0) return std::nullopt;
    // Half a turn is often programmed with a radius that misses the half chord by a last digit.
    if (chord - 2 * std::fabs(radius) > slack) return std::nullopt;
    const double square = std::fmax(0.0, radius * radius - chord * chord / 4);
    const double height = std::sqrt(square) / chord;
    // The centre lies left of the chord for a short counter-clockwise arc.
    const double side = (is_clockwise ? -1.0 : 1.0) * (radius < 0 ? -1.0 : 1.0);
    return PlanePoint{start[0] + dx / 2 - side * height * dy,
                      start[1] + dy / 2 + side * height * dx};
}

double radius_miss(const ArcPoints& arc, const PlanePoint& center) {
    return std::fabs(std::hypot(arc.start[0] - center[0], arc.start[1] - center[1]) -
                     std::hypot(arc.end[0] - center[0], arc.end[1] - center[1]));
}

RadiusArc radius_arc(const ArcPoints& points, double radius, int places, bool is_clockwise,
                     double scale) {
    const double slack = kHalfTurnSlack * scale;
    RadiusArc arc{points, {}, {}};
    const double rounded = round_to(radius, places);
    arc.exact = center_of_radius(points.start, points.end, radius, is_clockwise, slack);
    arc.reached =
        center_of_radius(points.text_start, points.text_end, rounded, is_clockwise, slack);
    if (!arc.exact || !arc.reached) return arc;
    const auto apart = [](const PlanePoint& a, const PlanePoint& b) {
        return std::hypot(a[0] - b[0], a[1] - b[1]);
    };
    arc.fits = apart(*arc.exact, *arc.reached) <= 5 * std::pow(10.0, -places) &&
               apart(points.text_start, points.text_end) <= 2 * std::fabs(rounded);
    return arc;
}

}  // namespace kadr::nc
