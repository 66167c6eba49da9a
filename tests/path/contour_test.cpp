// Contours: measures against closed forms, offsets against the definition of an offset.
#include "path/contour.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "path/contour_offset.h"
#include "tests/path/random_contour.h"

namespace kadr::path::contour_test {
namespace {

constexpr double kPi = std::numbers::pi;

Contour polygon(const std::vector<Vec2>& points, bool closes = true) {
    Contour contour;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        contour.push_back(line_element(points[i], points[i + 1]));
    if (closes) contour.push_back(line_element(points.back(), points.front()));
    return contour;
}

Contour rectangle(double w, double h) { return polygon({{0, 0}, {w, 0}, {w, h}, {0, h}}); }

Contour circle(const Vec2& center, double r, bool is_clockwise = false) {
    const Vec2 start = center + Vec2(r, 0);
    return {arc_element(start, start, center, is_clockwise)};
}

/// A slot along X: two lines, two half circles.
Contour slot(double length, double r) {
    return {line_element({0, -r}, {length, -r}),
            arc_element({length, -r}, {length, r}, {length, 0}, false),
            line_element({length, r}, {0, r}), arc_element({0, r}, {0, -r}, {0, 0}, false)};
}

TEST(Contour, Measures) {
    struct Row {
        const char* name;
        Contour contour;
        double length, area;
        Vec2 lower, upper;
    };
    const Row rows[] = {
        {"rectangle", rectangle(60, 40), 200, 2400, {0, 0}, {60, 40}},
        {"backwards", reversed(rectangle(60, 40)), 200, -2400, {0, 0}, {60, 40}},
        {"circle", circle({5, 5}, 10), 20 * kPi, 100 * kPi, {-5, -5}, {15, 15}},
        {"circle cw", circle({5, 5}, 10, true), 20 * kPi, -100 * kPi, {-5, -5}, {15, 15}},
        // two lines of 30, a circle of 5 in halves
        {"slot", slot(30, 5), 60 + 10 * kPi, 300 + 25 * kPi, {-5, -5}, {35, 5}},
        // a quarter turn keeps measures; the box turns
        {"turned slot",
         rotated(slot(30, 5), kPi / 2),
         60 + 10 * kPi,
         300 + 25 * kPi,
         {-5, -5},
         {5, 35}},
        {"mirrored slot",
         mirrored(slot(30, 5), true, false),
         60 + 10 * kPi,
         -300 - 25 * kPi,
         {-35, -5},
         {5, 5}},
        {"shifted", shifted(rectangle(1, 1), {1e4, -1e4}), 4, 1, {1e4, -1e4}, {10001, -9999}},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.name);
        EXPECT_TRUE(is_closed(row.contour));
        EXPECT_NEAR(length(row.contour), row.length, 1e-9);
        EXPECT_NEAR(signed_area(row.contour), row.area, 1e-9);
        EXPECT_LT((bounds(row.contour).lower - row.lower).norm(), 1e-9);
        EXPECT_LT((bounds(row.contour).upper - row.upper).norm(), 1e-9);
    }
    EXPECT_FALSE(is_closed(polygon({{0, 0}, {1, 0}, {1, 1}}, false)));
    EXPECT_FALSE(is_closed(Contour{}));
}

TEST(Contour, Inside) {
    struct Row {
        const char* name;
        Contour contour;
        Vec2 point;
        bool expected;
    };
    const Row rows[] = {
        {"middle", rectangle(60, 40), {30, 20}, true},
        {"on the edge", rectangle(60, 40), {60, 20}, true},
        {"on the corner", rectangle(60, 40), {0, 0}, true},
        {"level with an edge", rectangle(60, 40), {70, 40}, false},
        {"in the round of a slot", slot(30, 5), {34.9, 0}, true},
        {"beside the round", slot(30, 5), {34.9, 2}, false},
        {"circle", circle({0, 0}, 10), {9.99, 0}, true},
        {"beside the circle", circle({0, 0}, 10), {7.1, 7.1}, false},
        {"clockwise circle", circle({0, 0}, 10, true), {-7, -7}, true},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.name);
        EXPECT_EQ(is_inside(row.contour, row.point), row.expected);
    }
}

TEST(Contour, NearestPoint) {
    const Nearest corner = nearest(rectangle(60, 40), {63, 44});
    EXPECT_LT((corner.point - Vec2(60, 40)).norm(), 1e-12);
    EXPECT_NEAR(corner.distance, 5, 1e-12);  // 3, 4, 5
    const Nearest round = nearest(slot(30, 5), {38, 6});
    // From the centre (30, 0) along (8, 6)/10, five further.
    EXPECT_LT((round.point - Vec2(34, 3)).norm(), 1e-12);
    EXPECT_EQ(round.element, 1u);
    EXPECT_NEAR(nearest(circle({0, 0}, 10), {0, 0}).distance, 10, 1e-12);
}

