// A part with chamfers, compensated in space, on machines of every class: the cutter is as far from
// the edge as its radius says at every tick, and the tip's way is the same everywhere.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "tests/driver/scratch.h"

namespace chamfers_test {

namespace {

using kadr::read_file;
using kadr::test::Row;
using kadr::test::rows_of;

using Chamfers = kadr::test::ScratchFolder;

struct Point {
    double x = 0;
    double y = 0;
};

/// An edge of a chamfer at one height, as its line or arc.
struct Edge {
    Point from;
    Point to;
    Point center;
    bool is_arc = false;
    double z = 0;
};

Edge line(Point from, Point to, double z) { return {from, to, {}, false, z}; }
Edge arc(Point from, Point to, Point center, double z) { return {from, to, center, true, z}; }

/// Place at a share of an edge; arcs run counter-clockwise.
Point at(const Edge& edge, double share) {
    if (!edge.is_arc) {
        return {edge.from.x + share * (edge.to.x - edge.from.x),
                edge.from.y + share * (edge.to.y - edge.from.y)};
    }
    const auto angle = [&](Point p) {
        return std::atan2(p.y - edge.center.y, p.x - edge.center.x);
    };
    const double begin = angle(edge.from);
    const double turn = std::remainder(angle(edge.to) - begin, 2 * std::numbers::pi);
    const double radius = std::hypot(edge.from.x - edge.center.x, edge.from.y - edge.center.y);
    const double now = begin + share * turn;
    return {edge.center.x + radius * std::cos(now), edge.center.y + radius * std::sin(now)};
}

struct Nearest {
    double distance = 1e9;  // of the cutter's axis from the edge, mm
    double depth = 0;       // of the tip below the place that touches, along the tool, mm
};

Nearest seen_from(const Row& row, const Edge& edge, double share) {
    const Point place = at(edge, share);
    const double v[3] = {place.x - row.at("tip_x"), place.y - row.at("tip_y"),
                         edge.z - row.at("tip_z")};
    const double o[3] = {row.at("tool_i"), row.at("tool_j"), row.at("tool_k")};
    const double along = v[0] * o[0] + v[1] * o[1] + v[2] * o[2];
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2] - along * along;
    return {std::sqrt(std::max(square, 0.0)), along};
}

/// The least distance from a contour, by searching each edge ever more finely.
Nearest nearest(const Row& row, const std::vector<Edge>& contour) {
    constexpr int kParts = 40;
    Nearest best;
    for (const Edge& edge : contour) {
        double from = 0;
        double to = 1;
        for (int depth = 0; depth < 4; ++depth) {
            double share = from;
            Nearest here;
            for (int i = 0; i <= kParts; ++i) {
                const double s = from + (to - from) * i / kParts;
                const Nearest seen = seen_from(row, edge, s);
                if (seen.distance >= here.distance) continue;
                here = seen;
                share = s;
            }
            if (here.distance < best.distance) best = here;
            const double step = (to - from) / kParts;
            from = std::max(0.0, share - step);
            to = std::min(1.0, share + step);
        }
    }
    return best;
}

const std::vector<Edge> kUpper = {line({20, 0}, {0, 13}, -3), line({0, 13}, {-20, 0}, -3),
                                  line({-20, 0}, {0, -13}, -3), line({0, -13}, {20, 0}, -3)};
const std::vector<Edge> kLower = {arc({29, 0}, {5, 19}, {5, -5.658}, -10),
                                  line({5, 19}, {-5, 19}, -10),
                                  arc({-5, 19}, {-29, 0}, {-5, -5.658}, -10),
                                  arc({-29, 0}, {-5, -19}, {-5, 5.658}, -10),
                                  line({-5, -19}, {5, -19}, -10),
                                  arc({5, -19}, {29, 0}, {5, 5.658}, -10)};

/// Number N of each line of the program, 0 without.
std::vector<int> numbers_of(const std::string& program) {
    std::vector<int> numbers;
    std::istringstream lines(program);
    for (std::string text; std::getline(lines, text);)
        numbers.push_back(text.starts_with('N') ? std::stoi(text.substr(1)) : 0);
    return numbers;
}

TEST_F(Chamfers, AreCutAsDeepOnEveryMachine) {
    const std::string program = KADR_ROOT "/examples/chamfers.mpf";
    const std::vector<int> numbers = numbers_of(read_file(program).value());
    for (const char* machine :
         {"trunnion-ac", "trunnion-bc", "head-ab", "mixed-cb", "head-cb", "nutating"}) {
        SCOPED_TRACE(machine);
        const auto result = kadr(
            {"run", program, "-d", "sinumerik", "-m", machine, "--setpoints", file("part.csv")});
        ASSERT_EQ(result.status, 0) << result.err;
        const std::vector<Row> rows = rows_of(read_file(file("part.csv")).value());
        int seen = 0;
        double upper_error = 0;
        double lower_error = 0;
        double depth_error = 0;
        for (std::size_t i = 0; i < rows.size(); i += 7) {
            const int number = numbers.at(static_cast<std::size_t>(rows[i].at("iso")) - 1);
            const bool is_upper = number >= 140 && number <= 200;
            const bool is_lower = number >= 310 && number <= 370;
            if (!is_upper && !is_lower) continue;
            ++seen;
            const Nearest found = nearest(rows[i], is_upper ? kUpper : kLower);
            double& error = is_upper ? upper_error : lower_error;
            error = std::max(error, std::abs(found.distance - (is_upper ? 5 : 1)));
            depth_error = std::max(depth_error, std::abs(found.depth - (is_upper ? 1 : 2.1)));
        }
        EXPECT_GT(seen, 1000);
        EXPECT_LT(upper_error, 1e-6);
        // The centres of the drawing are rounded: its arcs miss their ends by 0.1 micrometres.
        EXPECT_LT(lower_error, 1e-4);
        EXPECT_LT(depth_error, 2e-4);
    }
}

TEST_F(Chamfers, CommandsAreTheSameOnEveryMachineButForRotaryAxes) {
    const std::string program = KADR_ROOT "/examples/chamfers.mpf";
    std::vector<std::vector<double>> first;
    for (const char* machine :
         {"trunnion-ac", "trunnion-bc", "head-ab", "mixed-cb", "head-cb", "nutating"}) {
        SCOPED_TRACE(machine);
        const auto result = kadr(
            {"run", program, "-d", "sinumerik", "-m", machine, "--commands", file("part.jsonl")});
        ASSERT_EQ(result.status, 0) << result.err;
        std::istringstream lines(read_file(file("part.jsonl")).value());
        std::vector<std::vector<double>> places;
        for (std::string text; std::getline(lines, text);) {
            const nlohmann::json command = nlohmann::json::parse(text);
            if (!command.contains("to") || !command.contains("tool")) continue;
            const auto& to = command["to"];
            std::vector<double> place = {to["X"], to["Y"], to["Z"]};
            for (const auto& part : command["tool"]) place.push_back(part.get<double>());
            places.push_back(place);
        }
        places.erase(places.begin());  // to where the head stands above the part at first
        if (first.empty()) first = places;
        ASSERT_EQ(places.size(), first.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            for (std::size_t k = 0; k < 6; ++k)
                EXPECT_NEAR(places[i][k], first[i][k], k < 3 ? 1e-3 : 1e-6) << i;
        }
    }
    EXPECT_GT(first.size(), 20u);
}

}  // namespace

}  // namespace chamfers_test
