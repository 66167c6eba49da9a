#include "motion/transformed_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace kadr::motion {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Where p and c are held against the straight line between the ends.
constexpr std::array<double, 3> kInside{0.25, 0.5, 0.75};
// Between two such points a difference may be greater by so much.
constexpr double kBetween = 1.15;
// Of an axis' acceleration, the most that may be kept back, and what is none.
constexpr double kMostKept = 0.006;
constexpr double kLeastKept = 1e-9;
// … and beside it, for the error of the polynomial itself.
constexpr double kCourseKept = 0.002;
// p of an axis whose velocity limits the path may differ by so much between the ends, and the speed
// between them be above what holds on the whole cell.
constexpr double kEvenRate = 1.12;
constexpr double kMostAbove = 1.15;
// While the path slows down it may bend more than at an even speed: so often the square of that
// speed.
constexpr double kMostSquare = 4;

// What an axis may need for the bend, in parts of its acceleration, and by how much its p may
// differ between the ends, before a part is better a cell: a cell has one acceleration, other
// pieces may speed up and brake.
constexpr double kSlightBend = 0.02;
constexpr double kSlightRate = 1.01;
// A ramp to the speed of a cell takes so many of them at least.
constexpr double kCellsOfRamp = 6;

/// An axis on a cell.
struct AxisView {
    double entry_rate = 0;
    double exit_rate = 0;
    double entry_bend = 0;
    double exit_bend = 0;
    double rate_miss = 0;  // greatest differences from the straight lines between these
    double bend_miss = 0;

    AxisView(const AxisPolynomials& polynomials, std::size_t axis)
        : entry_rate(polynomials.rate(axis, 0)),
          exit_rate(polynomials.rate(axis, 1)),
          entry_bend(polynomials.bend(axis, 0)),
          exit_bend(polynomials.bend(axis, 1)) {
        for (const double u : kInside) {
            const auto miss = [u](double from, double to, double at) {
                return kBetween * std::abs(at - (1 - u) * from - u * to);
            };
            rate_miss = std::max(rate_miss, miss(entry_rate, exit_rate, polynomials.rate(axis, u)));
            bend_miss = std::max(bend_miss, miss(entry_bend, exit_bend, polynomials.bend(axis, u)));
        }
    }

    double most_rate() const {
        return std::max(std::abs(entry_rate), std::abs(exit_rate)) + rate_miss;
    }
    double least_rate() const { return std::min(std::abs(entry_rate), std::abs(exit_rate)); }
    double most_bend() const {
        return std::max(std::abs(entry_bend), std::abs(exit_bend)) + bend_miss;
    }
};

using Views = std::vector<AxisView>;  // of the logical axes

Views views_of(const AxisPolynomials& polynomials) {
    Views views;
    for (std::size_t i = 0; i < kAxes; ++i) views.emplace_back(polynomials, i);
    return views;
}

/// v² is linear and p nearly is: with p in the ratio r at the ends, and the velocity of the axis at
/// its limit at both, it is greater between them by up to (1 + r)/2·sqrt((1 + r⁻²)/2).
double excess_between(double ratio) {
    return (1 + ratio) / 2 * std::sqrt((1 + 1 / (ratio * ratio)) / 2);
}

/// Speeds by the velocities of the axes, at the ends and between them; false if the cell is too
/// long for that.
bool take_velocities(const Views& views, const AxisBounds& bounds, BentCell& cell) {
    double even = cell.speed;  // that would hold on the whole cell
    for (std::size_t i = 0; i < kAxes; ++i) {
        if (views[i].most_rate() * even > bounds.velocity[i])
            even = bounds.velocity[i] / views[i].most_rate();
    }
    for (std::size_t i = 0; i < kAxes; ++i) {
        const AxisView& view = views[i];
        const double velocity = bounds.velocity[i];
        if (!(view.most_rate() * kMostAbove * even > velocity)) continue;
        const double ratio = view.most_rate() / view.least_rate();
        if (!(ratio < kEvenRate)) return false;
        const double most =
            velocity / (excess_between(ratio) * (1 + view.rate_miss / view.most_rate()));
        cell.entry.speed = std::min(cell.entry.speed, most / std::abs(view.entry_rate));
        cell.exit.speed = std::min(cell.exit.speed, most / std::abs(view.exit_rate));
    }
    cell.speed = std::min(cell.speed, kMostAbove * even);
    return true;
}