TEST(Contour, Intersections) {
    struct Row {
        const char* name;
        Contour a, b;
        std::vector<Vec2> points;
    };
    const Row rows[] = {
        {"two rectangles",
         rectangle(10, 10),
         shifted(rectangle(10, 10), {5, 5}),
         {{10, 5}, {5, 10}}},
        {"line and circle",
         {line_element({-10, 3}, {10, 3})},
         circle({0, 0}, 5),
         {{-4, 3}, {4, 3}}},  // 3, 4, 5
        {"tangent", {line_element({-10, 5}, {10, 5})}, circle({0, 0}, 5), {{0, 5}}},
        {"two circles", circle({0, 0}, 5), circle({8, 0}, 5), {{4, 3}, {4, -3}}},
        {"circles that touch", circle({0, 0}, 5), circle({8, 0}, 3), {{5, 0}}},
        {"one inside the other", circle({0, 0}, 5), circle({1, 0}, 2), {}},
        {"apart", rectangle(1, 1), shifted(rectangle(1, 1), {3, 0}), {}},
        {"over each other",
         {line_element({0, 0}, {10, 0})},
         {line_element({4, 0}, {20, 0})},
         {{4, 0}, {10, 0}}},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.name);
        const std::vector<Vec2> found = intersections(row.a, row.b);
        ASSERT_EQ(found.size(), row.points.size());
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_LT((found[i] - row.points[i]).norm(), 1e-7) << found[i].transpose();
    }
}

TEST(Contour, Crossings) {
    const struct Row {
        const char* name;
        Contour contour;
        Eigen::Index coordinate;
        double value;
        std::vector<Vec2> points;
    } rows[] = {
        {"rectangle", rectangle(10, 10), 0, 4, {{4, 0}, {4, 10}}},
        {"circle", circle({0, 0}, 5), 1, 3, {{4, 3}, {-4, 3}}},  // 3, 4, 5
        {"touched", circle({0, 0}, 5), 1, 5, {{0, 5}}},
        {"beside", circle({0, 0}, 5), 1, 5.1, {}},
        {"along a side", rectangle(10, 10), 1, 10, {{10, 10}, {0, 10}}},
        {"a corner", polygon({{0, 0}, {5, 5}, {10, 0}}, false), 1, 5, {{5, 5}}},
        {"nothing", {}, 0, 0, {}},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.name);
        const std::vector<Vec2> found = crossings(row.contour, row.coordinate, row.value);
        ASSERT_EQ(found.size(), row.points.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_LT((found[i] - row.points[i]).norm(), 1e-7) << found[i].transpose();
            EXPECT_EQ(found[i][row.coordinate], row.value);
        }
    }
}

struct OffsetRow {
    const char* name;
    Contour contour;
    double distance;
    std::vector<double> areas;   // of the results, signed, in any order
    std::vector<double> counts;  // of elements, in the same order
};

