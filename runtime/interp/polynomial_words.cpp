// polynomial_words.cpp — polynomials of the axes become control points.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "base/diagnostics/iso.h"
#include "interp/motion_words.h"
#include "path/linear.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::Slot;
using nc::SlotMask;
using path::ControlPoint;
using path::linear;

namespace {

constexpr AxisMask kLinearXYZ = bit(Axis::X) | bit(Axis::Y) | bit(Axis::Z);
constexpr std::size_t kMostDegree = 5;

/// One more: a line times a denominator of the highest degree.
constexpr std::size_t kTerms = kMostDegree + 2;
/// Coefficients by the powers of a parameter from 0 to 1.
using Terms = std::array<double, kTerms>;

/// The terms from `begin`, through `end`, with the coefficients from the second on as the
/// invocation has them from parameter `first` on.
Terms terms_between(double begin, double end, const Block& block, const Invocation& invocation,
                    std::size_t first, double range) {
    Terms terms{};
    terms[0] = begin;
    terms[1] = end - begin;
    double power = range;
    for (std::size_t k = 2; k <= kMostDegree; ++k) {
        power *= range;
        terms[k] = block.argument(invocation, first + k - 2) * power;
        terms[1] -= terms[k];
    }
    return terms;
}

std::size_t degree_of(const Terms& terms) {
    std::size_t degree = kTerms - 1;
    while (degree > 0 && terms[degree] == 0) --degree;
    return degree;
}

/// (begin + distance·q) times a polynomial.
Terms line_times(double begin, double distance, const Terms& by) {
    Terms product{};
    for (std::size_t k = 0; k < kTerms; ++k)
        product[k] = begin * by[k] + (k > 0 ? distance * by[k - 1] : 0);
    return product;
}

double binomial(std::size_t n, std::size_t k) {
    double value = 1;
    for (std::size_t i = 0; i < k; ++i)
        value = value * static_cast<double>(n - i) / static_cast<double>(i + 1);
    return value;
}

/// Coefficient j of the Bernstein form of a degree.
double bernstein(const Terms& terms, std::size_t degree, std::size_t j) {
    double sum = 0;
    for (std::size_t k = 0; k <= j; ++k) sum += binomial(j, k) / binomial(degree, k) * terms[k];
    return sum;
}

const Invocation* polynomial_of(const Block& block, std::size_t axis) {
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Invocation& invocation = block.functions[i];
        if (invocation.function != Function::PolynomialAxis) continue;
        if (block.argument(invocation, parameter_of<Function::PolynomialAxis>("axis")) ==
            static_cast<double>(axis + 1))
            return &invocation;
    }
    return nullptr;
}

}  // namespace

/// Where the block's polynomials and words lead to; nothing if it was reported.
std::optional<Target> MotionWords::end_of_polynomials(const Block& block) {
    Block places = block;
    for (std::size_t i = 0; i < 3; ++i) {
        const Invocation* const own = polynomial_of(block, i);
        if (own == nullptr) continue;
        const Slot slot = nc::slot_of(static_cast<Axis>(i));
        if (block.has(slot)) {
            reporter_.report(diag::PolynomialTwice, block, slot).arg(nc::slot_name(slot));
            return std::nullopt;
        }
        places.set(slot, block.argument(*own, parameter_of<Function::PolynomialAxis>("end")));
    }
    const SlotMask targets = places.given & nc::kTargetSlots;
    if (const SlotMask others = targets & ~SlotMask{kLinearXYZ};
        others != 0 && view_.is_transformed) {
        const auto other = static_cast<Slot>(std::countr_zero(others));
        reporter_.report(diag::PolynomialBeside, block, other).arg(nc::slot_name(other));
        return std::nullopt;
    }
    if (!require_axes(block, targets) || !require_rotary_approaches(block)) return std::nullopt;
    return target_of(places, targets);
}

/// The control points of the block; nothing if it was reported.
std::optional<MotionWords::Polynomials> MotionWords::polynomials_of(const Block& block) {
    const Invocation* const range_word = block.find(Function::PolynomialRange);
    const double range =
        range_word != nullptr
            ? block.argument(*range_word, parameter_of<Function::PolynomialRange>("range"))
            : 1;
    if (!(range > 0)) {
        reporter_.report(diag::PolynomialRange, block, Function::PolynomialRange).arg(range);
        return std::nullopt;
    }
    const std::optional<Target> target = end_of_polynomials(block);
    if (!target) return std::nullopt;
    const Invocation* const divisor = block.find(Function::PolynomialWeight);
    Terms weight{1};
    if (divisor != nullptr) {
        const double end =
            block.argument(*divisor, parameter_of<Function::PolynomialWeight>("end"));
        weight = terms_between(1, end, block, *divisor,
                               parameter_of<Function::PolynomialWeight>("a2"), range);
    }
    double weight_at_end = 0;
    for (const double term : weight) weight_at_end += term;

    std::array<Terms, 3> axes;
    std::size_t degree = std::max<std::size_t>(1, degree_of(weight));
    for (std::size_t i = 0; i < 3; ++i) {
        const double begin = view_.position.here()[i];
        const double end = target->here[i];
        if (const Invocation* const own = polynomial_of(block, i)) {
            axes[i] = terms_between(begin, end * weight_at_end, block, *own,
                                    parameter_of<Function::PolynomialAxis>("a2"), range);
            const double scale = i == 0 ? x_scale(block, true) : view_.axes.word_scale[i];
            for (std::size_t k = 2; k < kTerms && scale != 1; ++k) {
                axes[i][1] += (1 - scale) * axes[i][k];
                axes[i][k] *= scale;
            }
        } else {
            axes[i] = line_times(begin, end - begin, weight);
        }
        degree = std::max(degree, degree_of(axes[i]));
    }
    if (degree > kMostDegree) {
        reporter_.report(diag::PolynomialDegree, block).arg(static_cast<int>(degree));
        return std::nullopt;
    }
    Polynomials polynomials{*target, std::vector<ControlPoint>(degree + 1)};
    for (std::size_t j = 0; j <= degree; ++j) {
        ControlPoint& control_point = polynomials.control_points[j];
        for (std::size_t i = 0; i < 3; ++i)
            control_point[static_cast<Eigen::Index>(i)] = bernstein(axes[i], degree, j);
        control_point[3] = bernstein(weight, degree, j);
    }
    return polynomials;
}

}  // namespace kadr::interp
