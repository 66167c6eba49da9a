// clothoid.cpp — a transition curve: its curvature changes evenly along it.
//
// Between a line and an arc the curvature jumps, and with it the acceleration across the path; a
// piece of clothoid lets it grow. In the working plane, from where the tool stands:
//
//     θ(u) = direction + from·u + (to − from)·u²/(2·length)     the angle of travel after the way u
//     C(u) = ∫ (cos θ, sin θ) du
//
// Everything that Kadr needs to know of a kind of curve is in this file.
#include <algorithm>
#include <cmath>
#include <string>

#include "path/curve_registry.h"
#include "path/quadrature.h"

namespace {

using namespace kadr;

// What the law keeps in its numbers.
enum Number : std::size_t { kDirection, kFrom, kChange };

double angle(const path::CurveNumbers& numbers, double u) {
    return numbers[kDirection] + (numbers[kFrom] + 0.5 * numbers[kChange] * u) * u;
}

/// The integral of f from 0 to u, in parts on which the angle turns by half a radian at most: there
/// the rule of five points is exact to rounding.
template <typename Function>
double integral(const path::CurveNumbers& numbers, double u, const Function& f) {
    const double curvature =
        std::max(std::abs(numbers[kFrom]), std::abs(numbers[kFrom] + numbers[kChange] * u));
    const int parts = 1 + static_cast<int>(2 * curvature * u);
    double sum = 0;
    for (int i = 0; i < parts; ++i) sum += path::gauss(f, u * i / parts, u * (i + 1) / parts);
    return sum;
}

path::SplinePoint at(const path::CurveNumbers& numbers, double u) {
    const double theta = angle(numbers, u);
    const double curvature = numbers[kFrom] + numbers[kChange] * u;
    const path::Vec3 along(std::cos(theta), std::sin(theta), 0);
    const path::Vec3 left(-along.y(), along.x(), 0);
    const double x = integral(numbers, u, [&](double v) { return std::cos(angle(numbers, v)); });
    const double y = integral(numbers, u, [&](double v) { return std::sin(angle(numbers, v)); });
    return {{x, y, 0}, along, curvature * left};
}

/// direction  rad, of travel at the start
/// from, to   1/mm, curvature at the start and at the end; to the left above zero
/// length     mm
Result<path::CurveLaw, std::string> make(path::CurveArguments arguments) {
    constexpr double kMostTurn = 1000;  // rad; more is a slip of the pen
    if (arguments.size() != 4 ||
        !std::ranges::all_of(arguments, [](const auto& given) { return given.has_value(); }))
        return std::string("it needs direction, curvature at the start and at the end, length");
    const double length = *arguments[3];
    if (!(length > 0)) return std::string("its length is not above zero");
    const double from = *arguments[1];
    const double to = *arguments[2];
    if (std::max(std::abs(from), std::abs(to)) * length > kMostTurn)
        return std::string("it would turn by more than 1000 radians");
    path::CurveLaw law;
    law.numbers[kDirection] = *arguments[0];
    law.numbers[kFrom] = from;
    law.numbers[kChange] = (to - from) / length;
    law.to = length;
    return law;
}

constexpr path::CurveKind kClothoid = {"clothoid", make, at};
const path::CurveRegistration kRegistered(kClothoid);

}  // namespace
