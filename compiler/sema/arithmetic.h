// arithmetic.h — the mathematics of the language, the same for constants and while running.
//
// Angles are degrees and are reduced as degrees, where the reduction is exact; so sin(180deg) is 0
// and cos(60deg) is 0.5, not something near it.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "base/degrees.h"
#include "base/result.h"
#include "sema/code.h"

namespace kadr::sema {

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
