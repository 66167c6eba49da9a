#include "sema/arithmetic.h"

#include <algorithm>

namespace kadr::sema {

namespace {

/// The C library's root may miss by a bit in the last place, also that of a cube.
double cube_root(double a) {
    const double root = std::cbrt(a);
    const double whole = std::round(root);
    return whole * whole * whole == a ? whole : root;
}

double tan_deg(double angle_deg) {
    const detail::Reduced r = detail::reduce(angle_deg);
    if (std::fabs(r.angle) == 45.0) return (r.angle < 0) != ((r.quarter & 1u) != 0) ? -1.0 : 1.0;
    const double t = std::tan(r.angle * kRadPerDeg);
    return (r.quarter & 1u) != 0 ? -1.0 / t : t;
}

/// An inverse function gives back the angles whose sine or cosine is exact.
double exact_angle(double angle_deg) {
    const double whole = std::nearbyint(angle_deg / 15.0) * 15.0;
    return std::fabs(angle_deg - whole) < 1e-13 * std::max(1.0, std::fabs(whole)) ? whole
                                                                                  : angle_deg;
}

MathResult finite(double value) {
    if (!std::isfinite(value)) return MathFault::Overflow;
    return value;
}

MathResult power(double a, double b) {
    if (a == 0 && b < 0) return MathFault::DivisionByZero;
    const double value = std::pow(a, b);
    if (std::isnan(value)) return MathFault::NoPower;
    return finite(value);
}

}  // namespace

const char* describe(MathFault fault) {
    switch (fault) {
        case MathFault::DivisionByZero: return "division by zero";
        case MathFault::NegativeRoot: return "the square root of a negative number";
        case MathFault::OutOfRange: return "the argument of an arc function is outside of -1 to 1";
        case MathFault::NoTangent: return "the tangent of a right angle";
        case MathFault::NotPositive: return "the logarithm of a number that is not positive";
        case MathFault::Overflow: return "the result is too large for a number";
        case MathFault::NoPower: return "a fractional power of a negative number";
    }
    return "";
}

MathResult evaluate(Math function, double a) {
    switch (function) {
        case Math::Abs: return std::fabs(a);
        case Math::Sign: return a > 0 ? 1.0 : a < 0 ? -1.0 : 0.0;
        case Math::TanDeg: {
            const detail::Reduced r = detail::reduce(a);
            if (r.angle == 0 && (r.quarter & 1u) != 0) return MathFault::NoTangent;
            return tan_deg(a);
        }
        case Math::AsinDeg:
        case Math::AcosDeg:
            if (!(a >= -1 && a <= 1)) return MathFault::OutOfRange;
            return exact_angle((function == Math::AsinDeg ? std::asin(a) : std::acos(a)) /
                               kRadPerDeg);
        case Math::AtanDeg: return exact_angle(std::atan(a) / kRadPerDeg);
        case Math::Exp: return finite(std::exp(a));
        case Math::Ln:
        case Math::Log10:
            if (!(a > 0)) return MathFault::NotPositive;
            return function == Math::Ln ? std::log(a) : std::log10(a);
        case Math::Cbrt: return cube_root(a);
        case Math::Pow:
        case Math::Atan2Deg:
        case Math::Hypot:
        case Math::Min:
        case Math::Max: break;
    }
    return a;
}

MathResult evaluate(Math function, double a, double b) {
    switch (function) {
        case Math::Pow: return power(a, b);
        case Math::Atan2Deg: return exact_angle(std::atan2(a, b) / kRadPerDeg);
        case Math::Hypot: return finite(std::hypot(a, b));
        case Math::Min: return std::min(a, b);
        case Math::Max: return std::max(a, b);
        case Math::Abs:
        case Math::Sign:
        case Math::TanDeg:
        case Math::AsinDeg:
        case Math::AcosDeg:
        case Math::AtanDeg:
        case Math::Exp:
        case Math::Ln:
        case Math::Log10:
        case Math::Cbrt: break;
    }
    return a;
}

double round_to_unit(double value, Rounding rounding, double unit) {
    const double scaled = value / unit;
    switch (rounding) {
        case Rounding::Trunc: return std::trunc(scaled) * unit;
        case Rounding::Floor: return std::floor(scaled) * unit;
        case Rounding::Ceil: return std::ceil(scaled) * unit;
        case Rounding::Round: return std::round(scaled) * unit;
    }
    return value;
}

double slope(Math function, double a, double da) {
    if (da == 0) return 0;  // also where the function itself is vertical
    switch (function) {
        case Math::Abs: return a < 0 ? -da : da;
        case Math::Sign: return 0;
        case Math::TanDeg: {
            const double c = cos_deg(a);
            return da * kRadPerDeg / (c * c);
        }
        case Math::AsinDeg: return da / kRadPerDeg / std::sqrt((1 - a) * (1 + a));
        case Math::AcosDeg: return -da / kRadPerDeg / std::sqrt((1 - a) * (1 + a));
        case Math::AtanDeg: return da / kRadPerDeg / (1 + a * a);
        case Math::Exp: return da * std::exp(a);
        case Math::Ln: return da / a;
        case Math::Log10: return da / (a * std::log(10.0));
        case Math::Cbrt: {
            const double root = std::cbrt(a);
            return da / (3 * root * root);
        }
        case Math::Pow:
        case Math::Atan2Deg:
        case Math::Hypot:
        case Math::Min:
        case Math::Max: break;
    }
    return 0;
}

double slope(Math function, double a, double b, double da, double db) {
    if (da == 0 && db == 0) return 0;
    switch (function) {
        case Math::Pow: {
            const double by_base = da == 0 || b == 0 ? 0 : da * b * std::pow(a, b - 1);
            const double by_exponent = db == 0 || a <= 0 ? 0 : db * std::pow(a, b) * std::log(a);
            return by_base + by_exponent;
        }
        case Math::Atan2Deg: return (b * da - a * db) / (a * a + b * b) / kRadPerDeg;
        case Math::Hypot: return (a * da + b * db) / std::hypot(a, b);
        case Math::Min: return b < a ? db : da;
        case Math::Max: return a < b ? db : da;
        case Math::Abs:
        case Math::Sign:
        case Math::TanDeg:
        case Math::AsinDeg:
        case Math::AcosDeg:
        case Math::AtanDeg:
        case Math::Exp:
        case Math::Ln:
        case Math::Log10:
        case Math::Cbrt: break;
    }
    return 0;
}

std::optional<std::int64_t> to_integer(double value, Rounding rounding) {
    const double whole = round_to_unit(value, rounding, 1.0);
    // 2^63 itself does not fit; NaN fails both comparisons.
    if (!(whole >= -9223372036854775808.0 && whole < 9223372036854775808.0)) return std::nullopt;
    return static_cast<std::int64_t>(whole);
}

}  // namespace kadr::sema