TEST(ContourOffset, KnownShapes) {
    const double kDumbBell = 100 + 2 * (10 - std::sqrt(21.0) - 12.5 * std::asin(0.4));
    const OffsetRow rows[] = {
        {"rectangle inside", rectangle(60, 40), 5, {1500}, {4}},  // 50 x 30
        // 70 x 50 less the corners: 4·25 − 25π
        {"rectangle outside", rectangle(60, 40), -5, {3500 - 100 + 25 * kPi}, {8}},
        {"nothing left", rectangle(60, 40), 20.1, {}, {}},
        {"just nothing left", rectangle(60, 40), 20, {}, {}},
        {"circle inside", circle({0, 0}, 10), 4, {36 * kPi}, {1}},
        {"circle outside", circle({0, 0}, 10), -4, {196 * kPi}, {1}},
        {"clockwise circle outside", circle({0, 0}, 10, true), 4, {-196 * kPi}, {1}},
        {"slot inside", slot(30, 5), 2, {30 * 6 + 9 * kPi}, {4}},
        {"slot gone", slot(30, 5), 5.1, {}, {}},
        {"slot just gone", slot(30, 5), 5, {}, {}},
        // A dumb-bell: two squares of 20 joined by a neck of 4 fall into two of 10. Between the
        // corners of the neck they bulge: twice the integral of 5 − √(25 − u²), u from 0 to 2.
        {"dumb-bell",
         polygon({{0, 0},
                  {20, 0},
                  {20, 8},
                  {30, 8},
                  {30, 0},
                  {50, 0},
                  {50, 20},
                  {30, 20},
                  {30, 12},
                  {20, 12},
                  {20, 20},
                  {0, 20}}),
         5,
         {kDumbBell, kDumbBell},
         {7, 7}},
        // A C whose mouth of 4 closes: outside and the room inside, 24 x 24 less 3 all around.
        {"closing mouth",
         polygon({{0, 0},
                  {30, 0},
                  {30, 13},
                  {27, 13},
                  {27, 3},
                  {3, 3},
                  {3, 27},
                  {27, 27},
                  {27, 17},
                  {30, 17},
                  {30, 30},
                  {0, 30}}),
         -3,
         {},
         {}},
    };
    for (const OffsetRow& row : rows) {
        SCOPED_TRACE(row.name);
        const auto result = offset(row.contour, row.distance);
        ASSERT_TRUE(result);
        if (std::string_view(row.name) == "closing mouth") {
            ASSERT_EQ(result->size(), 2u);
            const double a = signed_area((*result)[0]);
            const double b = signed_area((*result)[1]);
            EXPECT_GT(std::max(a, b), 36 * 36 - 40);
            EXPECT_LT(std::min(a, b), -17 * 17);  // the other way around
            continue;
        }
        ASSERT_EQ(result->size(), row.areas.size());
        for (std::size_t i = 0; i < row.areas.size(); ++i) {
            EXPECT_TRUE(is_closed((*result)[i]));
            EXPECT_NEAR(signed_area((*result)[i]), row.areas[i], 1e-6);
            EXPECT_EQ((*result)[i].size(), row.counts[i]);
        }
    }
}

TEST(ContourOffset, OpenContour) {
    // An L, travelled to the right and up. Left: the corner is cut short; right: rounded.
    const Contour angle = polygon({{0, 0}, {20, 0}, {20, 15}}, false);
    const auto left = offset(angle, 3);
    ASSERT_TRUE(left);
    ASSERT_EQ(left->size(), 1u);
    EXPECT_EQ((*left)[0].size(), 2u);
    EXPECT_LT(((*left)[0].front().from - Vec2(0, 3)).norm(), 1e-9);
    EXPECT_LT(((*left)[0].front().to - Vec2(17, 3)).norm(), 1e-9);
    EXPECT_LT(((*left)[0].back().to - Vec2(17, 15)).norm(), 1e-9);
    const auto right = offset(angle, -3);
    ASSERT_TRUE(right);
    ASSERT_EQ(right->size(), 1u);
    ASSERT_EQ((*right)[0].size(), 3u);
    EXPECT_TRUE((*right)[0][1].is_arc());
    EXPECT_NEAR(length((*right)[0]), 35 + 3 * kPi / 2, 1e-9);
}

double rounded(double value) { return std::round(value * 1000) / 1000; }
Vec2 rounded(const Vec2& point) { return {rounded(point.x()), rounded(point.y())}; }

// Lines and arcs that are tangent but for the third decimal: beside them goes one piece.
TEST(ContourOffset, TangentElementsWithThreeDecimals) {
    for (int seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        test::Dice dice(static_cast<std::uint32_t>(seed));
        Contour contour;
        Vec2 at(0, 0);
        double heading = 0;
        const auto go = [&](double distance) {
            const Vec2 to = at + distance * Vec2(std::cos(heading), std::sin(heading));
            contour.push_back(line_element(rounded(at), rounded(to)));
            at = to;
        };
        go(20);
        for (int i = 0; i < 3; ++i) {
            const double turn = dice.between(0.2, 1.2) * (heading > 0 ? -1 : 1);
            const double radius = dice.between(3, 8);
            const Vec2 left(-std::sin(heading), std::cos(heading));
            const Vec2 center = at + left * std::copysign(radius, turn);
            const Vec2 to = center + Eigen::Rotation2D<double>(turn) * (at - center);
            // The centre as it is said, on the bisector of the ends.
            const Vec2 from = rounded(at);
            const Vec2 end = rounded(to);
            Vec2 said = from + rounded(Vec2(center - at));
            const Vec2 along = (end - from).normalized();
            said -= along * (said - (from + end) / 2).dot(along);
            contour.push_back(arc_element(from, end, said, turn < 0));
            at = to;
            heading += turn;
            go(dice.between(5, 20));
        }
        const auto beside = offset(contour, dice.between(0.4, 2.8) * (seed % 2 == 0 ? 1 : -1));
        ASSERT_TRUE(beside);
        EXPECT_EQ(beside->size(), 1u);
    }
}

