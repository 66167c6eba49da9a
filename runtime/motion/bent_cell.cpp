#include "motion/bent_cell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/assert.h"

namespace kadr::motion {

namespace {

using path::Vec3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// By so much of p and c·v², in parts of the greatest, may the middle of a cell differ from the mean
// of its ends: 9 degrees of an arc.
constexpr double kUneven = 0.0032;
// What the limits leave for that, times the difference: once for p, once for c, and four times for
// c·v², the product of two that are linear (on an arc of δ degrees the differences are δ²/8, and
// the product is off by δ·δ/2 of the acceleration at most).
constexpr double kReserve = 6;
// Where one axis is by far weaker than another, not more than half of it.
constexpr double kLeastRoom = 0.5;

// Of an acceleration: borders that are parallel, or only touched, must not cut by their rounding.
constexpr double kRounding = 1e-10;

/// a·x + b·y ≤ 1 with the squared speeds x at the entry and y at the exit.
struct HalfPlane {
    double a = 0;
    double b = 0;
};
struct HalfPlanes {
    std::array<HalfPlane, 4 * kAxes + 2> planes;
    std::size_t count = 0;

    /// −1 ≤ a·x + b·y ≤ 1
    void add(double a, double b) {
        planes[count++] = {a, b};
        planes[count++] = {-a, -b};
    }
    const HalfPlane* begin() const { return planes.data(); }
    const HalfPlane* end() const { return planes.data() + count; }
};

HalfPlanes planes_of(const BentCell& cell) {
    HalfPlanes planes;
    const double h = 0.5 / cell.length;
    const BentCell::End& entry = cell.entry;
    const BentCell::End& exit = cell.exit;
    for (std::size_t i = 0; i < kAxes; ++i) {
        const double into = h * entry.along[i];
        const double out = h * exit.along[i];
        if (into != 0 || entry.across[i] != 0) planes.add(entry.across[i] - into, into);
        if (out != 0 || exit.across[i] != 0) planes.add(-out, exit.across[i] + out);
    }
    planes.add(-h / cell.acceleration, h / cell.acceleration);
    return planes;
}

/// A stretch of a line of points, by its parameter.
struct Interval {
    double low = -kInfinity;
    double high = kInfinity;

    /// slope·t ≤ most
    void cut(double slope, double most) {
        if (slope > 0) high = std::min(high, most / slope);
        if (slope < 0) low = std::max(low, most / slope);
    }
};

// Where a curve is held against the straight line between its ends: in the middle, and where no
// whole number of turns shows the same.
constexpr std::array<double, 2> kInside{0.5, 0.30901699437494742};

/// A curvature that takes no more than the weakest axis has, even at the greatest speed.
double slight_curvature(const LinearLimits& limits, double speed) {
    const double most = std::min(speed, limits.velocity.norm());
    return limits.acceleration.minCoeff() / (most * most);
}

/// How much p and c inside differ from the straight line between the ends, in parts of the
/// greatest; of curvatures below a slight one in parts of that.
struct Evenness {
    path::CurvePoint first;
    path::CurvePoint last;
    double difference = 0;

    Evenness(const path::Curve& curve, double from, double to, double slight)
        : first(path::evaluate(curve, from)), last(path::evaluate(curve, to)) {
        const double bend = std::max({first.curvature.norm(), last.curvature.norm(), slight});
        for (const double share : kInside) {
            const path::CurvePoint inside = path::evaluate(curve, from + share * (to - from));
            const auto miss = [share](const Vec3& a, const Vec3& b, const Vec3& at) {
                return (at - (1 - share) * a - share * b).norm();
            };
            difference = std::max({difference, miss(first.tangent, last.tangent, inside.tangent),
                                   miss(first.curvature, last.curvature, inside.curvature) /
                                       std::max(bend, inside.curvature.norm())});
        }
    }
};

class Bounds {
  public:
    Bounds(const path::Curve& curve, double slight, double least)
        : curve_(curve), slight_(slight), least_(least) {}

    /// Appends the ends of the parts from here to there, without the start.
    void cut(double from, double to) {
        const bool is_short = to - from < 2 * least_;
        if (is_short || Evenness(curve_, from, to, slight_).difference <= kUneven) {
            ends.push_back(to);
            return;
        }
        cut(from, (from + to) / 2);
        cut((from + to) / 2, to);
    }

    std::vector<double> ends = {0};

