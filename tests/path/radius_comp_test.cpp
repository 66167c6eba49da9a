// The cutter's path beside a contour against tests/oracles/cutter_comp.json, and what rules change.
#include "path/radius_comp.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "path/contour_offset.h"
#include "tests/path/oracle_arcs.h"

namespace kadr::path {
namespace {

using std::numbers::pi;
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

// ---------------------------------------------------------------- against brute force

/// The least distance of a path from a contour, by points every 10 µm of the path.
double least_distance(const std::vector<CompPiece>& pieces, const Contour& contour) {
    constexpr double kStep = 0.01;
    double least = std::numeric_limits<double>::infinity();
    for (const CompPiece& piece : pieces) {
        const int count = 1 + static_cast<int>(length(piece.element) / kStep);
        for (int i = 0; i <= count; ++i) {
            const Vec2 point = point_at(piece.element, static_cast<double>(i) / count);
            least = std::min(least, nearest(contour, point).distance);
        }
    }
    return least;
}

double any(double least, double most) {
    return least + (most - least) * *rc::gen::inRange(0, 10001) / 10000;
}

/// From a point to a point, straight or with a bend.
Element any_element(const Vec2& from, const Vec2& to) {
    if (*rc::gen::inRange(0, 3) == 0) return line_element(from, to);
    const Vec2 across = Vec2(from.y() - to.y(), to.x() - from.x()) / 2;
    const double share = any(0.4, 4) * (*rc::gen::inRange(0, 2) == 0 ? 1 : -1);
    const Vec2 center = (from + to) / 2 + across * share;
    return arc_element(from, to, center, share > 0);
}

/// A contour around the zero point, counter-clockwise, with corners of every kind.
Contour any_contour() {
    const int count = *rc::gen::inRange(4, 9);
    std::vector<Vec2> corners;
    for (int i = 0; i < count; ++i) {
        const double heading = 2 * pi * (i + any(-0.4, 0.4)) / count;
        corners.push_back(any(5, 40) * Vec2(std::cos(heading), std::sin(heading)));
    }
    Contour contour;
    for (std::size_t i = 0; i < corners.size(); ++i)
        contour.push_back(any_element(corners[i], corners[(i + 1) % corners.size()]));
    return contour;
}

/// Whether elements meet at their ends only.
bool is_simple(const Contour& contour) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
        for (std::size_t j = i + 1; j < contour.size(); ++j) {
            for (const Crossing& crossing : crossings(contour[i], contour[j])) {
                const bool is_joint =
                    j == i + 1 && (crossing.point - contour[j].from).norm() < 1e-4;
                const bool closes = i == 0 && j + 1 == contour.size() &&
                                    (crossing.point - contour[i].from).norm() < 1e-4;
                if (!is_joint && !closes) return false;
            }
        }
    }
    return true;
}

/// Whether elements that do not touch are so near to each other that the cutter cannot pass
/// between. A control that looks a few blocks ahead does not see all of those.
bool is_narrow(const Contour& contour, double width) {
    constexpr int kPoints = 100;
    const std::size_t count = contour.size();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 2; j < std::min(count, count + i - 1); ++j) {
            for (int k = 0; k <= kPoints; ++k) {
                const Vec2 point = point_at(contour[i], static_cast<double>(k) / kPoints);
                if (nearest(contour[j], point).distance < width + 0.5) return true;
            }
        }
    }
    return false;
}

/// A path at the distance, or a fault.
void never_gouges(CompRules rules) {
    const Contour contour = any_contour();
    const double distance = any(0.3, 4) * (*rc::gen::inRange(0, 2) == 0 ? 1 : -1);
    const bool is_fit = is_simple(contour) && !is_narrow(contour, 2 * std::abs(distance));
    RC_CLASSIFY(!is_fit, "not tried");
    if (!is_fit) return;
    // Not so far that it meets the elements with which it began.
    rules.look_ahead = contour.size() - 2;
    const Outcome outcome = compensate(contour, distance, rules, true);
    RC_CLASSIFY(outcome.fault.has_value(), "does not fit");
    if (outcome.fault) return;
    for (const Element& e : contour) {
        RC_LOG() << "contour " << e.from.transpose() << " > " << e.to.transpose() << " c "
                 << e.center.transpose() << " sweep " << e.sweep << "\n";
    }
    for (const CompPiece& p : outcome.pieces) {
        RC_LOG() << "path " << p.index << (p.is_inserted ? "+ " : " ") << p.element.from.transpose()
                 << " > " << p.element.to.transpose() << " sweep " << p.element.sweep << "\n";
    }
    RC_LOG() << "distance " << distance << "\n";
    for (std::size_t i = 1; i < outcome.pieces.size(); ++i) {
        const double gap =
            (outcome.pieces[i].element.from - outcome.pieces[i - 1].element.to).norm();
        RC_ASSERT(gap < 1e-5);
    }
    RC_ASSERT(least_distance(outcome.pieces, contour) > std::abs(distance) - 1e-3);
}

RC_GTEST_PROP(RadiusComp, ArcsNeverGouge, ()) { never_gouges({}); }
RC_GTEST_PROP(RadiusComp, IntersectionsNeverGouge, ()) {
    never_gouges({.outside = OutsideCorner::Intersection, .limit = 100 * pi / 180});
}
RC_GTEST_PROP(RadiusComp, SquaresNeverGouge, ()) {
    never_gouges({.outside = OutsideCorner::Intersection,
                  .limit = pi / 2,
                  .sharp = OutsideCorner::Square,
                  .extends_tangents = true});
}

}  // namespace
}  // namespace kadr::path
