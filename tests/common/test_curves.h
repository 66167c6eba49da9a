// test_curves.h — registered kinds of curve whose lengths and shapes are known.
#pragma once

#include <cmath>
#include <string>

#include "path/curve_registry.h"

namespace kadr::testing {

/// A circle of radius r that begins in travel along x and is walked unevenly: the angle is
/// u + sin(u)/2, so that parameter and arc length differ.
inline constexpr path::CurveKind kUnevenCircle = {
    "uneven_circle",
    [](path::CurveArguments arguments) -> Result<path::CurveLaw, std::string> {
        if (arguments.size() != 2 || !arguments[0] || !arguments[1] || !(*arguments[0] > 0))
            return std::string("the radius is not above zero");
        path::CurveLaw law;
        law.numbers[0] = *arguments[0];
        law.to = *arguments[1];
        return law;
    },
    [](const path::CurveNumbers& numbers, double u) -> path::SplinePoint {
        const double r = numbers[0];
        const double angle = u + std::sin(u) / 2;
        const double rate = 1 + std::cos(u) / 2;
        const double bend = -std::sin(u) / 2;
        const path::Vec3 out(std::sin(angle), -std::cos(angle), 0);
        const path::Vec3 along(std::cos(angle), std::sin(angle), 0);
        return {r * out, r * rate * along, r * (bend * along - rate * rate * out)};
    }};

/// Arches of a cycloid on a circle of radius r: each has the length 8·r, and a cusp at its ends.
inline constexpr path::CurveKind kCycloid = {
    "cycloid",
    [](path::CurveArguments arguments) -> Result<path::CurveLaw, std::string> {
        path::CurveLaw law;
        law.numbers[0] = arguments[0].value_or(1);
        law.to = arguments[1].value_or(1) * 2 * M_PI;
        return law;
    },
    [](const path::CurveNumbers& numbers, double u) -> path::SplinePoint {
        const double r = numbers[0];
        return {{r * (u - std::sin(u)), r * (1 - std::cos(u)), 0},
                {r * (1 - std::cos(u)), r * std::sin(u), 0},
                {r * std::sin(u), r * std::cos(u), 0}};
    }};

/// A shape from the arguments of a call.
inline path::CurveShape shape_of(const path::CurveKind& kind, double first, double second) {
    const std::array<std::optional<double>, 2> arguments = {first, second};
    path::CurveShape shape;
    shape.kind = &kind;
    shape.law = *kind.make(arguments);
    return shape;
}

}  // namespace kadr::testing