// ---------------------------------------------------------------- properties

double number(double low, double high) {
    return low + (high - low) * (*rc::gen::inRange(0, 1000001)) / 1e6;
}

/// A star-shaped contour of lines and arcs: no crossing of itself by construction of its corners;
/// arcs bulge by less than would make them meet.
Contour random_contour() {
    const int n = *rc::gen::inRange(3, 12);
    std::vector<Vec2> points;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * kPi * (i + number(-0.3, 0.3)) / n;
        points.push_back(number(8, 40) * Vec2(std::cos(angle), std::sin(angle)));
    }
    Contour contour;
    for (int i = 0; i < n; ++i) {
        const Vec2 a = points[static_cast<std::size_t>(i)];
        const Vec2 b = points[static_cast<std::size_t>((i + 1) % n)];
        const int kind = *rc::gen::inRange(0, 3);
        if (kind == 0) {
            contour.push_back(line_element(a, b));
            continue;
        }
        // By the sweep: the centre is beside the middle of the chord.
        const double sweep = number(0.05, 1.2);
        const Vec2 chord = b - a;
        const Vec2 left(-chord.y(), chord.x());
        const double apart = 0.5 / std::tan(sweep / 2);
        const bool is_clockwise = kind == 1;
        const Vec2 center = (a + b) / 2 + left * (is_clockwise ? -apart : apart);
        contour.push_back(arc_element(a, b, center, is_clockwise));
    }
    return contour;
}

/// Corners on a grid of whole millimetres: parallels that run over each other, triple points,
/// touching arcs.
Contour random_grid_contour() {
    const int n = *rc::gen::inRange(2, 7);
    Contour contour;
    std::vector<Vec2> points;
    double x = 0;
    for (int i = 0; i < n; ++i) {  // a comb: teeth up from y = 0
        const double h = *rc::gen::inRange(2, 9);
        const double w = *rc::gen::inRange(1, 5);
        points.emplace_back(x, *rc::gen::inRange(1, 3));
        points.emplace_back(x, 2 + h);
        x += w;
        points.emplace_back(x, 2 + h);
        points.emplace_back(x, points[points.size() - 3].y());
        x += *rc::gen::inRange(1, 5);
    }
    points.emplace_back(points.back().x(), -3);
    points.emplace_back(0, -3);
    std::vector<Vec2> clean;
    for (const Vec2& p : points) {
        if (clean.empty() || (clean.back() - p).norm() > 0) clean.push_back(p);
    }
    return polygon(clean);
}

bool crosses_itself(const Contour& contour) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
        for (std::size_t j = i + 1; j < contour.size(); ++j) {
            for (const Crossing& crossing : crossings(contour[i], contour[j])) {
                const bool next = (j == i + 1 && crossing.share_b < 1e-6) ||
                                  (i == 0 && j + 1 == contour.size() && crossing.share_a < 1e-6);
                if (!next) return true;
            }
        }
    }
    return false;
}

/// The definition: inside the results are exactly the points of the free side that are farther
/// from the contour than the distance, and the results themselves keep it.
void check_offset(const Contour& contour, double d) {
    const auto result = offset(contour, d);
    RC_ASSERT(result.has_value());
    for (const Contour& piece : *result) {
        RC_ASSERT(is_closed(piece));
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const Element& element = piece[i];
            const Element& after = piece[(i + 1) % piece.size()];
            RC_ASSERT((element.to - after.from).norm() < 1e-9);
            if (element.is_arc()) {
                RC_ASSERT(std::fabs((element.to - element.center).norm() - radius(element)) < 1e-9);
            }
            for (int k = 0; k <= 20; ++k) {
                const double apart = nearest(contour, point_at(element, k / 20.0)).distance;
                RC_ASSERT(apart >= std::fabs(d) - kOffsetTolerance);
                RC_ASSERT(apart <= std::fabs(d) + 1e-5);
            }
        }
    }
    const Rectangle box = bounds(contour);
    const Vec2 margin = Vec2::Constant(std::fabs(d) * 1.3);
    const bool is_ccw = signed_area(contour) > 0;
    const bool wants_inside = (d > 0) == is_ccw;
    for (int k = 0; k < 400; ++k) {
        const Vec2 share(number(0, 1), number(0, 1));
        const Vec2 point =
            box.lower - margin + share.cwiseProduct(Vec2(box.upper - box.lower + 2 * margin));
        const double apart = nearest(contour, point).distance;
        if (std::fabs(apart - std::fabs(d)) < 1e-4) continue;
        const bool is_free = turns_around(contour, point) != 0 ? wants_inside : !wants_inside;
        int turns = 0;
        for (const Contour& piece : *result) turns += turns_around(piece, point);
        const bool is_beside = is_free && apart > std::fabs(d);
        // Outside, the results run around what is not free.
        const int expected = wants_inside ? (is_beside ? 1 : 0) : (is_beside ? 0 : 1);
        RC_ASSERT(turns * (is_ccw ? 1 : -1) == expected);
    }
}

