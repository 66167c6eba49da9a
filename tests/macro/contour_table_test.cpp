// Tables of contours: random contours, forwards and backwards. What the manual's examples say of
// them is held by programs of tests/control; here what holds of every table.
#include "macro/contour_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace kadr::macro::contour_table_test {
namespace {

using path::Vec2;

constexpr std::size_t kRows = 400;
constexpr double kClose = 1e-6;

using Table = std::vector<ContourRow>;

Table table_of(const PreparedContour& contour) {
    Table table(kRows, ContourRow{});
    for (const auto& row : contour.rows) table[row.index] = row.cells;
    return table;
}

/// Lines and arcs of up to three quarters of a turn, one behind the other.
std::vector<ContourElement> random_contour(std::mt19937& random) {
    const auto number = [&](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    std::vector<ContourElement> out;
    Vec2 from{number(-20, 20), number(-20, 20)};
    const int count = std::uniform_int_distribution<int>(3, 25)(random);
    for (int i = 0; i < count; ++i) {
        ContourElement element;
        const Vec2 to = from + Vec2{number(-15, 5), std::round(number(-2, 2)) * 5};
        element.shape = path::line_element(from, to);
        if (i > 0 && number(0, 1) < 0.4) {
            const double radius = number(1, 10);
            const double angle = number(0, 2 * std::numbers::pi);
            const double sweep =
                number(0.3, 1.5 * std::numbers::pi) * (number(0, 1) < 0.5 ? 1 : -1);
            const Vec2 center = from - radius * Vec2{std::cos(angle), std::sin(angle)};
            const Vec2 end =
                center + radius * Vec2{std::cos(angle + sweep), std::sin(angle + sweep)};
            element.shape = path::arc_element(from, end, center, sweep < 0);
        }
        out.push_back(element);
        from = element.shape.to;
    }
    return out;
}

struct Walk {
    std::vector<std::size_t> rows;
    double length = 0;
    int falls = 0;
    double end_height = 0;
    double greatest_height = 0;
};

/// Along the chain from a row on. Each row follows the one before, is one motion up or down, and a
/// mark names the row at which the next stretch begins.
Walk walk(const Table& table, std::size_t first, const ContourCut& cut) {
    Walk out;
    const auto height = [&](const ContourRow& row, int x) {
        return (cut.is_inside ? -1 : 1) * row[static_cast<std::size_t>(x + (cut.is_face ? 0 : 1))];
    };
    out.greatest_height = height(table[first], 3);
    double mark = 0;
    for (std::size_t row = first, before = 0; row != 0;
         before = row, row = static_cast<std::size_t>(table[row][1])) {
        const ContourRow& cells = table[row];
        EXPECT_EQ(cells[0], static_cast<double>(before));
        const auto element = element_of(cells);
        EXPECT_TRUE(element.has_value());
        if (!element || out.rows.size() > kRows) break;
        if (before != 0) {
            EXPECT_NEAR(table[before][5], cells[3], kClose);
            EXPECT_NEAR(table[before][6], cells[4], kClose);
        }
        const double from = height(cells, 3);
        const double to = height(cells, 5);
        for (const double share : {0.25, 0.5, 0.75}) {
            const Vec2 at = path::point_at(element->shape, share);
            const double between = (cut.is_inside ? -1 : 1) * at[cut.is_face ? 0 : 1];
            EXPECT_LE(between, std::max(from, to) + kClose);
            EXPECT_GE(between, std::min(from, to) - kClose);
        }
        EXPECT_GE(cells[8], 0);
        EXPECT_LE(cells[8], 180);
        if (cells[7] != 0) {
            if (mark != 0) {
                EXPECT_EQ(std::fabs(mark), static_cast<double>(row));
                EXPECT_NE(mark > 0, cells[7] > 0);
            }
            EXPECT_EQ(cells[7] > 0, to < from);
            out.falls += cells[7] > 0 ? 1 : 0;
            mark = cells[7];
        }
        out.rows.push_back(row);
        out.length += path::length(element->shape);
        out.end_height = to;
        out.greatest_height = std::max({out.greatest_height, from, to});
    }
    if (mark != 0) {
        EXPECT_EQ(mark, -1111);
    }
    return out;
}

double length_of(std::span<const ContourElement> elements) {
    double length = 0;
    for (const ContourElement& element : elements) length += path::length(element.shape);
    return length;
}

TEST(ContourTable, ChainsHoldTheContourAndEndAtItsHighestLevel) {
    std::mt19937 random(20261128);
    for (int round = 0; round < 400; ++round) {
        SCOPED_TRACE(round);
        const std::vector<ContourElement> contour = random_contour(random);
        const ContourCut cut{round % 2 == 1, round / 2 % 2 == 1, true};
        const auto prepared = prepared_contour(contour, cut, kRows);
        ASSERT_TRUE(prepared.has_value());
        const Table table = table_of(*prepared);
        const Walk forwards = walk(table, 1, cut);
        const Walk backwards = walk(table, static_cast<std::size_t>(table[kRows - 1][1]), cut);
        const double length = length_of(std::span(contour).subspan(1));
        // What is added closes undercuts: straight up from the last point.
        for (const Walk* way : {&forwards, &backwards}) {
            const bool is_forwards = way == &forwards;
            const Vec2 end = is_forwards ? contour.back().shape.to : contour[1].shape.from;
            const double height = (cut.is_inside ? -1 : 1) * end[cut.is_face ? 0 : 1];
            const double wall = way->end_height - height;
            EXPECT_GE(wall, -kClose);
            EXPECT_NEAR(way->length, length + wall, 1e-4);
            if (way->falls > 0) {
                EXPECT_NEAR(way->end_height, way->greatest_height, kClose);
            }
        }
        EXPECT_EQ(prepared->undercuts, forwards.falls);
        const auto last = static_cast<std::size_t>(table[0][1]);
        EXPECT_EQ(table[last + 1][0], forwards.falls);
        EXPECT_EQ(table[last + 1][1], backwards.falls);
        EXPECT_EQ(table[0][0], static_cast<double>(forwards.rows.back()));
        EXPECT_EQ(*std::ranges::max_element(forwards.rows), last);
        EXPECT_EQ(static_cast<double>(*std::ranges::min_element(backwards.rows)),
                  table[kRows - 1][0]);
        // A table with exactly these rows is enough, and one row less is not.
        const std::size_t needed = forwards.rows.size() + backwards.rows.size() + 3;
        EXPECT_TRUE(prepared_contour(contour, cut, needed).has_value());
        EXPECT_FALSE(prepared_contour(contour, cut, needed - 1).has_value());
    }
}

TEST(ContourTable, ElementsComeBackFromTheirRows) {
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        const std::vector<ContourElement> contour = random_contour(random);
        const auto prepared = prepared_contour(contour, {}, kRows);
        ASSERT_TRUE(prepared.has_value());
        const Table table = table_of(*prepared);
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const auto element = element_of(table[i]);
            ASSERT_TRUE(element.has_value());
            EXPECT_LT((element->shape.from - contour[i].shape.from).norm(), kClose);
            const bool is_whole = (element->shape.to - contour[i].shape.to).norm() < kClose;
            if (is_whole) {
                EXPECT_NEAR(element->shape.sweep, contour[i].shape.sweep, kClose);
            }
            EXPECT_EQ(element->modes.is_metric, contour[i].modes.is_metric);
        }
    }
}

