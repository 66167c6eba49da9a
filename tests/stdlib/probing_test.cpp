// Probing cycles over many sets of parameters: every face is looked for as far as it was said, fast
// and then slowly, the probe never moves at rapid towards the part, and forbidden parameters say
// so.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/stdlib/commands.h"

namespace probing_test {

namespace {

using nlohmann::json;
using stdlib_test::outcome_of;

constexpr double kExact = 2e-6;  // mm: what the number format of the common core rounds

std::string mm(double value) { return json(value).dump() + "mm"; }

std::string program_of(const std::string& call, const std::string& start) {
    return "import cycles.probing;\nprogram test() {\nwork_offset(1);\n" + start + "\n" + call +
           ";\nM30;\n}\n";
}

/// The probing moves that end behind a face: along one axis, from the front of it.
struct Touch {
    std::size_t axis;
    double from, to, feed;
};

std::vector<Touch> touches_of(const std::vector<json>& commands) {
    std::vector<Touch> touches;
    std::array<double, 3> at{};
    for (const json& command : commands) {
        if (!command.contains("to")) continue;
        const std::array<double, 3> to = {command["to"]["X"], command["to"]["Y"],
                                          command["to"]["Z"]};
        if (command["op"] == "probe") {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (std::fabs(to[axis] - at[axis]) < kExact) continue;
                touches.push_back({axis, at[axis], to[axis], command["feed"]});
            }
        }
        at = to;
    }
    return touches;
}

/// Whether among the moves the face at `place` was crossed fast, then slowly, `range` to each side.
void expect_touched(const std::vector<Touch>& all, std::size_t axis, double place, double sign,
                    double range) {
    std::vector<double> feeds;
    for (const Touch& touch : all) {
        const bool crosses = touch.axis == axis &&
                             std::fabs(touch.to - (place + sign * range)) < kExact &&
                             std::fabs(touch.from - (place - sign * range)) < kExact;
        if (crosses) feeds.push_back(touch.feed);
    }
    EXPECT_EQ(feeds, (std::vector<double>{400, 40})) << "axis " << axis << " at " << place;
}

TEST(Probing, TouchesEveryFaceTwice) {
    std::mt19937 random(31);
    const auto real = [&](double least, double most) {
        const double value = std::uniform_real_distribution<double>(least, most)(random);
        return std::round(value * 1000) / 1000;
    };
    for (int i = 0; i < 12; ++i) {
        const double d = real(20, 80), ball = real(1, 8), x = real(-50, 50), y = real(-50, 50);
        const double range = real(0.5, std::min(5.0, (d - ball) / 2 - 1));
        const std::string common = "ball_d: " + mm(ball) + ", offset: 1, range: " + mm(range) +
                                   ", fast: 400mm/min, slow: 40mm/min";
        const std::string round = "d: " + mm(d) + ", x: " + mm(x) + ", y: " + mm(y) + ", " + common;
        SCOPED_TRACE(round);
        const std::string start = "G0 X=" + mm(x) + " Y=" + mm(y) + ";\nG0 Z20;\nF400;\nG31 Z-5;";
        const auto bore = outcome_of(program_of("probe_bore(" + round + ")", start), "iso", "mill");
        ASSERT_EQ(bore.status, 0) << bore.messages;
        EXPECT_EQ(bore.messages, "");
        const double inside = (d - ball) / 2, outside = (d + ball) / 2;
        const std::vector<Touch> in = touches_of(bore.commands);
        for (const double sign : {1.0, -1.0}) {
            expect_touched(in, 0, x + sign * inside, sign, range);
            expect_touched(in, 1, y + sign * inside, sign, range);
        }
        const auto boss = outcome_of(
            program_of("probe_boss(" + round + ", to: -5mm, initial: 20mm)", start), "iso", "mill");
        ASSERT_EQ(boss.status, 0) << boss.messages;
        const std::vector<Touch> out = touches_of(boss.commands);
        for (const double sign : {1.0, -1.0}) {
            expect_touched(out, 0, x + sign * outside, -sign, range);
            expect_touched(out, 1, y + sign * outside, -sign, range);
        }
        // Nothing goes down at rapid.
        double z = 0;
        for (const json& command : boss.commands) {
            if (!command.contains("to")) continue;
            const double to = command["to"]["Z"];
            if (command["op"] == "rapid") {
                EXPECT_GE(to, std::min(z, 20.0)) << command;
            }
            z = to;
        }
    }
}

TEST(Probing, AnEdgeIsFoundFromItsFront) {
    struct Row {
        const char* way;
        const char* at;
        std::size_t axis;
        double place, sign;
    };
    // A ball of 6 meets a wall 3 earlier; its lowest point meets a floor there.
    for (const Row& row : {Row{"x_plus", "20mm", 0, 17, 1},
                           {"x_minus", "-20mm", 0, -17, -1},
                           {"y_plus", "20mm", 1, 17, 1},
                           {"y_minus", "-20mm", 1, -17, -1},
                           {"z_minus", "-20mm", 2, -20, -1}}) {
        SCOPED_TRACE(row.way);
        const auto outcome =
            outcome_of(program_of(std::string("probe_edge(") + row.way + ", at: " + row.at +
                                      ", ball_d: 6mm, offset: 1, fast: 400mm/min, slow: 40mm/min)",
                                  "G0 X0 Y0;\nG0 Z0;"),
                       "iso", "mill");
        ASSERT_EQ(outcome.status, 0) << outcome.messages;
        expect_touched(touches_of(outcome.commands), row.axis, row.place, row.sign, 3);
        const auto last = std::find_if(outcome.commands.rbegin(), outcome.commands.rend(),
                                       [](const json& c) { return c.contains("to"); });
        EXPECT_EQ((*last)["to"], json({{"X", 0}, {"Y", 0}, {"Z", 0}})) << "ends where it began";
    }
}

TEST(Probing, EdgesAreFoundWhereverTheyAre) {
    struct Row {
        const char* way;
        std::size_t axis;
        double sign;
    };
    std::mt19937 random(32);
    const auto real = [&](double least, double most) {
        const double value = std::uniform_real_distribution<double>(least, most)(random);
        return std::round(value * 1000) / 1000;
    };
    for (int i = 0; i < 2; ++i) {
        for (const Row& row : {Row{"x_plus", 0, 1}, Row{"x_minus", 0, -1}, Row{"y_plus", 1, 1},
                               Row{"y_minus", 1, -1}, Row{"z_minus", 2, -1}}) {
            const double ball = real(1, 8), range = real(0.5, 6), at = real(15, 90);
            const std::string call = std::string("probe_edge(") + row.way +
                                     ", at: " + mm(row.sign * at) + ", ball_d: " + mm(ball) +
                                     ", offset: 1, range: " + mm(range) +
                                     ", fast: 400mm/min, slow: 40mm/min)";
            SCOPED_TRACE(call);
            const auto outcome = outcome_of(program_of(call, "G0 X0 Y0;\nG0 Z0;"), "iso", "mill");
            ASSERT_EQ(outcome.status, 0) << outcome.messages;
            const double place = row.sign * (row.axis == 2 ? at : at - ball / 2);
            expect_touched(touches_of(outcome.commands), row.axis, place, row.sign, range);
        }
    }
}

/// The F that none has set before is none again, and what is not corrected stays known.
TEST(Probing, OneCycleBehindTheOther) {
    for (const char* dialect : {"iso", "fanuc", "sinumerik"}) {
        SCOPED_TRACE(dialect);
        const auto outcome =
            outcome_of(program_of("probe_edge(z_minus, at: 0mm, ball_d: 6mm, offset: 1);\n"
                                  "probe_edge(x_plus, at: 20mm, ball_d: 6mm, offset: 1);\n"
                                  "probe_edge(y_plus, at: 20mm, ball_d: 6mm, offset: 1);\n"
                                  "probe_bore(d: 30mm, ball_d: 6mm, offset: 1);\n"
                                  "probe_boss(d: 9mm, to: 5mm, ball_d: 6mm, offset: 1)",
                                  "tool(9);\nG0 X0 Y0;\nG0 Z20;"),
                       dialect, "mill");
        EXPECT_EQ(outcome.status, 0);
        EXPECT_EQ(outcome.messages, "");
    }
}

TEST(Probing, OnlyAShiftMayAct) {
    struct Row {
        const char* frame;
        int status;
    };
    for (const Row& row : {Row{"with mirror(x: true)", 1},
                           {"with rotate(30deg)", 1},
                           {"with scale(2)", 1},
                           {"with shift(x: 10mm)", 0}}) {
        for (const char* call : {"probe_edge(x_plus, at: 30mm, ball_d: 6mm, offset: 1)",
                                 "probe_bore(d: 30mm, ball_d: 6mm, offset: 1)",
                                 "probe_boss(d: 9mm, to: 5mm, ball_d: 6mm, offset: 1)"}) {
            SCOPED_TRACE(std::string(row.frame) + call);
            const auto outcome =
                outcome_of(program_of(std::string(row.frame) + " { " + call + "; }",
                                      "tool(9);\nG0 X0 Y0;\nG0 Z20;"),
                           "sinumerik", "mill");
            EXPECT_EQ(outcome.status, row.status);
            if (row.status == 1) {
                EXPECT_NE(outcome.messages.find("are not those of the work offset"),
                          std::string::npos)
                    << outcome.messages;
            }
        }
    }
}

TEST(Probing, ForbiddenParametersSaySo) {
    struct Row {
        const char* call;
        const char* message;
    };
    for (const Row& row : {
             Row{"probe_edge(x_plus, at: 20mm, ball_d: 0mm, offset: 1)", "a ball of diameter 0"},
             {"probe_edge(x_plus, at: 20mm, ball_d: 6mm, offset: 0)", "the work offset must be 1"},
             {"probe_edge(x_plus, at: 20mm, ball_d: 6mm, offset: 1, range: 0mm)", "looked for"},
             {"probe_edge(x_plus, at: 20mm, ball_d: 6mm, offset: 1, slow: 0mm/min)", "cannot be"},
             {"probe_edge(x_plus, at: 5mm, ball_d: 6mm, offset: 1)", "the probe stands at 0"},
             {"probe_edge(x_minus, at: 20mm, ball_d: 6mm, offset: 1)", "the probe stands at 0"},
             {"probe_edge(x_plus, at: 20mm, ball_d: 6mm, offset: 2)",
              "where the probe stands along X in work offset 2 is not known: move there again "
              "behind `work_offset(2)`"},
             {"probe_bore(d: 10mm, ball_d: 6mm, offset: 1)", "has no room for a range of 3"},
             {"probe_boss(d: 0mm, to: -5mm, ball_d: 6mm, offset: 1)", "a boss of diameter 0"},
             {"probe_boss(d: 9mm, to: 5mm, ball_d: 6mm, offset: 1)", "below the start at Z 0"},
             {"probe_boss(d: 9mm, to: -5mm, ball_d: 6mm, offset: 1, clear: 0mm)", "clear of the"},
         }) {
        SCOPED_TRACE(row.call);
        const auto outcome = outcome_of(program_of(row.call, "G0 X0 Y0;\nG0 Z0;"), "iso", "mill");
        EXPECT_EQ(outcome.status, 1);
        EXPECT_NE(outcome.messages.find(row.message), std::string::npos) << outcome.messages;
    }
}

}  // namespace

}  // namespace probing_test
