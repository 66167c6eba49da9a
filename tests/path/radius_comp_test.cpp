// The cutter's path beside a contour against tests/oracles/cutter_comp.json, and what rules change.
#include "path/radius_comp.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/path/oracle_arcs.h"
#include "tests/path/random_contour.h"

namespace kadr::path::radius_comp_test {
namespace {

using std::numbers::pi;
using test::any_contour;
using test::Dice;
using test::is_simple;
using test::Json;

Vec2 vec2(const Json& json) { return {json[0].get<double>(), json[1].get<double>()}; }

Contour contour_of(const Json& json) {
    Contour contour;
    for (const Json& one : json) {
        const Vec2 from = vec2(one["p"]);
        const Vec2 to = vec2(one["q"]);
        contour.push_back(one["t"] == "line" ? line_element(from, to)
                                             : arc_element(from, to, vec2(one["c"]), one["d"] < 0));
    }
    return contour;
}

struct Outcome {
    std::vector<CompPiece> pieces;
    std::optional<CompFault> fault;
    std::size_t at = 0;  // element that was pushed
};

/// A closed contour is gone around with one more element at both ends, which are left out again.
Outcome compensate(const Contour& contour, double distance, const CompRules& rules, bool closed) {
    Outcome outcome;
    RadiusComp comp(rules);
    const auto push = [&](const Element& element, std::size_t index) {
        if (outcome.fault) return;
        outcome.fault = comp.push(element, distance, index);
        outcome.at = index;
    };
    if (closed) push(contour.back(), 0);
    for (std::size_t i = 0; i < contour.size(); ++i) push(contour[i], i + 1);
    if (closed) push(contour.front(), contour.size() + 1);
    if (!outcome.fault) outcome.fault = comp.finish();
    if (!closed) {
        outcome.pieces = comp.pieces();
        return outcome;
    }
    for (const CompPiece& piece : comp.pieces()) {
        const std::size_t last = contour.size() + (piece.is_inserted ? 1 : 0);
        const std::size_t first = piece.is_inserted ? 2 : 1;
        if (piece.index >= first && piece.index <= last) outcome.pieces.push_back(piece);
    }
    return outcome;
}

std::string_view words(CompFault fault) {
    switch (fault) {
        case CompFault::ArcTooSmall: return "arc radius smaller than tool radius";
        case CompFault::NoIntersection: return "no intersection";
        case CompFault::Reversed: return "compensated block reversed (bottleneck)";
        case CompFault::Bottleneck: return "global gouge (bottleneck over several blocks)";
    }
    return "";
}

TEST(RadiusComp, CasesOfTheOracle) {
    std::ifstream file(KADR_ROOT "/tests/oracles/cutter_comp.json");
    const Json oracle = Json::parse(file);
    int cases = 0;
    for (const Json& test : oracle["cases"]) {
        if (test["kind"] != "2D") continue;
        SCOPED_TRACE(test["id"].get<std::string>());
        ++cases;
        const Json& input = test["input"];
        const Json& expected = test["expect"];
        const Contour contour = contour_of(input["contour"]);
        const double distance =
            input["tool_radius"].get<double>() * (input["side"] == "G41" ? 1 : -1);
        CompRules rules;
        if (input["corner"] == "G451") rules.outside = OutsideCorner::Intersection;
        const bool is_global = expected.contains("alarm") && expected["block"].is_null();
        if (is_global) rules.look_ahead = 8;
        const Outcome outcome = compensate(contour, distance, rules, input["closed"]);
        if (expected.contains("alarm")) {
            ASSERT_TRUE(outcome.fault);
            EXPECT_EQ(words(*outcome.fault), expected["alarm"]);
            continue;
        }
        ASSERT_FALSE(outcome.fault) << words(*outcome.fault);
        double total = 0;
        std::vector<Element> path;
        for (const CompPiece& piece : outcome.pieces) {
            total += length(piece.element);
            if (length(piece.element) > 1e-6) path.push_back(piece.element);
        }
        EXPECT_NEAR(total, expected["length"].get<double>(), 1e-5);
        std::vector<Json> elements;
        for (const Json& element : expected["elements"]) {
            const bool is_none = (vec2(element["from"]) - vec2(element["to"])).norm() < 1e-6;
            if (!is_none || element.contains("full")) elements.push_back(element);
        }
        ASSERT_EQ(path.size(), elements.size());
        for (std::size_t i = 0; i < path.size(); ++i) {
            SCOPED_TRACE(i);
            EXPECT_LT((path[i].from - vec2(elements[i]["from"])).norm(), 1e-6);
            EXPECT_LT((path[i].to - vec2(elements[i]["to"])).norm(), 1e-6);
            ASSERT_EQ(path[i].is_arc(), elements[i]["type"] == "arc");
            if (!path[i].is_arc()) continue;
            EXPECT_LT((path[i].center - vec2(elements[i]["center"])).norm(), 1e-6);
            EXPECT_EQ(path[i].sweep > 0, elements[i]["dir"] == "ccw");
        }
    }
    EXPECT_GE(cases, 46);
}

// ---------------------------------------------------------------- single rules

Contour chain(const std::vector<Vec2>& points) {
    Contour contour;
    for (std::size_t i = 1; i < points.size(); ++i)
        contour.push_back(line_element(points[i - 1], points[i]));
    return contour;
}

TEST(RadiusComp, PointedArcs) {
    // A square corner, radius 5: the arc's middle is at 5 from the corner, the sides meet at 5·√2.
    const Contour corner = chain({{0, 0}, {40, 0}, {40, 30}});
    const auto middle = [&](double pointed) {
        const Outcome outcome = compensate(corner, -5, {.pointed = pointed}, false);
        EXPECT_FALSE(outcome.fault);
        const CompPiece& piece = outcome.pieces[1];
        EXPECT_TRUE(piece.is_inserted);
        EXPECT_LT((conic_at(piece, 0) - Vec2(40, -5)).norm(), 1e-9);
        EXPECT_LT((conic_at(piece, 1) - Vec2(45, 0)).norm(), 1e-9);
        EXPECT_LT((piece.apex - Vec2(45, -5)).norm(), 1e-9) << "tangent to both sides";
        return (conic_at(piece, 0.5) - Vec2(40, 0)).norm();
    };
    const double meet = 5 * std::sqrt(2.0);
    EXPECT_NEAR(middle(0.3), 5 + 0.3 * (meet - 5), 1e-9);
    EXPECT_NEAR(middle(0.5), 5 + 0.5 * (meet - 5), 1e-9);
    // With nothing of it the conic is the arc itself.
    const Outcome round = compensate(corner, -5, {.pointed = 1e-12}, false);
    for (const double u : {0.1, 0.25, 0.7})
        EXPECT_NEAR((conic_at(round.pieces[1], u) - Vec2(40, 0)).norm(), 5, 1e-9);
    const Outcome full = compensate(corner, -5, {.pointed = 1}, false);
    ASSERT_EQ(full.pieces.size(), 4U);
    EXPECT_LT((full.pieces[1].element.to - Vec2(45, -5)).norm(), 1e-9) << "they meet";
}

/// Tangents that turn back: the curvatures tell on which side the second element goes.
TEST(RadiusComp, TurnsBackOnTheSideThatTheCurvaturesTell) {
    const auto half = [](double x, double sense) {  // from (x − 20, 0) to (x, 0) over the middle
        return Element{{x - 20, 0}, {x, 0}, {x - 10, 0}, sense * pi};
    };
    const Element up = line_element({20, 0}, {20, 30});
    const Element down = line_element({20, 30}, {20, 0});
    const Element level = line_element({0, 0}, {20, 0});
    const Element back = line_element({20, 0}, {0, 0});
    const double far = std::sqrt(15.0 * 15 - 10 * 10);  // radius 10 + 5, centres 20 apart
    const double near = std::sqrt(15.0 * 15 - 5 * 5);
    const struct {
        const char* name;
        Element first;
        Element second;
        double distance;
        std::optional<Vec2> corner;  // none: it goes around
    } rows[] = {
        {"two arcs, left", half(20, -1), half(40, -1), 5, Vec2(20, far)},
        {"two arcs, right", half(20, -1), half(40, -1), -5, std::nullopt},
        {"two arcs below, right", half(20, 1), half(40, 1), -5, Vec2(20, -far)},
        {"two arcs below, left", half(20, 1), half(40, 1), 5, std::nullopt},
        {"arc and line, left", half(20, -1), up, 5, Vec2(15, near)},
        {"arc and line, right", half(20, -1), up, -5, std::nullopt},
        {"line and arc, left", down, half(40, -1), 5, Vec2(25, near)},
        {"line and arc, right", down, half(40, -1), -5, std::nullopt},
        {"line and line", level, back, 5, std::nullopt},
        {"line and line, right", level, back, -5, std::nullopt},
        {"an arc and the same back", half(20, -1), {{20, 0}, {0, 0}, {10, 0}, pi}, 5, std::nullopt},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(row.name);
        const Outcome outcome = compensate({row.first, row.second}, row.distance, {}, false);
        ASSERT_FALSE(outcome.fault.has_value()) << words(*outcome.fault);
        ASSERT_EQ(outcome.pieces.size(), row.corner ? 2u : 3u);
        if (row.corner) {
            EXPECT_LT((outcome.pieces[0].element.to - *row.corner).norm(), 1e-9);
            EXPECT_LT((outcome.pieces[1].element.from - *row.corner).norm(), 1e-9);
        } else {
            EXPECT_TRUE(outcome.pieces[1].is_inserted);
            EXPECT_NEAR(std::abs(outcome.pieces[1].element.sweep), pi, 1e-9);
        }
    }
}

TEST(RadiusComp, AnArcAtOneCorner) {
    const CompRules rules{.outside = OutsideCorner::Intersection};
    const auto pieces = [&](double distance, std::optional<CompFault>& fault) {
        RadiusComp comp(rules);
        const Contour corner = chain({{0, 0}, {40, 0}, {40, 30}, {0, 30}});
        fault = comp.push(corner[0], distance, 1);
        comp.round_next_corner();
        for (std::size_t i = 1; i < corner.size() && !fault; ++i)
            fault = comp.push(corner[i], distance, i + 1);
        if (!fault) fault = comp.finish();
        return comp.pieces();
    };
    std::optional<CompFault> fault;
    const std::vector<CompPiece> outside = pieces(-5, fault);
    ASSERT_FALSE(fault);
    ASSERT_EQ(outside.size(), 4U) << "the next corner is an intersection again";
    EXPECT_NEAR(outside[1].element.sweep, pi / 2, 1e-12);
    pieces(5, fault);
    EXPECT_EQ(fault, CompFault::Bottleneck) << "the arc would cut into the corner";
}

TEST(RadiusComp, AnEndTowardsADirection) {
    const auto end = [](const Vec2& direction, double distance) {
        RadiusComp comp({});
        EXPECT_FALSE(comp.push(line_element({0, 0}, {40, 0}), distance, 1));
        EXPECT_FALSE(comp.finish_towards(direction));
        return comp.pieces().back().element.to;
    };
    EXPECT_LT((end({0, 1}, 5) - Vec2(35, 5)).norm(), 1e-9) << "a corner that closes";
    EXPECT_LT((end({0, 1}, -5) - Vec2(45, -5)).norm(), 1e-9) << "one that opens";
    EXPECT_LT((end({1, 0}, 5) - Vec2(40, 5)).norm(), 1e-9) << "straight on: no meeting";
}

/// A full circle with ways to it and from it that have its direction: sides lie on each other and
/// touch, and nothing is cut.
TEST(RadiusComp, ACircleWithItsLeads) {
    for (const double distance : {0.0, 2.0, 5.0}) {
        SCOPED_TRACE(distance);
        const Contour contour = {
            arc_element({110, 40}, {120, 30}, {110, 30}, true),
            arc_element({120, 30}, {120, 30}, {110, 30}, true),
            arc_element({120, 30}, {110, 20}, {110, 30}, true),
        };
        const Outcome outcome = compensate(contour, -distance, {.look_ahead = 3}, false);
        EXPECT_FALSE(outcome.fault);
        EXPECT_EQ(outcome.pieces.size(), 3U);
    }
}

// ---------------------------------------------------------------- against brute force

/// The least distance of a path from a contour, by points every 20 µm of the path.
double least_distance(const std::vector<CompPiece>& pieces, const Contour& contour) {
    constexpr double kStep = 0.02;
    double least = std::numeric_limits<double>::infinity();
    for (const CompPiece& piece : pieces) {
        const double reach =
            piece.weight > 0 ? (piece.apex - piece.element.from).norm() * 2 : length(piece.element);
        const int count = 1 + static_cast<int>(reach / kStep);
        for (int i = 0; i <= count; ++i) {
            const double share = static_cast<double>(i) / count;
            const Vec2 point =
                piece.weight > 0 ? conic_at(piece, share) : point_at(piece.element, share);
            least = std::min(least, nearest(contour, point).distance);
        }
    }
    return least;
}

double rounded(double value) { return std::round(value * 1000) / 1000; }
Vec2 rounded(const Vec2& point) { return {rounded(point.x()), rounded(point.y())}; }

/// A line, an arc tangent to it and a line tangent to that, all with three decimals, the centre as
/// a distance from the start of the arc: the arc ends up to a micrometre beside its circle.
Contour rounded_fillet(Dice& dice) {
    const double radius = dice.between(6, 20);
    const double heading = dice.between(-pi, pi);
    const double turn = dice.between(0.3, 2.5) * (dice.below(2) == 0 ? 1 : -1);
    const auto along = [](double angle) { return Vec2(std::cos(angle), std::sin(angle)); };
    const Vec2 aside = Vec2(-along(heading).y(), along(heading).x()) * (turn > 0 ? 1 : -1);
    const Vec2 first = along(heading) * 30;
    const Vec2 center = first + aside * radius;
    const Vec2 second = center + Eigen::Rotation2D<double>(turn) * (first - center);
    const Vec2 last = second + along(heading + turn) * 30;
    Contour contour{line_element(Vec2::Zero(), rounded(first)),
                    Element{rounded(first), rounded(second), Vec2::Zero(), 0},
                    line_element(rounded(second), rounded(last))};
    Element& arc = contour[1];
    arc.center = arc.from + rounded(Vec2(center - first));
    const Vec2 from = arc.from - arc.center;
    const Vec2 to = arc.to - arc.center;
    arc.sweep = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
    return contour;
}

TEST(RadiusComp, TangentArcsWithThreeDecimals) {
    constexpr double kDecimals = 2e-3;  // mm: what rounding moves a wall by
    for (std::uint32_t seed = 1; seed <= 400; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const Contour contour = rounded_fillet(dice);
        const double distance = dice.between(1, 5) * (dice.below(2) == 0 ? 1 : -1);
        CompRules rules;
        rules.look_ahead = contour.size();
        const Outcome outcome = compensate(contour, distance, rules, false);
        ASSERT_FALSE(outcome.fault) << words(*outcome.fault);
        EXPECT_GT(least_distance(outcome.pieces, contour), std::abs(distance) - kDecimals);
        double length = 0;
        double wanted = 0;
        for (const CompPiece& piece : outcome.pieces) length += path::length(piece.element);
        for (const Element& element : contour)
            wanted += path::length(element) - element.sweep * distance;
        EXPECT_NEAR(length, wanted, 20 * kDecimals);
    }
}

/// The arc about a centre as a program says it: three decimals, the centre as a distance from the
/// start. Equal ends make a full circle.
Element said_arc(const Vec2& from, const Vec2& to, const Vec2& center) {
    Element arc{rounded(from), rounded(to), rounded(from) + rounded(Vec2(center - from)), 0};
    const Vec2 a = arc.from - arc.center;
    const Vec2 b = arc.to - arc.center;
    arc.sweep = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    if (arc.sweep <= 1e-12) arc.sweep += 2 * pi;
    return arc;
}

// A bore as it is finished: in along a quarter, around, and out along a quarter.
TEST(RadiusComp, BoresWithThreeDecimals) {
    for (std::uint32_t seed = 1; seed <= 400; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const double bore = dice.between(10, 30);
        const double arc = bore * dice.between(0.4, 0.7);
        const double cutter = arc * dice.between(0.2, 0.8);
        const Vec2 center(dice.between(-50, 50), dice.between(-50, 50));
        const double angle = dice.between(0, 2 * pi);
        const Vec2 out(std::cos(angle), std::sin(angle));
        const Vec2 along(-out.y(), out.x());
        const Vec2 touching = center + bore * out;
        const Vec2 middle = center + (bore - arc) * out;
        const Contour contour{said_arc(middle - arc * along, touching, middle),
                              said_arc(touching, touching, center),
                              said_arc(touching, middle + arc * along, middle)};
        CompRules rules;
        rules.outside = OutsideCorner::Intersection;
        rules.look_ahead = contour.size();
        const Outcome outcome = compensate(contour, cutter, rules, false);
        ASSERT_FALSE(outcome.fault) << words(*outcome.fault);
        double sweep = 0;
        for (const CompPiece& piece : outcome.pieces) sweep += piece.element.sweep;
        EXPECT_NEAR(sweep, 3 * pi, 2e-3);
        EXPECT_GT(least_distance(outcome.pieces, {contour[1]}), cutter - 2e-3);
    }
}

// ---------------------------------------------------------------- ends that are too short

/// A contour whose first and last element may be left out.
Outcome compensate_open(const Contour& contour, double distance, const CompRules& rules) {
    Outcome outcome;
    RadiusComp comp(rules);
    comp.begin_open();
    for (std::size_t i = 0; i < contour.size() && !outcome.fault; ++i)
        outcome.fault = comp.push(contour[i], distance, i + 1);
    if (!outcome.fault) outcome.fault = comp.finish_open();
    outcome.pieces = comp.pieces();
    return outcome;
}

TEST(RadiusComp, AShortEndIsLengthened) {
    // Beside the first 5 mm there is no room for a radius of 10: to the circle about their start it
    // is sqrt(100 − 25), to their line 10. The same at the end.
    const Contour contour = chain({{50, 5}, {50, 0}, {0, 0}, {0, 5}});
    const auto ends = [&](OpenEnd kind) {
        const Outcome outcome = compensate_open(contour, -10, {.open_end = kind});
        EXPECT_FALSE(outcome.fault);
        EXPECT_EQ(outcome.pieces.size(), 1U);
        const Element& only = outcome.pieces.front().element;
        EXPECT_EQ(outcome.pieces.front().index, 2U);
        EXPECT_NEAR(only.from.y(), 10, 1e-9);
        EXPECT_NEAR(only.from.x() + only.to.x(), 50, 1e-9);
        return only.to.x();
    };
    EXPECT_NEAR(ends(OpenEnd::Arc), std::sqrt(75.0), 1e-9);
    EXPECT_NEAR(ends(OpenEnd::Line), 10, 1e-9);
    EXPECT_TRUE(compensate_open(contour, -10, {}).fault);
    // Where there is room nothing is left out.
    for (const OpenEnd kind : {OpenEnd::Arc, OpenEnd::Line}) {
        const Contour roomy = chain({{50, 15}, {50, 0}, {0, 0}, {0, 15}});
        EXPECT_EQ(compensate_open(roomy, -10, {.open_end = kind}).pieces.size(), 3U);
    }
    // In the middle of the contour a short element is what it ever was.
    const Contour step = chain({{50, 30}, {50, 5}, {45, 5}, {45, 30}, {0, 30}});
    EXPECT_EQ(compensate_open(step, -10, {.open_end = OpenEnd::Arc}).fault, CompFault::Reversed);
}

TEST(RadiusComp, AShortArcAtTheEnd) {
    // Beside the line the cutter's centre is at the height 3; beside the arc of radius 4 about
    // (26,0) on a circle of 1, which never comes there. The circle about the arc's end does, at
    // sqrt(9 − (3 − 4·sin 10°)²) before it.
    const double angle = 10 * pi / 180;
    const Vec2 end(26 + 4 * std::cos(angle), 4 * std::sin(angle));
    Contour contour = chain({{0, 0}, {30, 0}});
    contour.push_back(arc_element({30, 0}, end, {26, 0}, false));
    EXPECT_EQ(compensate(contour, 3, {}, false).fault, CompFault::NoIntersection);
    const Outcome outcome = compensate_open(contour, 3, {.open_end = OpenEnd::Arc});
    ASSERT_FALSE(outcome.fault);
    ASSERT_EQ(outcome.pieces.size(), 1U);
    const double up = 3 - end.y();
    const Vec2 expected(end.x() - std::sqrt(9 - up * up), 3);
    EXPECT_LT((outcome.pieces[0].element.to - expected).norm(), 1e-9);
    EXPECT_GT(least_distance(outcome.pieces, contour), 3 - 1e-9);
}

/// On random contours with short ends the cutter that leaves one element out does not cut into it,
/// nor into any other.
TEST(RadiusComp, LeavesOutShortEndsAndCutsNothing) {
    std::map<std::size_t, int> paths;  // by the number of elements that were left out
    for (std::uint32_t seed = 1; seed <= 20000; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        Contour contour = any_contour(dice);
        const double distance = test::any_distance(dice);
        if (!is_simple(contour)) continue;
        contour.front() = part(contour.front(), 1 - dice.between(0.01, 0.3), 1);
        contour.back() = part(contour.back(), 0, dice.between(0.01, 0.3));
        CompRules rules;
        rules.open_end = dice.below(3) == 0 ? OpenEnd::Line : OpenEnd::Arc;
        rules.look_ahead = contour.size();
        const Outcome plain = compensate(contour, distance, rules, false);
        const Outcome outcome = compensate_open(contour, distance, rules);
        if (!plain.fault) {
            ASSERT_FALSE(outcome.fault);
            EXPECT_EQ(outcome.pieces.size(), plain.pieces.size()) << "nothing to be left out";
            continue;
        }
        if (outcome.fault) continue;
        std::size_t kept = 0;
        for (const CompPiece& piece : outcome.pieces) kept += piece.is_inserted ? 0 : 1;
        const std::size_t left_out = contour.size() - kept;
        ++paths[left_out];
        if (left_out > 2) continue;
        const double cut = std::abs(distance) - least_distance(outcome.pieces, contour);
        EXPECT_LT(cut, 1e-3) << left_out;
    }
    for (const auto& [count, times] : paths)
        std::printf("%d paths with %zu elements left out\n", times, count);
    EXPECT_GT(paths[1], 20);
    EXPECT_GT(paths[2], 0);
}

/// Whether the cutter can touch the element anywhere without cutting into the contour elsewhere.
bool is_reachable(const Contour& contour, const Element& element, double distance) {
    constexpr int kPoints = 400;
    for (int i = 0; i <= kPoints; ++i) {
        const double share = static_cast<double>(i) / kPoints;
        const Vec2 tangent = [&]() -> Vec2 {
            if (!element.is_arc()) return start_direction(element);
            const Vec2 arm = (point_at(element, share) - element.center).normalized();
            return Vec2(-arm.y(), arm.x()) * (element.sweep > 0 ? 1 : -1);
        }();
        const Vec2 point = point_at(element, share) + Vec2(-tangent.y(), tangent.x()) * distance;
        if (nearest(contour, point).distance > std::abs(distance) - 1e-6) return true;
    }
    return false;
}

/// Whether the cutter cannot follow the contour where the fault is: one of the elements there
/// cannot be touched, or the path that is refused cuts.
bool is_justified(const Contour& contour, double distance, CompRules rules, const Outcome& outcome,
                  std::size_t at) {
    if (*outcome.fault == CompFault::Bottleneck) {
        rules.look_ahead = 1;
        const Outcome blind = compensate(contour, distance, rules, false);
        return blind.fault || least_distance(blind.pieces, contour) < std::abs(distance) - 4e-4;
    }
    for (std::size_t i = at < 3 ? 0 : at - 3; i < std::min(contour.size(), at); ++i)
        if (!is_reachable(contour, contour[i], distance)) return true;
    return false;
}

CompRules any_rules(Dice& dice, std::size_t look_ahead) {
    CompRules rules;
    rules.look_ahead = look_ahead;
    switch (dice.below(5)) {
        case 0: break;
        case 1: rules.pointed = dice.between(0, 1); break;
        case 2:
            rules.outside = OutsideCorner::Intersection;
            rules.limit = 100 * pi / 180;
            rules.pointed = dice.below(2) * 0.5;
            break;
        case 3:
            rules.outside = OutsideCorner::Intersection;
            rules.limit = pi / 2;
            rules.sharp = OutsideCorner::Square;
            rules.extends_tangents = true;
            break;
        default: rules.leaves_out = true; break;
    }
    return rules;
}

/// On random contours with random rules the cutter is never nearer to the contour than its radius
/// less 1 µm, and every refusal has its reason. KADR_CONTOURS says how many; they begin with
/// seed 1.
TEST(RadiusComp, KeepsItsDistanceOrHasAReason) {
    const char* const wanted = std::getenv("KADR_CONTOURS");
    const std::uint32_t count =
        wanted != nullptr ? static_cast<std::uint32_t>(std::stoul(wanted)) : 600;
    std::map<std::string_view, int> faults;
    int paths = 0;
    int unjustified = 0;
    double worst = 0;
    std::uint32_t tried = 0;
    for (std::uint32_t seed = 1; tried < count; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const Contour contour = any_contour(dice);
        const double distance = test::any_distance(dice);
        if (!is_simple(contour)) continue;
        ++tried;
        const CompRules rules = any_rules(dice, contour.size());
        const Outcome outcome = compensate(contour, distance, rules, false);
        if (outcome.fault) {
            ++faults[words(*outcome.fault)];
            if (is_justified(contour, distance, rules, outcome, outcome.at)) continue;
            ++unjustified;
            if (unjustified < 6)
                std::printf("seed %u: %s, without a reason\n", seed,
                            std::string(words(*outcome.fault)).c_str());
            continue;
        }
        ++paths;
        for (std::size_t i = 1; i < outcome.pieces.size(); ++i) {
            const double gap =
                (outcome.pieces[i].element.from - outcome.pieces[i - 1].element.to).norm();
            EXPECT_LT(gap, 1e-5);
        }
        const double cut = std::abs(distance) - least_distance(outcome.pieces, contour);
        worst = std::max(worst, cut);
        EXPECT_LT(cut, 1e-3);
    }
    std::printf("%u contours: %d paths, at most %.2g mm too near", tried, paths, worst);
    for (const auto& [what, times] : faults)
        std::printf("; %d %s", times, std::string(what).c_str());
    std::printf("; %d without a reason\n", unjustified);
    EXPECT_LE(unjustified * 1000, static_cast<int>(tried)) << "alarms on harmless contours";
}

}  // namespace
}  // namespace kadr::path::radius_comp_test