TEST(ContourTable, CommonPointLiesOnBoth) {
    std::mt19937 random(11);
    int found = 0;
    for (int round = 0; round < 3000; ++round) {
        const std::vector<ContourElement> contour = random_contour(random);
        const std::vector<ContourElement> other = random_contour(random);
        const auto point = common_point(contour[1], other[1]);
        if (!point) continue;
        ++found;
        EXPECT_LT(path::nearest(contour[1].shape, *point).distance, 1e-5);
        EXPECT_LT(path::nearest(other[1].shape, *point).distance, 1e-5);
    }
    EXPECT_GT(found, 20);
}

TEST(ContourTable, OfTwoCommonPointsTheFirstOneCounts) {
    // A line along y = 3 through the upper half of a circle of radius 5: at x = ±4.
    ContourElement arc;
    arc.shape = path::arc_element({5, 0}, {-5, 0}, {0, 0}, false);
    ContourElement line;
    for (const double direction : {1.0, -1.0}) {
        line.shape = path::line_element({-10 * direction, 3}, {10 * direction, 3});
        const auto point = common_point(line, arc);
        ASSERT_TRUE(point.has_value());
        EXPECT_LT((*point - Vec2{-4 * direction, 3}).norm(), kClose);
    }
    const auto along_arc = common_point(arc, line);
    ASSERT_TRUE(along_arc.has_value());
    EXPECT_LT((*along_arc - Vec2{4, 3}).norm(), kClose);
}

}  // namespace
}  // namespace kadr::macro::contour_table_test
