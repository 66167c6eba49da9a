// origins.cpp — numbers whose origin shows that they are meant otherwise: radians that become
// degrees, ratios that become lengths.
//
// Both are right by the rules (a bare number takes the dimension that is wanted there) and wrong in
// the part. The origin goes along with a value through products, quotients, sums and variables.
#include "sema/origins.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/diagnostics/sema.h"
#include "sema/checking.h"
#include "sema/values.h"

namespace kadr::sema {

using syntax::Operator;

namespace {

constexpr double kPi = 3.14159265358979323846;

/// Decimals of a literal: `3.1416` has four. With an exponent nobody writes a part of pi.
int decimals_of(std::string_view literal) {
    const std::size_t point = literal.find('.');
    if (point == std::string_view::npos || literal.find_first_of("eE") != std::string_view::npos)
        return 0;
    return static_cast<int>(literal.size() - point - 1);
}

/// Whether the literal is this number, rounded or cut off at its last decimal.
bool is_written(double literal, int decimals, double number) {
    const double step = std::pow(10.0, -decimals);
    const double low = std::floor(number / step + 1e-9) * step;
    const double near = std::round(number / step) * step;
    return std::min(std::abs(literal - low), std::abs(literal - near)) < 1e-3 * step;
}

}  // namespace

/// A number as it stands in the program: `3.14159` and `0.7854` are angles in radians, as `pi/4`.
/// With fewer than four decimals it may be anything.
Origin origin_of_literal(double number, std::string_view literal) {
    constexpr int kLeast = 4;
    constexpr std::array kRadians = {kPi / 6,     kPi / 4,     kPi / 3, kPi / 2,     2 * kPi / 3,
                                     3 * kPi / 4, 5 * kPi / 6, kPi,     3 * kPi / 2, 2 * kPi};
    const int decimals = decimals_of(literal);
    if (decimals < kLeast) return Origin::Any;
    const auto is = [&](double wanted) { return is_written(number, decimals, wanted); };
    if (std::ranges::any_of(kRadians, is) || (decimals > kLeast && is(kPi / 180)))
        return Origin::Radians;
    return is(180 / kPi) ? Origin::PerRadian : Origin::Any;
}

Origin origin_of_result(const Check& check, Operator op, const Value& left, const Value& right) {
    const auto either = [&](Origin origin) {
        return left.origin == origin || right.origin == origin;
    };
    // Times 180 or 360 nothing is in radians any more.
    const auto is_half_turns = [&check](const Value& value) {
        const std::optional<double> number =
            value.is_constant() ? number_of(check, value) : std::nullopt;
        return number == 180.0 || number == 360.0;
    };
    switch (op) {
        case Operator::Multiply:
            if (is_half_turns(left) || is_half_turns(right)) return Origin::Any;
            if (either(Origin::Radians) && either(Origin::PerRadian)) return Origin::Any;
            return either(Origin::Radians)     ? Origin::Radians
                   : either(Origin::PerRadian) ? Origin::PerRadian
                                               : Origin::Any;
        case Operator::Divide: {
            if (left.origin == Origin::Radians)
                return right.origin == Origin::Radians ? Origin::Any : Origin::Radians;
            if (right.origin == Origin::Radians) return Origin::PerRadian;
            const TypeInfo& a = check.type_info(left.type);
            const TypeInfo& b = check.type_info(right.type);
            const bool is_ratio = a.kind == TypeKind::Real && b.kind == TypeKind::Real &&
                                  a.quantity == b.quantity && !a.quantity.is_number() &&
                                  !right.is_constant();  // `a/1mm` makes a number on purpose
            return is_ratio ? Origin::Ratio : Origin::Any;
        }
        case Operator::Add:
        case Operator::Subtract: return either(Origin::Radians) ? Origin::Radians : Origin::Any;
        default: return Origin::Any;
    }
}

/// A bare number is about to take the dimension that is wanted.
void warn_of_origin(Check& check, const Value& value, Type target, const SourceRange& range) {
    const TypeInfo& to = check.type_info(target);
    const bool is_angle = to.kind == TypeKind::Real && to.quantity == kAngle;
    if (value.origin == Origin::Radians && is_angle) {
        check.report(diag::RadiansAsDegrees, range)
            .fix("say that it is in radians: `(" + std::string(check.sources.text(range)) +
                 ")*1rad`");
    } else if (value.origin == Origin::Ratio && !is_angle) {  // 360*w/h is one on purpose
        check.report(diag::RatioAsQuantity, range).arg(check.type_name(target));
    }
}

}  // namespace kadr::sema
