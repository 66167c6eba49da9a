#include "write/arc_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/numbers.h"
#include "base/units.h"

namespace kadr::write {

namespace {

/// Not hypot: positions of machines neither overflow nor vanish when they are squared, and every
/// arc asks for thirty of these.
double distance(const PlanePoint& a, const PlanePoint& b) {
    const double dx = a[0] - b[0];
    const double dy = a[1] - b[1];
    return std::sqrt(dx * dx + dy * dy);
}

/// p moved towards the perpendicular bisector of a and b, as far as it takes, `most` at most.
PlanePoint towards_bisector(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b,
                            double most) {
    const double dx = b[0] - a[0];
    const double dy = b[1] - a[1];
    const double square = dx * dx + dy * dy;
    const double along =
        ((p[0] - (a[0] + b[0]) / 2) * dx + (p[1] - (a[1] + b[1]) / 2) * dy) / square;
    const double limit = most / std::sqrt(square);
    const double step = std::clamp(along, -limit, limit);
    return {p[0] - step * dx, p[1] - step * dy};
}

// A control that shifts the centre refuses an arc that would be turned by more (path/arc.h), rad.
constexpr double kMostShift = 1.7 * std::numbers::pi / 180;

}  // namespace

double CenterGrid::increment() const { return std::fmax(end_increment, std::pow(10.0, -decimals)); }

PlanePoint center_words(const ArcPoints& arc, const PlanePoint& center, const CenterGrid& grid) {
    const double step = std::pow(10.0, -grid.decimals);
    const PlanePoint origin = grid.is_absolute ? PlanePoint{0, 0} : arc.text_start;
    const auto word = [&](const PlanePoint& c, std::size_t i, int steps) {
        if (grid.fixed_zero[i]) return grid.is_absolute ? c[i] : 0.0;
        return round_to(round_to(c[i] - origin[i], grid.decimals) + steps * step, grid.decimals);
    };
    const PlanePoint nearest = {word(center, 0, 0), word(center, 1, 0)};
    const bool is_full = distance(arc.text_start, arc.text_end) < step / 2;
    const double miss = std::fabs(distance(arc.start, center) - distance(arc.end, center));
    // A miss of the program itself is the control's to judge; it is not smoothed over here.
    if (is_full || miss > 1.5 * step) return nearest;

    const auto misfit_of = [&](const PlanePoint& words) {
        const PlanePoint c = {origin[0] + words[0], origin[1] + words[1]};
        return std::fabs(distance(arc.text_start, c) - distance(arc.text_end, c));
    };
    // The nine points of the grid around the ideal centre, as far as they lie near the one that is
    // meant: equal radii first; among equals the nearest.
    const auto best_within = [&](double most) {
        const PlanePoint ideal = towards_bisector(center, arc.text_start, arc.text_end, most / 2);
        const auto cost_of = [&](const PlanePoint& words) {
            const double moved = distance({origin[0] + words[0], origin[1] + words[1]}, center);
            return moved > most ? std::numeric_limits<double>::infinity()
                                : misfit_of(words) + 1e-3 * moved;
        };
        PlanePoint best = nearest;
        double best_cost = cost_of(nearest);
        for (const int across : {-1, 0, 1}) {
            for (const int along : {-1, 0, 1}) {
                const PlanePoint words = {word(ideal, 0, across), word(ideal, 1, along)};
                const double cost = cost_of(words);
                if (cost >= best_cost) continue;
                best_cost = cost;
                best = words;
            }
        }
        return best;
    };
    const PlanePoint near = best_within(grid.increment());
    if (misfit_of(near) <= grid.most_misfit) return near;
    return best_within(std::numeric_limits<double>::max());
}

TracedArc traced_arc(const ArcPoints& arc, const PlanePoint& center, bool is_clockwise,
                     bool shifts_center) {
    TracedArc traced{center, distance(arc.text_start, center), distance(arc.text_end, center), 0};
    const PlanePoint half = {(arc.text_end[0] - arc.text_start[0]) / 2,
                             (arc.text_end[1] - arc.text_start[1]) / 2};
    const double half_chord = std::sqrt(half[0] * half[0] + half[1] * half[1]);
    constexpr double kEqual = 1e-12;  // of the text's unit: nobody knows when a control begins
    const bool differs = std::fabs(traced.start_radius - traced.end_radius) > kEqual;
    if (shifts_center && differs && half_chord > 0) {
        const double radius = std::fmax(traced.start_radius, half_chord);
        const double height = std::sqrt(radius * radius - half_chord * half_chord) / half_chord;
        const PlanePoint middle = {arc.text_start[0] + half[0], arc.text_start[1] + half[1]};
        // Left of the chord, or right of it, as the centre of the words is.
        const double side =
            half[0] * (center[1] - middle[1]) - half[1] * (center[0] - middle[0]) < 0 ? -1 : 1;
        traced.center = {middle[0] - side * height * half[1], middle[1] + side * height * half[0]};
        traced.start_radius = traced.end_radius = radius;
        const PlanePoint& start = arc.text_start;
        const PlanePoint programmed = {center[0] - start[0], center[1] - start[1]};
        const PlanePoint moved = {traced.center[0] - start[0], traced.center[1] - start[1]};
        const double sine = programmed[0] * moved[1] - programmed[1] * moved[0];
        const double cosine = programmed[0] * moved[0] + programmed[1] * moved[1];
        traced.is_refused = std::fabs(sine) > std::tan(kMostShift) * cosine;
    }
    traced.sweep = sweep_angle(arc.text_start, arc.text_end, traced.center, is_clockwise);
    return traced;
}

double path_error(const ArcPoints& arc, const PlanePoint& center, double sweep, bool is_clockwise,
                  const TracedArc& traced, double increment) {
    constexpr double kNoAnswer = std::numeric_limits<double>::infinity();
    if (traced.is_refused) return kNoAnswer;
    if (std::fabs(traced.sweep - sweep) > kTurnRad / 2) return kNoAnswer;
    // Ends side by side as seen from the centre: whether the arc is nothing or a full circle hangs
    // on the last digit of a word.
    constexpr double kAside = 0.25;  // increments
    const double aside = std::fmin(traced.sweep, kTurnRad - traced.sweep) * traced.start_radius;
    if (arc.text_start != arc.text_end && aside < kAside * increment) return kNoAnswer;
    const double begin =
        std::atan2(arc.text_start[1] - traced.center[1], arc.text_start[0] - traced.center[0]);
    const double turn = is_clockwise ? -traced.sweep : traced.sweep;
    const double first = distance(arc.start, center);
    const double last = distance(arc.end, center);
    constexpr int kParts = 24;  // the error is a sine and a line: this finds a percent of it
    double error = 0;
    for (int i = 0; i <= kParts; ++i) {
        const double share = static_cast<double>(i) / kParts;
        const double angle = begin + share * turn;
        const double radius = std::lerp(traced.start_radius, traced.end_radius, share);
        const PlanePoint point = {traced.center[0] + radius * std::cos(angle),
                                  traced.center[1] + radius * std::sin(angle)};
        error =
            std::fmax(error, std::fabs(distance(point, center) - std::lerp(first, last, share)));
    }
    return error;
}

double sweep_angle(const PlanePoint& start, const PlanePoint& end, const PlanePoint& center,
                   bool is_clockwise) {
    constexpr double kNothing =
        1e-9;  // rad; start and end that are the same point but for rounding
    const double from = std::atan2(start[1] - center[1], start[0] - center[0]);
    const double to = std::atan2(end[1] - center[1], end[0] - center[0]);
    double sweep = is_clockwise ? from - to : to - from;
    while (sweep <= kNothing) sweep += kTurnRad;
    while (sweep > kTurnRad + kNothing) sweep -= kTurnRad;
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
    if (apart(points.text_start, points.text_end) > 2 * std::fabs(rounded)) return arc;
    const double moved = apart(*arc.exact, *arc.reached) * std::pow(10.0, places);  // increments
    constexpr double kFairly = 5;
    arc.fits = moved <= 1;
    arc.fits_fairly = moved <= kFairly;
    return arc;
}

}  // namespace kadr::write
