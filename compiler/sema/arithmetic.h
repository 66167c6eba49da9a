// arithmetic.h — the mathematics of the language, the same for constants and while running.
//
// Angles are degrees and are reduced as degrees, where the reduction is exact; so sin(180deg) is 0
// and cos(60deg) is 0.5, not something near it.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "base/result.h"
#include "sema/code.h"

namespace kadr::sema {

inline constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

namespace detail {

struct Reduced {
    double angle;      // degrees, -45 to 45
    unsigned quarter;  // how many right angles were taken off, 0 to 3
};

/// Takes right angles off. Exact: `quarter·90` and the difference are multiples of the last bit of
/// the angle and no larger than it.
inline Reduced reduce(double angle_deg) {
    if (!(std::fabs(angle_deg) < 1e15)) {
        angle_deg = std::fmod(angle_deg, 360.0);
        if (std::isnan(angle_deg)) return {angle_deg, 0};  // it was infinite, or no number before
    }
    const auto turns =
        static_cast<std::int64_t>(angle_deg * (1.0 / 90.0) + (angle_deg < 0 ? -0.5 : 0.5));
    return {angle_deg - static_cast<double>(turns) * 90.0, static_cast<unsigned>(turns) & 3u};
}

inline double sin_small(double angle_deg) {
    if (std::fabs(angle_deg) == 30.0) return angle_deg < 0 ? -0.5 : 0.5;
    return std::sin(angle_deg * kRadPerDeg);
}

inline double cos_small(double angle_deg) {
    // sin and cos of 45° are the same number.
    if (std::fabs(angle_deg) == 45.0) return std::sin(45.0 * kRadPerDeg);
    return std::cos(angle_deg * kRadPerDeg);
}

}  // namespace detail

/// Sine and cosine of degrees; exact at multiples of 30° where the result is a fraction.
inline double sin_deg(double angle_deg) {
    const detail::Reduced r = detail::reduce(angle_deg);
    switch (r.quarter) {
        case 0: return detail::sin_small(r.angle);
        case 1: return detail::cos_small(r.angle);
        case 2: return -detail::sin_small(r.angle);
        default: return -detail::cos_small(r.angle);
    }
}
inline double cos_deg(double angle_deg) {
    const detail::Reduced r = detail::reduce(angle_deg);
    switch (r.quarter) {
        case 0: return detail::cos_small(r.angle);
        case 1: return -detail::sin_small(r.angle);
        case 2: return -detail::cos_small(r.angle);
        default: return detail::sin_small(r.angle);
    }
}

/// Why a calculation has no answer.
enum class MathFault : std::uint8_t {
    DivisionByZero,
    NegativeRoot,
    OutOfRange,
    NoTangent,
    NotPositive,
    Overflow,
    NoPower,
};
/// For a message: "division by zero", "the root of a negative number" …
const char* describe(MathFault fault);

using MathResult = Result<double, MathFault>;
MathResult evaluate(Math function, double a);
MathResult evaluate(Math function, double a, double b);

/// How the value of a function changes when its arguments change by `da`, `db`: the derivative that
/// goes with `evaluate`. Where there is none (the ends of asin, the root of 0) it is not finite.
double slope(Math function, double a, double da);
double slope(Math function, double a, double b, double da, double db);

/// A whole number, or nothing if it does not fit in 64 bits.
std::optional<std::int64_t> to_integer(double value, Rounding rounding);
/// Rounds to a multiple of `unit`.
double round_to_unit(double value, Rounding rounding, double unit);

/// The amount of a whole number; nothing for the least one, whose amount is beyond 64 bits.
constexpr std::optional<std::int64_t> magnitude(std::int64_t a) {
    if (a == INT64_MIN) return std::nullopt;
    return a < 0 ? -a : a;
}

/// The remainder with the sign of the dividend, as in C. `b` is not zero.
constexpr std::int64_t remainder(std::int64_t a, std::int64_t b) { return b == -1 ? 0 : a % b; }

}  // namespace kadr::sema
