#include "process/scan_field.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include <Eigen/LU>

namespace kadr::process {

namespace {

// A path is never cut finer: a two-thousandth of it, or so many vectors that nobody wants them.
constexpr double kFinest = 1.0 / 65536;
// Points looked at between the ends of a vector that shall stand for a bent path.
constexpr std::size_t kProbes = 7;
constexpr std::size_t kMostProbes = 1024;
// Of the tolerance, what the points that are looked at may take.
constexpr double kOfTolerance = 0.95;
// A point on a path to a millionth of a cell.
constexpr int kHalvings = 20;
// Rounding of frames and of the matrix, mm: no point beyond the field.
constexpr double kRounding = 1e-6;

double least_side(const std::vector<double>& values) {
    double least = values.back() - values.front();
    for (std::size_t i = 1; i < values.size(); ++i)
        least = std::min(least, values[i] - values[i - 1]);
    return least;
}

/// The cell of a value, and how far it is through it; the outermost cells go on beyond the table.
struct CellIndex {
    std::size_t index;
    double share;
};
CellIndex cell_of(const std::vector<double>& values, double value) {
    const auto above = std::upper_bound(values.begin() + 1, values.end() - 1, value);
    const auto index = static_cast<std::size_t>(above - values.begin()) - 1;
    return {index, (value - values[index]) / (values[index + 1] - values[index])};
}

double distance_to_chord(const Vec2& point, const Vec2& from, const Vec2& to) {
    const Vec2 chord = to - from;
    const double square = chord.squaredNorm();
    const double share =
        square > 0 ? std::clamp((point - from).dot(chord) / square, 0.0, 1.0) : 0.0;
    return (point - from - share * chord).norm();
}

}  // namespace

ScanField::ScanField(const machine::Scanner& scanner) : scanner_(scanner) {
    Eigen::Matrix2d matrix;
    matrix << scanner.matrix[0], scanner.matrix[1], scanner.matrix[2], scanner.matrix[3];
    inverse_ = matrix.inverse();
    const machine::FieldGrid& grid = scanner.correction;
    if (!grid.is_empty()) cell_ = std::min(least_side(grid.x), least_side(grid.y));
}

Vec2 ScanField::field_of(const path::Vec3& point, const path::Vec3& stage) const {
    return inverse_ * (point - stage).head<2>();
}

double ScanField::outside(const Vec2& field) const {
    const double beyond = field.cwiseAbs().maxCoeff() - scanner_.half_field;
    return beyond > kRounding ? beyond : 0;
}

Vec2 ScanField::corrected(const Vec2& field) const {
    const machine::FieldGrid& grid = scanner_.correction;
    if (grid.is_empty()) return field;
    const CellIndex x = cell_of(grid.x, field.x());
    const CellIndex y = cell_of(grid.y, field.y());
    const std::size_t row = grid.x.size();
    const std::size_t first = y.index * row + x.index;
    const auto between = [&](const std::vector<double>& values) {
        const double below = std::lerp(values[first], values[first + 1], x.share);
        const double above = std::lerp(values[first + row], values[first + row + 1], x.share);
        return std::lerp(below, above, y.share);
    };
    return field + Vec2(between(grid.dx), between(grid.dy));
}

FieldStep ScanField::at(const StagedCurve& curve, double share) const {
    FieldStep step;
    step.field = field_of(path::position(curve.curve, share * curve.length), curve.stage);
    step.to = corrected(step.field);
    step.share = share;
    return step;
}

FieldStep ScanField::end_of(const path::Curve& curve, const path::Vec3& stage) const {
    return at({curve, stage, path::length(curve)}, 1);
}

std::vector<FieldStep> ScanField::vectors(const path::Curve& curve, const path::Vec3& stage) const {
    const StagedCurve staged{curve, stage, path::length(curve)};
    std::vector<FieldStep> steps;
    if (std::holds_alternative<path::Line>(curve)) {
        cut(staged, 0, 1, steps);
        return steps;
    }
    // A bent path may come back to where it began, or be alike on both sides of its middle.
    constexpr int kFirst = 8;
    for (int i = 0; i < kFirst; ++i)
        cut(staged, static_cast<double>(i) / kFirst, static_cast<double>(i + 1) / kFirst, steps);
    return steps;
}

/// How many points show what a vector would leave out: more where it crosses many cells.
std::size_t ScanField::probes(const StagedCurve& curve, double from, double to) const {
    if (cell_ == 0) return kProbes;
    const double length = (field_of(path::position(curve.curve, to * curve.length), curve.stage) -
                           field_of(path::position(curve.curve, from * curve.length), curve.stage))
                              .norm();
    const double crossed = std::min(2 * length / cell_, static_cast<double>(kMostProbes));
    return std::clamp(static_cast<std::size_t>(std::ceil(crossed)), kProbes, kMostProbes);
}

/// Where a path crosses a line of the table between two points that are no farther apart than a
/// cell: by its share, along X and along Y.
std::vector<double> ScanField::kinks(const StagedCurve& curve, const FieldStep& from,
                                     const FieldStep& to) const {
    std::vector<double> shares;
    const machine::FieldGrid& grid = scanner_.correction;
    if (grid.is_empty()) return shares;
    for (const Eigen::Index axis : {0, 1}) {
        const std::vector<double>& values = axis == 0 ? grid.x : grid.y;
        const auto cell = [&](const FieldStep& step) {
            return cell_of(values, step.field[axis]).index;
        };
        const std::size_t first = cell(from);
        if (first == cell(to)) continue;
        double inside = from.share;
        double beyond = to.share;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = (inside + beyond) / 2;
            (cell(at(curve, middle)) == first ? inside : beyond) = middle;
        }
        shares.push_back(beyond);
    }
    return shares;
}

bool ScanField::is_straight(const StagedCurve& curve, double from, double to) const {
    if (cell_ == 0 && std::holds_alternative<path::Line>(curve.curve)) return true;
    if (to - from <= kFinest) return true;
    const FieldStep start = at(curve, from);
    const FieldStep end = at(curve, to);
    // Between the points that are looked at the path bends by little of what it bends in all.
    const double most = kOfTolerance * scanner_.chord_tolerance;
    const auto is_near = [&](const FieldStep& step) {
        return distance_to_chord(step.to, start.to, end.to) <= most;
    };
    const std::size_t count = probes(curve, from, to);
    FieldStep before = start;
    for (std::size_t i = 1; i <= count + 1; ++i) {
        const double share =
            std::lerp(from, to, static_cast<double>(i) / static_cast<double>(count + 1));
        const FieldStep step = i > count ? end : at(curve, share);
        if (!is_near(step)) return false;
        // A path has a kink where it comes into another cell.
        for (const double kink : kinks(curve, before, step))
            if (!is_near(at(curve, kink))) return false;
        before = step;
    }
    return true;
}

void ScanField::cut(const StagedCurve& curve, double from, double to,
                    std::vector<FieldStep>& out) const {
    if (is_straight(curve, from, to)) {
        out.push_back(at(curve, to));
        return;
    }
    const double middle = (from + to) / 2;
    cut(curve, from, middle, out);
    cut(curve, middle, to, out);
}

}  // namespace kadr::process