  private:
    const path::Curve& curve_;
    double slight_;
    double least_;
};

}  // namespace

std::vector<double> cell_bounds(const path::Curve& curve, double length, const LinearLimits& limits,
                                const CellWishes& wishes) {
    Bounds bounds(curve, slight_curvature(limits, wishes.speed), wishes.least);
    bounds.cut(0, length);
    return std::move(bounds.ends);
}

std::optional<BentCell> cell_of(const path::Curve& part, double length, const LinearLimits& limits,
                                double speed) {
    const auto [first, last, difference] =
        Evenness(part, 0, length, slight_curvature(limits, speed));
    if (difference > kUneven * (1 + 1e-6)) return std::nullopt;
    BentCell cell;
    cell.length = length;
    cell.speed = speed;
    cell.acceleration = kInfinity;
    double strongest = 0;
    for (const double limit : limits.acceleration) {
        if (std::isfinite(limit)) strongest = std::max(strongest, limit);
    }
    for (int i = 0; i < 3; ++i) {
        const auto axis = static_cast<std::size_t>(i);
        const double most = limits.acceleration[i];
        const double room = std::max(kLeastRoom, 1 - kReserve * difference * strongest / most);
        const double share = 1 / (room * most);
        cell.entry.along[axis] = first.tangent[i] * share;
        cell.exit.along[axis] = last.tangent[i] * share;
        cell.entry.across[axis] = first.curvature[i] * share;
        cell.exit.across[axis] = last.curvature[i] * share;
        const double rate =
            std::max(std::abs(first.tangent[i]), std::abs(last.tangent[i])) + 2 * difference;
        if (rate * cell.speed > limits.velocity[i]) cell.speed = limits.velocity[i] / rate;
    }
    return cell;
}

namespace {

/// With so much acceleration along a cell it can be run from rest to rest.
double resting_acceleration(const BentCell& cell) {
    // In the middle v² = a·length; p and c are taken where they are greatest.
    return 1 /
           std::max(1 / cell.acceleration, std::ranges::max(greatest_load(cell, 1, cell.length)));
}

}  // namespace

Profile profile_over(const BentCell& cell, double entry, double exit) {
    if (entry == 0 && exit == 0) {
        const double a = resting_acceleration(cell);
        const auto profile = trapezoid(cell.length, 0, 0, {cell.speed, a, a});
        KADR_ASSERT(profile.has_value(), "from rest to rest there is always a profile");
        return *profile;
    }
    Profile profile;
    profile.length = cell.length;
    profile.entry_speed = entry;
    profile.exit_speed = exit;
    profile.peak_speed = std::max(entry, exit);
    const double time = 2 * cell.length / (entry + exit);
    if (exit > entry) {
        profile.accelerating = time;
        profile.acceleration = (exit - entry) / time;
    } else if (exit < entry) {
        profile.braking = time;
        profile.deceleration = (entry - exit) / time;
    } else {
        profile.cruising = time;
    }
    return profile;
}

/// Seidel's algorithm: the half-planes come one by one, and where the best point so far is cut off,
/// the best one lies on the new border.
double entry_square(const BentCell& cell, double entry_most, double exit_most) {
    const HalfPlanes halves = planes_of(cell);
    const auto& planes = halves.planes;
    entry_most = std::min(entry_most, cell.entry.speed * cell.entry.speed);
    exit_most = std::min(exit_most, cell.exit.speed * cell.exit.speed);
    double x = entry_most;
    double y = exit_most;
    for (std::size_t i = 0; i < halves.count; ++i) {
        const auto [a, b] = planes[i];
        if (a * x + b * y <= 1 + kRounding) continue;
        // Points of the border: (a, b)/(a² + b²) + t·(−b, a).
        const double square = a * a + b * b;
        const double x0 = a / square;
        const double y0 = b / square;
        Interval range;
        range.cut(b, x0);
        range.cut(-b, entry_most - x0);
        range.cut(-a, y0);
        range.cut(a, exit_most - y0);
        for (std::size_t j = 0; j < i; ++j) {
            const auto [c, d] = planes[j];
            range.cut(d * a - c * b, 1 + kRounding - c * x0 - d * y0);
        }
        const double t = b < 0 ? range.high : range.low;
        x = x0 - b * t;
        y = y0 + a * t;
    }
    return std::clamp(x, 0.0, entry_most);
}

double exit_square(const BentCell& cell, double entry, double exit_most) {
    // There is an exit speed for this entry speed, so the greatest is where a border falls.
    Interval range{0, std::min(exit_most, cell.exit.speed * cell.exit.speed)};
    for (const auto& [a, b] : planes_of(cell)) range.cut(b, 1 + kRounding - a * entry);
    return std::max(0.0, range.high);
}

AxisValues load_between(const BentCell& cell, double entry_speed, double exit_speed) {
    const double entry = entry_speed * entry_speed;
    const double exit = exit_speed * exit_speed;
    const double a = (exit - entry) / (2 * cell.length);
    AxisValues loads{};
    for (std::size_t i = 0; i < kAxes; ++i) {
        const double into = cell.entry.along[i] * a + cell.entry.across[i] * entry;
        const double out = cell.exit.along[i] * a + cell.exit.across[i] * exit;
        loads[i] = std::max(std::abs(into), std::abs(out));
    }
    return loads;
}

AxisValues greatest_load(const BentCell& cell, double acceleration, double square) {
    AxisValues loads{};
    for (const BentCell::End* end : {&cell.entry, &cell.exit}) {
        for (std::size_t i = 0; i < kAxes; ++i) {
            const double load =
                acceleration * std::abs(end->along[i]) + square * std::abs(end->across[i]);
            loads[i] = std::max(loads[i], load);
        }
    }
    return loads;
}

}  // namespace kadr::motion
