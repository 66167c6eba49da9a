// Chamfers between lines and arcs, against a search of all widths.
#include "path/contour_corner.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kadr::path::contour_corner_test {
namespace {

double any(int from, int to) { return *rc::gen::inRange(from * 100, to * 100) * 0.01; }

/// A line or an arc that ends, or begins, at the origin.
Element any_element(bool ends) {
    const double angle = any(-3, 3);
    const Vec2 out(std::cos(angle), std::sin(angle));
    const Vec2 far = any(1, 30) * out;
    if (*rc::gen::inRange(0, 2) == 0)
        return ends ? line_element(far, Vec2::Zero()) : line_element(Vec2::Zero(), far);
    const double radius = any(1, 10);
    const Vec2 center = radius * out;
    const double sweep = any(0, 3) + 0.05;
    const Vec2 arm = -center;
    const double turn = ends ? -sweep : sweep;
    const Vec2 other(center.x() + arm.x() * std::cos(turn) - arm.y() * std::sin(turn),
                     center.y() + arm.x() * std::sin(turn) + arm.y() * std::cos(turn));
    Element arc{ends ? other : Vec2(Vec2::Zero()), ends ? Vec2(Vec2::Zero()) : other, center,
                sweep};
    return arc;
}

double chord(const Element& a, const Element& b, double width) {
    const auto cut = chamfer(a, b, width);
    return cut ? length(cut->piece) : 0;
}

/// The chamfer of a length is the first one that is so long; beside an arc that bends towards the
/// other element a wider one may be shorter.
RC_GTEST_PROP(ContourCorner, TheChamferOfALengthIsTheFirstOne, ()) {
    constexpr int kWidths = 2000;
    const Element a = any_element(true);
    const Element b = any_element(false);
    if (std::fabs(turn_between(a, b)) > std::numbers::pi - 1e-3) return;
    const double wanted = any(0, 20) + 0.01;
    const double widest = widest_chamfer(a, b);
    const auto width = chamfer_width(a, b, wanted);
    if (width && *width <= widest) {
        RC_ASSERT(std::fabs(chord(a, b, *width) - wanted) < 1e-6);
        for (int i = 1; i < kWidths; ++i)
            RC_ASSERT(chord(a, b, *width * i / kWidths) < wanted + 1e-6);
        return;
    }
    const double longest = chord(a, b, width_of_longest_chamfer(a, b));
    RC_ASSERT(longest <= wanted + 1e-6);
    for (int i = 1; i <= kWidths; ++i)
        RC_ASSERT(chord(a, b, widest * i / kWidths) <= longest * (1 + 1e-6) + 1e-9);
}

}  // namespace
}  // namespace kadr::path::contour_corner_test
