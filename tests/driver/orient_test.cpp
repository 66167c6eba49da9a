// Tool centre point control and directions of the tool in a source: in the words of every control
// that has some, the same ways of the tip and of the tool by all of them.
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/disk_files.h"
#include "tests/driver/same_paths.h"

namespace orient_test {

namespace {

using kadr::test::Way;
using nlohmann::json;

/// Lines, turns about the tip, a vector of lengths, angles, a point beside a direction; great
/// circles and, at the end, the axes in proportion.
const std::string kProgram = R"(
program part() {
    tool(1); S8000 M3; F2000;
    G0 X0 Y0 Z60;
    point corner = {40mm, 30mm, 2mm};
    tcp(on);
    G0 X0 Y0 Z60 orient(k: 1);
    G1 Z2;
    X40 orient(i: 0.5, k: 1);
    G1 corner orient(i: 5mm, j: 5mm, k: 10mm);
    orient(i: -0.5, j: 0.5, k: 1);
    angle lean = 20deg;
    X10 orient(a: lean, b: -10deg);
    for (int n = 1; n <= 6; n++) X=10 + 5*n orient(a: lean - n*5deg, b: -10deg);
    turn_axes();
    Y0 orient(i: 0.3, k: 1);
    G0 Z80 orient(k: 1);
    tcp(off);
    G0 Z100;
    M30;
}
)";

class Orient : public kadr::test::ScratchFolder {
  protected:
    std::string expanded(const std::string& source, const std::string& control) {
        save("part.kadr", source);
        const auto result = kadr({"expand", file("part.kadr"), "-d", control});
        EXPECT_EQ(result.status, 0) << control << result.err;
        return result.out;
    }
    /// Where motions with a direction of the tool end, from the first to a place of its own.
    std::vector<json> motions(const std::string& control, const std::string& machine) {
        const auto result = kadr({"run", file("part.kadr"), "-d", control, "-m", machine,
                                  "--commands", file("all.jsonl"), "--setpoints", file("all.csv")});
        EXPECT_EQ(result.status, 0) << control << result.err;
        std::vector<json> found;
        std::istringstream lines(kadr::read_file(file("all.jsonl")).value_or(""));
        for (std::string line; std::getline(lines, line);) {
            json command = json::parse(line);
            if (!command.contains("tool") || !command.contains("to")) continue;
            found.push_back(
                {{"op", command["op"]}, {"to", command["to"]}, {"tool", command["tool"]}});
        }
        return found;
    }
    /// Tip and tool at the ticks of the last run.
    std::vector<Way> ticks() {
        return kadr::test::sample_distances_of(kadr::read_file(file("all.csv")).value_or(""));
    }
};

TEST_F(Orient, EveryControlHasItsWords) {
    const std::string sinumerik = expanded(kProgram, "sinumerik");
    const auto has = [](const std::string& text, const std::string& words) {
        EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    };
    has(sinumerik, "TRAORI\n");
    has(sinumerik, "ORIWKS");
    has(sinumerik, "ORIVECT");
    has(sinumerik, "X40 A3=0.5 B3=0 C3=1");
    has(sinumerik, "X40 Y30 Z2 A3=5 B3=5 C3=10");
    has(sinumerik, "A3=-0.5 B3=0.5 C3=1");
    // sin -10°, -sin 20°·cos 10°, cos 20°·cos 10°
    has(sinumerik, "X10 A3=-0.1736482 B3=-0.3368241 C3=0.9254166");
    has(sinumerik, "ORIAXES");
    has(sinumerik, "TRAFOOF");
    EXPECT_EQ(expanded(kProgram, "axioma").find("G43"), std::string::npos);
    const std::string fanuc = expanded(kProgram, "fanuc");
    has(fanuc, "\nG43.5 H01 P1\n");
    has(fanuc, "X40. I0.5 J0. K1.\n");
    has(fanuc, "X40. Y30. Z2. I5. J5. K10.\n");
    // Three digits behind the point would be off by a second of arc.
    has(fanuc, "X10. I-1736.482 J-3368.241 K9254.166\n");
    has(fanuc, "\nG43.5 H01 P0\n");
    // With G49 the axis would travel the length towards the part.
    has(fanuc, "\nG43 H01\n");
    EXPECT_EQ(fanuc.find("G43 H01\n"), fanuc.rfind("G43 H01"));
}

TEST_F(Orient, TheTipAndTheToolGoTheSameWaysOnEveryControl) {
    save("part.kadr", kProgram);
    for (const std::string machine : {"trunnion-ac", "head-cb"}) {
        std::vector<json> first;
        std::vector<Way> way;
        for (const std::string control : {"sinumerik", "axioma", "fanuc"}) {
            SCOPED_TRACE(control + " on " + machine);
            std::vector<json> all = motions(control, machine);
            // The length of G43.5 acts in a motion of its own, which goes nowhere.
            if (control == "fanuc") all.erase(all.begin());
            ASSERT_EQ(all.size(), 14u);
            const std::vector<Way> now = ticks();
            ASSERT_GT(now.size(), 500u);
            if (first.empty()) {
                first = all;
                way = now;
            }
            for (std::size_t n = 0; n < all.size(); ++n) {
                EXPECT_EQ(all[n]["op"], first[n]["op"]);
                for (const auto& [axis, value] : all[n]["to"].items()) {
                    const bool is_linear = axis < "A" || axis > "C";
                    EXPECT_NEAR(value.get<double>(), first[n]["to"][axis].get<double>(),
                                is_linear ? 1e-3 : 1e-4)
                        << n << axis;
                }
                for (std::size_t i = 0; i < 3; ++i)
                    EXPECT_NEAR(all[n]["tool"][i].get<double>(), first[n]["tool"][i].get<double>(),
                                1e-6)
                        << n;
            }
            kadr::test::expect_same_paths(now, way);
        }
        // The direction of the fifth: (-0.5, 0.5, 1) of length 1.
        EXPECT_NEAR(first[4]["tool"][0].get<double>(), -0.5 / std::sqrt(1.5), 1e-6);
        EXPECT_NEAR(first[4]["to"]["Y"].get<double>(), 30, 1e-9);
    }
}

TEST_F(Orient, AWithEndsItAndTheTextReadsBack) {
    const std::string source = R"(
program p() {
    tool(2); S3000 M3; F500;
    G0 X0 Y0 Z50;
    with tcp(on) {
        G0 X10 Y0 Z20 orient(b: 30deg);
        G1 Z5;
        G0 Z50;
        orient(0, 0, 1);
    }
    G0 X0 Y0 Z80;
    with tcp_on() { G0 X1 Y1 Z60; }
    M30;
}
)";
    for (const std::string control : {"sinumerik", "axioma"}) {
        const std::string text = expanded(source, control);
        EXPECT_NE(text.find("TRAORI"), text.rfind("TRAORI")) << text;
        EXPECT_NE(text.find("TRAFOOF"), text.rfind("TRAFOOF")) << text;
        EXPECT_NE(text.find("A3=0.5 B3=0 C3=0.8660254"), std::string::npos) << text;
    }
    // There the rotary axes must be known to stand at 0 before it begins again.
    const auto refused = kadr({"expand", file("part.kadr"), "-d", "fanuc"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.err.find("error[K3272]"), std::string::npos) << refused.err;
    std::string brought = source;
    brought.replace(brought.find("    G0 X0 Y0 Z80;"), 0, "    G0 B=0 C=0;\n");
    EXPECT_NE(expanded(brought, "fanuc").find("G43.5 H02 P1"), std::string::npos);
}

TEST_F(Orient, AnExampleRunsOnTwoMachinesByEveryControl) {
    for (const std::string control : {"sinumerik", "axioma", "fanuc"}) {
        for (const std::string machine : {"trunnion-ac", "head-cb", "mixed-cb"}) {
            SCOPED_TRACE(control + " on " + machine);
            const auto result = kadr({"run", KADR_ROOT "/examples/orientation.kadr", "-d", control,
                                      "-m", machine, "--setpoints", file("all.csv")});
            ASSERT_EQ(result.status, 0) << result.err;
            // The side of the cutter touches the wall: its axis is by its radius of 10 mm, square
            // to the wall, outside of the cone, at every tick on which it goes around.
            const double t = std::acos(-1) / 12;
            double lowest = 100;
            int around = 0;
            for (const Way& way : ticks()) {
                lowest = std::min(lowest, way.tip.z());
                if (way.tip.z() > -20 + 10 * std::sin(t) + 1e-3) continue;
                const double r = std::hypot(way.tip.x(), way.tip.y());
                if (r > 40 + 10 * std::cos(t) + 1e-3) continue;  // on the way in and out
                ++around;
                const double wall = (r - 40) * std::cos(t) + (way.tip.z() + 20) * std::sin(t);
                EXPECT_NEAR(wall, 10, 0.011);  // the tolerance of the corners
                EXPECT_NEAR(way.tool.z(), std::cos(t), 1e-4);
            }
            EXPECT_NEAR(lowest, -20 + 10 * std::sin(t), 1e-3);
            EXPECT_GT(around, 1000);
        }
    }
}

TEST_F(Orient, WhatCannotBeSaidIsRefused) {
    const struct {
        std::string body, control, code;
    } cases[] = {
        {"tcp(on); orient(i: 1, b: 30deg);", "sinumerik", "K3266"},
        {"tcp(on); orient();", "sinumerik", "K3266"},
        {"tcp(on); orient(i: 1deg);", "sinumerik", "K2102"},
        {"tcp(1);", "sinumerik", "K3268"},
        {"tcp();", "sinumerik", "K3268"},
        {"orient(k: 1);", "sinumerik", "K3269"},
        {"tcp(on); tcp(off); G1 X5 orient(k: 1);", "fanuc", "K3269"},
        {"tcp(on); raw \"G4 F1\"; G1 X5 F100 orient(k: 1);", "sinumerik", "K3212"},
        {"tcp(on); real n = 0; G1 X5 orient(i: n, j: 0*n);", "sinumerik", "K3270"},
        {"tcp(on);", "iso", "K3271"},
        {"tcp(on);", "fanuc-lathe", "K3271"},
        {"tilt(a: 30deg); tcp(on);", "sinumerik", "K3272"},
        {"G41 G1 X5; X10; tcp(on);", "sinumerik", "K3272"},
        {"rotate(30deg); tcp(on);", "fanuc", "K3272"},
        {"G0 C=30; tcp(on);", "fanuc", "K3272"},
        {"tcp(on); tool(2);", "sinumerik", "K3273"},
        {"tcp(on); retract();", "axioma", "K3273"},
        {"tcp(on); home();", "fanuc", "K3273"},
        {"tcp(on); tilt(a: 30deg);", "sinumerik", "K3273"},
        {"tcp(on); shift(x: 10mm);", "fanuc", "K3273"},
        {"with shift(x: 10mm) { tcp(on); }", "fanuc", "K3273"},
        {"tcp(on); with rotate(10deg) { G0 X5; }", "fanuc", "K3273"},
        {"tcp(on); G41 G1 X5;", "fanuc", "K3273"},
        {"tcp(on); G1 B=10;", "fanuc", "K3273"},
        {"tcp(on); orient(i: 0.5, k: 1); tcp(off);", "fanuc", "K3274"},
        {"tcp(on); G1 X0 Y0; G2 X10 Y10 CR=10;", "fanuc", "K3275"},
        {"tcp(on); G1 X0 Y0; G2 X10 Y10 CR=10; orient(k: 1);", "sinumerik", "K3276"},
        {"point a = {1mm, 2mm}; G1 a a;", "sinumerik", "K3277"},
        {"tcp(on); G1 X5 orient(k: 1) orient(k: 1);", "sinumerik", "K3277"},
    };
    for (const auto& wrong : cases) {
        SCOPED_TRACE(wrong.body + " for " + wrong.control);
        save("wrong.kadr",
             "program p() { tool(1); S1000 M3; F500; G0 X0 Y0 Z50; " + wrong.body + " M30; }\n");
        const auto result = kadr({"expand", file("wrong.kadr"), "-d", wrong.control});
        EXPECT_EQ(result.status, 1);
        EXPECT_NE(result.err.find("error[" + wrong.code + "]"), std::string::npos) << result.err;
    }
    // In the words of a control a block has its direction already.
    save("wrong.kadr",
         "dialect sinumerik;\nprogram p() { T1 D1; M6; S1000 M3; F500; G0 X0 Y0 Z50; TRAORI; "
         "G1 X10 C3=1 orient(k: 1); M30; }\n");
    const auto twice = kadr({"expand", file("wrong.kadr"), "-d", "sinumerik"});
    EXPECT_NE(twice.err.find("error[K3267]"), std::string::npos) << twice.err;
    save("wrong.kadr", "program p() { S1000 M3; F500; G0 X0 Y0 Z50; tcp(on); M30; }\n");
    const auto result = kadr({"expand", file("wrong.kadr"), "-d", "fanuc"});
    EXPECT_NE(result.err.find("error[K3272]"), std::string::npos) << result.err;
}

}  // namespace

}  // namespace orient_test