RC_GTEST_PROP(ContourOffset, IsTheOffsetOfRandomContours, ()) {
    const Contour contour = random_contour();
    RC_PRE(!crosses_itself(contour));
    const bool is_reversed = *rc::gen::arbitrary<bool>();
    const double d = number(0.1, 15) * (*rc::gen::arbitrary<bool>() ? 1 : -1);
    check_offset(is_reversed ? reversed(contour) : contour, d);
}

/// A wall and islands in it together: beside all of them, everywhere far enough from each.
RC_GTEST_PROP(ContourOffset, IsTheOffsetOfAWallAndItsIslands, ()) {
    std::vector<Contour> walls = {random_contour()};
    RC_PRE(!crosses_itself(walls[0]));
    if (signed_area(walls[0]) < 0) walls[0] = reversed(walls[0]);
    const Rectangle box = bounds(walls[0]);
    for (int k = *rc::gen::inRange(1, 4); k > 0; --k) {
        const Vec2 share(number(0, 1), number(0, 1));
        const Vec2 center = box.lower + share.cwiseProduct(Vec2(box.upper - box.lower));
        const Contour island = *rc::gen::arbitrary<bool>()
                                   ? circle(center, number(0.5, 6), true)
                                   : shifted(reversed(rectangle(5, 3)), center);
        // Apart from what is there, and inside the wall.
        const bool is_apart = std::all_of(walls.begin(), walls.end(), [&](const Contour& other) {
            return intersections(other, island).empty() && !is_inside(island, other[0].from);
        });
        const Vec2 start = island[0].from;
        if (is_apart && is_inside(walls[0], start) &&
            std::none_of(walls.begin() + 1, walls.end(),
                         [&](const Contour& other) { return is_inside(other, start); })) {
            walls.push_back(island);
        }
    }
    const double d = number(0.1, 6);
    const auto result = offset(walls, d);
    RC_ASSERT(result.has_value());
    const auto apart = [&](const Vec2& point) {
        double least = 1e9;
        for (const Contour& wall : walls) least = std::min(least, nearest(wall, point).distance);
        return least;
    };
    for (const Contour& piece : *result) {
        RC_ASSERT(is_closed(piece));
        for (const Element& element : piece) {
            for (const double share : {0.0, 0.3, 0.7})
                RC_ASSERT(std::fabs(apart(point_at(element, share)) - d) < 1e-5);
        }
    }
    for (int k = 0; k < 400; ++k) {
        const Vec2 share(number(0, 1), number(0, 1));
        const Vec2 point = box.lower + share.cwiseProduct(Vec2(box.upper - box.lower));
        if (std::fabs(apart(point) - d) < 1e-4) continue;
        int sides = 0;
        for (const Contour& wall : walls) sides += turns_around(wall, point);
        int turns = 0;
        for (const Contour& piece : *result) turns += turns_around(piece, point);
        RC_ASSERT(turns == (sides == 1 && apart(point) > d ? 1 : 0));
    }
}

RC_GTEST_PROP(ContourOffset, IsTheOffsetOfCombsOnAGrid, ()) {
    const Contour contour = random_grid_contour();
    RC_PRE(!crosses_itself(contour));
    // Halves of millimetres: teeth and gaps are met exactly.
    const double d = *rc::gen::inRange(1, 8) / 2.0 * (*rc::gen::arbitrary<bool>() ? 1 : -1);
    check_offset(contour, d);
}

RC_GTEST_PROP(ContourOffset, OfAnOffset, ()) {
    // Tangent joins everywhere: out by d, in by d gives the contour less what was rounded.
    const Contour contour = random_contour();
    RC_PRE(!crosses_itself(contour));
    const double d = number(0.5, 6);
    const auto outside = offset(contour, -d);
    RC_ASSERT(outside.has_value());
    for (const Contour& piece : *outside) check_offset(piece, number(0.2, 8));
}

}  // namespace
}  // namespace kadr::path::contour_test