/// The most that can be asked for on a cell.
struct CellExtremes {
    double square = kInfinity;        // of the speed
    double acceleration = kInfinity;  // along the path, which is the same at both ends
};

CellExtremes extremes_of(const Views& views, const AxisBounds& bounds, double speed) {
    CellExtremes most{speed * speed, kInfinity};
    for (std::size_t i = 0; i < kAxes; ++i) {
        const double bend = views[i].most_bend();
        if (bend * most.square > kMostSquare * bounds.acceleration[i])
            most.square = kMostSquare * bounds.acceleration[i] / bend;
    }
    for (std::size_t i = 0; i < kAxes; ++i) {
        const double limit = bounds.acceleration[i];
        const auto take = [&](double rate, double bend) {
            const double all = limit + std::abs(bend) * most.square;
            if (std::abs(rate) * most.acceleration > all) most.acceleration = all / std::abs(rate);
        };
        if (std::isinf(limit)) continue;
        take(views[i].entry_rate, views[i].entry_bend);
        take(views[i].exit_rate, views[i].exit_bend);
    }
    return most;
}

/// What of an axis' acceleration the differences from straight lines may take.
///
/// source  p·a + c·v², and c·v² of two that are linear: a quarter of the product of their changes
double kept_back(const AxisView& view, const CellExtremes& most, double length) {
    const double bend_change = std::abs(view.exit_bend - view.entry_bend);
    const double square_change = std::min(most.square, 2 * most.acceleration * length);
    const double of_rate = view.rate_miss > 0 ? view.rate_miss * most.acceleration : 0;
    const double of_bend = view.bend_miss > 0 ? view.bend_miss * most.square : 0;
    return of_rate + of_bend + (bend_change > 0 ? bend_change * square_change / 4 : 0);
}

/// Whether one speed and one acceleration suit the part as well as a cell does.
bool is_nearly_straight(const Views& views, const AxisBounds& bounds, double speed) {
    for (std::size_t i = 0; i < kAxes; ++i) {
        if (views[i].most_rate() * speed > bounds.velocity[i])
            speed = bounds.velocity[i] / views[i].most_rate();
    }
    for (std::size_t i = 0; i < kAxes; ++i) {
        const AxisView& view = views[i];
        if (view.most_bend() > 0 &&
            !(view.most_bend() * speed * speed < kSlightBend * bounds.acceleration[i]))
            return false;
        if (view.most_rate() * kSlightRate * speed > bounds.velocity[i] &&
            view.most_rate() > kSlightRate * view.least_rate())
            return false;
    }
    return true;
}

}  // namespace

bool is_nearly_straight(const AxisPolynomials& polynomials, const AxisBounds& bounds,
                        double speed) {
    return is_nearly_straight(views_of(polynomials), bounds, speed);
}

std::optional<BentCell> cell_on(const AxisPolynomials& polynomials, const AxisBounds& bounds,
                                double speed) {
    const Views views = views_of(polynomials);
    if (is_nearly_straight(views, bounds, speed)) return std::nullopt;
    BentCell cell;
    cell.length = polynomials.length();
    cell.speed = speed;
    cell.acceleration = kInfinity;
    if (!take_velocities(views, bounds, cell)) return std::nullopt;
    const CellExtremes most = extremes_of(views, bounds, cell.speed);
    cell.speed = std::min(cell.speed, std::sqrt(most.square));
    if (2 * kCellsOfRamp * most.acceleration * cell.length > cell.speed * cell.speed)
        return std::nullopt;
    for (std::size_t i = 0; i < kAxes; ++i) {
        const AxisView& view = views[i];
        const double limit = bounds.acceleration[i];
        if (std::isinf(limit)) continue;
        const double kept = kept_back(view, most, cell.length) / limit;
        if (!(kept <= kMostKept)) return std::nullopt;
        const double share = 1 / (limit * (kept > kLeastKept ? 1 - kept - kCourseKept : 1));
        cell.entry.along[i] = view.entry_rate * share;
        cell.exit.along[i] = view.exit_rate * share;
        cell.entry.across[i] = view.entry_bend * share;
        cell.exit.across[i] = view.exit_bend * share;
    }
    return cell;
}

}  // namespace kadr::motion
